// The longest stable step of bodies in space, from their contact areas.
//
// Input: for each contact its area A, middle, normal n, arms and radius (see SolidPressure), and the tangent of its
// law. Each body then has springs along n and two axes across, b = (e, arm x e). Rotational springs are kn A (a x n)(a
// x n)' for the two arms a of the second moments, and ks A radius^2 about n. Output: the bound of lambda over all
// bodies. Bearings are springs and dashpots along and about their axes. With mass scaling, meshed bodies have the same
// springs about their centres of mass too, as if they were rigid.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "assembly/bearing_motion.hpp"
#include "assembly/bounds/local_solids.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "base/team.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "law/bearing/dish.hpp"

namespace trilith {
namespace {

/// Local matrices of contacts and bearings.
struct SolidLocals {
  std::vector<LocalSolid> node;                  ///< [node] nodes that turn
  NodeRows rows;                                 ///< [node] nodes that do not turn
  std::vector<LocalSolid> whole;                 ///< [body] meshed bodies as if they were rigid; empty: not requested
  std::vector<std::optional<ScaledWhole>> body;  ///< [body] rigid motion of meshed bodies; none if the body has no
                                                 ///< rigid motion

  [[nodiscard]] const ScaledWhole* scaled(int b) const {
    return body.empty() || !body[static_cast<std::size_t>(b)] ? nullptr : &*body[static_cast<std::size_t>(b)];
  }
};

/// Stiffness and damping of the force in one direction.
struct DirectionStiffness {
  double tangent = 0, dashpot = 0;
};
DirectionStiffness stiffness_of(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) -> DirectionStiffness {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
          return {};
        else
          return {l.tangent(), l.dashpot()};
      },
      law);
}

/// Nodal forces of a fit per unit force at the point of a bearing. If the point lies off the plane of a face, the tilt
/// of the face moves it along the plane, so that a force along the plane also acts on the nodes across it.
std::array<double, most_fit_nodes> lever_weights(const Model<3>& model, const Fit& fit, const Fitted& now,
                                                 const Vec3& at) {
  std::array<double, most_fit_nodes> out = weights_at(model, fit, now, at, false);
  if (!fit.is_face) return out;
  const double lever = std::abs(now.axes.col(2).dot(at - now.place));
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const number = &model.fit_number[static_cast<std::size_t>(fit.first_number + 4 * i)];
    double& weight = out[static_cast<std::size_t>(i)];
    weight = std::abs(weight) + lever * std::sqrt(number[1] * number[1] + number[2] * number[2]);
  }
  return out;
}

/// Adds a spring through a point, or about an axis. A spring about an axis has forces across the axis, at the distance
/// of the nodes.
void add_spring_to_fit(const Model<3>& model, const State<3>& state, int contact_frame, const Vec3& at, bool along,
                       double weight, const DirectionStiffness& s, NodeRows& rows) {
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - contact_frame)];
  const Fitted now = fitted(model, fit, state.position, state.velocity);
  if (along) return rows.add(model, fit, lever_weights(model, fit, now, at), weight * s.tangent, weight * s.dashpot);
  for (const Vec3& e : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
    rows.add(model, fit, weights_at(model, fit, now, e, true), weight * s.tangent, weight * s.dashpot);
}

/// Adds a spring and a dashpot along e through a point at `arm`, or about e.
template <class Scaled>
void add_spring(const Scaled& node, const Vec3& e, const Vec3& arm, bool along, double weight,
                const DirectionStiffness& s, LocalSolid& local) {
  Vector6 v = Vector6::Zero();
  if (along)
    v = node.along(e, arm);
  else
    v.tail<3>() = node.about(e);
  local.k += weight * s.tangent * v * v.transpose();
  local.c += weight * s.dashpot * v * v.transpose();
}

/// Adds a spring and a dashpot along and about each axis of every bearing, at the point of side b. A waiting bearing
/// counts already, because it may become live between two estimates.
void add_bearings(const Model<3>& model, const State<3>& state, const Work<3>& work, SolidLocals& locals) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    if (!is_live(work.bearing[i].status) && work.bearing[i].status != BearingStatus::waiting) continue;
    const Bearing<3>& b = model.bearings[i];
    const Vec3 at = point_of(model, state, b.end_b);
    const Turn3 turn = turn_of(motion_of(model, state, b.end_a.node[0]).rotation * b.angle);
    std::array axes{turn.x(), turn.y(), turn.z()}, springs = axes;
    if (has_dish(b)) {  // the axial law acts along the normal
      const Dish<3> dish(b, bearing_motion(model, state, i).counted(work.bearing[i]));
      springs[2] -= dish.slope[0] * axes[0] + dish.slope[1] * axes[1];
    }
    const DirectionStiffness both = stiffness_of(b.horizontal);
    for (std::size_t k = 0; k < 6; ++k) {
      const Vec3& axis = k < 3 ? springs[k] : axes[k - 3];
      DirectionStiffness s = stiffness_of(b.law[k]);
      if (k < 2) s.tangent += both.tangent, s.dashpot += both.dashpot;
      for (const auto& [body, other] : {std::pair(b.body_a, b.body_b), std::pair(b.body_b, b.body_a)}) {
        if (!model.body_moves(body)) continue;
        const double weight = model.body_moves(other) ? 2 : 1;
        if (const ScaledWhole* whole = locals.scaled(body)) {
          LocalSolid& local = locals.whole[static_cast<std::size_t>(body)];
          add_spring(*whole, axis, at - whole->centre, k < 3, weight, s, local);
        }
        const int n = body == b.body_a ? b.end_a.node[0] : b.end_b.node[0];
        if (n < 0) {
          add_spring_to_fit(model, state, n, at, k < 3, weight, s, locals.rows);
          continue;
        }
        const ScaledNode node = scaled_node(model, n, state.rotation[n]);
        add_spring(node, axis, at - state.position[n], k < 3, weight, s, locals.node[n]);
      }
    }
  }
}

/// Adds the springs of all touching contacts, for both bodies of each contact.
void add_contacts(const Model<3>& model, const State<3>& state, const Work<3>& work, SolidLocals& locals) {
  std::vector<ScaledNode> nodes;
  nodes.reserve(locals.node.size());
  for (int n = 0; n < model.nodes(); ++n) nodes.push_back(scaled_node(model, n, state.rotation[n]));
  for (const GeneralContact<3>& contact : work.general_touching) {
    const ContactArea& area = work.solids.areas[static_cast<std::size_t>(contact.row)];
    const NearPair& pair = work.pairs[contact.row];
    const int body[2] = {model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]};
    const int node[2] = {model.node_of_piece(pair.piece_a), model.node_of_piece(pair.piece_b)};
    const ContactTangent law = solid_tangent(model, pair.law, contact.depth);
    const auto springs = [&](const Vec3& origin) {
      return AreaSprings{area.middle - origin, area.normal, area.area, area.radius, area.arm, law};
    };
    for (const int side : {0, 1}) {
      if (!model.body_moves(body[side])) continue;
      const double weight = model.body_moves(body[1 - side]) ? 2 : 1;
      if (const ScaledWhole* whole = locals.scaled(body[side]))
        add_area(springs(whole->centre), *whole, weight, locals.whole[static_cast<std::size_t>(body[side])]);
      if (model.is_fitted(side == 0 ? pair.piece_a : pair.piece_b)) {
        const int contact_frame =
            side == 0 ? model.carrier_of(pair.piece_a, area.face_a) : model.carrier_of(pair.piece_b, area.face_b);
        const auto i = static_cast<std::size_t>(-1 - contact_frame);
        add_area_to_fit(model, model.fits[i], work.solids.fitted[i], springs(Vec3::Zero()), weight, locals.rows);
        continue;
      }
      const int n = node[side];
      add_area(springs(state.position[n]), nodes[static_cast<std::size_t>(n)], weight, locals.node[n]);
    }
  }
}

SolidLocals locals_of(const Model<3>& model, const State<3>& state, const Work<3>& work, bool as_rigid) {
  SolidLocals locals{std::vector<LocalSolid>(model.mass.size()), rows_of(model), {}, {}};
  if (as_rigid) {
    locals.whole.resize(model.bodies.size()), locals.body.resize(model.bodies.size());
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (!is_of_elements(model.bodies[b])) continue;
      const WholeBody<3> whole = whole_body(model, state, static_cast<int>(b));
      if (whole.moves()) locals.body[b].emplace(whole);
    }
  }
  add_contacts(model, state, work, locals);
  add_bearings(model, state, work, locals);
  return locals;
}

/// Calls f(k, c) for each node of a body, with the rates of its contacts and bearings or of the body's stiffest face.
/// Constraints about some axes do not increase any eigenvalue and are ignored.
template <class F>
void each_node(const Model<3>& model, const Work<3>& work, const SolidLocals& locals, std::size_t b, F&& f) {
  const Body& body = model.bodies[b];
  const bool turn = body.nodes_turn();
  const RateBound& face = work.face_bound[b];
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    f(std::max(face.stiffness, turn ? largest_bound(locals.node[n].k) : locals.rows.k[n]),
      std::max(face.damping, turn ? largest_bound(locals.node[n].c) : locals.rows.c[n]));
}

RateBound elements_of_body(const Model<3>& model, std::size_t b) {
  return model.element_bound.empty() ? RateBound{} : model.element_bound[b];
}

/// Contacts and bearings add to the frequencies of beams or elements at most as much as they add to the nodes alone.
/// Reduces `found` to the step of the body.
void shorten_to_plain(const Model<3>& model, const State<3>& state, const Work<3>& work, const SolidLocals& locals,
                      std::size_t b, StableStep& found) {
  const RateBound own = elements_of_body(model, b);
  // The rotary inertia of a body of one element is smaller by `ratio`, see assembly/element/rotary_inertia.hpp.
  const double ratio = lumped_over_own(model, state, static_cast<int>(b));
  each_node(model, work, locals, b, [&](double stiffness, double damping) {
    const double k = own.stiffness + stiffness, c = own.damping + damping + model.mass_damping, dt = step_for(k, c);
    if (dt < found.dt) found = {dt, static_cast<int>(b), k, c};
    if (ratio == 1) return;
    const double turning = ratio * stiffness, braked = ratio * (damping + model.mass_damping);
    if (const double least = step_for(turning, braked); least < found.dt)
      found = {least, static_cast<int>(b), turning, braked};
  });
}

BodyRates rates_of(const Model<3>& model, const State<3>& state, const Work<3>& work, const SolidLocals& locals,
                   std::size_t b) {
  BodyRates out;
  out.elements = elements_of_body(model, b);
  each_node(model, work, locals, b, [&](double stiffness, double damping) {
    out.contacts.stiffness = std::max(out.contacts.stiffness, stiffness);
    out.contacts.damping = std::max(out.contacts.damping, damping);
  });
  if (locals.scaled(static_cast<int>(b)) != nullptr)
    out.rigid = {std::max(work.around_bound[b].stiffness, largest_bound(locals.whole[b].k)),
                 std::max(work.around_bound[b].damping, largest_bound(locals.whole[b].c))};
  if (const double ratio = lumped_over_own(model, state, static_cast<int>(b)); ratio != 1)
    out.rigid.stiffness *= ratio, out.rigid.damping *= ratio;
  StableStep plain{longest_step};
  shorten_to_plain(model, state, work, locals, b, plain);
  out.plain = plain.dt;
  return out;
}

/// Bodies per chunk of a thread, about 10 microseconds.
constexpr int rated_solids = 32;
/// Largest rotation of a body in a step [rad].
constexpr double longest_turn = 0.1;

}  // namespace

std::vector<BodyRates> body_rates(const Model<3>& model, const State<3>& state, const Work<3>& work, bool as_rigid) {
  const SolidLocals locals = locals_of(model, state, work, as_rigid);
  std::vector<BodyRates> out(model.bodies.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (model.body_moves(static_cast<int>(b))) out[b] = rates_of(model, state, work, locals, b);
  return out;
}

double turning_step(const Model<3>& model, const State<3>& state) {
  double fastest = 0;
  for (const Body& body : model.bodies) {
    if (!body.is_rigid()) continue;
    const Vec3& inertia = model.inertia[body.first_node];
    if (inertia.maxCoeff() > inertia.minCoeff()) fastest = std::max(fastest, state.spin[body.first_node].norm());
  }
  return fastest * longest_step > longest_turn ? longest_turn / fastest : longest_step;
}

StableStep stable_step(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  const bool is_scaled = !state.added_share.empty();
  const SolidLocals locals = locals_of(model, state, work, is_scaled);
  const auto shorten = [&](std::size_t b, StableStep& found) {
    if (is_scaled && state.added_share[b] > 0)
      shorten_to_scaled(rates_of(model, state, work, locals, b), state.added_share[b], model.mass_damping,
                        static_cast<int>(b), found);
    else
      shorten_to_plain(model, state, work, locals, b, found);
  };
  const int bodies = static_cast<int>(model.bodies.size());
  const StableStep none{longest_step};
  std::vector<StableStep> by(static_cast<std::size_t>((bodies + rated_solids - 1) / rated_solids), none);
  share(work.threads, static_cast<int>(by.size()), 1, [&](int first, int last, int /*thread*/) {
    for (int s = first; s < last; ++s)
      for (int b = s * rated_solids; b < std::min(bodies, (s + 1) * rated_solids); ++b)
        if (model.body_moves(b)) shorten(static_cast<std::size_t>(b), by[static_cast<std::size_t>(s)]);
  });
  StableStep found = none;
  for (const StableStep& one : by)
    if (one.dt < found.dt) found = one;
  return found;
}

}  // namespace trilith
