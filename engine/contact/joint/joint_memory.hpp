// Memory of two solids whose faces are bonded by mortar, for each patch of the shared area.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/space.hpp"

namespace trilith {

struct JointPlan;

/// Number of patches of a joint along each of its two axes, and in total.
inline constexpr int patches_along = 4;
inline constexpr int most_patches = patches_along * patches_along;
/// Points of a patch that soften and slide separately.
inline constexpr int patch_points = 4;

/// An overlap that is linear over the plane of a joint; negative where the faces are apart.
struct LinearOverlap {
  double at = 0;              ///< at the origin of the joint [m]
  Vec2 slope = Vec2::Zero();  ///< [m/m]

  [[nodiscard]] double operator()(const Vec2& p) const { return at + slope.dot(p); }
  [[nodiscard]] LinearOverlap plus(const LinearOverlap& o, double times = 1) const {
    return {at + times * o.at, slope + times * o.slope};
  }
  [[nodiscard]] LinearOverlap raised(double by) const { return {at + by, slope}; }
};

/// One number for each point of a patch.
using PatchNumbers = std::array<double, patch_points>;

/// History of one patch. Each of its points carries shear by its own spring and slider, along the joint's axes.
struct PatchMemory {
  PatchNumbers elastic_x{}, elastic_y{};  ///< force of the first body on the second, of the springs [N]
  PatchNumbers total_x{}, total_y{};      ///< the same with damping [N]
  PatchNumbers damage{};                  ///< lost share of the strength
  double active = 0;                      ///< area that carries shear [m2]
  double slip = 0;                        ///< accumulated sliding distance, mean of its points [m]
  double crushed = 0;                     ///< crushed depth of its mortar [m]
  double opened = 0;                      ///< opening by the slip of the last step [m]

  /// Calls f with each number but `crushed` and `opened` in turn. `Self`: const or not.
  template <class Self, class F>
  static void fields(Self& m, F&& f) {
    for (auto* numbers : {&m.elastic_x, &m.elastic_y, &m.total_x, &m.total_y, &m.damage})
      for (auto& v : *numbers) f(v);
    f(m.active), f(m.slip);
  }
};

/// History of a joint. Without a plan there is no joint, and the solids are in ordinary contact. An intact joint stores
/// no patches, neither here nor in its plan, because nearly all joints are intact. divide() creates them.
struct JointMemory {
  std::shared_ptr<const JointPlan> plan;  ///< its geometry when it set
  LinearOverlap moved;                    ///< overlap gained from setting to the last step
  std::uint32_t bonds = 0;                ///< bit k: patch k is at least partly bonded
  /// Intact: nothing has cracked or slid, so the shear is linear over the whole joint. `elastic` and, with damping,
  /// `total` hold the force along both axes and the couple about the centroid [N], [N m].
  bool sound = false;
  Vec3 elastic = Vec3::Zero(), total = Vec3::Zero();
  std::vector<PatchMemory> patch;  ///< [patch] unused while the joint is intact

  [[nodiscard]] bool empty() const { return plan == nullptr; }
  [[nodiscard]] bool bonded(int k) const { return (bonds >> k & 1U) != 0; }
  /// Largest crushed depth of a patch [m].
  [[nodiscard]] double most_crushed() const {
    double most = 0;
    if (sound) return most;
    for (const PatchMemory& p : patch) most = std::max(most, p.crushed);
    return most;
  }
  /// Largest opening of a patch by the slip of the last step [m].
  [[nodiscard]] double most_opened() const {
    double most = 0;
    if (sound) return most;
    for (const PatchMemory& p : patch) most = std::max(most, p.opened);
    return most;
  }
};

}  // namespace trilith
