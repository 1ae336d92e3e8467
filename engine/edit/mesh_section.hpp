// Stress in the section of a mesh before it cracks, from the balance of its nodes.
//
// A node of the cut belongs to elements behind the cut and to elements ahead of it. Its copies behind and ahead have
// the masses m_a and m_b, and the elements on both sides the internal forces F_a and F_b. External forces E are divided
// like the masses. Both copies keep the acceleration of the node under the force T of the part ahead on the part
// behind:
//
//     T = m_a a - F_a - E m_a / m = (m_a F_b - m_b F_a) / m,     m = m_a + m_b,    m a = F_a + F_b + E
//
// So inertia, weight, supports and loads cancel, and no stiffness is added. The stress is interpolated as the
// displacements are, and has the nodal forces T: the system of the consistent matrices of the edges, in space of the
// faces. Source: Camacho and Ortiz, "Computational modelling of impact damage in brittle materials", Int. J. Solids
// Structures 33, 1996.
#pragma once

#include <array>
#include <vector>

#include "base/space.hpp"
#include "edit/crack_scratch.hpp"
#include "model/crack_cut.hpp"

namespace trilith {

/// [node of the cut] force of the part ahead on the part behind [N]. References into `scratch`, also from the functions
/// below, are valid until its next use.
template <int D>
const std::vector<Vec<D>>& cut_forces(const Model<D>& model, const State<D>& state, int body, const MeshCut& cut,
                                      CrackScratch<D>& scratch);

/// Cracks of the meshes among `cracking`, in their order: the section of each that uses most of its strength, if this
/// is more than the share `limit`. The edges or faces of a cut are compared one by one, as sections of their own.
template <int D>
CrackSearch<D> mesh_cracks(const Model<D>& model, const State<D>& state, const Cracking<D>& cracking,
                           CrackScratch<D>& scratch, double limit = 1);

/// The edge or face of a cut that uses most of its strength. Its place, and the stress of the whole cut as
/// Crack::traction has it, are computed where this is more than the share `limit`.
template <int D>
struct WorstPlace {
  SectionUse use;
  Vec<D> place = Vec<D>::Zero();  ///< [m]
  std::vector<Vec<D>> traction;
};
WorstPlace<2> worst_place(const Model<2>& model, const State<2>& state, const CrackingBody<2>& row, const MeshCut& cut,
                          CrackScratch<2>& scratch, double limit);
WorstPlace<3> worst_place(const Model<3>& model, const State<3>& state, const CrackingBody<3>& row, const MeshCut& cut,
                          CrackScratch<3>& scratch, double limit);

// In the plane.

/// The rotation of each node of a cut from the initial position: the mean of the edges at it.
std::vector<Turn> turns_of_cut(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut);

/// [node of the cut] stress on the part behind, along the axes of the world [Pa]. At the thickness of the contacts of
/// the model, so that it carries the forces of elements of any thickness.
const std::vector<Vec2>& mesh_tractions(const Model<2>& model, const State<2>& state, int body, const MeshCut& cut,
                                        CrackScratch<2>& scratch);

/// Distance of both copies of each node of a cut at which the bond of a law carries the stress `traction` [node of the
/// cut], in the initial position of the body [m]. Where the edges at a node are in one line it is along their normal.
std::vector<Vec2> cut_openings(const Model<2>& model, int body, const MeshCut& cut, const std::vector<Vec2>& traction,
                               const ContactLaw& law);

// In space the faces of a cut are plates in contact: they carry normal stress that is linear over each face, uniform
// shear, and a couple about the normal (model/contact/contact_frame.hpp).

/// `nodes`: present positions of the nodes of the cut [m].
PlacedPlate placed_plate(const std::vector<Vec3>& nodes, const CutFace& face);

/// [face of the cut] resultants of the stress at the nodes, along the axes of each face. `rounds`: corrections after
/// the first solution, by which the forces of the plates on the nodes approach T.
const std::vector<SpaceForces>& plate_forces(const Model<3>& model, const State<3>& state, int body,
                                             const SpaceCut& cut, CrackScratch<3>& scratch, int rounds);

/// Adds the forces of a plate on the part behind to the nodes of the cut [N].
void add_plate_forces(const CutFace& face, const PlacedPlate& now, const SpaceForces& forces,
                      std::vector<Vec3>& node_force);

/// Resultants as the two vectors of a face in Crack::traction, and back.
std::array<Vec3, 2> packed_forces(const SpaceForces& forces);
SpaceForces unpacked_forces(const Crack<3>& crack, std::size_t face);

}  // namespace trilith
