#include "assembly/element/spin_terms.hpp"

#include "assembly/element/integration_shares.hpp"

namespace trilith {
namespace {

/// s x (s x r).
Vec2 centripetal(const TurnVector<2>& spin, const Vec2& arm) {
  return -spin[0] * spin[0] * arm;
}
Vec3 centripetal(const Vec3& spin, const Vec3& arm) {
  return cross(spin, cross(spin, arm));
}

TurnVector<2> rotation_rate(const TurnVector<2>& /*spin*/, const TurnVector<2>& /*vector*/) {
  return TurnVector<2>::Zero();
}
Vec3 rotation_rate(const Vec3& spin, const Vec3& vector) {
  return cross(spin, vector);
}

Vec2 rotation_velocity(const TurnVector<2>& spin, const Vec2& arm) {
  return cross(spin[0], arm);
}
Vec3 rotation_velocity(const Vec3& spin, const Vec3& arm) {
  return cross(spin, arm);
}

/// The rate of the inertia of masses whose arms change by `moved`, times the spin.
template <int D>
TurnVector<D> inertia_rate(const MassCloud<D>& cloud, const NodeVectors<D>& moved, const TurnVector<D>& spin) {
  TurnVector<D> sum = TurnVector<D>::Zero();
  for (int i = 0; i < cloud.count; ++i) {
    const Vec<D>&r = cloud.arm[i], &u = moved[i];
    if constexpr (D == 2)
      sum += 2 * cloud.mass[i] * r.dot(u) * spin;
    else
      sum += cloud.mass[i] * (2 * r.dot(u) * spin - u.dot(spin) * r - r.dot(spin) * u);
  }
  return sum;
}

/// Velocities of the nodes without translation and rotation.
template <int D>
NodeVectors<D> deformation(const RotaryInertia<D>& of, const NodeVectors<D>& velocity, const TurnVector<D>& spin) {
  NodeVectors<D> out;
  Vec<D> momentum = Vec<D>::Zero();
  double mass = 0;
  for (int i = 0; i < of.nodes.count; ++i) momentum += of.nodes.mass[i] * velocity[i], mass += of.nodes.mass[i];
  for (int i = 0; i < of.nodes.count; ++i)
    out[i] = velocity[i] - momentum / mass - rotation_velocity(spin, of.nodes.arm[i]);
  return out;
}

/// The same at the integration points.
template <int D>
NodeVectors<D> at_points(const RotaryInertia<D>& of, const NodeVectors<D>& nodes) {
  NodeVectors<D> out;
  for (int g = 0; g < of.points.count; ++g) {
    out[g].setZero();
    for (int i = 0; i < corners_in<D>; ++i) out[g] += node_share<D>(i, g) * nodes[of.place[i]];
  }
  return out;
}

}  // namespace

template <int D>
SpinTerms<D>::SpinTerms(const RotaryInertia<D>& of, const TurnVector<D>& momentum) {
  const TurnMatrix<D> back = of.lumped.inverse();
  const double lack = 1 - 1 / of.multiple;
  spin = back * momentum;
  rate = -lack * (back * rotation_rate(spin, momentum));
  for (int i = 0; i < of.nodes.count; ++i) force[i] = lack * of.nodes.mass[i] * centripetal(spin, of.nodes.arm[i]);
}

template <int D>
SpinTerms<D>::SpinTerms(const RotaryInertia<D>& of, const NodeVectors<D>& velocity) {
  const TurnVector<D> momentum = angular_momentum(of, [&](int i) { return velocity[i]; });
  if (of.multiple > 0) {
    *this = SpinTerms(of, momentum);
    return;
  }
  const TurnMatrix<D> back = of.lumped.inverse();
  spin = back * momentum;
  const NodeVectors<D> moved = deformation(of, velocity, spin);
  const TurnVector<D> turned = rotation_rate(spin, momentum), lumped = inertia_rate(of.nodes, moved, spin) + turned,
                      own = inertia_rate(of.points, at_points(of, moved), spin) + turned;
  rate = back * (of.own * (back * lumped) - own);
  for (int i = 0; i < of.nodes.count; ++i) force[i] = of.nodes.mass[i] * centripetal(spin, of.nodes.arm[i]);
  for (int g = 0; g < of.points.count; ++g) {
    const Vec<D> inwards = of.points.mass[g] * centripetal(spin, of.points.arm[g]);
    for (int i = 0; i < corners_in<D>; ++i) force[of.place[i]] -= node_share<D>(i, g) * inwards;
  }
}

template struct SpinTerms<2>;
template struct SpinTerms<3>;

}  // namespace trilith
