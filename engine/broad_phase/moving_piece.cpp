#include "broad_phase/moving_piece.hpp"

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

/// A corner that turns with a section of a frame. Returns how fast its way bends [m/s2].
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

/// Bodies in three kinds: corners that are nodes go straight on; those of a rigid body and of a frame's sections turn
/// with a node, x = x_n + R(rotation + later spin) r, so their way bends by spin^2 |r|.
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

/// The corner of a piece that reaches least far along `n`.
int deepest_corner(const MovingPiece& piece, const Vec2& n) {
  int deepest = 0;
  for (int c = 1; c < piece.corners; ++c)
    if (n.dot(piece.at[c]) < n.dot(piece.at[deepest])) deepest = c;
  return deepest;
}

/// Takes over what is less: `other` beneath the edges of `owner`.
/// The overlap along a normal n of the owner's edge is how far the other's deepest corner lies below the edge:
///
///             |  other |
///       ______|________|______  edge, n upwards      The least over all edges of both is the shortest way out;
///      |      `-._  _.-'      |                      `at` is half-way from the deepest corner to the edge.
///      | owner    `'          |
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

/// Along the normal of one piece's edge: where and how fast the corners of both are.
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
  /// The overlap `time` from now: the owner's farthest corner along n less the other's nearest, each a greatest or
  /// least of linear functions, so that their difference is convex.
  [[nodiscard]] double after(double time) const {
    double far = -unbounded, near = unbounded;
    for (int i = 0; i < owners; ++i) far = std::max(far, owner[i] + time * owner_rate[i]);
    for (int j = 0; j < others; ++j) near = std::min(near, other[j] + time * other_rate[j]);
    return far - near;
  }
  /// Up to `longest`, how long the overlap stays at `most` or below; 0 where it is above that now.
  [[nodiscard]] double time_to(double most, double longest) const {
    if (overlap > most) return 0;
    if (after(longest) <= most) return longest;
    // Convex and allowed now: it passes `most` once, as the first two corners, i of the owner and j of the other, do.
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

/// `least` bounds the overlap of now from above. Where the two are apart it is below 0 and -depth is asked for.
double time_to_depth(const MovingPiece& a, const MovingPiece& b, double longest, double depth) {
  double least = unbounded;
  for_directions(a, b, [&](const Direction& d) { return least = std::min(least, d.overlap), true; });
  const double most = std::max(least + depth, -depth), bend = 0.5 * (a.bend + b.bend);
  // Any one direction that stays allowed will do, so the longest time of all counts; the room is less what turning
  // takes, bend t^2, with the t that is tried.
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
  // Turning may take all the room there is in so long a time: half of it is left to what moves straight on.
  if (const double shorter = std::sqrt(0.5 * depth / bend); bend > 0 && shorter < longest) try_all(shorter);
  return found;
}

}  // namespace trilith
