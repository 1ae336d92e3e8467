// Tunnelling: pieces that get too deep into each other, or pass through each other, within one step. The whole path of
// a step is checked, not only its end.
#pragma once

#include <vector>

#include "base/space.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Largest additional penetration in an implicit step, as a share of the thickness of the thinner piece.
/// report_deep_penetration reports depths from half of the thickness on, so no step skips the reported range.
inline constexpr double depth_per_implicit_step = 0.2;

/// The motion of all nodes over a step that ends at a state:
///
///     x(s) = x0 + s dt v0 + s^2 (x1 - x0 - dt v0),   s from 0 to 1.
///
/// It keeps the initial velocity v0 and both ends. Rotations change at a constant rate.
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
  int piece_a = -1, piece_b = -1;  ///< -1: none found
  double depth = 0;                ///< least translation that separates the pieces [m]
  double thickness = 0;            ///< thickness of the thinner piece [m]
  double speed = 0;                ///< mean relative speed over the step [m/s]
  Vec<D> place = Vec<D>::Zero();   ///< point between their middles [m]
};

/// The first pair of pieces whose depth has increased by more than depth_per_implicit_step within the step. Their
/// bodies must have a contact law and not be in State::passed. `state` is the end of the step, at which `work` is
/// evaluated.
template <int D>
Tunnelling<D> find_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                              const StepBegin<D>& begin);

/// All pairs of bodies, with one pair of pieces each, whose depth exceeds `share` of the thickness of the thinner piece
/// at some time within the step.
template <int D>
std::vector<Tunnelling<D>> list_tunnelling(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const StepBegin<D>& begin, double share);

}  // namespace trilith
