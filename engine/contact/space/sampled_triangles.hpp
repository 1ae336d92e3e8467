// Pressures that are sampled at points of triangles, four triangles at a time, for laws whose pressure is not
// proportional to the overlap.
//
// Input: triangles with the depth at their corners (geometry/space/triangle_lanes.hpp), the law, and the damped motion.
// Output: sums as in contact/space/triangle_sums.hpp.
#pragma once

#include <array>
#include <cstddef>

#include "contact/space/triangle_sums.hpp"
#include "law/contact/point_law.hpp"

namespace trilith {

/// Integrals over kn of a pressure sampled at points of the triangles: six points, exact to degree 4 (Dunavant 1985, as
/// in law/contact/power.hpp).
struct alignas(32) SampledPressure : TrianglePressure {
  TRILITH_INLINE SampledPressure() {
    const Lanes none{};
    force = none, power = none, first = {none, none, none};
  }
  TRILITH_INLINE void add(const Lanes& at, const Lanes& closing, const Triple<Lanes>& arm) {
    force += at, power += at * closing, first = first + arm * at;
  }
};

/// Two orbits of three points: barycentric coordinate of the own corner, of the other two, and weight.
inline constexpr std::array<std::array<double, 3>, 2> sample_rule{
    {{0.108103018168070, 0.445948490915965, 0.223381589678011},
     {0.816847572980459, 0.091576213509771, 0.109951743655322}}};

/// Force on b of the springs of four triangles, over half the stiffness [m3].
template <class K>
Vec3 sampled_push(const FourTriangles& in, const K& law) {
  Lanes springs{};
  for (const auto& [own, other, weight] : sample_rule)
    for (const std::size_t i : {0U, 1U, 2U})
      springs += weight *
                 effective_of(law, Lanes(own * in.depth[i] + other * (in.depth[(i + 1) % 3] + in.depth[(i + 2) % 3])));
  const Triple<Lanes> push = in.normal * (in.sign * area_of(in) * springs);
  return {push.x[0] + push.x[1] + push.x[2] + push.x[3], push.y[0] + push.y[1] + push.y[2] + push.y[3],
          push.z[0] + push.z[1] + push.z[2] + push.z[3]};
}

/// Adds the pressure of four triangles with its damping, and their area.
template <class K>
TRILITH_INLINE void sum_sampled(const FourTriangles& in, const K& law, const DampedMotion& motion, TriangleSums& sums) {
  const Lanes area = area_of(in), along = motion.along(in);
  const std::array<Lanes, 3> closing = motion.closing(in, along);
  SampledPressure springs, total;
  for (const auto& [own, other, weight] : sample_rule)
    for (const std::size_t i : {0U, 1U, 2U}) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Lanes here = weight * area, speed = own * closing[i] + other * (closing[j] + closing[k]);
      const Triple<Lanes> arm = in.arm[i] * (Lanes{} + own) + (in.arm[j] + in.arm[k]) * (Lanes{} + other);
      const Lanes spring = effective_of(law, Lanes(own * in.depth[i] + other * (in.depth[j] + in.depth[k])));
      const Lanes pressed = here * larger<Lanes>(spring + law.beta * speed, Lanes{});
      springs.add(here * spring, speed, arm), total.add(pressed, speed, arm);
      const ArmProducts products(arm, arm);
      for (std::size_t m = 0; m < 6; ++m) sums.arm_second[m] += pressed * products.of[m];
    }
  sums.add_pressure(in, along, springs, total);
  sums.add_area(in, in.arm[0] + in.arm[1] + in.arm[2], area * (1.0 / 12));
  for (const Lanes& d : in.depth) sums.depth = larger<Lanes>(sums.depth, d);
}

}  // namespace trilith
