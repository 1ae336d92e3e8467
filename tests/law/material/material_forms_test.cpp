// Every solid law of the list in the plane and in space: equal responses, and the same in any orientation. With
// TRILITH_TABLE in the environment a table of all results is printed.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "base/rotation_3d.hpp"
#include "law/material/space_point.hpp"
#include "law_sample.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

constexpr double forms_young = 30e9, forms_poisson = 0.2, forms_size = 4e-4;
const UsualNumbers usual_in_forms{{"Pa", 3e6}, {"rad", 0.5}, {"1", 0.2}, {"s", 0}};

/// Calls f(law) with each sample of every law with history that acts in space.
template <class F>
void for_each_in_space(F&& f) {
  SolidLaws::for_each([&]<class L>() {
    if constexpr (!L::is_elastic && acts_in_space<L>)
      for (L& law : samples<L>(usual_in_forms)) {
        law.young = forms_young, law.poisson = forms_poisson;
        INFO(describe(law));
        f(law);
      }
  });
}

/// A law in space as one of tensor form, whatever its own form.
template <class Law>
struct InSpace {
  const Law& law;
  double young = law.young, poisson = law.poisson;
  [[nodiscard]] SpaceResponse respond(const SpaceVector& strain, const SpaceMemory& before) const {
    return respond_in_space(law, strain, before);
  }
};

/// Largest difference of the responses in the plane and in space [Pa].
double apart(const PointResponse& plane, const PointResponse& space) {
  return std::max({std::abs(plane.stress.xx - space.stress.xx), std::abs(plane.stress.yy - space.stress.yy),
                   std::abs(plane.stress.zz - space.stress.zz), std::abs(plane.stress.xy - space.stress.xy)});
}

template <class Law>
void tell_material(const Law&, std::string_view form, double stress, double off) {
  if (std::getenv("TRILITH_TABLE") == nullptr) return;
  fmt::print("{:14} {:13} largest stress {:9.4g} Pa  difference from space {:8.1e}\n", Law::name, form, stress,
             off / stress);
}

SpaceVector turned_from(const Eigen::Matrix3d& r, const SpaceVector& v, double shear) {
  Eigen::Matrix3d t;
  t << v[0], v[3] / shear, v[5] / shear, v[3] / shear, v[1], v[4] / shear, v[5] / shear, v[4] / shear, v[2];
  t = (r * t * r.transpose()).eval();
  return (SpaceVector() << t(0, 0), t(1, 1), t(2, 2), shear * t(0, 1), shear * t(1, 2), shear * t(2, 0)).finished();
}

SpaceMemory memory_of(const SpaceVector& flown, double measure) {
  return {flown[0], flown[1], flown[2], flown[3], flown[4], flown[5], measure};
}

}  // namespace

TEST_CASE("a solid law in plane strain and plane stress equals the law in space, step by step") {
  for_each_in_space([](const auto& law) {
    for (const Plane plane : {Plane::strain, Plane::stress}) {
      std::mt19937_64 bits(3);
      std::uniform_real_distribution<double> share(-1, 1);
      PlasticMemory in_plane;
      SpaceMemory in_space;
      double most = 0, off = 0;
      for (int i = 0; i < 30; ++i) {
        const PlaneVector strain(forms_size * share(bits), forms_size * share(bits), forms_size * share(bits));
        const PointResponse p = respond_in_plane(law, plane, strain, in_plane);
        const SpaceResponse s =
            plane == Plane::strain
                ? respond_in_space(law, space_strain(strain, 0), in_space)
                : respond_without_stress_across(InSpace<std::decay_t<decltype(law)>>{law}, strain, in_space);
        most = std::max(most, p.stress.in_plane().cwiseAbs().maxCoeff());
        off = std::max(off, apart(p, plane_part(s)));
        CHECK(near_zero(p.stored - s.stored, 1e-8 * forms_young * forms_size * forms_size));
        CHECK(near_zero(p.dissipated - s.dissipated, 1e-8 * forms_young * forms_size * forms_size));
        in_plane = p.memory, in_space = s.memory;
      }
      CHECK(near_zero(off, 1e-8 * forms_young * forms_size));
      tell_material(law, plane == Plane::strain ? "plane strain" : "plane stress", most, off);
    }
  });
}

TEST_CASE("a solid law in space gives rotated stress for rotated strain") {
  for_each_in_space([](const auto& law) {
    std::mt19937_64 bits(4);
    std::uniform_real_distribution<double> share(-1, 1);
    SpaceMemory memory;
    for (int i = 0; i < 30; ++i) {
      SpaceVector strain;
      for (int k = 0; k < 6; ++k) strain[k] = forms_size * share(bits);
      const Turn3 turn(rotation_by(Vec3(share(bits), 2 * share(bits), share(bits))));
      Eigen::Matrix3d r;
      r << turn.x(), turn.y(), turn.z();
      const SpaceResponse plain = respond_in_space(law, strain, memory),
                          from_side = respond_in_space(law, turned_from(r, strain, 2),
                                                       memory_of(turned_from(r, memory.strain(), 2), memory.measure));
      const double scale = 1e-9 * forms_young * forms_size;
      CHECK((turned_from(r, plain.stress, 1) - from_side.stress).cwiseAbs().maxCoeff() < scale);
      CHECK((turned_from(r, plain.memory.strain(), 2) - from_side.memory.strain()).cwiseAbs().maxCoeff() <
            1e-9 * forms_size);
      CHECK(near_zero(plain.stored - from_side.stored, scale * forms_size));
      CHECK(near_zero(plain.dissipated - from_side.dissipated, scale * forms_size));
      memory = plain.memory;
    }
  });
}

TEST_CASE("a solid under three equal strains has three equal stresses") {
  for_each_in_space([](const auto& law) {
    for (const double strain : {2e-4, -2e-4}) {
      SpaceVector all;
      all << strain, strain, strain, 0, 0, 0;
      const SpaceVector stress = respond_in_space(law, all, {}).stress;
      for (const int k : {1, 2}) CHECK(near_zero(stress[k] - stress[0], 1e-9 * std::abs(stress[0])));
      for (const int k : {3, 4, 5}) CHECK(near_zero(stress[k], 1e-9 * std::abs(stress[0])));
    }
  });
}

namespace {

/// Solid laws outside of the list: one for the plane only, and one of tensor form.
struct PlaneAlone {
  static constexpr bool is_elastic = false;
  double young = 1, poisson = 0;
  [[nodiscard]] PointResponse respond(Plane, const PlaneVector&, const PlasticMemory&) const { return {}; }
};

/// Elastic, written in space.
struct Tensor {
  static constexpr bool is_elastic = false;
  double young = forms_young, poisson = forms_poisson;
  [[nodiscard]] SpaceResponse respond(const SpaceVector& strain, const SpaceMemory& before) const {
    SpaceResponse out;
    out.stress = elastic_in_space(young, poisson) * (strain - before.strain());
    out.memory = before, out.stored = 0.5 * out.stress.dot(strain - before.strain());
    return out;
  }
};
static_assert(!acts_in_space<PlaneAlone> && acts_in_space<Tensor> && acts_in_space<J2>);

}  // namespace

TEST_CASE("plane strain and plane stress follow from a solid of tensor form") {
  const Tensor law;
  const PlasticMemory flown{1e-5, -2e-5, 3e-5, 4e-5, 0};
  const PlaneVector strain(3e-4, -1e-4, 2e-4), elastic = strain - PlaneVector(flown.xx, flown.yy, flown.xy);
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    const PointResponse r = respond_in_plane(law, plane, strain, flown);
    const Stress expected = elastic_stress(law.young, law.poisson, plane, elastic, flown.zz);
    CHECK(near(r.stress.xx, expected.xx, 1e-10));
    CHECK(near(r.stress.yy, expected.yy, 1e-10));
    CHECK(near(r.stress.xy, expected.xy, 1e-10));
    CHECK(near_zero(r.stress.zz - expected.zz, 1e-10 * std::abs(expected.xx)));
  }
}

}  // namespace trilith::testing
