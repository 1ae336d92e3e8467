// A meshed body as a whole: its mass, its centre, and the rigid part of its motions.
//
// The body can translate along an axis if no node is fixed along it, and rotate about an axis if it can translate along
// both others. A body whose nodes are all fixed out of its plane translates in the plane and rotates in it.
#pragma once

#include <Eigen/LU>

#include <span>
#include <type_traits>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Rotary inertia: a number in the plane, a tensor in space [kg m2].
template <int D>
using TurnInertia = std::conditional_t<D == 2, double, Eigen::Matrix3d>;

/// `mass` and `inertia` are sums over its nodes.
template <int D>
struct WholeBody {
  Vec<D> goes = Vec<D>::Zero();        ///< 1 along axes of free translation, otherwise 0
  Spin<D> turns = nothing<Spin<D>>();  ///< 1 about axes of free rotation, otherwise 0
  double mass = 0;                     ///< [kg]
  TurnInertia<D> inertia{};            ///< about its centre of mass [kg m2]
  Vec<D> centre = Vec<D>::Zero();      ///< of mass [m]

  /// True if it has some rigid motion.
  [[nodiscard]] bool moves() const { return goes.sum() > 0; }
  /// True if none of its nodes is constrained.
  [[nodiscard]] bool is_free() const { return goes.sum() == D; }
};

/// True for quads, bricks and meshes: elements whose nodes do not turn.
inline bool is_of_elements(const Body& body) {
  return !body.is_rigid() && !body.nodes_turn();
}

/// Axes of free rotation from the axes of free translation.
inline double turns_of(const Vec2& goes) {
  return goes.x() * goes.y();
}
inline Vec3 turns_of(const Vec3& goes) {
  return {goes.y() * goes.z(), goes.z() * goes.x(), goes.x() * goes.y()};
}

/// Rotary inertia of a mass at `arm`.
inline double turn_inertia(double mass, const Vec2& arm) {
  return mass * arm.squaredNorm();
}
inline Eigen::Matrix3d turn_inertia(double mass, const Vec3& arm) {
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

/// The body with its nodes at `position` [node] [m].
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

/// Rotation rate of the body from an angular momentum, or from a moment: about all axes, about its one free axis, or
/// zero.
inline double turn_from(const WholeBody<2>& whole, double moment) {
  return whole.turns * moment / whole.inertia;
}
inline Vec3 turn_from(const WholeBody<3>& whole, const Vec3& moment) {
  if (whole.is_free()) return whole.inertia.inverse() * moment;
  return whole.turns.cwiseProduct(moment).cwiseQuotient(Vec3(whole.inertia.diagonal()));
}

/// Gyroscopic moment w x I w of a rotating body [N m].
inline double gyroscopic(const WholeBody<2>& /*whole*/, double /*spin*/) {
  return 0;
}
inline Vec3 gyroscopic(const WholeBody<3>& whole, const Vec3& spin) {
  return cross(spin, Vec3(whole.inertia * spin));
}

/// Rigid motion of the body: translation of its centre and rotation about it. Velocities, or accelerations of a body
/// with the spin `spin`.
template <int D>
struct RigidPart {
  Vec<D> along = Vec<D>::Zero(), centre = Vec<D>::Zero();
  Spin<D> about = nothing<Spin<D>>(), spin = nothing<Spin<D>>();

  [[nodiscard]] Vec<D> at(const Vec<D>& place) const { return along + cross(about, Vec<D>(place - centre)); }
  /// Acceleration at a point, including the centripetal part.
  [[nodiscard]] Vec<D> turning_at(const Vec<D>& place) const {
    const Vec<D> arm = place - centre;
    return along + cross(about, arm) + cross(spin, cross(spin, arm));
  }
};

/// The rigid motion with the same momentum and angular momentum as the nodal momenta of(n), along the free axes of the
/// body.
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
