// Rotary inertia of free quads in the plane, four at a time.
//
// Most quads are parallelograms. Their own moment of inertia is a third of the moment Jl of their lumped masses m_i at
// arms r_i from the centroid. So the moment M of the nodal forces needs the additional forces
//   f_i = (3 / Jl - 1 / Jl) M m_i (-r_iy, r_ix) - (1 - 1/3) s^2 m_i r_i,      s the spin,
// which rotary_inertia.hpp states for any body of one element.
#pragma once

#include <array>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Quads that one thread takes in one call.
inline constexpr int quads_at_a_time = 128;

/// A list of quads whose four nodes are free, and the forces on these nodes.
struct FreeQuads {
  std::array<int, quads_at_a_time + 3> first_node;     ///< the entries after `count` are room for a whole group of four
  std::array<const Vec2*, quads_at_a_time + 3> force;  ///< of the first of four nodes [N]
  std::array<bool, quads_at_a_time + 3> skewed;        ///< result: no parallelogram within a part in a thousand
  int count = 0;

  void add(int node, const Vec2* on) {
    const auto i = static_cast<std::size_t>(count++);
    first_node[i] = node, force[i] = on;
  }
};

/// Adds the additional forces of the parallelograms to `added` [node] [N], and marks the quads of another shape, to
/// which nothing is added.
void add_quad_rotation(const Model<2>& model, const State<2>& state, FreeQuads& quads, std::vector<Vec2>& added);

}  // namespace trilith
