// Every contact law in every geometry: the same pair gives the same forces and energies, or the law is rejected there.
// With TRILITH_TABLE in the environment a table of all results is printed.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>

#include "contact/contact_samples.hpp"
#include "contact/joint/face_resultant.hpp"
#include "contact/law_trial.hpp"
#include "contact/plane/face_pair.hpp"
#include "law/contact/form_check.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Relative tolerance, above the ratio of the penetration to the blocks' length of 1 m. Strips along the edges, where
/// another face is the nearest, are as wide as the penetration, and the pressure of a nonlinear law is sampled at the
/// end of the contact.
constexpr double trial_within = 1e-3;
constexpr double trial_overlap = 2e-5, trial_speed = 0.2, trial_step = 1e-3;

/// The same pair: parallel; tilted and fully closed; tilted with three tenths open.
constexpr std::array<Lie, 3> trial_lies{{{trial_overlap, 0, trial_speed, trial_step},
                                         {trial_overlap, 2e-5, trial_speed, trial_step},
                                         {trial_overlap, 1e-4, trial_speed, trial_step}}};

void tell_law(std::string_view law, std::string_view geometry, const Lie& lie, const Carried& at, const Carried& of) {
  if (std::getenv("TRILITH_TABLE") == nullptr) return;
  fmt::print("{:13} {:34} tilt {:7.1e}  N {:11.5g} N  T {:11.5g} N  stored {:9.3g} J  difference {:8.1e}\n", law,
             geometry, lie.tilt, at.normal, at.shear, at.stored,
             std::max(std::abs(at.normal / of.normal - 1),
                      of.shear == 0 ? std::abs(at.shear) : std::abs(at.shear / of.shear - 1)));
}

template <class K>
Carried carried_by(const ContactLaw& law, const Lie& lie, ContactForm form) {
  switch (form) {
    case ContactForm::plane_faces:
      return as_plane_faces<K>(law, lie);
    case ContactForm::polygons:
      return as_polygons<K>(law, lie);
    case ContactForm::flat_faces:
      return as_solids(law, lie, true);
    case ContactForm::polyhedra:
      return as_solids(law, lie, false);
    default:
      return as_ball(law, lie);
  }
}

/// Whether sliding lifts dilating faces; the work of this lift is returned as the faces are pressed again.
template <class L>
bool lifts(const L& law) {
  if constexpr (requires { law.dilation; }) return law.dilation > 0;
  return false;
}

void check_same_carried(const Carried& found, const Carried& expected, bool lifts) {
  CHECK(near(found.normal, expected.normal, trial_within));
  CHECK(near_zero(found.shear - expected.shear, trial_within * (std::abs(expected.shear) + 1e-9 * expected.normal)));
  CHECK(near(found.stored, expected.stored, 2 * trial_within));
  if (lifts) return;
  CHECK(
      near_zero(found.taken - expected.taken, 2 * trial_within * (std::abs(expected.taken) + 1e-9 * expected.stored)));
}

/// Whether open faces still carry force, of a law of which friction remains.
template <class K>
bool compares(const Lie& lie) {
  const bool open = 0.5 * std::abs(lie.tilt) > lie.overlap;
  return !open || K::bonds || !friction_remains<K>;
}

template <class L>
void try_law(const L& numbers) {
  using K = typename L::Kernel;
  const ContactLaw law = numbers;
  INFO(describe(numbers));
  for (const Lie& lie : trial_lies) {
    if (!compares<K>(lie)) continue;
    const Carried faces = as_plane_faces<K>(law, lie);
    REQUIRE(faces.normal > 0);
    for (const ContactForm form : contact_forms) {
      if (form == ContactForm::spheres) continue;
      const std::string_view name = contact_form_names[static_cast<std::size_t>(form)];
      INFO(name << ", tilt " << lie.tilt);
      if (!left_out<K>(form).empty()) continue;
      const Carried found = carried_by<K>(law, lie, form);
      tell_law(L::name, name, lie, found, faces);
      check_same_carried(found, faces, lifts(numbers));
    }
  }
}

/// The ball against its rings, each pressed as parallel faces.
template <class L>
void try_ball(const L& numbers) {
  using K = typename L::Kernel;
  const ContactLaw law = numbers;
  INFO(describe(numbers));
  if (!left_out<K>(ContactForm::spheres).empty()) return;
  const Lie lie{trial_overlap, 0, trial_speed, trial_step};
  const auto even = [&](double depth) { return as_plane_faces<K>(law, {depth, 0, 0, trial_step}); };
  Carried rings = rings_of_ball(
      trial_overlap, [&](double d) { return even(d).normal; }, [&](double d) { return even(d).stored; });
  const Carried found = as_ball(law, lie), slid = as_plane_faces<K>(law, lie);
  rings.shear = rings.normal * slid.shear / slid.normal;
  tell_law(L::name, contact_form_names[4], lie, found, rings);
  CHECK(near(found.normal, rings.normal, trial_within));
  CHECK(near(found.stored, rings.stored, 2 * trial_within));
  // For friction proportional to the pressure, the mean over the disc counts.
  if constexpr (!has_own_friction<K>)
    CHECK(near_zero(found.shear - rings.shear, trial_within * (std::abs(rings.shear) + 1e-9 * rings.normal)));
}

}  // namespace

TEST_CASE("a pair under any law has the same forces and energies in every geometry of the law") {
  ContactLaws::for_each([]<class L>() {
    for (const L& law : samples<L>(usual_in_contact)) try_law(law);
  });
}

TEST_CASE("a ball is pressed by any law ring by ring as even faces are") {
  ContactLaws::for_each([]<class L>() {
    for (const L& law : samples<L>(usual_in_contact)) try_ball(law);
  });
}

TEST_CASE("a law without equations for a geometry is rejected by name, with the laws that act there") {
  ContactLaws::for_each([]<class L>() {
    for (const ContactForm form : contact_forms) {
      const std::string message = form_refusal(sample<L>(usual_in_contact), std::array{form});
      const std::string_view own = left_out<typename L::Kernel>(form);
      INFO(L::name << " " << message);
      CHECK(message.empty() == own.empty());
      if (own.empty()) continue;
      CHECK(message.find(own) != std::string::npos);
      CHECK(message.find(contact_form_names[static_cast<std::size_t>(form)]) != std::string::npos);
      CHECK(message.find("frictional") != std::string::npos);
      if (std::getenv("TRILITH_TABLE") != nullptr) fmt::print("{}: {}\n", L::name, message);
    }
  });
}

namespace {

/// Kernels outside of all lists, for tests of compile-time properties.
struct Rubbing : PointLaw<Rubbing> {
  using PointLaw::PointLaw;
  [[nodiscard]] double friction(double /*pressure*/, double speed_now) const { return mu + speed_now; }
};
struct RubbingOnCoulomb : Coulomb {
  using Coulomb::Coulomb;
  [[nodiscard]] double friction(double /*pressure*/, double speed_now) const { return mu + speed_now; }
};
struct PullingFaces : Coulomb {
  using Coulomb::Coulomb;
  template <class T>
  void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
    Coulomb::press(halves, active, out);
  }
};
struct SlidingFaces : Coulomb {
  using Coulomb::Coulomb;
  template <class T>
  T slide(HalfState<T>& half, T active, const ShearBefore<T>& before, HalfResponse<T>& out) const {
    return Coulomb::slide(half, active, before, out);
  }
};
struct StifferPower : Power::Kernel {
  using Power::Kernel::Kernel;
  [[nodiscard]] double effective(double of) const { return 2 * of; }
};
struct OtherBond : Bonded::Kernel {
  using Bonded::Kernel::Kernel;
  template <class T>
  void press(const HalfState<T>* halves, T* active, HalfResponse<T>* out) const {
    Coulomb::press(halves, active, out);
  }
};

template <class K>
constexpr bool acts(ContactForm form) {
  return left_out<K>(form).empty();
}
template <class K>
constexpr bool acts_everywhere() {
  return acts<K>(ContactForm::plane_faces) && acts<K>(ContactForm::polygons) && acts<K>(ContactForm::flat_faces) &&
         acts<K>(ContactForm::polyhedra) && acts<K>(ContactForm::spheres);
}
static_assert(acts_everywhere<Coulomb>() && acts_everywhere<Rubbing>() && has_whole_point_form<Rubbing>);
static_assert(!has_whole_point_form<RubbingOnCoulomb>, "faces would not ask its friction");
static_assert(!has_whole_point_form<StifferPower>, "PointLaw would go on asking the pressure of Power");
static_assert(acts<PullingFaces>(ContactForm::plane_faces) && !acts<PullingFaces>(ContactForm::polygons) &&
              !acts<PullingFaces>(ContactForm::flat_faces) && !acts<PullingFaces>(ContactForm::spheres));
static_assert(acts<SlidingFaces>(ContactForm::polygons) && !acts<SlidingFaces>(ContactForm::flat_faces) &&
              !acts<SlidingFaces>(ContactForm::polyhedra) && !acts<SlidingFaces>(ContactForm::spheres));
static_assert(acts_everywhere<Bonded::Kernel>() && !acts<OtherBond>(ContactForm::polygons) &&
                  !acts<OtherBond>(ContactForm::flat_faces),
              "what begins with a bond has none of its declarations");
static_assert(takes_one_type<decltype([](const Coulomb& k) { return k.kn; })>, "with_kernel refuses it");
static_assert(!takes_one_type<decltype([](const auto& k) { return k.kn; })>);

}  // namespace

TEST_CASE("two faces that slide hold the friction of their law at their slip speed") {
  const Rubbing law(Frictional{1e9, 5e8, 0.3, 0}, 0.5, 1e-2);
  for (const double speed : {0.2, 0.7}) {
    const FaceEnds<double> a{1, 0, 0, 0, 0, 0, 0, 0}, b{0, -1.45e-4, 1, -1.55e-4, speed, 0, speed, 0};
    const auto r = respond_face_pair<Rubbing, double>(a, b, 1.0, {}, {}, law);
    const double shear = std::abs(r.memory.shear_total[0] + r.memory.shear_total[1]), normal = 1e9 * 0.5 * 1.5e-4;
    CHECK(near(shear, (0.3 + speed) * normal, 1e-9));
    CHECK(near(face_friction(a, b, normal, law), shear, 1e-12));
  }
  const Coulomb plain(Frictional{1e9, 5e8, 0.3, 0}, 0.5, 1e-2);
  CHECK(face_friction({}, {}, 100, plain) == 30);
}
