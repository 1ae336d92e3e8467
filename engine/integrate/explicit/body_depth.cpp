#include "integrate/explicit/body_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "geometry/plane/overlap.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

struct PieceOutline {
  std::array<Vec2, max_piece_corners> at;
  int corners;

  PieceOutline(const Model<2>& model, const Work<2>& work, int piece) : corners(model.corners_of(piece)) {
    const int first = model.piece_first[piece];
    for (int c = 0; c < corners; ++c) {
      const SkinMotion<2>& s = work.skin[model.corner_skin[first + c]];
      at[c] = {s.x, s.y};
    }
  }
  [[nodiscard]] std::span<const Vec2> points() const { return std::span(at).first(static_cast<std::size_t>(corners)); }
};

double distance_to(const Vec2& from, const Vec2& to, const Vec2& point) {
  const Vec2 along = to - from;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp(along.dot(point - from) / square, 0.0, 1.0) : 0;
  return (point - from - share * along).norm();
}

/// Calls f(from, to) for each surface edge of a piece.
template <class F>
void each_surface_edge(const Model<2>& model, const Work<2>& work, int piece, F&& f) {
  const int begin = model.piece_first[piece], count = model.corners_of(piece);
  for (int c = 0; c < count; ++c) {
    if (model.edge_is_face[begin + c] == 0) continue;
    const SkinMotion<2>&from = work.skin[model.corner_skin[begin + c]],
          &to = work.skin[model.corner_skin[begin + (c + 1) % count]];
    f(Vec2(from.x, from.y), Vec2(to.x, to.y));
  }
}

/// Distance of a point to the surface edges of the pieces from `first` on; unbounded if there are none [m].
double surface_distance(const Model<2>& model, const Work<2>& work, int first, int pieces, const Vec2& point) {
  double least = unbounded;
  for (int piece = first; piece < first + pieces; ++piece)
    each_surface_edge(model, work, piece,
                      [&](const Vec2& from, const Vec2& to) { least = std::min(least, distance_to(from, to, point)); });
  return least;
}

double body_distance(const Model<2>& model, const Work<2>& work, int piece, const Vec2& point) {
  const Body& body = model.bodies[model.piece_body[piece]];
  return surface_distance(model, work, body.first_piece, body.pieces, point);
}

/// True where a point lies behind some surface edge of a piece.
bool is_behind_surface(const Model<2>& model, const Work<2>& work, int piece, const Vec2& point) {
  bool behind = false;
  each_surface_edge(model, work, piece, [&](const Vec2& from, const Vec2& to) {
    behind = behind || cross(Vec2(to - from), Vec2(point - from)) > 0;
  });
  return behind;
}

/// True inside the outline of the body of a piece. The pieces of a meshed body cover only its outer elements.
bool is_in_body(const Model<2>& model, const Work<2>& work, int piece, const Vec2& point) {
  const Body& body = model.bodies[model.piece_body[piece]];
  bool inside = false;
  for (int other = body.first_piece; other < body.first_piece + body.pieces; ++other)
    each_surface_edge(model, work, other, [&](const Vec2& from, const Vec2& to) {
      if ((from.y() > point.y()) == (to.y() > point.y())) return;
      const double share = (point.y() - from.y()) / (to.y() - from.y());
      if (point.x() < from.x() + share * (to.x() - from.x())) inside = !inside;
    });
  return inside;
}

/// Depth of the surface of piece `other` in the body of `owner`, where it is nearest to the surface of that piece [m].
double passed_into(const Model<2>& model, const Work<2>& work, int owner, int other) {
  double deepest = 0;
  each_surface_edge(model, work, other, [&](const Vec2& from, const Vec2& to) {
    const Vec2 middle = 0.5 * (from + to);
    if (!is_behind_surface(model, work, owner, middle) || !is_in_body(model, work, owner, middle)) return;
    const double depth = body_distance(model, work, owner, middle);
    if (surface_distance(model, work, owner, 1, middle) <= depth) deepest = std::max(deepest, depth);
  });
  return deepest > piece_width(model, work, owner) ? deepest : 0;
}

bool has_surface(const Model<2>& model, int piece) {
  const auto first = model.edge_is_face.begin() + model.piece_first[piece];
  return std::any_of(first, first + model.corners_of(piece), [](std::uint8_t face) { return face != 0; });
}

bool is_thin(const Model<2>& model, const Work<2>& work, int piece, double allowed) {
  return model.bodies[model.piece_body[piece]].pieces > 1 && piece_width(model, work, piece) < allowed;
}

}  // namespace

double body_depth(const Model<2>& model, const Work<2>& work, int p, int q, double most) {
  static thread_local OverlapBuffer buffer;  // grows to the largest overlap once
  const Overlap shared =
      convex_overlap(PieceOutline(model, work, p).points(), PieceOutline(model, work, q).points(), buffer);
  if (!(shared.area > 0)) return 0;
  const double near =
      surface_distance(model, work, p, 1, shared.centroid) + surface_distance(model, work, q, 1, shared.centroid);
  if (near <= most) return near;
  return body_distance(model, work, p, shared.centroid) + body_distance(model, work, q, shared.centroid);
}

double passed_depth(const Model<2>& model, const Work<2>& work, int p, int q) {
  return std::max(passed_into(model, work, p, q), passed_into(model, work, q, p));
}

bool is_thin_for(const Model<2>& model, const Work<2>& work, int p, int q, double allowed) {
  return is_thin(model, work, p, allowed) || is_thin(model, work, q, allowed);
}

double piece_width(const Model<2>& model, const Work<2>& work, int piece) {
  const PieceOutline outline(model, work, piece);
  return least_width(outline.points());
}

double body_thickness(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (b.pieces == 1) return model.piece_thickness[b.first_piece];
  double least = unbounded;
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    if (has_surface(model, piece)) least = std::min(least, model.piece_thickness[piece]);
  return least;
}

}  // namespace trilith
