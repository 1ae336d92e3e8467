// What pressed triangles come to, a lane each: forces, moments, power and how the pressure lies, springs and damping.
//
// Comes in: of four triangles the integrals of the pressure of springs and of that with its damping; which way they
// push b. Goes out: sums. Springs push along the normals of the faces, and together along some n; where other pieces of
// the same two bodies press at the same place n is the direction of all of them. What is damped is the motion along
// that, v . n: a face whose push is along u closes at c = -m (v . n), m = u . n where that is above 0, and
// its damping acts on b along n with the share m. So what slides across n is not braked, and any motion loses energy.
#pragma once

#include <array>

#include "base/simd/lane_vectors.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// Sums over triangles in the room of one pair of solids, all over half the stiffness. Moments are about the point that
/// arms are from.
struct PressedSums {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();            ///< on b
  Vec3 damping = Vec3::Zero(), damping_moment = Vec3::Zero();  ///< the part that damping adds
  double damped = 0;                                           ///< power that damping takes
  double pressure = 0;                                         ///< integral of the pressure, whatever way it acts
  Vec3 arm = Vec3::Zero();                                     ///< ... of the pressure times the arm
  std::array<double, 6> arm_second{};                          ///< ... and times its products: xx, yy, zz, xy, yz, zx
  double area = 0;                                             ///< of both sides
  Vec3 area_arm = Vec3::Zero();                                ///< integral of the arm over it
  std::array<double, 6> area_second{};                         ///< ... of its products
  double depth = 0;                                            ///< greatest [m]
};

/// How b moves against a.
struct ClosingMotion {
  Vec3 velocity, spin;  ///< at the origin of arms [m/s], [rad/s]
};

/// The part of it along the push of the springs.
struct alignas(32) DampedMotion {
  Triple<Lanes> normal, turning;  ///< n; n x w, as n . (w x r) = r . (n x w)
  Lanes moving;                   ///< n . v [m/s]

  /// `push` of any length; where it is zero nothing is pressed on the whole.
  TRILITH_INLINE DampedMotion(const Vec3& push, const ClosingMotion& motion) {
    const double size = push.norm();
    const Vec3 n = size > 0 ? Vec3(push / size) : Vec3(Vec3::Zero()), t = cross(n, motion.spin);
    normal = four_of(n, n, n, n), turning = four_of(t, t, t, t);
    moving = Lanes{} + n.dot(motion.velocity);
  }
  /// u . n.
  [[nodiscard]] TRILITH_INLINE Lanes along(const FourTriangles& in) const { return in.sign * in.normal.dot(normal); }
  /// At the corners [m/s].
  [[nodiscard]] TRILITH_INLINE std::array<Lanes, 3> closing(const FourTriangles& in, const Lanes& along) const {
    const Lanes facing = larger<Lanes>(along, Lanes{});
    const auto at = [&](std::size_t k) { return Lanes(-facing * (moving + in.arm[k].dot(turning))); };
    return {at(0), at(1), at(2)};
  }
};

/// Of the triangles [m2].
TRILITH_INLINE Lanes area_of(const FourTriangles& in) {
  return 0.5 * in.normal.dot(cross(in.arm[1] - in.arm[0], in.arm[2] - in.arm[0]));
}

/// Products of vectors, in the order of PressedSums.
struct ArmProducts {
  std::array<Lanes, 6> of;
  TRILITH_INLINE ArmProducts(const Triple<Lanes>& a, const Triple<Lanes>& b)
      : of{a.x * b.x, a.y * b.y, a.z * b.z, a.x * b.y, a.y * b.z, a.z * b.x} {}
};

/// Integrals over triangles of a pressure over kn, and of it times the arm and the closing speed.
struct alignas(32) TrianglePressure {
  Lanes force, power;
  Triple<Lanes> first;
};

/// PressedSums in each lane.
struct alignas(32) TriangleSums {
  Triple<Lanes> moment, turning, arm, area_arm;
  Lanes force, damping, power,  // the first two along n
      pressure, area, depth;
  std::array<Lanes, 6> arm_second, area_second;

  /// Each for itself: set as one stretch of memory, they would be waited for.
  TRILITH_INLINE TriangleSums() {
    const Lanes none{};
    for (Triple<Lanes>* v : {&moment, &turning, &arm, &area_arm}) v->x = none, v->y = none, v->z = none;
    force = none, damping = none, power = none, pressure = none, area = none, depth = none;
    for (std::size_t k = 0; k < 6; ++k) arm_second[k] = none, area_second[k] = none;
  }
  TRILITH_INLINE void add_pressure(const FourTriangles& in, const Lanes& along, const TrianglePressure& springs,
                                   const TrianglePressure& total) {
    const Lanes facing = larger<Lanes>(along, Lanes{});
    force += along * total.force, moment = moment + cross(springs.first, in.normal * in.sign);
    damping += facing * (total.force - springs.force), turning = turning + (total.first - springs.first) * facing;
    power += total.power - springs.power;
    pressure += total.force, arm = arm + total.first;
  }
  /// Triangles whose corners' arms sum to `u`, with their areas over 12.
  TRILITH_INLINE void add_area(const FourTriangles& in, const Triple<Lanes>& u, const Lanes& twelfth) {
    area += 12.0 * twelfth, area_arm = area_arm + u * (4.0 * twelfth);
    const ArmProducts uu(u, u), pp(in.arm[0], in.arm[0]), qq(in.arm[1], in.arm[1]), rr(in.arm[2], in.arm[2]);
    for (std::size_t k = 0; k < 6; ++k) area_second[k] += twelfth * (uu.of[k] + pp.of[k] + qq.of[k] + rr.of[k]);
  }
};

/// What the springs of all triangles push b by, over half the stiffness [m3].
Vec3 spring_force(std::span<const FourTriangles> triangles);

/// Over all lanes; `normal` that of the damped motion. `push`: that of the springs where they do not push along it,
/// else nullptr.
PressedSums over_lanes(const TriangleSums& sums, const Triple<Lanes>& normal, const Vec3* push);

struct SolidPressure;
/// What such sums come to, with arms from `origin` [m] and `k` half of the stiffness [Pa/m], as the faces of the other
/// solid bring the other half: moments about the centre of pressure, and how area and pressure are spread.
SolidPressure pressure_of_sums(const Vec3& origin, double k, const PressedSums& sums);

}  // namespace trilith
