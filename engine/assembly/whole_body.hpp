// A body of elements as a whole: its mass, its centre, and the part of motions that is rigid.
//
// Along an axis along which no node is held the body may move as a whole, and about an axis where both across are so.
// One that is held in its plane by all nodes goes along the plane and turns in it.
#pragma once

#include <Eigen/LU>

#include <span>
#include <type_traits>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Resistance to turns: one number in the plane, a tensor in space [kg m2].
template <int D>
using TurnInertia = std::conditional_t<D == 2, double, Eigen::Matrix3d>;

/// `mass` and `inertia` are those of its nodes.
template <int D>
struct WholeBody {
  Vec<D> goes = Vec<D>::Zero();        ///< 1 along the axes along which it may move as a whole, else 0
  Spin<D> turns = nothing<Spin<D>>();  ///< 1 about the axes about which it may turn as a whole, else 0
  double mass = 0;                     ///< [kg]
  TurnInertia<D> inertia{};            ///< about its centre of mass [kg m2]
  Vec<D> centre = Vec<D>::Zero();      ///< of mass [m]

  /// It has some rigid motion.
  [[nodiscard]] bool moves() const { return goes.sum() > 0; }
  /// None of its nodes is held.
  [[nodiscard]] bool is_free() const { return goes.sum() == D; }
};

/// True of quads, bricks and meshes: elements whose nodes do not turn.
inline bool is_of_elements(const Body& body) {
  return !body.is_rigid() && !body.nodes_turn();
}

/// About which axes a body turns that goes along these.
inline double turns_of(const Vec2& goes) {
  return goes.x() * goes.y();
}
inline Vec3 turns_of(const Vec3& goes) {
  return {goes.y() * goes.z(), goes.z() * goes.x(), goes.x() * goes.y()};
}

/// Of a mass at `arm`.
inline double turn_inertia(double mass, const Vec2& arm) {
  return mass * arm.squaredNorm();
}
inline Eigen::Matrix3d turn_inertia(double mass, const Vec3& arm) {
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

/// With its nodes at `position` [node] m.
template <int D>
WholeBody<D> whole_body(const Model<D>& model, const std::vector<Vec<D>>& position, int body) {
  const Body& b = model.bodies[body];
  WholeBody<D> whole;
  whole.goes.setOnes();
  if constexpr (D == 3) whole.inertia.setZero();
  const int end = b.first_node + b.nodes;
  for (int n = b.first_node; n < end; ++n) {
    for (int k = 0; k < D; ++k)
      if (model.support[n][k] != Support::free) whole.goes[k] = 0;
    whole.mass += model.mass[n], whole.centre += model.mass[n] * position[n];
  }
  whole.turns = turns_of(whole.goes);
  whole.centre /= whole.mass;
  for (int n = b.first_node; n < end; ++n)
    whole.inertia += turn_inertia(model.mass[n], Vec<D>(position[n] - whole.centre));
  return whole;
}
template <int D>
WholeBody<D> whole_body(const Model<D>& model, const State<D>& state, int body) {
  return whole_body(model, state.position, body);
}

/// The turn that an angular momentum, or a moment, makes of the body: about all axes, the one it may turn about, or
/// none.
inline double turn_from(const WholeBody<2>& whole, double moment) {
  return whole.turns * moment / whole.inertia;
}
inline Vec3 turn_from(const WholeBody<3>& whole, const Vec3& moment) {
  if (whole.is_free()) return whole.inertia.inverse() * moment;
  return whole.turns.cwiseProduct(moment).cwiseQuotient(Vec3(whole.inertia.diagonal()));
}

/// w x I w: what the angular momentum of a turning body changes by as its axes turn [N m].
inline double gyroscopic(const WholeBody<2>& /*whole*/, double /*spin*/) {
  return 0;
}
inline Vec3 gyroscopic(const WholeBody<3>& whole, const Vec3& spin) {
  return cross(spin, Vec3(whole.inertia * spin));
}

/// A motion of the body as if it were rigid: of its centre, and about it. Velocities; or accelerations, of a body that
/// turns with `spin`.
template <int D>
struct RigidPart {
  Vec<D> along = Vec<D>::Zero(), centre = Vec<D>::Zero();
  Spin<D> about = nothing<Spin<D>>(), spin = nothing<Spin<D>>();

  [[nodiscard]] Vec<D> at(const Vec<D>& place) const { return along + cross(about, Vec<D>(place - centre)); }
  /// Of accelerations, with those that the turn has towards its axis.
  [[nodiscard]] Vec<D> turning_at(const Vec<D>& place) const {
    const Vec<D> arm = place - centre;
    return along + cross(about, arm) + cross(spin, cross(spin, arm));
  }
};

/// Of a body with momenta of(n) at its nodes, the motion with the same momentum and angular momentum, as far as it may
/// go along.
template <int D, class Momentum>
RigidPart<D> rigid_part(const Model<D>& model, const State<D>& state, int body, const WholeBody<D>& whole,
                        Momentum&& of) {
  RigidPart<D> out;
  if (!whole.moves()) return out;
  const Body& b = model.bodies[body];
  out.centre = whole.centre;
  Moment<D> moment = nothing<Moment<D>>();
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const Vec<D> momentum = of(n);
    out.along += momentum, moment += cross(Vec<D>(state.position[n] - whole.centre), momentum);
  }
  out.along = whole.goes.cwiseProduct(out.along) / whole.mass;
  out.about = turn_from(whole, moment);
  return out;
}

}  // namespace trilith
