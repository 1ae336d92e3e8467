// Tunnelling: pieces that one step takes deep into each other, or through each other. The whole path of a step is
// checked, from its begin to its end, not only its end.
#pragma once

#include <vector>

#include "base/space.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An implicit step takes two pieces deeper into each other by no more than this share of the thinner one's thickness.
/// report_deep_penetration reports depths from half of it on, so that no step goes past the depths that are reported.
inline constexpr double depth_per_implicit_step = 0.2;

/// The motion of all nodes over a step that ends at a state:
///
///     x(s) = x0 + s dt v0 + s^2 (x1 - x0 - dt v0),   s from 0 to 1,
///
/// which keeps the velocity v0 of the begin and both ends. Rotations change at a steady rate.
template <int D>
struct StepBegin {
  const std::vector<Vec<D>>& position;       ///< [node] [m]
  const std::vector<Vec<D>>& velocity;       ///< [node] [m/s]
  const std::vector<Rotation<D>>& rotation;  ///< [node]
  double dt;                                 ///< [s]
};

/// Two pieces on the path of a step.
template <int D>
struct Tunnelling {
  int piece_a = -1, piece_b = -1;  ///< -1: there are none
  double depth = 0;                ///< the least translation that would part them [m]
  double thickness = 0;            ///< of the thinner one [m]
  double speed = 0;                ///< mean speed of one against the other over the step [m/s]
  Vec<D> place = Vec<D>::Zero();   ///< between their middles [m]
};

/// The first two pieces, of bodies with a contact law that are not in State::passed, that get deeper into each other
/// than they were at the begin by more than depth_per_implicit_step. `state` is the end of the step, `work` evaluated
/// there.
template <int D>
Tunnelling<D> find_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                              const StepBegin<D>& begin);

/// All pairs of bodies, one pair of pieces of each, that are in each other by more than `share` of the thinner one's
/// thickness at some time within the step.
template <int D>
std::vector<Tunnelling<D>> list_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const StepBegin<D>& begin, double share);

}  // namespace trilith
