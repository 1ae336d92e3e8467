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

/// Bounds of the motion of all points of the body that a piece belongs to.
struct PointSpeeds {
  Vec3 velocity;       ///< of the reference point [m/s]
  double turning = 0;  ///< largest speed relative to it [m/s]

  PointSpeeds(const Model<3>& model, const State<3>& state, int piece) {
    const BodyMotion m = motion_of(model, state, model.carrier_of(piece));
    velocity = m.velocity, turning = m.spin.norm() * reach_of(model, piece);
  }
  [[nodiscard]] double fastest() const { return velocity.norm() + turning; }
  /// Upper bound of the closing speed of any points of the two [m/s].
  [[nodiscard]] double against(const PointSpeeds& other) const {
    return (velocity - other.velocity).norm() + turning + other.turning;
  }
};

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
    const PointSpeeds own(model, state, p);
    const double reach = (own.fastest() + work.fastest) * step.dt;
    if (reach <= share * model.least_thickness || !work.search.boxes.holds(p)) continue;
    const FatBox<3> box = box_around(work.solids.placed[p]);
    work.search.boxes.for_meeting(widened(box, reach), [&](int q) {
      const int other = model.piece_body[q];
      if (other == body || state.left[other] != 0) return;
      if (model.law_of[model.bodies[body].surface * model.surfaces + model.bodies[other].surface] < 0) return;
      const double speed = own.against(PointSpeeds(model, state, q)),
                   thickness = std::min(model.piece_thickness[p], model.piece_thickness[q]);
      if (!(speed * step.dt > share * thickness)) return;  // whatever the gap
      const double path = gap_of(box, box_around(work.solids.placed[q])) + share * thickness;
      if (speed * step.dt > path) step = {path / speed, p, q, speed, thickness};
    });
  }
  if (step.piece_a >= 0) step.dt = settled_step(step.dt, 1);
  return step;
}

}  // namespace trilith
