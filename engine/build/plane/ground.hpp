// Ground bodies between a surface line and a level base.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/block.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// A level stretch of ground.
struct GroundStep {
  double from = 0;   ///< x of its left end [m]; it extends to the next step
  double level = 0;  ///< y of its surface [m]

  static constexpr auto keys() {
    using K = KeysOf<GroundStep>;
    return std::tuple(K::Number{&GroundStep::from, "from", "m", "x of its left end", any_number, must_be_given},
                      K::Number{&GroundStep::level, "level", "m", "y of its surface", any_number, must_be_given});
  }
};

/// A ground body under a surface line.
struct GroundProfile {
  std::string name = "ground";
  std::vector<Vec2> surface = {};           ///< points from left to right [m]; two with the same x make a vertical step
  double base_level = 0;                    ///< y of the bottom [m], below every surface point
  std::vector<GroundStep> steps = {};       ///< instead of `surface`, with `to`, for parts()
  std::optional<double> to = std::nullopt;  ///< end of the last step [m]

  static constexpr std::string_view kind = "ground";
  static constexpr std::string_view sentence = "ground under a surface line";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<GroundProfile>;
    return std::tuple(
        K::Points{&GroundProfile::surface, "surface", "top of the ground, from left to right; or steps", Preset{}},
        K::List<GroundStep>{&GroundProfile::steps, "steps", "step", "{ { from = , level = }, ... }"},
        K::MaybeNumber{&GroundProfile::to, "to", "m", "end of the last step"},
        K::Number{&GroundProfile::base_level, "base_level", "m", "bottom of the ground", any_number, must_be_given},
        OneOf{"surface", "steps", "a list of points {{x, y}, ...}, or steps", ""},
        Needs{"steps", "to", "a number in m, the end of the last step"});
  }
  /// build_ground_profile.
  [[nodiscard]] BuiltParts parts() const;
};

/// One part, group "ground": the base from left to right, then the surface from right to left. Edge 0 is the base, edge
/// 1 the right side, the last edge the left side. Throws InputError for fewer than 2 points, points that are not sorted
/// by x, a base that is not below the surface, or points that form no simple polygon.
PolygonPart build_ground_profile(const GroundProfile& profile);

/// Surface points of level steps, from left to right, ending at `end`, for use in a GroundProfile. Neighbours of equal
/// level are joined. Throws InputError for no steps or steps out of order.
std::vector<Vec2> stepped_surface(const std::vector<GroundStep>& steps, double end);

}  // namespace trilith
