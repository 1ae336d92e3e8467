// Limit of the time step for fast and thin bodies: no piece may get deep into another within one step.
#pragma once

#include <string>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Largest additional penetration in a step, as a share of the thickness of the thinner piece.
inline constexpr double depth_per_step = 0.1;
/// The same limit for a step that the user gives: beyond it the pieces are past each other's middle.
inline constexpr double deepest_per_step = 0.5;

/// A step and the pair of pieces that limits it.
struct TunnellingLimit {
  double dt = 0;                   ///< [s]
  int piece_a = -1, piece_b = -1;  ///< -1 if no pair limits the step
  double speed = 0;                ///< largest relative speed of their points [m/s]
  double thickness = 0;            ///< thickness of the thinner piece [m]

  /// The step required while the pieces are in contact [s].
  [[nodiscard]] double needed() const { return depth_per_step * thickness / speed; }
};

/// `dt` [s], or the longest safe step for pieces that move into each other: each step increases the depth by at most
/// `share` of the thickness of the thinner piece. The result depends on the last evaluation alone, so the step recovers
/// without memory. If limited, it is on the ladder of settled_step. The cost is one comparison if nothing is fast.
TunnellingLimit tunnelling_limit(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt,
                                 double share = depth_per_step);

/// In space: neighbouring pieces get deeper by at most `share` of the thickness of the thinner piece, at the present
/// speeds. A piece without neighbours moves no farther than the search range.
TunnellingLimit tunnelling_limit(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt,
                                 double share = depth_per_step);

/// Text: the pieces that meet, their speed and the thickness.
template <int D>
std::string explain_tunnelling_limit(const Model<D>& model, const TunnellingLimit& step);

}  // namespace trilith
