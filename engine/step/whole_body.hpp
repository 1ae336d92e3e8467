// A body of elements in the plane as a whole: its mass, its centre, and the part of motions that is rigid.
#pragma once

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

/// It moves as a rigid body where none of its nodes is held; `mass` and `inertia` are those of its nodes.
struct WholeBody {
  bool is_free = false;
  double mass = 0, inertia = 0;  ///< [kg], [kg m2] about its centre of mass
  Vec2 centre = Vec2::Zero();    ///< [m]
};

/// True of quads and meshes: elements whose nodes do not turn.
inline bool is_of_elements(const Body& body) {
  return !body.is_rigid() && !body.nodes_turn();
}

inline WholeBody whole_body(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  WholeBody whole;
  whole.is_free = true;
  const int end = b.first_node + b.nodes;
  for (int n = b.first_node; n < end; ++n) {
    whole.is_free = whole.is_free && model.support[n][0] == Support::free && model.support[n][1] == Support::free;
    whole.mass += model.mass[n], whole.centre += model.mass[n] * state.position[n];
  }
  whole.centre /= whole.mass;
  for (int n = b.first_node; n < end; ++n)
    whole.inertia += model.mass[n] * (state.position[n] - whole.centre).squaredNorm();
  return whole;
}

/// A motion of the body as if it were rigid: of its centre, and about it. Of velocities or of accelerations.
struct RigidPart {
  Vec2 along = Vec2::Zero(), centre = Vec2::Zero();
  double about = 0;

  [[nodiscard]] Vec2 at(const Vec2& place) const { return along + about * left_of(place - centre); }
};

/// Of a body with momenta of(n) at its nodes, the motion with the same momentum and angular momentum; forces give
/// accelerations likewise. Nothing of a body that is held.
template <class Momentum>
RigidPart rigid_part(const Model<2>& model, const State<2>& state, int body, const WholeBody& whole, Momentum&& of) {
  RigidPart out;
  if (!whole.is_free) return out;
  const Body& b = model.bodies[body];
  out.centre = whole.centre;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const Vec2 momentum = of(n);
    out.along += momentum, out.about += cross(state.position[n] - whole.centre, momentum);
  }
  out.along /= whole.mass, out.about /= whole.inertia;
  return out;
}

}  // namespace trilith
