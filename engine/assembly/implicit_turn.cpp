#include "assembly/implicit_turn.hpp"

#include <Eigen/Cholesky>

namespace trilith {
namespace {

bool is_all_free(const std::array<bool, 3>& free) {
  return free[0] && free[1] && free[2];
}

/// Rate of spin from a rate l of the angular momentum, I A = l - w x L, on the free axes; `held` on the others.
Vec3 rate_of_spin(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin, const Vec3& moment,
                  const std::array<bool, 3>& free, const Vec3& held) {
  const Turn3 turn(rotation);
  const Vec3 momentum = turn.apply(inertia.cwiseProduct(turn.undo(spin))), right = moment - cross(spin, momentum);
  if (is_all_free(free)) return turn.apply(turn.undo(right).cwiseQuotient(inertia));
  if (!free[0] && !free[1] && !free[2]) return held;
  Eigen::Matrix3d axes, left;
  axes << turn.x(), turn.y(), turn.z();
  left = axes * inertia.asDiagonal() * axes.transpose();
  Vec3 known = right - left * held;
  for (int k = 0; k < 3; ++k) {
    if (free[static_cast<std::size_t>(k)]) continue;
    left.row(k).setZero(), left.col(k).setZero();
    left(k, k) = 1, known[k] = 0;
  }
  Vec3 out = left.ldlt().solve(known);
  for (int k = 0; k < 3; ++k)
    if (!free[static_cast<std::size_t>(k)]) out[k] = held[k];
  return out;
}

Vec3 held_alone(Vec3 v, const std::array<bool, 3>& free) {
  for (int k = 0; k < 3; ++k)
    if (free[static_cast<std::size_t>(k)]) v[k] = 0;
  return v;
}

}  // namespace

TurnMotion<2> turned(const Model<2>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<2>& from,
                     double path, const TurnMotion<2>& to) {
  TurnMotion<2> out = to;
  out.rotation = from.rotation + path;
  if (model.support[node][2] != Support::free) return out;
  const double per = 1 / (scheme.b * dt * dt), half = 0.5 - scheme.b;
  out.rate = per * (path - dt * from.spin - half * dt * dt * from.rate);
  out.spin = from.spin + dt * ((1 - scheme.g) * from.rate + scheme.g * out.rate);
  return out;
}

// Input: t, and R, w, A of the start. Output: R', then w' from the rotation, L' from w', l' from the momentum, A' from
// l'.
TurnMotion<3> turned(const Model<3>& model, int node, const AlphaScheme& scheme, double dt, const TurnMotion<3>& from,
                     const Vec3& path, const TurnMotion<3>& to) {
  const std::array<bool, 3> free = free_turns(model, node);
  const Vec3& inertia = model.inertia[node];
  TurnMotion<3> out = to;
  out.rotation = turned_by(path, from.rotation);
  if (!free[0] && !free[1] && !free[2]) return out;
  const double share = scheme.b / scheme.g;
  Vec3 carried = (1 - share) * from.spin + dt * (0.5 - share) * from.rate;
  if (is_all_free(free)) carried = turn_by(path).apply(carried);
  const Vec3 spin = (path / dt - carried) / share;
  for (int k = 0; k < 3; ++k)
    if (free[static_cast<std::size_t>(k)]) out.spin[k] = spin[k];
  const Vec3 before = momentum_of(inertia, from.rotation, from.spin),
             after = momentum_of(inertia, out.rotation, out.spin);
  const Vec3 moment = ((after - before) / dt - (1 - scheme.g) * moment_taken(inertia, from)) / scheme.g;
  out.rate = rate_of_spin(inertia, out.rotation, out.spin, moment, free, held_alone(to.rate, free));
  return out;
}

double corrected_turn(const Model<2>& /*model*/, int /*node*/, double path, double by) {
  return path + by;
}

/// Composes two rotations. For a node that is fixed about some axis the vectors are added: the sum of two rotations
/// about free axes has no component on the other axes, unlike their composition.
Vec3 corrected_turn(const Model<3>& model, int node, const Vec3& path, const Vec3& by) {
  return is_all_free(free_turns(model, node)) ? turned_on(by, path) : Vec3(path + by);
}

Vec3 moment_taken(const Vec3& inertia, const TurnMotion<3>& motion) {
  return momentum_of(inertia, motion.rotation, motion.rate) +
         cross(motion.spin, momentum_of(inertia, motion.rotation, motion.spin));
}

double spin_rate_under(const Model<2>& model, const State<2>& /*state*/, int node, double moment) {
  return model.support[node][2] == Support::free ? moment / model.inertia[node] : 0;
}
Vec3 spin_rate_under(const Model<3>& model, const State<3>& state, int node, const Vec3& moment) {
  return rate_of_spin(model.inertia[node], state.rotation[node], state.spin[node], moment, free_turns(model, node),
                      Vec3::Zero());
}

Dofs<2> damping_by_mass(const Model<2>& model, const State<2>& state, int node) {
  const Dofs<2> mass = mass_of(model, state, node), v = velocity_of(state, node);
  Dofs<2> out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = model.mass_damping * mass[k] * v[k];
  return out;
}
Dofs<3> damping_by_mass(const Model<3>& model, const State<3>& state, int node) {
  if (model.mass_damping == 0) return {};
  const Vec3 turning = momentum_of(model.inertia[node], state.rotation[node], state.spin[node]);
  return dofs_of(Vec3(model.mass_damping * model.mass[node] * state.velocity[node]),
                 Vec3(model.mass_damping * turning));
}

Dofs<2> inertia_column(const Model<2>& model, const State<2>& state, const Freedom& f, double inertia,
                       double /*rate*/) {
  Dofs<2> out{};
  out[f.k] = inertia * mass_of(model, state, f.node)[f.k];
  return out;
}

// With e the axis of the unknown, a rotation by h e changes I w to I w + h (e x L - I (e x w)), and w by c h e.
Dofs<3> inertia_column(const Model<3>& model, const State<3>& state, const Freedom& f, double inertia, double rate) {
  Dofs<3> out{};
  if (f.k < 3) {
    out[f.k] = inertia * model.mass[f.node];
    return out;
  }
  const Vec3 &own = model.inertia[f.node], &spin = state.spin[f.node], axis = Vec3::Unit(f.k - 3);
  const UnitQuaternion& rotation = state.rotation[f.node];
  Vec3 moment = momentum_of(own, rotation, axis);
  if (rate > 0)
    moment += (cross(axis, momentum_of(own, rotation, spin)) - momentum_of(own, rotation, cross(axis, spin))) / rate;
  return dofs_of(Vec3(Vec3::Zero()), Vec3(inertia * moment));
}

}  // namespace trilith
