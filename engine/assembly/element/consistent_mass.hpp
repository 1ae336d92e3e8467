// Consistent mass of frames under implicit steps and in modes: the difference from the lumped mass of the nodes.
// Explicit steps keep the lumped mass, because they divide by it. In space the same holds with
// element/beam/beam_inertia_3d.hpp.
//
//   E = G' f(y, dy/dt) - M_lumped dv/dt,   y = G v: the ends of the beam, which rigid arms connect to its nodes.
//
// The function f is defined in element/beam/beam_inertia.hpp. E contains all directions of a beam's nodes, also
// prescribed ones, where the support does its work.
#pragma once

#include <vector>

#include "assembly/node_forces.hpp"
#include "element/beam/beam_inertia.hpp"
#include "element/beam/beam_inertia_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Consistent minus lumped mass of the beam's two nodes, in world axes, in its present position.
BeamMatrix added_mass(const Model<2>& model, const State<2>& state, const Beam& beam);

BeamMatrix3 added_mass(const Model<3>& model, const State<3>& state, const Beam3& beam);

/// True if a beam has a consistent mass, or a body of one element has its own rotary inertia
/// (assembly/element/rotary_inertia.hpp).
template <int D>
bool has_added_mass(const Model<D>& model);

/// E of all nodes [N], [N m]; empty if has_added_mass is false. With `rising` false it contains the velocity terms
/// alone.
void added_inertia(const Model<2>& model, const State<2>& state, bool rising, std::vector<Dofs<2>>& out);
void added_inertia(const Model<3>& model, const State<3>& state, bool rising, std::vector<Dofs<3>>& out);

/// Forces of all nodes at the evaluated state for implicit steps, with the damping of the selected mass.
template <int D>
std::vector<NodeForces<D>> implicit_forces(const Model<D>& model, const State<D>& state, const Work<D>& work);

/// Additional damping by mass, -mass_damping (M - M_lumped) v, of free directions [N], [N m]; empty if zero.
template <int D>
void added_damping(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out);

/// Additional kinetic energy [J].
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state);

/// Work of the supports on it along `path` of a node [J].
template <int D>
double work_on_support(const Model<D>& model, int node, const std::type_identity_t<Dofs<D>>& force,
                       const std::type_identity_t<Dofs<D>>& path);

/// Accelerations of the free directions [m/s2], [rad/s2] from the forces on them, by conjugate gradients; 0 for the
/// others.
template <int D>
std::vector<Dofs<D>> accelerations(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& force);

}  // namespace trilith
