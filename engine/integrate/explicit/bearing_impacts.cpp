#include "integrate/explicit/bearing_impacts.hpp"

#include <algorithm>
#include <variant>

#include "assembly/bearing_motion.hpp"
#include "integrate/explicit/node_gain.hpp"
#include "law/bearing/clearance.hpp"

namespace trilith {
namespace {

/// Acceleration of a node along `e` at a point per unit force along `e` at this point: 1 / mass, with the rotation if
/// the node turns [1/kg].
double yielding_of_node(const Model<2>& model, const State<2>& state, int node, const Vec2& at, const Vec2& e) {
  if (!model.moves(node)) return 0;
  const double lever = cross(Vec2(at - state.position[node]), e), inertia = model.inertia[node];
  return 1 / model.mass[node] + (inertia > 0 ? lever * lever / inertia : 0);
}
double yielding_of_node(const Model<3>& model, const State<3>& state, int node, const Vec3& at, const Vec3& e) {
  if (!model.moves(node)) return 0;
  const Vec3 lever = turn_of(state.rotation[node]).undo(cross(Vec3(at - state.position[node]), e));
  double sum = 1 / model.mass[node];
  for (const int k : {0, 1, 2})
    if (model.inertia[node][k] > 0) sum += lever[k] * lever[k] / model.inertia[node][k];
  return sum;
}

/// Acceleration of the end of a bearing per unit force along `e`, by the weights of its nodes [1/kg].
double yielding(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment, const Vec2& at,
                const Vec2& e) {
  double sum = 0;
  for (int i = 0; i < attachment.nodes; ++i)
    sum += attachment.weight[i] * attachment.weight[i] * yielding_of_node(model, state, attachment.node[i], at, e);
  return sum;
}
double yielding(const Model<3>& model, const State<3>& state, const Attachment<3>& attachment, const Vec3& at,
                const Vec3& e) {
  if (attachment.node[0] >= 0) return yielding_of_node(model, state, attachment.node[0], at, e);
  double mass = 0;
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - attachment.node[0])];
  for (int i = 0; i < fit.nodes; ++i)
    if (model.moves(fit.node[static_cast<std::size_t>(i)])) mass += model.mass[fit.node[static_cast<std::size_t>(i)]];
  return mass > 0 ? 1 / mass : 0;
}

/// Angular acceleration of a node per unit couple about an axis of the bearing: 1 / inertia [1/(kg m2)].
double yielding_turn(const Model<2>& model, const State<2>& /*state*/, int node, const Vec2& /*axis*/) {
  return model.moves(node) && model.inertia[node] > 0 ? 1 / model.inertia[node] : 0;
}
double yielding_turn(const Model<3>& model, const State<3>& state, int node, const Vec3& axis) {
  if (node < 0 || !model.moves(node)) return 0;
  const Vec3 own = turn_of(state.rotation[node]).undo(axis);
  double sum = 0;
  for (const int k : {0, 1, 2})
    if (model.inertia[node][k] > 0) sum += own[k] * own[k] / model.inertia[node][k];
  return sum;
}

/// Sum over both ends along direction k: 1 / mass [1/kg], or 1 / inertia [1/(kg m2)] for a rotation.
template <int D>
double yielding_along(const Model<D>& model, const State<D>& state, const Bearing<D>& b, const BearingMotion<D>& motion,
                      int k) {
  std::array<double, Space<D>::dofs> unit{};
  unit[static_cast<std::size_t>(k)] = 1;
  if (k < Directions<D>::first_turning) {
    const Vec<D> e = motion.force(unit);
    return yielding(model, state, b.end_a, motion.point, e) + yielding(model, state, b.end_b, motion.point, e);
  }
  Vec<D> axis = Vec<D>::Zero();
  if constexpr (D == 3) axis = motion.moment(unit);
  return yielding_turn(model, state, b.end_a.turn[0], axis) + yielding_turn(model, state, b.end_b.turn[0], axis);
}

/// Acceleration of the end of a bearing along `e` at a point [m/s2], and about `axis` if it turns [rad/s2].
Vec2 gain_at(const Model<2>& model, const State<2>& state, const Work<2>& work, const Attachment<2>& attachment,
             const Vec2& at, double dt) {
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < attachment.nodes; ++i) {
    const int n = attachment.node[i];
    sum += attachment.weight[i] * gain_of(model, state, work, n, dt).at(at - state.position[n]);
  }
  return sum;
}
Vec3 gain_at(const Model<3>& model, const State<3>& state, const Work<3>& work, const Attachment<3>& attachment,
             const Vec3& at, double dt) {
  const int n = attachment.node[0];
  if (n >= 0) return gain_of(model, state, work, n, dt).at(at - state.position[n]);
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - n)];
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < fit.nodes; ++i)
    mean += gain_of(model, state, work, fit.node[static_cast<std::size_t>(i)], dt).along / fit.nodes;
  return mean;
}
Spin<2> turning_gain_of(const Model<2>& model, const State<2>& state, const Work<2>& work,
                        const Attachment<2>& attachment, double dt) {
  return gain_of(model, state, work, attachment.turn[0], dt).about;
}
Spin<3> turning_gain_of(const Model<3>& model, const State<3>& state, const Work<3>& work,
                        const Attachment<3>& attachment, double dt) {
  return attachment.turn[0] < 0 ? Vec3(Vec3::Zero()) : gain_of(model, state, work, attachment.turn[0], dt).about;
}

/// Rate of change of the relative velocity along direction k [m/s2] or [rad/s2].
template <int D>
double gain_along(const Model<D>& model, const State<D>& state, const Work<D>& work, const Bearing<D>& b,
                  const BearingMotion<D>& motion, int k, double dt) {
  std::array<double, Space<D>::dofs> unit{};
  unit[static_cast<std::size_t>(k)] = 1;
  if (k < Directions<D>::first_turning) {
    const Vec<D> gain =
        gain_at(model, state, work, b.end_b, motion.point, dt) - gain_at(model, state, work, b.end_a, motion.point, dt);
    return -motion.force(unit).dot(gain);  // the force resists displacement
  }
  const Spin<D> gain =
      turning_gain_of(model, state, work, b.end_b, dt) - turning_gain_of(model, state, work, b.end_a, dt);
  if constexpr (D == 3)
    return -motion.moment(unit).dot(gain);
  else
    return gain;
}

bool may_close(const DirectionLaw& law) {
  return std::visit([](const auto& l) { return ClosesAndOpens<std::decay_t<decltype(l)>>; }, law);
}

/// One sense of a direction of a bearing: distance to closing, closing speed, acceleration, and stiffness when closed.
struct Closing {
  double gap, speed, gain, stiffness;  ///< [m], [m/s], [m/s2], [N/m]
};

/// Calls f with both senses of direction k, for closing and opening of the law. `rate`, `gain`: present speed and
/// acceleration.
template <int D, class F>
void each_closing(const Bearing<D>& b, const BearingMemory<D>& memory, const BearingMotion<D>& motion, std::size_t k,
                  double rate, double gain, F&& f) {
  const double displacement = motion.counted(memory)[k];
  std::visit(
      [&](const auto& law) {
        if constexpr (ClosesAndOpens<std::decay_t<decltype(law)>>)
          for (const double way : {1.0, -1.0})
            f(Closing{clearance(law, memory.direction[k], displacement, way), way * rate, way * gain, law.stiffness});
      },
      b.law[k]);
}

}  // namespace

template <int D>
double list_bearing_impacts(const Model<D>& model, const State<D>& state, Work<D>& work, double dt) {
  ImpactWork& own = work.impacts;
  double stored = 0;
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<D>& b = model.bearings[i];
    if (!is_live(state.bearing[i].status) || (own.counts[b.body_a] == 0 && own.counts[b.body_b] == 0)) continue;
    if (std::none_of(b.law.begin(), b.law.end(), may_close)) continue;
    const BearingMotion<D> motion = bearing_motion(model, state, i);
    for (std::size_t k = 0; k < b.law.size(); ++k) {
      if (!may_close(b.law[k])) continue;
      const double gain = gain_along(model, state, work, b, motion, static_cast<int>(k), dt),
                   rate = motion.rate[k] + 0.5 * state.last_dt * gain;
      each_closing(b, state.bearing[i], motion, k, rate, gain, [&](const Closing& c) {
        if (c.gap > 0 && !(c.gap < farthest(c.speed, c.gain, dt))) return;
        const double depth = std::max(-c.gap, 0.0), force = c.stiffness * depth;
        stored += 0.5 * force * depth;
        const double yielding = depth > 0 ? yielding_along(model, state, b, motion, static_cast<int>(k)) : 0;
        const double speed = c.gap > 0 ? speed_at_touch(c.gap, c.speed, c.gain) : c.speed;
        own.blows.push_back({c.gap > 0 ? time_to_touch(c.gap, c.speed, c.gain) : 0,
                             0.5 * (c.stiffness * speed * speed + force * force * yielding)});
      });
    }
  }
  return stored;
}

template double list_bearing_impacts(const Model<2>&, const State<2>&, Work<2>&, double);
template double list_bearing_impacts(const Model<3>&, const State<3>&, Work<3>&, double);

}  // namespace trilith
