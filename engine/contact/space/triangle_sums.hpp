// Sums over pressed triangles in lanes: forces, moments, power and second moments of the pressure, for springs and
// damping.
//
// Input: integrals of the pressure of four triangles, without and with damping; their direction of push on b. Output:
// sums. Springs push along the normals of the faces, and in total along some n. If other pieces of the same two bodies
// press at the same position, n is the direction of their total. The motion v . n along n is damped. A face whose push
// is along u closes at c = -m (v . n), with m = u . n where positive, and its damping acts on b along n with the factor
// m. So sliding across n is not braked, and any motion loses energy.
#pragma once

#include <array>

#include "base/simd/lane_vectors.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// Sums over the triangles of one pair of solids, over half the stiffness. Moments are about the origin of arms.
struct PressedSums {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();            ///< on b
  Vec3 damping = Vec3::Zero(), damping_moment = Vec3::Zero();  ///< the part due to damping
  double damped = 0;                                           ///< power dissipated by damping
  double pressure = 0;                                         ///< integral of the pressure's magnitude
  Vec3 arm = Vec3::Zero();                                     ///< integral of the pressure times the arm
  std::array<double, 6> arm_second{};   ///< integral of the pressure times the arm's products: xx, yy, zz, xy, yz, zx
  double area = 0;                      ///< of both sides
  Vec3 area_arm = Vec3::Zero();         ///< integral of the arm over the area
  std::array<double, 6> area_second{};  ///< integral of the arm's products over the area
  double depth = 0;                     ///< largest depth [m]
};

/// The sums of one pair, and the origin of their arms [m].
struct PairSums {
  PressedSums sums;
  Vec3 origin;
};

/// Motion of b relative to a.
struct ClosingMotion {
  Vec3 velocity, spin;  ///< at the origin of arms [m/s], [rad/s]
};

/// The component of the motion along the push of the springs.
struct alignas(32) DampedMotion {
  Triple<Lanes> normal, turning;  ///< n; n x w, as n . (w x r) = r . (n x w)
  Lanes moving;                   ///< n . v [m/s]

  /// `push` of any length; zero means no resultant pressure.
  TRILITH_INLINE DampedMotion(const Vec3& push, const ClosingMotion& motion) {
    const double size = push.norm();
    const Vec3 n = size > 0 ? Vec3(push / size) : Vec3(Vec3::Zero()), t = cross(n, motion.spin);
    normal = four_of(n, n, n, n), turning = four_of(t, t, t, t);
    moving = Lanes{} + n.dot(motion.velocity);
  }
  /// u . n.
  [[nodiscard]] TRILITH_INLINE Lanes along(const FourTriangles& in) const { return in.sign * in.normal.dot(normal); }
  /// Closing speeds at the corners [m/s].
  [[nodiscard]] TRILITH_INLINE std::array<Lanes, 3> closing(const FourTriangles& in, const Lanes& along) const {
    const Lanes facing = larger<Lanes>(along, Lanes{});
    const auto at = [&](std::size_t k)
                        TRILITH_INLINE_LAMBDA { return Lanes(-facing * (moving + in.arm[k].dot(turning))); };
    return {at(0), at(1), at(2)};
  }
};

/// Areas of the triangles [m2].
TRILITH_INLINE Lanes area_of(const FourTriangles& in) {
  return 0.5 * in.normal.dot(cross(in.arm[1] - in.arm[0], in.arm[2] - in.arm[0]));
}

/// Products of vector components, in the order of PressedSums.
struct ArmProducts {
  std::array<Lanes, 6> of;
  TRILITH_INLINE ArmProducts(const Triple<Lanes>& a, const Triple<Lanes>& b)
      : of{a.x * b.x, a.y * b.y, a.z * b.z, a.x * b.y, a.y * b.z, a.z * b.x} {}
};

/// Integrals over triangles of a pressure over kn, and of its product with arm and closing speed.
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

  /// Initialised one by one: as one block of memory, the stores would stall the loads that follow.
  TRILITH_INLINE TriangleSums() {
    const Lanes none{};
    for (Triple<Lanes>* v : {&moment, &turning, &arm, &area_arm}) v->x = none, v->y = none, v->z = none;
    force = none, damping = none, power = none, pressure = none, area = none, depth = none;
    for (std::array<Lanes, 6>* of : {&arm_second, &area_second}) {
      (*of)[0] = none, (*of)[1] = none, (*of)[2] = none;
      (*of)[3] = none, (*of)[4] = none, (*of)[5] = none;
    }
  }
  TRILITH_INLINE void add_pressure(const FourTriangles& in, const Lanes& along, const TrianglePressure& springs,
                                   const TrianglePressure& total) {
    const Lanes facing = larger<Lanes>(along, Lanes{});
    force += along * total.force, moment = moment + cross(springs.first, in.normal * in.sign);
    damping += facing * (total.force - springs.force), turning = turning + (total.first - springs.first) * facing;
    power += total.power - springs.power;
    pressure += total.force, arm = arm + total.first;
  }
  /// The same for triangles whose springs count elsewhere.
  TRILITH_INLINE void add_damped(const Lanes& along, const TrianglePressure& total) {
    const Lanes facing = larger<Lanes>(along, Lanes{});
    force += along * total.force;
    damping += facing * total.force, turning = turning + total.first * facing;
    power += total.power;
    pressure += total.force, arm = arm + total.first;
  }
  /// Triangles whose corners' arms sum to `u`, with their areas over 12.
  TRILITH_INLINE void add_area(const FourTriangles& in, const Triple<Lanes>& u, const Lanes& twelfth) {
    area += 12.0 * twelfth, area_arm = area_arm + u * (4.0 * twelfth);
    const ArmProducts uu(u, u), pp(in.arm[0], in.arm[0]), qq(in.arm[1], in.arm[1]), rr(in.arm[2], in.arm[2]);
    for (std::size_t k = 0; k < 6; ++k) area_second[k] += twelfth * (uu.of[k] + pp.of[k] + qq.of[k] + rr.of[k]);
  }
};

/// Force on b of the springs of all triangles, over half the stiffness [m3].
Vec3 spring_force(std::span<const FourTriangles> triangles);

/// Sums over all lanes; `normal`: direction of the damped motion. `push`: the springs' force if its direction differs,
/// else nullptr.
PressedSums over_lanes(const TriangleSums& sums, const Triple<Lanes>& normal, const Vec3* push);

struct SolidPressure;
/// The pressure from such sums, with arms from `origin` [m]: moments about the centre of pressure, and second moments
/// of area and pressure. `k` is half of the stiffness [Pa/m], because the faces of the other solid add the other half.
SolidPressure pressure_of_sums(const Vec3& origin, double k, const PressedSums& sums);

}  // namespace trilith
