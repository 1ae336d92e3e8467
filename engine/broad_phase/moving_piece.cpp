#include "broad_phase/moving_piece.hpp"

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

/// Places a corner that rotates with a section of a frame. Returns the acceleration of its path due to rotation [m/s2].
double place_section(const Model<2>& model, const State<2>& state, double later, int first, int corner,
                     MovingPiece& out) {
  const int skin = model.corner_skin[first + corner], n = model.skin_node[skin], t = model.skin_turn[skin];
  const double spin = state.spin[t];
  const Vec2 arm = Turn(state.rotation[t] + later * spin).apply(model.skin_place[skin]);
  out.at[corner] = state.position[n] + later * state.velocity[n] + arm;
  out.velocity[corner] = state.velocity[n] + cross(spin, arm);
  return spin * spin * arm.norm();
}

}  // namespace

/// Three kinds of bodies. Corners that are nodes move straight on. Corners of rigid bodies and of frame sections rotate
/// with a node, x = x_n + R(rotation + later spin) r, so their paths have the acceleration spin^2 |r|.
MovingPiece moving_piece(const Model<2>& model, const State<2>& state, int piece, double later) {
  MovingPiece out;
  const Body& body = model.bodies[model.piece_body[piece]];
  const int first = model.piece_first[piece];
  out.corners = model.corners_of(piece);
  out.is_face = model.edge_is_face.data() + first;
  if (!body.nodes_turn()) {
    for (int c = 0; c < out.corners; ++c) {
      const int node = model.skin_node[model.corner_skin[first + c]];
      out.velocity[c] = state.velocity[node];
      out.at[c] = state.position[node] + later * out.velocity[c];
    }
    return out;
  }
  if (!body.is_rigid()) {
    for (int c = 0; c < out.corners; ++c)
      out.bend = std::max(out.bend, place_section(model, state, later, first, c, out));
    return out;
  }
  const int node = body.first_node;
  const double spin = state.spin[node];
  const Turn turn(state.rotation[node] + later * spin);
  const Vec2 &velocity = state.velocity[node], place = state.position[node] + later * velocity;
  double radius = 0;
  for (int c = 0; c < out.corners; ++c) {
    const Vec2 arm = turn.apply(model.skin_place[model.corner_skin[first + c]]);
    out.at[c] = place + arm;
    out.velocity[c] = velocity + cross(spin, arm);
    radius = std::max(radius, arm.norm());
  }
  out.bend = spin * spin * radius;
  return out;
}

namespace {

/// Unit outward normal of an edge.
Vec2 normal_of(const MovingPiece& piece, int edge) {
  const Vec2 along = piece.at[(edge + 1) % piece.corners] - piece.at[edge];
  return Vec2(along.y(), -along.x()).normalized();
}

/// The corner of a piece with the least coordinate along `n`.
int deepest_corner(const MovingPiece& piece, const Vec2& n) {
  int deepest = 0;
  for (int c = 1; c < piece.corners; ++c)
    if (n.dot(piece.at[c]) < n.dot(piece.at[deepest])) deepest = c;
  return deepest;
}

/// Updates the least overlap with the overlaps of `other` below the edges of `owner`. The overlap along the normal n of
/// an edge is the depth of the other's deepest corner below it.
///
///             |  other |
///       ______|________|______  edge, n upwards
///      |      `-._  _.-'      |
///      | owner    `'          |
///
/// The least overlap over all edges of both pieces is the shortest way out; `at` is midway between the deepest corner
/// and the edge.
void add_edges(const MovingPiece& owner, const MovingPiece& other, PieceOverlap& least) {
  const bool has_face = std::any_of(owner.is_face, owner.is_face + owner.corners, [](auto face) { return face != 0; });
  for (int e = 0; e < owner.corners; ++e) {
    const Vec2 n = normal_of(owner, e), corner = other.at[deepest_corner(other, n)];
    const double depth = n.dot(owner.at[e] - corner);
    least.whole = std::min(least.whole, depth);
    if (has_face && owner.is_face[e] == 0) continue;
    if (depth < least.depth) least.depth = depth, least.at = corner + 0.5 * depth * n, least.normal = n;
  }
}

/// Positions and velocities of both pieces' corners along the normal of one edge.
struct Direction {
  std::array<double, max_piece_corners> owner, other, owner_rate, other_rate;
  int owners, others;
  double overlap;  ///< now [m]

  Direction(const MovingPiece& a, int edge, const MovingPiece& b) : owners(a.corners), others(b.corners) {
    const Vec2 n = normal_of(a, edge);
    for (int i = 0; i < owners; ++i) owner[i] = n.dot(a.at[i]), owner_rate[i] = n.dot(a.velocity[i]);
    for (int j = 0; j < others; ++j) other[j] = n.dot(b.at[j]), other_rate[j] = n.dot(b.velocity[j]);
    overlap = after(0);
  }
  /// The overlap at `time` from now: the owner's farthest corner along n minus the other's nearest one. The first is a
  /// maximum and the second a minimum of linear functions, so the difference is convex.
  [[nodiscard]] double after(double time) const {
    double far = -unbounded, near = unbounded;
    for (int i = 0; i < owners; ++i) far = std::max(far, owner[i] + time * owner_rate[i]);
    for (int j = 0; j < others; ++j) near = std::min(near, other[j] + time * other_rate[j]);
    return far - near;
  }
  /// Time, up to `longest`, for which the overlap stays at `most` or below; 0 where it is above that now.
  [[nodiscard]] double time_to(double most, double longest) const {
    if (overlap > most) return 0;
    if (after(longest) <= most) return longest;
    // Convex and at most `most` now, so it passes `most` once. The first pair of corners, i of the owner and j of the
    // other, to pass it gives the time.
    double time = longest;
    for (int i = 0; i < owners; ++i)
      for (int j = 0; j < others; ++j) {
        const double rate = owner_rate[i] - other_rate[j], room = most - (owner[i] - other[j]);
        if (rate > 0 && room < time * rate) time = std::max(0.0, room / rate);
      }
    return time;
  }
};

template <class Visit>
void for_directions(const MovingPiece& a, const MovingPiece& b, Visit&& visit) {
  for (int e = 0; e < a.corners; ++e)
    if (!visit(Direction(a, e, b))) return;
  for (int e = 0; e < b.corners; ++e)
    if (!visit(Direction(b, e, a))) return;
}

}  // namespace

PieceOverlap overlap_of(const MovingPiece& a, const MovingPiece& b) {
  PieceOverlap least{unbounded, Vec2::Zero(), Vec2::UnitX(), unbounded};
  add_edges(a, b, least);
  add_edges(b, a, least);
  return least;
}

/// `least` is an upper bound of the present overlap. Where the two are apart it is negative, and the limit is -depth.
double time_to_depth(const MovingPiece& a, const MovingPiece& b, double longest, double depth) {
  double least = unbounded;
  for_directions(a, b, [&](const Direction& d) { return least = std::min(least, d.overlap), true; });
  const double most = std::max(least + depth, -depth), bend = 0.5 * (a.bend + b.bend);
  // Any single direction within its limit suffices, so the longest time over all directions counts. The limit is
  // reduced by bend t^2 for rotation, with the trial time t.
  double found = 0;
  const auto try_all = [&](double time) {
    const double by_rotation = bend * time * time;
    for_directions(a, b, [&](const Direction& d) {
      found = std::max(found, d.time_to(most - by_rotation, time));
      return found < time;
    });
  };
  try_all(longest);
  if (found >= longest) return longest;
  // Over this trial time rotation may use up the whole limit: a shorter time leaves half of it to straight motion.
  if (const double shorter = std::sqrt(0.5 * depth / bend); bend > 0 && shorter < longest) try_all(shorter);
  return found;
}

}  // namespace trilith
