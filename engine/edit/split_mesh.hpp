// Meshes that split: the rows of their parts, and the motion, links and contacts that move to them from the body.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "edit/split_contacts.hpp"
#include "model/crack_planes.hpp"
#include "model/state.hpp"

namespace trilith {

/// Rows of a mesh that has split, and the rows of its two parts that continue them. Side 0 is behind the cut, 1 ahead.
class MeshParts {
 public:
  /// `model` has the parts at the ends of its arrays. Refers to it, so it must not be reallocated.
  MeshParts(const Model<2>& model, const SplitBody& split, const MeshCut& cut);

  [[nodiscard]] int body(int side) const { return side == 0 ? split_.behind : split_.ahead; }
  [[nodiscard]] bool has_node(int node) const {
    return node >= first_node_ && node < first_node_ + static_cast<int>(copy_[0].size());
  }
  /// The copy of a node of the body on a side, or -1.
  [[nodiscard]] int copy(int side, int node) const {
    return copy_[static_cast<std::size_t>(side)][static_cast<std::size_t>(node - first_node_)];
  }
  [[nodiscard]] bool on_both(int node) const { return copy(0, node) >= 0 && copy(1, node) >= 0; }
  /// The skin point of a part at a skin point of the body, or -1.
  [[nodiscard]] int skin_copy(int side, int skin) const;
  /// The side whose part has the face between two skin points of the body, counter-clockwise, and its piece; -1: none.
  struct Face {
    int side = -1, piece = -1;
  };
  [[nodiscard]] Face face(int from, int to) const;
  /// The piece of a part at a face between two of its own skin points; -1: none.
  [[nodiscard]] int piece_at(int side, int from, int to) const;
  /// The piece that continues a piece of the body, and its side; -1: none.
  [[nodiscard]] Face piece(int piece) const;
  /// Pairs of elements: of the body, and of the part that has it.
  [[nodiscard]] const std::vector<std::array<int, 2>>& elements() const { return elements_; }

 private:
  void add_pieces(int side);

  const Model<2>& model_;
  SplitBody split_;
  int first_node_;
  std::array<std::vector<int>, 2> copy_;
  std::array<std::map<std::pair<int, int>, int>, 2> faces_;  // by skin points of the part
  std::array<std::map<std::vector<int>, int>, 2> pieces_;    // by its nodes, sorted
  std::vector<std::array<int, 2>> elements_;
};

/// Sets the motion of both parts to the motion of their body, with their faces apart by their opening, and copies the
/// plastic strains. The body is deactivated, without deformation.
void place_mesh_parts(const Model<2>& model, State<2>& state, const SplitBody& split, const MeshCut& cut);

/// Attaches bearings, seats, loads and displacement controls to the part that has their element, and gives both parts
/// the supports, motions and steady forces of their nodes. Forces at a node of the cut are divided like its mass.
void hand_over_mesh_links(Model<2>& model, const SplitBody& split, const MeshCut& cut);

/// Gives the contacts of the body to its parts, which have the same faces.
std::vector<ContactRecord> mesh_handed_over(const Model<2>& model, const std::vector<ContactRecord>& records,
                                            const SplitBody& split, const MeshCut& cut);

/// The contacts of both parts across the faces of the cut: whole bonds, with the shear of its stress.
std::vector<ContactRecord> mesh_crack_contacts(const Model<2>& model, const SplitBody& split,
                                               const CrackingBody<2>& row, const Crack<2>& crack);

}  // namespace trilith
