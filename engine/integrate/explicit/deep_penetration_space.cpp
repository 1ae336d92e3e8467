// Watch on deep penetration of polyhedra in space.
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

/// Share for bodies that inner cuts divide: a body that is half inside one of them may share less with each of two
/// pieces.
constexpr double share_by_cuts = 0.9;
/// Rounding error of a depth, as a share of it.
constexpr double rounding = 1e-9;

/// 1 / mass of the part that moves with a piece, 0 if it does not move [1/kg]. For a frame this is one node; for a
/// meshed body, the whole body.
double mobility_of(const Model<3>& model, int piece) {
  const int body = model.piece_body[piece];
  if (!model.body_moves(body)) return 0;
  return 1 / (model.is_fitted(piece) ? body_mass(model, body) : model.mass[model.node_of_piece(piece)]);
}

/// Normal stiffness that would limit the penetration to half of the report limit [Pa/m], as in the plane:
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

/// The faster body is named first.
Event event_of(const Model<3>& model, const State<3>& state, int p, int q) {
  const Vec3 va = motion_of(model, state, model.carrier_of(p)).velocity,
             vb = motion_of(model, state, model.carrier_of(q)).velocity;
  const bool turned = vb.norm() > va.norm();
  return event_now(state, EventType::body_passed, model.piece_body[turned ? q : p], model.piece_body[turned ? p : q]);
}

/// Least translation that separates two pieces, inner cuts included [m]. The depth of a contact is measured from the
/// nearest face of the other piece and is never above half of the thickness of that piece. For two equally thick pieces
/// it cannot distinguish half from full penetration.
double overlap_of(const Work<3>& work, const NearPair& pair) {
  const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
  const bool round = a.solid->is_sphere() || b.solid->is_sphere();
  return -(round ? sphere_distance(a, b) : separation(a, b).distance);
}

/// Both depths must be large: one above the reported share, the other above half of it. The overlap alone is not
/// sufficient for a piece that other pieces of its body surround. The face depth alone is not sufficient for a
/// tetrahedron with only an edge in the plane of a joint: its depth is the distance to its own next face.
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
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick; kn of {:.1e} Pa/m would prevent it", speed,
                       thickness, needed_stiffness(model, state, work, c, deep_penetration_share * thickness, speed));
  return e;
}

double thinner_of(const Model<3>& model, int p, int q) {
  return std::min(model.piece_thickness[p], model.piece_thickness[q]);
}

/// Stores that two bodies are reported; false if they were reported before.
bool remember(const Model<3>& model, State<3>& state, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  const ContactKey key = contact_key(std::min(a, b), std::max(a, b));
  const auto at = std::lower_bound(state.passed.begin(), state.passed.end(), key);
  if (at != state.passed.end() && *at == key) return false;
  state.passed.insert(at, key);
  return true;
}

/// Event of two pieces that passed through each other within the last step.
Event through_event(const Model<3>& model, const State<3>& state, const Tunnelling<3>& t) {
  Event e = event_of(model, state, t.piece_a, t.piece_b);
  e.value = t.depth;
  e.set_place(t.place);
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick, within a step of {:.2g} s; use a shorter step",
                       t.speed, t.thickness, state.last_dt);
  return e;
}

/// Checks fast pieces along the last step, with the velocities at its end: the exact path of a leapfrog step.
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

/// The two ways to get too deep are those in the plane: through and out again within the last step, which is checked
/// along its path, or deeper step by step.
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
