#include "world/mesh_skin.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "contact/solid_faces.hpp"

namespace trilith {
namespace {

/// An edge of a face of a piece of the skin: that from corner `k` of its loop to the next.
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

/// How far the face of `other` reaches beyond the edge `e`, in the plane of the face of `e` [m].
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

/// Cosine of the angle up to which a face of the skin goes on in another one, smoothly as on a vault.
constexpr double smooth = 0.866;
/// A corner may lie this far outside of a plane that bounds its piece, as a share of its size.
constexpr double outside = 1e-6;

const Vec3& normal_of(const Model<3>& model, const SkinFace& f) {
  return model.piece_solid[f.piece].normals[f.face];
}

std::vector<int> nodes_of(const Model<3>& model, const SkinFace& f) {
  std::vector<int> nodes;
  for (const int c : model.piece_solid[f.piece].shape.faces[f.face]) nodes.push_back(node_at(model, f.piece, c));
  return nodes;
}

/// Whether `other`, which has some corner of `piece`, bounds the body there beside the piece's own faces.
bool bounds(const Model<3>& model, const SkinFace& other, int piece) {
  const ConvexSolid& solid = model.piece_solid[piece];
  const std::vector<int> corners = nodes_of(model, other);
  const Vec3 &n = normal_of(model, other), &on = model.start_position[corners[0]];
  const auto above = [&](int node) { return n.dot(Vec3(model.start_position[node] - on)); };
  for (int c = 0; c < model.corners_of(piece); ++c)
    if (above(node_at(model, piece, c)) > outside * solid.size) return false;
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    const std::vector<int> own = nodes_of(model, {piece, f});
    const bool touches = std::any_of(own.begin(), own.end(), [&](int node) {
      return std::find(corners.begin(), corners.end(), node) != corners.end();
    });
    if (solid.is_surface(f) && touches && solid.normals[f].dot(n) > smooth) return false;
    const bool in_plane =
        std::all_of(own.begin(), own.end(), [&](int node) { return above(node) > -outside * solid.size; });
    if (!solid.is_surface(f) && in_plane) return false;
  }
  return true;
}

}  // namespace

void find_bounds(Model<3>& model, int first_piece) {
  std::map<int, std::vector<SkinFace>> faces_at;
  for (int p = first_piece; p < model.pieces(); ++p)
    for (int f = 0; f < model.piece_solid[p].shape.faces.count(); ++f) {
      if (!model.piece_solid[p].is_surface(f)) continue;
      for (const int node : nodes_of(model, {p, f})) faces_at[node].push_back({p, f});
    }
  for (int p = first_piece; p < model.pieces(); ++p) {
    std::set<SkinFace> others;
    for (int c = 0; c < model.corners_of(p); ++c)
      for (const SkinFace& f : faces_at[node_at(model, p, c)])
        if (f.piece != p) others.insert(f);
    for (const SkinFace& f : others) {
      if (!bounds(model, f, p)) continue;
      // Faces in one plane bound it once.
      model.piece_bounds.resize(static_cast<std::size_t>(model.pieces()));
      std::vector<int>& list = model.piece_bounds[p];
      const bool known = std::any_of(list.begin(), list.end(), [&](int fit) {
        const Fit& of = model.fits[fit];
        const Fitted there = fitted(model, of, model.start_position, model.start_velocity);
        return there.axes.col(2).dot(normal_of(model, f)) >= -opposed_enough;
      });
      if (!known) list.push_back(model.piece_fit[f.piece] + 1 + f.face);
    }
  }
}

}  // namespace trilith
