// What two solids remember whose faces mortar holds together: patch by patch of the area they share.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#include "base/space.hpp"

namespace trilith {

struct JointPlan;

/// Patches that a joint is divided into along each of its two axes, and in all.
inline constexpr int patches_along = 4;
inline constexpr int most_patches = patches_along * patches_along;
/// Places of a patch that soften and slide each for itself.
inline constexpr int patch_points = 4;

/// An overlap that is linear over the plane of a joint; below 0 where the faces stand apart.
struct LinearOverlap {
  double at = 0;              ///< at the origin of the joint [m]
  Vec2 slope = Vec2::Zero();  ///< [m per m]

  [[nodiscard]] double operator()(const Vec2& p) const { return at + slope.dot(p); }
  [[nodiscard]] LinearOverlap plus(const LinearOverlap& o, double times = 1) const {
    return {at + times * o.at, slope + times * o.slope};
  }
  [[nodiscard]] LinearOverlap raised(double by) const { return {at + by, slope}; }
};

/// One number for each place of a patch.
using PatchNumbers = std::array<double, patch_points>;

/// History of one patch. Each of its places carries shear by a spring and a slider of its own, along the joint's axes.
struct PatchMemory {
  PatchNumbers elastic_x{}, elastic_y{};  ///< the first body drives the second by it, of the springs [N]
  PatchNumbers total_x{}, total_y{};      ///< ... with damping [N]
  PatchNumbers damage{};                  ///< share of the strength that is lost
  double active = 0;                      ///< area that carries shear [m2]
  double slip = 0;                        ///< accumulated sliding distance, mean of its places [m]

  /// Calls f with every number in turn. `Self`: of either constness.
  template <class Self, class F>
  static void fields(Self& m, F&& f) {
    for (auto* numbers : {&m.elastic_x, &m.elastic_y, &m.total_x, &m.total_y, &m.damage})
      for (auto& v : *numbers) f(v);
    f(m.active), f(m.slip);
  }
};

/// History of a joint. Without a plan there is none, and the solids touch as any others do.
struct JointMemory {
  std::shared_ptr<const JointPlan> plan;  ///< how it was laid; never changes
  LinearOverlap moved;                    ///< overlap gained since the mortar set, as of the last step
  std::uint32_t bonds = 0;                ///< bit k: patch k holds its bond, or some of it
  /// Nothing has cracked or slid yet, so that the shear is linear over all of the joint: `elastic` and `total`, with
  /// damping, have the force along both axes and the couple about the middle [N], [N m], and the patches nothing.
  bool sound = false;
  Vec3 elastic = Vec3::Zero(), total = Vec3::Zero();
  std::array<PatchMemory, most_patches> patch;
  std::array<double, most_patches> crushed{};  ///< depth by which the mortar of each patch is crushed [m]

  [[nodiscard]] bool empty() const { return plan == nullptr; }
  [[nodiscard]] bool bonded(int k) const { return (bonds >> k & 1U) != 0; }
  /// The greatest depth by which some patch is crushed [m].
  [[nodiscard]] double most_crushed() const { return *std::max_element(crushed.begin(), crushed.end()); }
};

}  // namespace trilith
