// Equilibria that a stage without motion has come by, to be told as it is.
#pragma once

#include <vector>

#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// How long a stage lasts that follows a load path [s]. Nothing moves by itself on the path, so that time is only the
/// coordinate of its points there: each has the share of it that its share of the path's length is.
inline constexpr double path_duration = 1;

/// An equilibrium.
template <int D>
struct Waypoint {
  State<D> state;
  double factor = 0;               ///< of the loads that are scaled
  double length = 0;               ///< of the path up to here, by arcs [m]
  std::vector<Event> events = {};  ///< since the point before
};

/// Loads that a path has scaled, at factor 1, and the points it came by from its begin to its end.
template <int D>
struct LoadWay {
  std::vector<PointLoad<D>> loads;
  std::vector<Waypoint<D>> points;

  /// How long the stage lasts [s]; 0 for a path without length.
  [[nodiscard]] double duration() const { return points.back().length > 0 ? path_duration : 0; }
  /// Time of a point since the stage began [s]: it grows from point to point. The last point is as long before the end
  /// of the stage, where rest is found once more, as points are apart in the mean.
  [[nodiscard]] double time_of(std::size_t point) const {
    if (!(points.back().length > 0)) return 0;
    const double count = static_cast<double>(points.size());
    return path_duration * (points[point].length / points.back().length) * (count / (count + 1));
  }
};

}  // namespace trilith
