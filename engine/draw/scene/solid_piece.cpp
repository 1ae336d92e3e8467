#include "draw/scene/solid_piece.hpp"

#include <algorithm>
#include <cmath>

namespace trilith::draw {
namespace {

/// Distances of corners from the plane; 0 within the slack. A face with a side in the plane that crosses it by only a
/// few times the slack does so by rounding: its part beyond counts as in the plane.
std::vector<double> heights(const PieceFace& face, const CutPlane& plane, double slack) {
  constexpr double rounding_of_a_side = 10;
  std::vector<double> out;
  double low = 0, high = 0;
  for (const Vec3& p : face.corners) {
    const double h = plane.above(p);
    out.push_back(std::abs(h) <= slack ? 0 : h);
    low = std::min(low, h), high = std::max(high, h);
  }
  bool side_in_plane = false;
  for (std::size_t i = 0; i < out.size(); ++i)
    side_in_plane = side_in_plane || (out[i] == 0 && out[(i + 1) % out.size()] == 0);
  if (side_in_plane && std::min(-low, high) <= rounding_of_a_side * slack)
    for (double& h : out)
      if (h * (high + low) < 0) h = 0;
  return out;
}

/// The part of a face on the side where `sign` times the height is not negative (Sutherland and Hodgman, 1974); empty
/// if it has no area there.
PieceFace side_of(const PieceFace& face, const std::vector<double>& height, double sign, bool cut_is_edge) {
  PieceFace out{{}, {}, face.normal, face.kind, face.value};
  const std::size_t count = face.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double a = sign * height[i], b = sign * height[next];
    const auto add = [&](const Vec3& p, bool edge) {
      out.corners.push_back(p);
      out.is_edge.push_back(edge);
    };
    // A corner in the plane belongs to the side of its neighbours: in a non-convex face other corners would form spikes
    // without width.
    const double before = sign * height[(i + count - 1) % count];
    if (a > 0 || (a == 0 && (b > 0 || before > 0)))
      add(face.corners[i], b < 0 && a == 0 ? cut_is_edge : face.is_edge[i]);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const Vec3 p = face.corners[i] + (face.corners[next] - face.corners[i]) * (a / (a - b));
      add(p, a > 0 ? cut_is_edge : face.is_edge[i]);
    }
  }
  return out;
}

/// The convex hull of points in a plane, anticlockwise seen from the tip of `normal` (Andrew, 1979).
std::vector<Vec3> hull_in_plane(std::vector<Vec3> points, const Vec3& normal, double slack) {
  const Vec3 other = std::abs(normal.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 u = cross(normal, other).normalized(), v = cross(normal, u);
  const auto less = [&](const Vec3& a, const Vec3& b) {
    const double xa = u.dot(a), xb = u.dot(b);
    return xa != xb ? xa < xb : v.dot(a) < v.dot(b);
  };
  std::sort(points.begin(), points.end(), less);
  std::vector<Vec3> hull;
  for (const int round : {0, 1}) {
    const std::size_t first = hull.size();
    for (const Vec3& p : points) {
      while (hull.size() >= first + 2) {
        const Vec3 a = hull[hull.size() - 1] - hull[hull.size() - 2], b = p - hull[hull.size() - 2];
        if (normal.dot(cross(a, b)) > slack * b.norm()) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    if (round == 0) std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct Line {
  Vec3 from, to;
};

/// The faces of a piece on one side of a plane, and the lines in which they end there, oriented along their faces.
struct Side {
  std::vector<PieceFace> faces;
  std::vector<Line> ends;
};

void add_ends(const PieceFace& part, const CutPlane& plane, double slack, std::vector<Line>& ends) {
  const std::size_t count = part.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &from = part.corners[i], &to = part.corners[(i + 1) % count];
    if (std::abs(plane.above(from)) <= slack && std::abs(plane.above(to)) <= slack && (to - from).norm() > slack)
      ends.push_back({from, to});
  }
}

Side faces_beside(const SolidPiece& piece, const CutPlane& plane, double sign, double slack, bool cut_is_edge) {
  Side out;
  for (const PieceFace& face : piece.faces) {
    const std::vector<double> height = heights(face, plane, slack);
    if (std::all_of(height.begin(), height.end(), [](double h) { return h == 0; })) {
      // A face in the plane bounds the part below it or, reversed, the part above.
      if (sign * face.normal.dot(plane.normal) < 0) out.faces.push_back(face);
      continue;
    }
    if (std::none_of(height.begin(), height.end(), [&](double h) { return sign * h > 0; })) continue;
    // A face that crosses the plane is clipped. Other faces are whole on this side; they may have corners in the plane
    // whose neighbours lie there too, as a side or all but one corner may.
    const bool crosses = std::any_of(height.begin(), height.end(), [&](double h) { return sign * h < 0; });
    PieceFace part = crosses ? side_of(face, height, sign, cut_is_edge) : face;
    if (part.corners.size() < 3) continue;
    add_ends(part, plane, slack, out.ends);
    out.faces.push_back(std::move(part));
  }
  return out;
}

bool goes_through(const Line& line, const Vec3& p, double slack) {
  const Vec3 along = line.to - line.from;
  const double share = std::clamp(along.dot(p - line.from) / along.squaredNorm(), 0.0, 1.0);
  return (line.from + share * along - p).norm() <= slack;
}

/// The closing face of a convex piece: a convex polygon. Its sides are edges where the skin ends, not where the piece
/// was divided from others.
PieceFace hull_of_ends(const std::vector<Line>& ends, const Vec3& normal, double slack, FaceKind kind) {
  std::vector<Vec3> points;
  for (const Line& line : ends) points.push_back(line.from), points.push_back(line.to);
  PieceFace out{hull_in_plane(std::move(points), normal, slack), {}, normal, kind};
  const std::size_t count = out.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 middle = 0.5 * (out.corners[i] + out.corners[(i + 1) % count]);
    out.is_edge.push_back(kind == FaceKind::section && std::any_of(ends.begin(), ends.end(), [&](const Line& line) {
                            return goes_through(line, middle, 1e3 * slack);
                          }));
  }
  return out;
}

/// Removes a line and the lines that continue it from `left` until none does, in the reverse sense, because they bound
/// the closing face.
std::vector<Vec3> next_loop(std::vector<Line>& left, double slack) {
  std::vector<Vec3> loop;
  for (auto line = left.end() - 1; line != left.end();) {
    const Vec3 at = line->from;
    loop.push_back(line->to);
    left.erase(line);
    line = std::find_if(left.begin(), left.end(), [&](const Line& l) { return (l.to - at).norm() <= slack; });
  }
  return loop;
}

/// The closing face of a skin of any shape: the loops in which it ends, holes included, as one polygon that runs from
/// its first corner to each loop and back.
PieceFace loops_of_ends(std::vector<Line> ends, const Vec3& normal, double slack, FaceKind kind) {
  PieceFace out{{}, {}, normal, kind};
  const auto add = [&](const Vec3& p, bool edge) {
    out.corners.push_back(p);
    out.is_edge.push_back(edge && kind == FaceKind::section);
  };
  while (!ends.empty()) {
    const std::vector<Vec3> loop = next_loop(ends, 1e3 * slack);
    const bool first = out.corners.empty();
    const Vec3 home = first ? loop[0] : out.corners[0];
    if (!first) add(home, false);
    for (const Vec3& p : loop) add(p, true);
    if (!first) add(loop[0], false);
  }
  return out;
}

/// The face in the plane of a part on one side of it, if the part has no own face there.
std::optional<PieceFace> closing_face(const SolidPiece& piece, const Side& side, const CutPlane& plane,
                                      const Vec3& normal, double slack, FaceKind kind) {
  const bool bounded = std::any_of(side.faces.begin(), side.faces.end(), [&](const PieceFace& face) {
    return face.normal.dot(normal) > 1 - 1e-9 && std::abs(plane.above(face.corners[0])) <= slack;
  });
  if (bounded || side.ends.empty()) return std::nullopt;
  PieceFace face = is_convex(piece, 1e3 * slack) ? hull_of_ends(side.ends, normal, slack, kind)
                                                 : loops_of_ends(side.ends, normal, slack, kind);
  if (face.corners.size() < 3) return std::nullopt;
  return face;
}

std::optional<SolidPiece> half_of(const SolidPiece& piece, const CutPlane& plane, double sign, double slack,
                                  FaceKind kind) {
  Side side = faces_beside(piece, plane, sign, slack, kind == FaceKind::section);
  if (side.faces.empty()) return std::nullopt;
  auto closing = closing_face(piece, side, plane, -sign * plane.normal, slack, kind);
  SolidPiece out{piece.body, std::move(side.faces), piece.borders};
  if (closing) out.faces.push_back(std::move(*closing));
  return out;
}

/// A face with a part of the piece above its plane.
const PieceFace* reflex_face(const SolidPiece& piece, double slack) {
  for (const PieceFace& face : piece.faces) {
    if (face.kind != FaceKind::skin) continue;
    const CutPlane plane{face.normal, face.normal.dot(face.corners[0])};
    for (const PieceFace& other : piece.faces)
      for (const Vec3& p : other.corners)
        if (plane.above(p) > slack) return &face;
  }
  return nullptr;
}

/// As half_of, without a face at the border, which may have any shape.
SolidPiece open_half(const SolidPiece& piece, const CutPlane& plane, double sign, double slack) {
  SolidPiece out{piece.body, faces_beside(piece, plane, sign, slack, false).faces, piece.borders};
  out.borders.push_back(plane.normal);
  return out;
}

}  // namespace

std::pair<std::optional<SolidPiece>, std::optional<SolidPiece>> divided(const SolidPiece& piece, const CutPlane& plane,
                                                                        double slack, FaceKind kind) {
  double low = 0, high = 0;
  for (const PieceFace& face : piece.faces)
    for (const Vec3& p : face.corners) {
      low = std::min(low, plane.above(p));
      high = std::max(high, plane.above(p));
    }
  if (high <= slack) return {piece, std::nullopt};
  if (low >= -slack) return {std::nullopt, piece};
  return {half_of(piece, plane, -1, slack, kind), half_of(piece, plane, 1, slack, kind)};
}

std::vector<SolidPiece> convex_pieces(SolidPiece solid, double slack) {
  std::vector<SolidPiece> todo, done;
  todo.push_back(std::move(solid));
  // Each cut removes one plane from both parts, so the loop ends; the bound is for faces that are not plane.
  std::size_t cuts = 0, most = 4 * todo[0].faces.size() + 16;
  while (!todo.empty()) {
    SolidPiece piece = std::move(todo.back());
    todo.pop_back();
    const PieceFace* face = cuts < most ? reflex_face(piece, slack) : nullptr;
    if (!face) {
      if (!piece.faces.empty()) done.push_back(std::move(piece));
      continue;
    }
    ++cuts;
    const CutPlane plane{face->normal, face->normal.dot(face->corners[0])};
    for (const double sign : {-1.0, 1.0}) todo.push_back(open_half(piece, plane, sign, slack));
  }
  return done;
}

bool is_convex(const SolidPiece& piece, double slack) {
  return reflex_face(piece, slack) == nullptr;
}

double piece_size(const SolidPiece& piece) {
  Vec3 low = piece.faces[0].corners[0], high = low;
  for (const PieceFace& face : piece.faces)
    for (const Vec3& p : face.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

}  // namespace trilith::draw
