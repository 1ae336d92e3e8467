#include "model/builder/mesh_pieces.hpp"

#include <array>
#include <cmath>

#include "geometry/plane/convex_parts.hpp"
#include "model/flatness.hpp"

namespace trilith {

void fill_lines(Model<2>& model) {
  for (std::vector<int>* of : {&model.skin_before, &model.skin_after})
    for (std::size_t s = of->size(); s < model.skin_place.size(); ++s) of->push_back(static_cast<int>(s));
}

namespace {

/// Links neighbours on straight sides of a mesh across elements, see broad_phase/face_line.hpp. `edges`: its surface
/// edges, from one skin point to the next.
void link_straight_sides(const std::vector<std::array<int, 2>>& edges, Model<2>& model) {
  std::vector<int> before(model.skin_place.size(), -1), after = before;
  for (const auto& [from, to] : edges) after[from] = to, before[to] = from;
  const auto at = [&](int skin) { return Vec2(model.start_position[model.skin_node[skin]] + model.skin_place[skin]); };
  for (const auto& [from, to] : edges) {
    if (after[to] < 0) continue;
    const Vec2 in = at(to) - at(from), out = at(after[to]) - at(to);
    if (!(in.dot(out) > 0 && std::abs(cross(in, out)) <= kStraightAngle * in.norm() * out.norm())) continue;
    fill_lines(model);
    model.skin_before[to] = from, model.skin_after[to] = after[to];
  }
}

}  // namespace

void append_element_pieces(const Mesh& mesh, bool all, int body, Model<2>& model) {
  const CheckedMesh checked = check_mesh(mesh, "");
  const int first_skin = model.bodies[body].first_skin;
  std::vector<std::array<int, 2>> surface;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    if (!all && checked.boundary_edges[e] == 0) continue;
    const std::vector<Vec2> corners = corners_of(mesh, e);
    ConvexPiece piece;
    for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
      piece.corners.push_back(i);
      piece.faces.push_back((checked.boundary_edges[e] >> static_cast<unsigned>(i) & 1U) != 0 ? i : -1);
    }
    const PieceEdges edges = piece_edges(corners, piece);
    model.piece_body.push_back(body);
    model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
    for (std::size_t c = 0; c < edges.corner.size(); ++c) {
      const auto skin = [&](std::size_t k) {
        return first_skin + mesh.element[e][edges.corner[k % edges.corner.size()]];
      };
      if (edges.is_face[c] != 0) surface.push_back({skin(c), skin(c + 1)});
      model.corner_skin.push_back(skin(c));
      model.edge_is_face.push_back(edges.is_face[c]);
      model.edge_corner.push_back(edges.flatness[c]);
    }
  }
  link_straight_sides(surface, model);
}

}  // namespace trilith
