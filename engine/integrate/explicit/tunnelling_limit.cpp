#include "integrate/explicit/tunnelling_limit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "broad_phase/moving_piece.hpp"
#include "broad_phase/swept_pairs.hpp"
#include "integrate/explicit/stable_step.hpp"

namespace trilith {
namespace {

/// Largest relative speed of any corners of two pieces [m/s].
double largest_speed(const MovingPiece& a, const MovingPiece& b) {
  double most = 0;
  for (int i = 0; i < a.corners; ++i)
    for (int j = 0; j < b.corners; ++j) most = std::max(most, (a.velocity[i] - b.velocity[j]).norm());
  return most;
}

}  // namespace

/// The shortest time in which any pair may get deeper by `share` of the thickness of the thinner piece, rounded down to
/// the ladder of settled_step. Each pair is searched only up to the shortest time so far.
TunnellingLimit tunnelling_limit(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt,
                                 double share) {
  TunnellingLimit step{dt};
  if (goes_slowly(model, work, dt, share)) return step;
  for (const auto& [p, q] : swept_pairs(model, state, work, dt, share)) {
    const MovingPiece a = moving_piece(model, state, p), b = moving_piece(model, state, q);
    const double thickness = std::min(model.piece_thickness[p], model.piece_thickness[q]);
    const double time = time_to_depth(a, b, step.dt, share * thickness);
    if (time > 0 && time < step.dt) step = {time, p, q, largest_speed(a, b), thickness};
  }
  if (step.piece_a >= 0) step.dt = settled_step(step.dt, 1);
  return step;
}

template <int D>
std::string explain_tunnelling_limit(const Model<D>& model, const TunnellingLimit& step) {
  const auto name = [&](int piece) -> const std::string& { return model.bodies[model.piece_body[piece]].name; };
  return fmt::format("'{}' and '{}' meet at {:.3g} m/s, and the thinner one is {:.3g} m thick", name(step.piece_a),
                     name(step.piece_b), step.speed, step.thickness);
}

template std::string explain_tunnelling_limit(const Model<2>&, const TunnellingLimit&);
template std::string explain_tunnelling_limit(const Model<3>&, const TunnellingLimit&);

}  // namespace trilith
