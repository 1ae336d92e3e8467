#include "model/space_builder/mesh_skin.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "contact/space/solid_faces.hpp"

namespace trilith {
namespace {

/// An edge of a face of a skin piece: from corner `k` of its loop to the next.
struct SkinEdge {
  int piece, face, k;
};

int node_at(const Model<3>& model, int piece, int corner) {
  return model.skin_node[model.corner_skin[model.piece_first[piece] + corner]];
}

/// The nodes at the ends of an edge, in the order of the loop.
std::pair<int, int> ends_of(const Model<3>& model, const SkinEdge& e) {
  const std::span<const int> loop = model.piece_solid[e.piece].shape.faces[e.face];
  const auto next = static_cast<std::size_t>(e.k + 1) % loop.size();
  return {node_at(model, e.piece, loop[static_cast<std::size_t>(e.k)]), node_at(model, e.piece, loop[next])};
}

/// Extent of the face of `other` beyond the edge `e`, in the plane of the face of `e` [m].
double reach_beyond(const Model<3>& model, const SkinEdge& e, const SkinEdge& other) {
  const auto [from, to] = ends_of(model, e);
  const Vec3& start = model.start_position[from];
  const Vec3 out = cross(Vec3(model.start_position[to] - start), model.piece_solid[e.piece].normals[e.face]);
  double most = 0;
  for (const int c : model.piece_solid[other.piece].shape.faces[other.face])
    most = std::max(most, out.dot(Vec3(model.start_position[node_at(model, other.piece, c)] - start)));
  return most / out.norm();
}

}  // namespace

void find_faces_in_line(Model<3>& model, int first_piece) {
  std::map<std::pair<int, int>, std::vector<SkinEdge>> edges;
  for (int p = first_piece; p < model.pieces(); ++p) {
    const ConvexSolid& solid = model.piece_solid[p];
    for (int f = 0; f < solid.shape.faces.count(); ++f) {
      if (!solid.is_surface(f)) continue;
      for (int k = 0; k < static_cast<int>(solid.shape.faces[f].size()); ++k) {
        const SkinEdge edge{p, f, k};
        const auto [from, to] = ends_of(model, edge);
        edges[std::minmax(from, to)].push_back(edge);
      }
    }
  }
  for (const auto& [ends, both] : edges) {
    if (both.size() != 2 || both[0].piece == both[1].piece) continue;
    const auto normal = [&](const SkinEdge& e) { return model.piece_solid[e.piece].normals[e.face]; };
    if (!(normal(both[0]).dot(normal(both[1])) >= -opposed_enough)) continue;
    for (const std::size_t i : {0U, 1U}) {
      ConvexSolid& solid = model.piece_solid[both[i].piece];
      const FaceLoops& faces = solid.shape.faces;
      solid.goes_on.resize(faces.corner.size(), 0.0);
      solid.goes_on[static_cast<std::size_t>(faces.start[both[i].face] + both[i].k)] =
          reach_beyond(model, both[i], both[1 - i]);
    }
  }
}

namespace {

/// A face of a piece.
struct SkinFace {
  int piece, face;
  bool operator<(const SkinFace& other) const { return piece != other.piece ? piece < other.piece : face < other.face; }
};

/// Cosine of the angle up to which a skin face continues smoothly in another one, as on a vault.
constexpr double smooth = 0.866;
/// Tolerance for a corner outside of a plane that bounds its piece, relative to its size.
constexpr double outside = 1e-6;

const Vec3& normal_of(const Model<3>& model, const SkinFace& f) {
  return model.piece_solid[f.piece].normals[f.face];
}

int first_node_of(const Model<3>& model, const SkinFace& f) {
  return node_at(model, f.piece, model.piece_solid[f.piece].shape.faces[f.face][0]);
}

bool has_node(const Model<3>& model, const SkinFace& f, int node) {
  const auto corners = model.piece_solid[f.piece].shape.faces[f.face];
  return std::any_of(corners.begin(), corners.end(), [&](int c) { return node_at(model, f.piece, c) == node; });
}

/// Whether `other`, which has some corner of `piece`, bounds the body there in addition to the piece's own faces.
bool bounds(const Model<3>& model, const SkinFace& other, int piece) {
  const ConvexSolid& solid = model.piece_solid[piece];
  const Vec3 &n = normal_of(model, other), &on = model.start_position[first_node_of(model, other)];
  const auto above = [&](int corner) { return n.dot(Vec3(model.start_position[node_at(model, piece, corner)] - on)); };
  for (int c = 0; c < model.corners_of(piece); ++c)
    if (above(c) > outside * solid.size) return false;
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    const auto own = solid.shape.faces[f];
    if (solid.is_surface(f)) {
      const auto touches = [&](int c) { return has_node(model, other, node_at(model, piece, c)); };
      if (solid.normals[f].dot(n) > smooth && std::any_of(own.begin(), own.end(), touches)) return false;
    } else if (std::all_of(own.begin(), own.end(), [&](int c) { return above(c) > -outside * solid.size; })) {
      return false;
    }
  }
  return true;
}

/// Faces of other pieces that have some corner of a piece, in order.
std::vector<SkinFace> faces_around(const Model<3>& model, int piece,
                                   const std::map<int, std::vector<SkinFace>>& faces_at) {
  std::vector<SkinFace> others;
  for (int c = 0; c < model.corners_of(piece); ++c)
    if (const auto at = faces_at.find(node_at(model, piece, c)); at != faces_at.end())
      for (const SkinFace& f : at->second)
        if (f.piece != piece) others.push_back(f);
  std::sort(others.begin(), others.end());
  const auto same = [](const SkinFace& a, const SkinFace& b) { return a.piece == b.piece && a.face == b.face; };
  others.erase(std::unique(others.begin(), others.end(), same), others.end());
  return others;
}

}  // namespace

void find_bounds(Model<3>& model, int first_piece) {
  std::map<int, std::vector<SkinFace>> faces_at;
  for (int p = first_piece; p < model.pieces(); ++p)
    for (int f = 0; f < model.piece_solid[p].shape.faces.count(); ++f) {
      if (!model.piece_solid[p].is_surface(f)) continue;
      for (const int c : model.piece_solid[p].shape.faces[f]) faces_at[node_at(model, p, c)].push_back({p, f});
    }
  std::vector<Vec3> normals;
  for (int p = first_piece; p < model.pieces(); ++p) {
    normals.clear();
    for (const SkinFace& f : faces_around(model, p, faces_at)) {
      if (!bounds(model, f, p)) continue;
      // Coplanar faces bound it once.
      const Vec3& n = normal_of(model, f);
      if (std::any_of(normals.begin(), normals.end(), [&](const Vec3& o) { return o.dot(n) >= -opposed_enough; }))
        continue;
      normals.push_back(n);
      model.piece_bounds.resize(static_cast<std::size_t>(model.pieces()));
      model.piece_bounds[p].push_back(model.piece_fit[f.piece] + 1 + f.face);
    }
  }
}

}  // namespace trilith
