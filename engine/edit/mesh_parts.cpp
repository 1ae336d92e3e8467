#include "edit/mesh_parts.hpp"

#include <algorithm>

#include "model/element/one_element.hpp"

namespace trilith {

template <int D>
int first_element_of(const Model<D>& model, int body) {
  const auto& elements = elements_of(model);
  return static_cast<int>(&first_element(elements, body) - elements.data());
}
template int first_element_of(const Model<2>&, int);
template int first_element_of(const Model<3>&, int);

template <int D>
MeshParts<D>::MeshParts(const Model<D>& model, const SplitBody& split, const MeshCut& cut)
    : model_(model), split_(split), first_node_(model.bodies[static_cast<std::size_t>(split.body)].first_node) {
  const auto& elements = elements_of(model);
  std::array next{first_element_of(model, split.behind), first_element_of(model, split.ahead)};
  const int nodes = model.bodies[static_cast<std::size_t>(split.body)].nodes;
  for (std::vector<int>& of : copy_) of.assign(static_cast<std::size_t>(nodes), -1);
  const int first = first_element_of(model, split.body);
  for (std::size_t e = 0; e < cut.behind.size(); ++e) {
    const std::size_t side = cut.behind[e] != 0 ? 0 : 1;
    const int whole = first + static_cast<int>(e), own = next[side]++;
    const auto &from = elements[static_cast<std::size_t>(whole)], &to = elements[static_cast<std::size_t>(own)];
    for (std::size_t i = 0; i < static_cast<std::size_t>(nodes_of(from)); ++i)
      copy_[side][static_cast<std::size_t>(from.node[i] - first_node_)] = to.node[i];
    elements_.push_back({whole, own});
  }
  for (const int side : {0, 1}) add_pieces(side);
}

template <int D>
std::vector<int> MeshParts<D>::continued_nodes() const {
  std::vector<int> out;
  for (const int side : {0, 1}) {
    const Body& part = model_.bodies[static_cast<std::size_t>(body(side))];
    const std::size_t first = out.size();
    out.resize(first + static_cast<std::size_t>(part.nodes), -1);
    const std::vector<int>& copies = copy_[static_cast<std::size_t>(side)];
    for (std::size_t i = 0; i < copies.size(); ++i)
      if (copies[i] >= 0)
        out[first + static_cast<std::size_t>(copies[i] - part.first_node)] = first_node_ + static_cast<int>(i);
  }
  return out;
}

template <int D>
void MeshParts<D>::add_pieces(int side) {
  const auto at = static_cast<std::size_t>(side);
  const Body& part = model_.bodies[static_cast<std::size_t>(body(side))];
  for (int p = part.first_piece; p < part.first_piece + part.pieces; ++p) {
    const int first = model_.piece_first[static_cast<std::size_t>(p)], corners = model_.corners_of(p);
    std::vector<int> nodes;
    for (int k = 0; k < corners; ++k) {
      const auto corner = static_cast<std::size_t>(first + k);
      const int skin = model_.corner_skin[corner],
                after = model_.corner_skin[static_cast<std::size_t>(first + (k + 1) % corners)];
      nodes.push_back(model_.skin_node[static_cast<std::size_t>(skin)]);
      if (D == 2 && model_.edge_is_face[corner] != 0) faces_[at][{skin, after}] = p;
    }
    std::sort(nodes.begin(), nodes.end());
    pieces_[at][nodes] = p;
  }
}

template <int D>
PartPiece MeshParts<D>::piece(int piece) const {
  const int first = model_.piece_first[static_cast<std::size_t>(piece)];
  for (const int side : {0, 1}) {
    std::vector<int> nodes;
    for (int k = first; k < first + model_.corners_of(piece); ++k)
      nodes.push_back(
          copy(side, model_.skin_node[static_cast<std::size_t>(model_.corner_skin[static_cast<std::size_t>(k)])]));
    std::sort(nodes.begin(), nodes.end());
    const auto& pieces = pieces_[static_cast<std::size_t>(side)];
    if (const auto at = pieces.find(nodes); at != pieces.end()) return {side, at->second};
  }
  return {};
}

/// The nodes of a mesh are its skin points.
template <int D>
int MeshParts<D>::skin_copy(int side, int skin) const {
  const int node = model_.skin_node[static_cast<std::size_t>(skin)];
  if (!has_node(node) || copy(side, node) < 0) return -1;
  const Body& part = model_.bodies[static_cast<std::size_t>(body(side))];
  return part.first_skin + copy(side, node) - part.first_node;
}

template <int D>
int MeshParts<D>::piece_at(int side, int from, int to) const {
  const auto& faces = faces_[static_cast<std::size_t>(side)];
  const auto at = faces.find({from, to});
  return at == faces.end() ? -1 : at->second;
}

template <int D>
PartPiece MeshParts<D>::face(int from, int to) const {
  for (const int side : {0, 1}) {
    const int a = skin_copy(side, from), b = skin_copy(side, to);
    if (a < 0 || b < 0) continue;
    if (const int piece = piece_at(side, a, b); piece >= 0) return {side, piece};
  }
  return {};
}

/// The rows of Model::fits of a piece follow each other, and its part has as many.
template <int D>
typename MeshParts<D>::Frame MeshParts<D>::frame(int frame) const {
  const Body& whole = model_.bodies[static_cast<std::size_t>(split_.body)];
  const int fit = -1 - frame;
  if (frame >= 0 || fit < whole.first_fit || fit >= whole.first_fit + whole.fits) return {};
  int piece = whole.first_piece;
  while (piece + 1 < whole.first_piece + whole.pieces && model_.piece_fit[static_cast<std::size_t>(piece + 1)] <= fit)
    ++piece;
  const PartPiece own = this->piece(piece);
  if (own.piece < 0) return {};
  const int of_part =
      model_.piece_fit[static_cast<std::size_t>(own.piece)] + fit - model_.piece_fit[static_cast<std::size_t>(piece)];
  return {own.side, -1 - of_part};
}

template <int D>
int MeshParts<D>::piece_of_element(int element) const {
  const int own = elements_[static_cast<std::size_t>(element)][1];
  const SpaceElement& e = model_.space_elements[static_cast<std::size_t>(own)];
  std::vector<int> nodes(e.node.begin(), e.node.begin() + info_of(e.shape).corners);
  std::sort(nodes.begin(), nodes.end());
  const auto& pieces = pieces_[e.body == split_.behind ? 0 : 1];
  const auto at = pieces.find(nodes);
  return at == pieces.end() ? -1 : at->second;
}

template class MeshParts<2>;
template class MeshParts<3>;

}  // namespace trilith
