// Limit of the time step for fast and thin bodies in space.
#include <algorithm>
#include <cmath>

#include "broad_phase/solid_pairs.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "integrate/explicit/tunnelling_limit.hpp"

namespace trilith {
namespace {

/// Largest distance of a point from the reference point of its motion [m]. This point is the node of a rigid body or of
/// a frame piece. For a deforming piece it is a corner, which gives an upper bound of the distance from the middle.
double reach_of(const Model<3>& model, int piece) {
  const int body = model.piece_body[piece];
  if (model.bodies[body].is_rigid()) return model.body_radius[body];
  double most = 0;
  for (const Vec3& x : model.piece_solid[piece].shape.corners) most = std::max(most, x.squaredNorm());
  return std::sqrt(most);
}

/// Upper bound of the speed of any point of the body that a piece belongs to [m/s].
double fastest_point(const Model<3>& model, const State<3>& state, int piece) {
  const BodyMotion m = motion_of(model, state, model.carrier_of(piece));
  return m.velocity.norm() + m.spin.norm() * reach_of(model, piece);
}

/// Upper bound of the closing speed of any points of two pieces [m/s].
double closing_bound(const Model<3>& model, const State<3>& state, int a, int b) {
  const BodyMotion of_a = motion_of(model, state, model.carrier_of(a)),
                   of_b = motion_of(model, state, model.carrier_of(b));
  return (of_a.velocity - of_b.velocity).norm() + of_a.spin.norm() * reach_of(model, a) +
         of_b.spin.norm() * reach_of(model, b);
}

/// Distance of two boxes along the axis that separates them best; 0 if they overlap [m].
double gap_of(const FatBox<3>& a, const FatBox<3>& b) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max({most, a.low[k] - b.high[k], b.low[k] - a.high[k]});
  return most;
}

}  // namespace

/// For each piece that is fast enough, the broad phase is queried with the AABB that the piece can reach within the
/// step. Pairs that meet there may close the gap of their boxes and then penetrate by `share` of the thickness of the
/// thinner piece. The result is rounded down to the ladder.
TunnellingLimit tunnelling_limit(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt,
                                 double share) {
  TunnellingLimit step{dt};
  if (2 * work.fastest * dt <= share * model.least_thickness) return step;
  for (int p = 0; p < model.pieces(); ++p) {
    const int body = model.piece_body[p];
    if (state.left[body] != 0 || !model.body_moves(body)) continue;
    const double reach = (fastest_point(model, state, p) + work.fastest) * step.dt;
    if (reach <= share * model.least_thickness || !work.search.boxes.holds(p)) continue;
    const FatBox<3> box = box_around(work.solids.placed[p]);
    work.search.boxes.for_meeting(widened(box, reach), [&](int q) {
      const int other = model.piece_body[q];
      if (other == body || state.left[other] != 0) return;
      if (model.law_of[model.bodies[body].surface * model.surfaces + model.bodies[other].surface] < 0) return;
      const double speed = closing_bound(model, state, p, q),
                   thickness = std::min(model.piece_thickness[p], model.piece_thickness[q]);
      const double path = gap_of(box, box_around(work.solids.placed[q])) + share * thickness;
      if (speed * step.dt > path) step = {path / speed, p, q, speed, thickness};
    });
  }
  if (step.piece_a >= 0) step.dt = settled_step(step.dt, 1);
  return step;
}

}  // namespace trilith
