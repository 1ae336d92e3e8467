// The step in time for solids in space that fly fast and thin.
#include <algorithm>

#include "detect/solid_pairs.hpp"
#include "step/stable_step.hpp"
#include "step/sweep.hpp"

namespace trilith {
namespace {

/// How fast some point of a body may go [m/s].
double fastest_point(const Model<3>& model, const State<3>& state, int body) {
  const int n = model.bodies[body].first_node;
  return state.velocity[n].norm() + state.spin[n].norm() * model.body_radius[body];
}

/// ... against any point of another.
double closing_bound(const Model<3>& model, const State<3>& state, int a, int b) {
  const int n = model.bodies[a].first_node, m = model.bodies[b].first_node;
  return (state.velocity[n] - state.velocity[m]).norm() + state.spin[n].norm() * model.body_radius[a] +
         state.spin[m].norm() * model.body_radius[b];
}

/// How far two boxes are apart along the axis that parts them best; 0 where none does [m].
double gap_of(const FatBox<3>& a, const FatBox<3>& b) {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max({most, a.low[k] - b.high[k], b.low[k] - a.high[k]});
  return most;
}

}  // namespace

/// Of every piece that is fast enough to matter, the box of what it may reach within the step is looked up; two that
/// meet there may close the gap of their boxes and go `share` of the thinner one's thickness deep. Rounded down to the
/// ladder, as every step is.
SweptStep swept_step(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt, double share) {
  SweptStep step{dt};
  if (2 * work.fastest * dt <= share * model.least_thickness) return step;
  for (int p = 0; p < model.pieces(); ++p) {
    const int body = model.piece_body[p];
    if (state.left[body] != 0 || !model.body_moves(body)) continue;
    const double reach = (fastest_point(model, state, body) + work.fastest) * step.dt;
    if (reach <= share * model.least_thickness) continue;
    const FatBox<3> box = box_around(work.solids.placed[p]);
    work.search.boxes.for_meeting(widened(box, reach), [&](int q) {
      const int other = model.piece_body[q];
      if (other == body || state.left[other] != 0) return;
      if (model.law_of[model.bodies[body].surface * model.surfaces + model.bodies[other].surface] < 0) return;
      const double speed = closing_bound(model, state, body, other),
                   thickness = std::min(model.piece_thickness[p], model.piece_thickness[q]);
      const double path = gap_of(box, box_around(work.solids.placed[q])) + share * thickness;
      if (speed * step.dt > path) step = {path / speed, p, q, speed, thickness};
    });
  }
  if (step.piece_a >= 0) step.dt = settled_step(step.dt, 1);
  return step;
}

}  // namespace trilith
