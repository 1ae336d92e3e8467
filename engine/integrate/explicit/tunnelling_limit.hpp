// The step in time for what flies fast and thin: none may get deep into another within one step.
#pragma once

#include <string>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// No step takes two pieces deeper into each other by more than this share of the thinner one's thickness.
inline constexpr double depth_per_step = 0.1;
/// A step that is given may take them no deeper than this share: beyond it they are past each other's middle.
inline constexpr double deepest_per_step = 0.5;

/// A step, and what it is cut short for.
struct TunnellingLimit {
  double dt = 0;                   ///< [s]
  int piece_a = -1, piece_b = -1;  ///< -1 where nothing cuts it short
  double speed = 0;                ///< largest of their points against each other [m/s]
  double thickness = 0;            ///< of the thinner one [m]

  /// What it has to be as long as they are in contact [s].
  [[nodiscard]] double needed() const { return depth_per_step * thickness / speed; }
};

/// `dt` [s], or what of it is safe for pieces that fly into each other, each step deeper by `share` of the thinner
/// one's thickness at most. From the last evaluation, and nothing else: it needs no memory, and the step goes back by
/// itself. Where it holds, it is on the ladder of settled_step. One comparison where nothing is fast.
TunnellingLimit tunnelling_limit(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt,
                                 double share = depth_per_step);

/// In space: two pieces that are near each other get deeper by `share` of the thinner one's thickness at most, by the
/// speeds of now; what flies alone goes no farther than the search looks ahead.
TunnellingLimit tunnelling_limit(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt,
                                 double share = depth_per_step);

/// In words: what meets, how fast, and how thin it is.
template <int D>
std::string explain_tunnelling_limit(const Model<D>& model, const TunnellingLimit& step);

}  // namespace trilith
