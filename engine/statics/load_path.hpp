// The equilibria of a structure as its loads are scaled by a factor, past limit points and snap-back.
//
//   F(x, factor) = weight + factor q(x) + resist + respond = 0,     g(x, factor) = 0
//
// are solved together by Newton's method, each step on from the last equilibrium by one of three conditions g:
//
//   load          factor = given                       ends at the first limit point
//   displacement  mean of some displacements = given    past limit points, not past snap-back
//   arc           d . S d = l^2                         past both: d is the way from the last equilibrium, S the masses
//                                                       over their sum, so l [m] is a mean of the way
//
// The arc is Crisfield's cylinder ("A fast incremental/iterative solution procedure that handles snap-through", Comput.
// Struct. 13, 1981), made linear with the rest, so that there are no two roots to choose between (Schweizerhof and
// Wriggers, "Consistent linearization for path following methods in nonlinear FE analysis", Comput. Methods Appl. Mech.
// Engng 59, 1986); a step that turns back by more than a right angle is cut. Masses weigh rotations by radii of
// gyration (on such weights: Ritto-Correa and Camotim, "On the arc-length and other quadratic control methods", Comput.
// Struct. 86, 2008).
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "assembly/tangent/dof_graph.hpp"
#include "model/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// `dissipation`, the energy given off, is used by an arc where softening turns the path sharply.
enum class PathControl { load, displacement, arc, dissipation };

/// A part of the displacement that is followed: of this freedom, times its weight.
struct FollowedFreedom {
  Freedom freedom;
  double weight = 1;
};

/// An equilibrium on the path.
struct PathPoint {
  double factor = 0;
  double displacement = 0;  ///< weighed sum of the followed freedoms since the path began [m] or [rad]
  double length = 0;        ///< of the path up to here, by arcs [m]
  int iterations = 0;       ///< that led here
  std::size_t events = 0;   ///< how many of LoadPath::events had happened by then
};

/// Where the factor turns: the top or bottom of the parabola through the three points about it.
struct LimitPoint {
  double factor = 0, displacement = 0;
  bool is_highest = false;
};

template <int D = 2>
struct LoadPathOptions {
  PathControl control = PathControl::arc;
  std::string loads;  ///< name of those that are scaled; empty: all point and face loads. Steady ones are kept
  std::vector<FollowedFreedom> followed;
  double begin = 0;     ///< factor at which the path begins, at rest
  double first = 0;     ///< first step: of factor, displacement or arc; below 0: that way
  double longest = 0;   ///< longest step; 0: ten times the first
  double shortest = 0;  ///< shortest step; 0: 1e-5 of the first
  double to = std::numeric_limits<double>::infinity();  ///< factor or displacement to end at, where that is controlled
  int most_points = 1000;
  double tolerance = 1e-8;  ///< as in EquilibriumOptions
  int most_iterations = 15;
  int wanted_iterations = 4;  ///< steps are made longer or shorter by the root of this over the iterations they take
  /// Called at every point, the first one too, with the state there (committed); the path ends where it gives false.
  std::function<bool(const PathPoint&, const State<D>&)> goes_on;
};

/// How a path ended: where it was asked to; after the most points; no step however short leads on; no rest at its
/// begin; nothing carries the loads any more.
enum class PathEnd { arrived, most_points, stuck, no_rest, no_resistance };

struct LoadPath {
  PathEnd end = PathEnd::no_rest;
  std::vector<PathPoint> points;
  std::vector<LimitPoint> limits;  ///< in the order of the path
  int iterations = 0;              ///< of all steps, failed ones too
  int cuts = 0;
  double left = 0;  ///< of the last try, see Equilibrium
  int worst = -1;
  int jumps = 0;  ///< steps over which a brittle break left no equilibrium between its ends
  std::vector<Event> events;
};

/// Follows the path from rest at options.begin. `state` becomes that of the last point, as find_equilibrium leaves one;
/// it belongs to loads scaled by that point's factor (scale_loads). Where there is no rest to begin with it is as it
/// was. Throws InputError for options out of range, where no load has the name, and as find_equilibrium does.
template <int D>
LoadPath follow_loads(const Model<D>& model, State<D>& state, const LoadPathOptions<D>& options);

}  // namespace trilith
