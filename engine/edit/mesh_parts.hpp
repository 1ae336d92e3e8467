// Rows of a mesh that has split, and the rows of its two parts that continue them.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "edit/split_contacts.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// A piece of a part. Side 0 is behind the cut, 1 ahead; -1: none.
struct PartPiece {
  int side = -1, piece = -1;
};

template <int D>
class MeshParts {
 public:
  /// `model` has the parts at the ends of its arrays. Refers to it, so it must not be reallocated.
  MeshParts(const Model<D>& model, const SplitBody& split, const MeshCut& cut);

  [[nodiscard]] int body(int side) const { return side == 0 ? split_.behind : split_.ahead; }
  [[nodiscard]] bool has_node(int node) const {
    return node >= first_node_ && node < first_node_ + static_cast<int>(copy_[0].size());
  }
  /// The copy of a node of the body on a side, or -1.
  [[nodiscard]] int copy(int side, int node) const {
    return copy_[static_cast<std::size_t>(side)][static_cast<std::size_t>(node - first_node_)];
  }
  /// For each node of the part behind, then of the part ahead, the node of the body that it continues.
  [[nodiscard]] std::vector<int> continued_nodes() const;
  [[nodiscard]] bool on_both(int node) const { return copy(0, node) >= 0 && copy(1, node) >= 0; }
  /// The piece that continues a piece of the body.
  [[nodiscard]] PartPiece piece(int piece) const;
  /// Pairs of elements: of the body, and of the part that has it.
  [[nodiscard]] const std::vector<std::array<int, 2>>& elements() const { return elements_; }

  /// In the plane: the skin point of a part at a skin point of the body, or -1.
  [[nodiscard]] int skin_copy(int side, int skin) const;
  /// In the plane: the piece whose face lies between two skin points of the body, counter-clockwise.
  [[nodiscard]] PartPiece face(int from, int to) const;
  /// In the plane: the piece of a part at a face between two of its own skin points; -1: none.
  [[nodiscard]] int piece_at(int side, int from, int to) const;

  /// In space: the contact frame of the body's parts that continues one of its contact frames, and its side; -1: none.
  struct Frame {
    int side = -1, frame = 0;
  };
  [[nodiscard]] Frame frame(int frame) const;
  /// In space: the piece of a part that has an element of the body (counted from its first), or -1.
  [[nodiscard]] int piece_of_element(int element) const;

 private:
  void add_pieces(int side);

  const Model<D>& model_;
  SplitBody split_;
  int first_node_;
  std::array<std::vector<int>, 2> copy_;
  std::array<std::map<std::pair<int, int>, int>, 2> faces_;  // by skin points of the part; in the plane
  std::array<std::map<std::vector<int>, int>, 2> pieces_;    // by its nodes, sorted
  std::vector<std::array<int, 2>> elements_;
};

/// Index of the first element of a body that has elements.
template <int D>
int first_element_of(const Model<D>& model, int body);

}  // namespace trilith
