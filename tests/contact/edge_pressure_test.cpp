#include "contact/plane/edge_pressure.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "contact/plane/edge_energy.hpp"
#include "contact/space/solid_energy.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "geometry/space/separation_3d.hpp"
#include "near.hpp"

using namespace trilith;

namespace {

PlacedSolid put(const ConvexSolid& solid, const UnitQuaternion& rotation, const Vec3& at) {
  PlacedSolid out;
  place(solid, Turn3(rotation), at, out);
  return out;
}

ConvexSolid a_box(std::mt19937_64& bits) {
  const Vec3 half = Vec3(1, 1, 1) + 0.5 * random_in_ball(bits);
  return convex_solid(box_solid(-0.5 * half, 0.5 * half), "box");
}

/// Prisms over triangles and quadrilaterals, and solids of four to six corners.
ConvexSolid of_few_faces(std::mt19937_64& bits) {
  return random_count(bits, 0, 1) == 0
             ? convex_solid(random_convex_solid(bits, {.most_corners = 6, .slenderest = 3}), "solid")
             : convex_solid(random_prism(bits, 0.5, 1.5, {.most_corners = 4}), "prism");
}

/// Reference method: one solid clipped by the faces of the other, cells clipped one by one.
SolidPressure cut_way(const MovingSolid& a, const MovingSolid& b, const ContactLaw& law) {
  SolidOverlapBuffer shared;
  shared_volume(a.placed, b.placed, shared);
  return solid_pressure(a, b, {law}, shared);
}

/// Largest difference of two pressures: forces relative to their size, lengths relative to the size of the solids.
double difference(const SolidPressure& p, const SolidPressure& q, double size) {
  const double force = q.pressure + q.damping.norm(), share = q.pressure / force;
  const auto second = [](const SolidPressure& of) {
    return Eigen::Matrix3d(of.arm[0] * of.arm[0].transpose() + of.arm[1] * of.arm[1].transpose());
  };
  return std::max(
      {(p.force - q.force).norm() / force, (p.damping - q.damping).norm() / force,
       (p.moment - q.moment).norm() / (force * size), (p.damping_moment - q.damping_moment).norm() / (force * size),
       std::abs(p.damped - q.damped) / (force * 10), std::abs(p.pressure - q.pressure) / force,
       share * (p.centre - q.centre).norm() / size, share * std::abs(p.friction_arm - q.friction_arm) / size,
       std::abs(p.area - q.area) / q.area, (p.middle - q.middle).norm() / size, std::abs(p.radius - q.radius) / size,
       (second(p) - second(q)).norm() / (size * size), std::abs(p.depth - q.depth) / size});
}

/// Pairs, and the number per thousand that fall back to the reference method.
struct Pairs {
  std::uint64_t seed;
  int pairs;
  double deep;  ///< penetration depth over its start value
  Vec3 far = Vec3::Zero();
};

/// Random overlapping pairs, separated along the axis of least depth until `deep` of the penetration remains. Their
/// motion is such that with damping the pressure is above zero on all of a face, on a part or nowhere.
template <class Solid>
double check_pairs(const Pairs& of, double within, Solid&& solid) {
  std::mt19937_64 bits(of.seed);
  Frictional law;
  law.kn = 1e8, law.beta = 1e-3;
  int touching = 0, left = 0;
  double worst = 0;
  std::vector<FourTriangles> room;
  while (touching < of.pairs) {
    const ConvexSolid sa = solid(bits), sb = solid(bits);
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = of.far + 0.1 * random_in_ball(bits);
    const PlacedSolid a = put(sa, random_rotation(bits), of.far), b = put(sb, turn, at);
    const Separation3 apart = separation(a, b);
    if (!(apart.distance < 0)) continue;
    const PlacedSolid moved = put(sb, turn, at - (1 - of.deep) * apart.distance * apart.axis);
    const double fast = 1e3 * of.deep;
    const MovingSolid of_a{a, of.far, fast * random_in_ball(bits), fast * random_in_ball(bits)},
        of_b{moved, at, fast * random_in_ball(bits), fast * random_in_ball(bits)};
    const SolidPressure expected = cut_way(of_a, of_b, law);
    if (!(expected.area > 0)) continue;
    ++touching;
    SolidPressure pressed;
    if (edge_pressure(of_a, of_b, law.kn, law.beta, room, pressed))
      worst = std::max(worst, difference(pressed, expected, sa.size));
    else
      ++left;
  }
  CHECK(worst < within);
  return 1e3 * left / of.pairs;
}

/// The same pairs: the energy from the triangles against the energy from cells, relative.
template <class Solid>
double check_energies(const Pairs& of, double within, Solid&& solid) {
  std::mt19937_64 bits(of.seed);
  Frictional law;
  law.kn = 2;  // kn / 2 is 1
  int touching = 0, left = 0;
  double worst = 0;
  std::vector<FourTriangles> room;
  SolidOverlapBuffer shared, cell;
  while (touching < of.pairs) {
    const ConvexSolid sa = solid(bits), sb = solid(bits);
    const UnitQuaternion turn = random_rotation(bits);
    const Vec3 at = of.far + 0.1 * random_in_ball(bits);
    const PlacedSolid a = put(sa, random_rotation(bits), of.far), b = put(sb, turn, at);
    const Separation3 apart = separation(a, b);
    if (!(apart.distance < 0)) continue;
    const PlacedSolid moved = put(sb, turn, at - (1 - of.deep) * apart.distance * apart.axis);
    const double expected = solid_energy(a, moved, {law}, shared, cell);
    if (!(expected > 0)) continue;
    ++touching;
    double found = 0;
    if (edge_depths(a, moved, room, found))
      worst = std::max(worst, std::abs(found / expected - 1));
    else
      ++left;
  }
  CHECK(worst < within);
  return 1e3 * left / of.pairs;
}

}  // namespace

TEST_CASE("contact of boxes from edges equals contact from cutting") {
  CHECK(check_pairs({21, 5000, 1e-4}, 1e-9, a_box) < 1);
  CHECK(check_pairs({22, 5000, 1e-2}, 1e-10, a_box) < 10);
}

TEST_CASE("... for other solids with few faces") {
  CHECK(check_pairs({23, 5000, 1e-4}, 1e-9, of_few_faces) < 50);
  CHECK(check_pairs({24, 5000, 1e-2}, 1e-10, of_few_faces) < 100);
}

TEST_CASE("... at deep overlap, where few have at most four nearest faces") {
  CHECK(check_pairs({25, 3000, 0.1}, 1e-10, a_box) < 500);
  CHECK(check_pairs({26, 3000, 0.5}, 1e-10, of_few_faces) < 1000);
}

TEST_CASE("... and far from the origin, within the rounding of the corners") {
  CHECK(check_pairs({27, 2000, 1e-3, Vec3(1e3, -2e3, 5e2)}, 1e-6, a_box) < 5);
}

TEST_CASE("the energy of a contact is the same from its triangles and from the cells of its volume") {
  CHECK(check_energies({31, 2000, 1e-4}, 1e-9, a_box) < 20);
  CHECK(check_energies({32, 2000, 1e-2}, 1e-10, a_box) < 100);
  CHECK(check_energies({33, 2000, 1e-2}, 1e-10, of_few_faces) < 300);
}

TEST_CASE("... at deep overlap too, or there is none from the triangles") {
  CHECK(check_energies({34, 1000, 0.1}, 1e-10, a_box) < 900);
  CHECK(check_energies({35, 1000, 0.5}, 1e-10, of_few_faces) <= 1000);
}
