// Equilibria of a structure while its loads are scaled by a factor, past limit points and snap-back.
//
//     F(x, factor) = weight + factor q(x) + internal forces + contact forces = 0,     g(x, factor) = 0
//
// are solved together by Newton's method. Each step starts at the last equilibrium and uses one of three conditions g:
//
//     load          factor = given                       ends at the first limit point
//     displacement  mean of some displacements = given    past limit points, not past snap-back
//     arc           d . S d = l^2                         past both; d: increment from the last equilibrium, S: masses
//                                                         over their sum, so l [m] is a mean displacement
//
// The arc is Crisfield's cylinder ("A fast incremental/iterative solution procedure that handles snap-through", Comput.
// Struct. 13, 1981), linearised together with the equations. So there are no two roots to choose between (Schweizerhof
// and Wriggers, "Consistent linearization for path following methods in nonlinear FE analysis", Comput. Methods Appl.
// Mech. Engng 59, 1986). A step that turns back by more than a right angle is cut. Masses weight rotations by radii of
// gyration (on such weights: Ritto-Correa and Camotim, "On the arc-length and other quadratic control methods", Comput.
// Struct. 86, 2008).
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "assembly/node_forces.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "model/event/event.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An arc uses `dissipation`, control by the dissipated energy, where softening turns the path sharply.
enum class PathControl { load, displacement, arc, dissipation };

/// A part of the followed displacement: this degree of freedom, times its weight.
struct FollowedFreedom {
  Freedom freedom;
  double weight = 1;
};

/// An equilibrium on the path.
struct PathPoint {
  double factor = 0;
  double displacement = 0;  ///< weighted sum of the followed displacements from the start of the path [m] or [rad]
  double length = 0;        ///< arc length of the path up to here [m]
  int iterations = 0;       ///< iterations of the step to this point
  std::size_t events = 0;   ///< number of entries of LoadPath::events up to here
};

/// A limit point: vertex of the parabola through the three points around it.
struct LimitPoint {
  double factor = 0, displacement = 0;
  bool is_highest = false;
};

template <int D = 2>
struct LoadPathOptions {
  PathControl control = PathControl::arc;
  std::string loads;  ///< name of the scaled loads; empty: all point and face loads. Steady loads remain constant
  std::vector<FollowedFreedom> followed;
  double begin = 0;     ///< factor at the start of the path, at rest
  double first = 0;     ///< first step of factor, displacement or arc; negative in the opposite sense
  double longest = 0;   ///< longest step; 0: ten times the first
  double shortest = 0;  ///< shortest step; 0: 1e-5 of the first
  double to = std::numeric_limits<double>::infinity();  ///< factor or displacement at the end, if it is controlled
  int most_points = 1000;   ///< steps that are shortened for their accuracy count by their share of the first one
  double tolerance = 1e-8;  ///< as in EquilibriumOptions
  int most_iterations = 15;
  int wanted_iterations = 4;  ///< the step length is scaled by the square root of this over the iterations taken.
  /// Called at every point, including the first one, with the committed state; the path ends when it returns false.
  std::function<bool(const PathPoint&, const State<D>&)> goes_on;
  /// Called at each iteration and at each trial position; the path ends at its last point when it returns true. Empty:
  /// never stopped.
  std::function<bool()> is_stopped;
  /// Largest share of a strength that the sections of bodies use at an equilibrium [1]. A step that ends above 1 is
  /// shortened, and the path ends as `cracks` at the first point above share_at_crack. Empty: no body cracks.
  std::function<double(const Model<D>&, const State<D>&, const Work<D>&)> strength_used;
  // Of a path that goes on after bodies have cracked (run/crack_path.hpp).
  bool finds_again = false;        ///< rest is found at the same followed displacement, at another factor if necessary
  double displacement = 0;         ///< followed displacement at the start
  std::vector<Dofs<D>> last_step;  ///< [node] displacement of the last step: the sense of the path; or empty
  double rise = 0;                 ///< change of the factor in that step
};

/// Bodies are divided from this share of their strength on. The joint of the parts then begins before its peak.
inline constexpr double share_at_crack = 0.999;

/// End of a path: at the requested value; after the largest number of points; no step converges, however short; no rest
/// at its start; no resistance to the loads any more; stopped. `cracks`: a section is at its strength.
enum class PathEnd { arrived, most_points, stuck, no_rest, no_resistance, stopped, cracks };

struct LoadPath {
  PathEnd end = PathEnd::no_rest;
  std::vector<PathPoint> points;
  std::vector<LimitPoint> limits;  ///< in the order of the path
  int iterations = 0;              ///< of all steps, including failed ones
  int cuts = 0;
  double left = 0;  ///< of the last try, see Equilibrium
  int worst = -1;
  int jumps = 0;      ///< steps across a brittle break without an equilibrium between their ends
  double missed = 0;  ///< work that the shortest steps miss, over the largest factor [m], see most_path_error
  int searched = 0;   ///< points found by a search for rest at a given displacement
  int snaps = 0;      ///< points across a snap, where no rest lies next to the point before
  std::vector<Event> events;
};

/// Largest mean deviation of the factor from the straight line between two points, as a share of the largest factor so
/// far. Arcs of structures of several bodies are shortened to it.
inline constexpr double most_path_error = 0.005;

/// Follows the path from rest at options.begin. `state` becomes the state of the last point, as after find_equilibrium;
/// it belongs to loads scaled by that point's factor (scale_loads). Without rest at the start it remains unchanged.
/// Throws InputError for options out of range, for an unknown load name, and as find_equilibrium does.
template <int D>
LoadPath follow_loads(const Model<D>& model, State<D>& state, const LoadPathOptions<D>& options);

}  // namespace trilith
