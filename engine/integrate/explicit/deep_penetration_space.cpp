// The watch on solids in space that get too deep into each other.
#include <fmt/format.h>

#include <algorithm>

#include "assembly/implicit_turn.hpp"
#include "events/body_events.hpp"
#include "geometry/space/separation_3d.hpp"
#include "geometry/space/sphere_distance.hpp"
#include "integrate/explicit/deep_penetration.hpp"
#include "integrate/explicit/tunnelling.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Inner cuts of a body part its pieces: a body that is half in one of them may share less with each of two.
constexpr double share_by_cuts = 0.9;
/// Rounding of a depth, as a share of it.
constexpr double rounding = 1e-9;

/// 1 / mass of what may move, 0 of what may not; of a frame of one node of it, of elements of the whole body [1/kg].
double mobility_of(const Model<3>& model, int piece) {
  const int body = model.piece_body[piece];
  if (!model.body_moves(body)) return 0;
  return 1 / (model.is_fitted(piece) ? body_mass(model, body) : model.mass[model.node_of_piece(piece)]);
}

/// The stiffness that would keep the two half as deep as is told [Pa/m], as in the plane:
/// kn A d^2 / 2 = m (v^2 / 2 + g d) + kn_now A depth^2 / 2 at that depth.
double needed_stiffness(const Model<3>& model, const State<3>& state, const Work<3>& work, const GeneralContact<3>& c,
                        double allowed, double speed) {
  const NearPair& pair = work.pairs[c.row];
  const double most = 0.5 * allowed;
  const double mass = 1 / (mobility_of(model, pair.piece_a) + mobility_of(model, pair.piece_b));
  const double kn = std::visit([](const auto& l) { return l.kn; }, model.laws[pair.law]);
  const double weight = model.gravity.at(state.time).norm();
  return (mass * (speed * speed + 2 * weight * most) + kn * c.size * c.depth * c.depth) / (c.size * most * most);
}

/// The faster body is named first, as the one that passed.
Event event_of(const Model<3>& model, const State<3>& state, int p, int q) {
  const Vec3 va = motion_of(model, state, model.carrier_of(p)).velocity,
             vb = motion_of(model, state, model.carrier_of(q)).velocity;
  const bool turned = vb.norm() > va.norm();
  return event_now(state, EventType::body_passed, model.piece_body[turned ? q : p], model.piece_body[turned ? p : q]);
}

/// The least translation that parts two pieces, cuts and all [m]. A contact knows the depth of its faces below the
/// nearest face of the other piece, which is never above half of that piece's thickness: of two that are equally thick
/// it does not tell half from through.
double overlap_of(const Work<3>& work, const NearPair& pair) {
  const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
  const bool round = a.solid->is_sphere() || b.solid->is_sphere();
  return -(round ? sphere_distance(a, b) : separation(a, b).distance);
}

/// Both depths are asked for, one of them beyond the share that is reported and the other beyond half of that. The
/// overlap alone does not do for a piece that others of its body surround, nor the depth of faces for a tetrahedron
/// that has but an edge in the plane of a joint: it is as deep in the other body as its own next face is far.
bool is_too_deep(const Model<3>& model, const Work<3>& work, const GeneralContact<3>& c, double thickness) {
  const NearPair& pair = work.pairs[c.row];
  const double allowed = deep_penetration_share * thickness;
  if (c.depth <= 0.5 * allowed) return false;
  const bool cut = model.bodies[model.piece_body[pair.piece_a]].pieces > 1 ||
                   model.bodies[model.piece_body[pair.piece_b]].pieces > 1;
  const double overlap = overlap_of(work, pair);
  return overlap > (c.depth > allowed ? 0.5 : cut ? share_by_cuts : 1 - rounding) * allowed;
}

Event passed_event(const Model<3>& model, const State<3>& state, const Work<3>& work, const GeneralContact<3>& c,
                   double thickness) {
  const NearPair& pair = work.pairs[c.row];
  const Vec3 va = motion_of(model, state, model.carrier_of(pair.piece_a)).velocity,
             vb = motion_of(model, state, model.carrier_of(pair.piece_b)).velocity;
  Event e = event_of(model, state, pair.piece_a, pair.piece_b);
  e.value = overlap_of(work, pair);
  e.set_place(c.centre);
  const double speed = (va - vb).norm();
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick; kn of {:.1e} Pa/m would hold it", speed, thickness,
                       needed_stiffness(model, state, work, c, deep_penetration_share * thickness, speed));
  return e;
}

double thinner_of(const Model<3>& model, int p, int q) {
  return std::min(model.piece_thickness[p], model.piece_thickness[q]);
}

/// Remembers that two bodies are reported; false where they were before.
bool remember(const Model<3>& model, State<3>& state, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  const ContactKey key = contact_key(std::min(a, b), std::max(a, b));
  const auto at = std::lower_bound(state.passed.begin(), state.passed.end(), key);
  if (at != state.passed.end() && *at == key) return false;
  state.passed.insert(at, key);
  return true;
}

/// Two that the last step took through each other, in and out again.
Event through_event(const Model<3>& model, const State<3>& state, const Tunnelling<3>& t) {
  Event e = event_of(model, state, t.piece_a, t.piece_b);
  e.value = t.depth;
  e.set_place(t.place);
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick, within a step of {:.2g} s; take a shorter one",
                       t.speed, t.thickness, state.last_dt);
  return e;
}

/// Follows fast pieces back through the last step, by the velocities of its end: a leapfrog step has gone exactly so.
void look_back(const Model<3>& model, State<3>& state, const Work<3>& work, std::vector<Event>& told) {
  if (!(2 * work.fastest * state.last_dt > model.least_thickness)) return;
  std::vector<Vec3> position(state.position);
  std::vector<UnitQuaternion> rotation(state.rotation);
  for (std::size_t n = 0; n < position.size(); ++n) {
    position[n] -= state.last_dt * state.velocity[n];
    rotation[n] = turned_by(Vec3(-state.last_dt * state.spin[n]), rotation[n]);
  }
  const StepBegin<3> begin{position, state.velocity, rotation, state.last_dt};
  for (const Tunnelling<3>& t : list_tunnelling(model, state, work, begin, deep_penetration_share))
    if (remember(model, state, t.piece_a, t.piece_b)) told.push_back(through_event(model, state, t));
}

}  // namespace

/// Two ways to be too deep, as in the plane: through and out again within the last step, which is followed back, and
/// deeper step by step.
std::vector<Event> report_deep_penetration(const Model<3>& model, State<3>& state, Work<3>& work) {
  std::vector<Event> told;
  look_back(model, state, work, told);
  for (const GeneralContact<3>& c : work.general_touching) {
    const NearPair& pair = work.pairs[c.row];
    const double thickness = thinner_of(model, pair.piece_a, pair.piece_b);
    if (is_too_deep(model, work, c, thickness) && remember(model, state, pair.piece_a, pair.piece_b))
      told.push_back(passed_event(model, state, work, c, thickness));
  }
  return told;
}

}  // namespace trilith
