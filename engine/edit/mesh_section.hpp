// Stress in the section of a mesh before it cracks, from the balance of its nodes.
//
// A node of the cut belongs to elements behind the cut and to elements ahead of it. Its copies behind and ahead have
// the masses m_a and m_b, and the elements on both sides the internal forces F_a and F_b. External forces E are divided
// like the masses. Both copies keep the acceleration of the node under the force T of the part ahead on the part
// behind:
//
//     T = m_a a - F_a - E m_a / m = (m_a F_b - m_b F_a) / m,     m = m_a + m_b,    m a = F_a + F_b + E
//
// So inertia, weight, supports and loads cancel, and no stiffness is added. The stress is linear along each edge and
// has the nodal forces T: the tridiagonal system of the edges' consistent matrices. Source: Camacho and Ortiz,
// "Computational modelling of impact damage in brittle materials", Int. J. Solids Structures 33, 1996.
#pragma once

#include <optional>
#include <vector>

#include "base/space.hpp"
#include "edit/crack_search.hpp"

namespace trilith {

/// The rotation of each node of a cut from the initial position: the mean of the edges at it.
std::vector<Turn> turns_of_cut(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut);

/// [node of the cut] stress on the part behind, along the axes of the world [Pa]. At the thickness of the contacts of
/// the model, so that it carries the forces of elements of any thickness.
std::vector<Vec2> mesh_tractions(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut,
                                 Work<2>& scratch);

/// Cracks of the meshes among `cracking`, in their order: the section of each that uses most of its strength, if this
/// is more than all. The edges of a cut are compared one by one, as sections of their own.
std::vector<Crack<2>> mesh_cracks(const Model<2>& model, const State<2>& state, const Cracking<2>& cracking);
std::vector<Crack<3>> mesh_cracks(const Model<3>& model, const State<3>& state, const Cracking<3>& cracking);

/// Distance of both copies of each node of a cut at which the bond of a law carries the stress `traction` [node of the
/// cut], in the initial position of the body [m]. Where the edges at a node are in one line it is along their normal.
std::vector<Vec2> cut_openings(const Model<2>& model, int body, const MeshCut& cut, const std::vector<Vec2>& traction,
                               const ContactLaw& law);

}  // namespace trilith
