// Meshes that split: the motion, links and contacts that move to their parts from the body.
#pragma once

#include <vector>

#include "edit/mesh_parts.hpp"
#include "edit/split_contacts_space.hpp"
#include "model/state.hpp"

namespace trilith {

/// Sets the motion of both parts to the motion of their body, and copies the plastic strains. In the plane their faces
/// are apart by their opening; in space the seats of their joints are. The body is deactivated, without deformation.
template <int D>
void place_mesh_parts(const Model<D>& model, State<D>& state, const SplitBody& split, const MeshCut& cut);

/// Attaches bearings, seats, loads and displacement controls to the part that has their element, and gives both parts
/// the supports, motions and steady forces of their nodes. Forces at a node of the cut are divided like its mass. In
/// space an attached point belongs to one face of the skin, and moves with it.
template <int D>
void hand_over_mesh_links(Model<D>& model, const SplitBody& split, const MeshCut& cut);

/// As crack_faces of rigid bodies, see edit/split_parts.hpp.
std::vector<SplitFace> mesh_crack_faces(const Model<2>& model, const SplitBody& split, const MeshCut& cut);

/// Gives the contacts of the body to its parts, which have the same faces.
std::vector<ContactRecord> mesh_handed_over(const Model<2>& model, const State<2>& state,
                                            const std::vector<ContactRecord>& records, const SplitBody& split,
                                            const MeshCut& cut);
std::vector<SolidRecord> mesh_handed_over(const Model<3>& model, const State<3>& state,
                                          const std::vector<SolidRecord>& records, const SplitBody& split,
                                          const MeshCut& cut);

/// The contacts of both parts across the faces of the cut: whole bonds, with the stress of the cut. `state` has the
/// parts in their positions.
std::vector<ContactRecord> mesh_crack_contacts(const Model<2>& model, const State<2>& state, const SplitBody& split,
                                               const CrackingBody<2>& row, const Crack<2>& crack);
std::vector<SolidRecord> mesh_crack_contacts(const Model<3>& model, const State<3>& state, const SplitBody& split,
                                             const CrackingBody<3>& row, const Crack<3>& crack);

}  // namespace trilith
