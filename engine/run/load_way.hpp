// Equilibria on a load path, which a stage without motion reports in sequence.
#pragma once

#include <memory>
#include <vector>

#include "edit/crack_search.hpp"
#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Duration of a stage that follows a load path [s]. Nothing moves by itself on the path, so time is only a coordinate
/// of its points. The time of a point is its share of the path length.
inline constexpr double path_duration = 1;

/// An equilibrium.
template <int D>
struct Waypoint {
  State<D> state;
  double factor = 0;               ///< load factor of the scaled loads
  double length = 0;               ///< arc length of the path up to here [m]
  std::vector<Event> events = {};  ///< events after the previous point
  /// Bodies that crack at this point, after it is reported: sets that are divided one after the other.
  std::vector<std::vector<Crack<D>>> cracks = {};
  std::vector<PointLoad<D>> loads = {};  ///< the scaled loads at factor 1 from these cracks on
};

/// Loads that a path has scaled, at factor 1, and the points of the path.
template <int D>
struct LoadWay {
  std::vector<PointLoad<D>> loads;
  std::vector<Waypoint<D>> points;
  /// State at the end of a path on which bodies crack, at whose start the stage begins; none: the stage begins at it.
  std::shared_ptr<const State<D>> end = nullptr;

  /// Duration of the stage [s]; 0 for a path without length.
  [[nodiscard]] double duration() const { return points.back().length > 0 ? path_duration : 0; }
  /// Time of a point after the start of the stage [s], increasing from point to point. The last point lies before the
  /// end of the stage by the mean interval of the points. At the end, rest is found once more.
  [[nodiscard]] double time_of(std::size_t point) const {
    if (!(points.back().length > 0)) return 0;
    const double count = static_cast<double>(points.size());
    return path_duration * (points[point].length / points.back().length) * (count / (count + 1));
  }
};

/// Repeats the shifts of motions and load curves by a path that was reported, with the same rounding, and sets its
/// scaled loads. The model, with the parts of all bodies that have cracked, is then as it was at the end of the path.
template <int D>
void postpone_by_way(Model<D>& model, const LoadWay<D>& way);

}  // namespace trilith
