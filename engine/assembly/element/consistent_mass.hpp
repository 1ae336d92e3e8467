// Consistent mass of frames under implicit steps and in modes: what it adds to that lumped at the nodes, which explicit
// steps keep, as they want a mass that they can divide by.
// In space the same with element/beam/beam_inertia_3d.hpp, where beams begin and end at their nodes.
//
//   E = G' f(y, dy/dt) - M_lumped dv/dt,   y = G v: the ends of the beam, which rigid arms carry with its nodes
//
// with f of element/beam/beam_inertia.hpp. E stands for all directions of a beam's nodes, those that a support moves
// included: there the support does its work.
#pragma once

#include <vector>

#include "assembly/node_forces.hpp"
#include "element/beam/beam_inertia.hpp"
#include "element/beam/beam_inertia_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// What consistent mass adds to the lumped one of the beam's two nodes, in the world, as the beam lies.
BeamMatrix added_mass(const Model<2>& model, const State<2>& state, const Beam& beam);

BeamMatrix3 added_mass(const Model<3>& model, const State<3>& state, const Beam3& beam);

/// Some beam has a consistent mass, or some body of one element its own rotary inertia
/// (assembly/element/rotary_inertia.hpp).
template <int D>
bool has_added_mass(const Model<D>& model);

/// E of all nodes [N], [N m]; empty where has_added_mass is false. With `rising` false: of velocities alone.
void added_inertia(const Model<2>& model, const State<2>& state, bool rising, std::vector<Dofs<2>>& out);
void added_inertia(const Model<3>& model, const State<3>& state, bool rising, std::vector<Dofs<3>>& out);

/// Forces of all nodes at the evaluated state, as implicit steps have them: damping of the mass that was chosen.
template <int D>
std::vector<NodeForces<D>> implicit_forces(const Model<D>& model, const State<D>& state, const Work<D>& work);

/// What it adds to the damping by mass, -mass_damping (M - M_lumped) v, of free directions [N], [N m]; empty where it
/// adds nothing.
template <int D>
void added_damping(const Model<D>& model, const State<D>& state, std::vector<Dofs<D>>& out);

/// What it adds to the kinetic energy [J].
template <int D>
double added_kinetic(const Model<D>& model, const State<D>& state);

/// Work that supports do on it along `path` of a node [J].
template <int D>
double work_on_support(const Model<D>& model, int node, const std::type_identity_t<Dofs<D>>& force,
                       const std::type_identity_t<Dofs<D>>& path);

/// Accelerations of the free directions [m/s2, rad/s2] from the forces on them, by conjugate gradients; the others are
/// 0.
template <int D>
std::vector<Dofs<D>> accelerations(const Model<D>& model, const State<D>& state, const std::vector<Dofs<D>>& force);

}  // namespace trilith
