// Contact laws: rejected declarations, and loss of bonds.
#include <doctest/doctest.h>

#include "contact/contact_samples.hpp"
#include "contact/face_scene.hpp"
#include "model/builder/builder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

std::string message_of(const ContactLaw& law) {
  ModelBuilder builder;
  try {
    builder.add_law("joint", law);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a contact law outside its declared ranges is rejected with its name, its number and the range") {
  ContactLaws::for_each([]<class L>() {
    const std::vector<L> sounds = samples<L>(usual_in_contact);
    const L sound = sounds.front();
    for (const L& law : sounds) CHECK(message_of(law).empty());
    for (const Parameter<L>& p : L::parameters()) {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      std::vector<double> bad{p.least - 1, -unbounded, unbounded, nan};
      if (!p.includes_least) bad.push_back(p.least);
      if (p.most < unbounded) bad.push_back(p.most * (1 + 1e-9) + 1e-9);
      for (const double value : bad) {
        L law = sound;
        law.*(p.member) = value;
        const std::string message = message_of(law);
        CAPTURE(p.name);
        CAPTURE(value);
        CHECK(message.find(p.name) != std::string::npos);
        CHECK(message.find(L::name) != std::string::npos);
        CHECK(message.find(p.range()) != std::string::npos);
      }
      // The ends of the range are accepted by the sample. A number that needs others may only miss these: its range is
      // not the reason.
      const auto accepts = [&](double value) {
        L law = sound, full = sounds.back();
        law.*(p.member) = value, full.*(p.member) = value;
        return message_of(law).empty() || message_of(full).find(p.range()) == std::string::npos;
      };
      CAPTURE(p.name);
      CHECK((!p.includes_least || accepts(p.least)));
      CHECK((!(p.most < unbounded) || accepts(p.most)));
    }
  });
}

TEST_CASE("a bond stronger in tension than its shear limit allows is accepted with a note") {
  ModelBuilder builder;
  builder.add_law("wall", Bonded{1e8, 4e7, 0.7, 0, 9768, 19150, 0});
  REQUIRE(builder.notes().size() == 1);
  CHECK(builder.notes()[0].find("apex of the Coulomb line") != std::string::npos);
}

namespace {

/// A bonded joint of 1 m, opened by `gap` at its middle and rotated by `slope`.
using BondResponse = FaceResponse<double, LawMemory<Bonded::Kernel>>;
BondResponse opened(double gap, double slope, double slip, bool by_point, const FaceMemory<double>& before) {
  const Bonded::Kernel law({1e8, 5e7, 0.5, 0, 1e6, 2e4, by_point ? 1.0 : 0.0}, 1, 1e-3);
  const Vec2 speed(slip / law.dt, 0);
  const Faces f{rigid_face({1, 0}, {0, 0}, Vec2::Zero(), 0),
                rigid_face({0, gap - 0.5 * slope}, {1, gap + 0.5 * slope}, speed, 0)};
  return respond_fresh(f, before, law);
}

}  // namespace

TEST_CASE("C7: below its strength a bond pulls with kn times the gap, above it with nothing") {
  const BondResponse below = opened(1.99e-4, 0, 0, false, no_memory(true)),
                     above = opened(2.01e-4, 0, 0, false, no_memory(true));
  CHECK(near((on_b0(below) + on_b1(below)).y(), -1.99e4, 1e-12));
  CHECK(below.memory.bonds[0]);
  CHECK((on_b0(above) + on_b1(above)).norm() == 0.0);
  CHECK_FALSE(above.memory.bonds[0]);
  CHECK_FALSE(above.touching);
  CHECK(near(above.lost_fracture, 0.5 * 1e8 * 2.01e-4 * 2.01e-4, 1e-12));
}

TEST_CASE("C7: where one end exceeds its strength, the whole face or half of it fails, as selected") {
  // Opening of 3e-4 m at the right end and 1e-4 m in the middle; the left end is closed.
  const BondResponse whole = opened(1e-4, 4e-4, 0, false, no_memory(true)),
                     half = opened(1e-4, 4e-4, 0, true, no_memory(true));
  CHECK_FALSE((whole.memory.bonds[0] || whole.memory.bonds[1]));
  // Halves are counted from the start of the first face, which is at the right.
  CHECK_FALSE(half.memory.bonds[0]);
  CHECK(half.memory.bonds[1]);
  CHECK(whole.lost_fracture > half.lost_fracture);
  // Closed for x from 0 to 0.25, with a penetration of 1e-4 m at the left.
  const double pressed = 0.5 * 1e8 * 1e-4 * 0.25;
  CHECK(near((on_b0(whole) + on_b1(whole)).y(), pressed, 1e-6));
  // The intact half carries its tension as well: its mean gap is 0.
  CHECK(near_zero((on_b0(half) + on_b1(half)).y(), 1e-5));
}

TEST_CASE("C7: a lost bond does not recover, and slides with friction only") {
  FaceMemory<double> memory = opened(2.01e-4, 0, 0, false, no_memory(true)).memory;
  memory = opened(-1e-4, 0, 0, false, memory).memory;
  CHECK_FALSE(memory.bonds[0]);
  const BondResponse pulled = opened(1e-5, 0, 0, false, memory);
  CHECK_FALSE(pulled.touching);
  const BondResponse slid = opened(-1e-4, 0, 1e-3, false, memory);
  CHECK(near(std::abs((on_b0(slid) + on_b1(slid)).x()), 0.5 * 1e4, 1e-12));
  CHECK(slid.lost_friction > 0);
}
