// The watch on solids in space that get too deep into each other.
#include <fmt/format.h>

#include <algorithm>

#include "step/body_events.hpp"
#include "step/passed.hpp"
#include "world/pose.hpp"

namespace trilith {
namespace {

/// What is half as deep as the thinner is thick presses on no less than this share of its thickness squared, but for
/// slivers: a tetrahedron of a mesh that has but an edge in the plane of a joint counts as deep in the other body as
/// its own next outer face is far.
constexpr double least_area = 0.01;

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
Event passed_event(const Model<3>& model, const State<3>& state, const Work<3>& work, const GeneralContact<3>& c,
                   double thickness) {
  const NearPair& pair = work.pairs[c.row];
  const int a = model.piece_body[pair.piece_a], b = model.piece_body[pair.piece_b];
  const Vec3 va = motion_of(model, state, model.carrier_of(pair.piece_a)).velocity,
             vb = motion_of(model, state, model.carrier_of(pair.piece_b)).velocity;
  const bool turned = vb.norm() > va.norm();
  Event e = event_now(state, EventType::body_passed, turned ? b : a, turned ? a : b);
  e.value = c.depth;
  e.set_place(c.centre);
  const double speed = (va - vb).norm();
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick; kn of {:.1e} Pa/m would hold it", speed, thickness,
                       needed_stiffness(model, state, work, c, passed_share * thickness, speed));
  return e;
}

}  // namespace

/// Every contact that touches knows how deep it is; what goes through between two steps, the sweep keeps from it.
std::vector<Event> notice_passed(const Model<3>& model, State<3>& state, Work<3>& work) {
  std::vector<Event> told;
  for (const GeneralContact<3>& c : work.general_touching) {
    const NearPair& pair = work.pairs[c.row];
    const double thickness = std::min(model.piece_thickness[pair.piece_a], model.piece_thickness[pair.piece_b]);
    if (c.depth <= passed_share * thickness || c.size <= least_area * thickness * thickness) continue;
    const int a = model.piece_body[pair.piece_a], b = model.piece_body[pair.piece_b];
    const ContactKey key = contact_key(std::min(a, b), std::max(a, b));
    const auto at = std::lower_bound(state.passed.begin(), state.passed.end(), key);
    if (at != state.passed.end() && *at == key) continue;
    state.passed.insert(at, key);
    told.push_back(passed_event(model, state, work, c, thickness));
  }
  return told;
}

}  // namespace trilith
