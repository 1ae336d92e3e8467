#include "draw/solid_piece.hpp"

#include <algorithm>
#include <cmath>

namespace trilith::draw {
namespace {

/// Distances from the plane, those within the slack as 0.
std::vector<double> heights(const PieceFace& face, const CutPlane& plane, double slack) {
  std::vector<double> out;
  for (const Vec3& p : face.corners) {
    const double h = plane.above(p);
    out.push_back(std::abs(h) <= slack ? 0 : h);
  }
  return out;
}

/// The part of a face on the side where `sign` times the height is not below 0 (Sutherland and Hodgman, 1974); empty
/// where none has an area there. Points that lie in the plane go to `cut`.
PieceFace side_of(const PieceFace& face, const std::vector<double>& height, double sign, bool cut_is_edge,
                  std::vector<Vec3>& cut) {
  PieceFace out{{}, {}, face.normal, face.kind};
  const std::size_t count = face.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double a = sign * height[i], b = sign * height[next];
    const auto add = [&](const Vec3& p, bool edge) {
      out.corners.push_back(p);
      out.is_edge.push_back(edge);
    };
    // A corner in the plane belongs to the side that a neighbour of it is on: of a face that is not convex others would
    // be the tips of spikes without width.
    const double before = sign * height[(i + count - 1) % count];
    if (a > 0 || (a == 0 && (b > 0 || before > 0)))
      add(face.corners[i], b < 0 && a == 0 ? cut_is_edge : face.is_edge[i]);
    if (a == 0) cut.push_back(face.corners[i]);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      const Vec3 p = face.corners[i] + (face.corners[next] - face.corners[i]) * (a / (a - b));
      add(p, a > 0 ? cut_is_edge : face.is_edge[i]);
      cut.push_back(p);
    }
  }
  return out;
}

/// The convex polygon around points of a plane, anticlockwise seen from the tip of `normal` (Andrew, 1979).
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

/// The faces of a piece on one side of a plane, and where the plane meets them.
struct Side {
  std::vector<PieceFace> faces;
  std::vector<std::vector<Vec3>> cuts;  ///< of each face that has an area there its points in the plane
};

Side faces_beside(const SolidPiece& piece, const CutPlane& plane, double sign, double slack, bool cut_is_edge) {
  Side out;
  for (const PieceFace& face : piece.faces) {
    const std::vector<double> height = heights(face, plane, slack);
    if (std::all_of(height.begin(), height.end(), [](double h) { return h == 0; })) {
      // What lies in the plane bounds the part below it or, turned round, the one above.
      if (sign * face.normal.dot(plane.normal) < 0) out.faces.push_back(face);
      continue;
    }
    if (std::none_of(height.begin(), height.end(), [&](double h) { return sign * h > 0; })) continue;
    std::vector<Vec3> cut;
    PieceFace part = side_of(face, height, sign, cut_is_edge, cut);
    if (part.corners.size() >= 3) out.faces.push_back(std::move(part));
    out.cuts.push_back(std::move(cut));
  }
  return out;
}

/// Whether one of the lines between the first and the last of so many points goes through `p`.
bool is_on_any(const std::vector<std::vector<Vec3>>& lines, const Vec3& p, double slack) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::vector<Vec3>& line) {
    if (line.size() < 2) return false;
    const Vec3 along = line.back() - line.front();
    const double share = std::clamp(along.dot(p - line.front()) / along.squaredNorm(), 0.0, 1.0);
    return (line.front() + share * along - p).norm() <= slack;
  });
}

/// The face that a plane gives to what is on one side of it of a convex piece. Sides of a section are edges where the
/// skin ends there, and not where the piece was divided from others.
std::optional<PieceFace> closing_face(const Side& side, const CutPlane& plane, double sign, double slack,
                                      FaceKind kind) {
  const Vec3 normal = -sign * plane.normal;
  const bool bounded = std::any_of(side.faces.begin(), side.faces.end(), [&](const PieceFace& face) {
    return face.normal.dot(normal) > 1 - 1e-9 && std::abs(plane.above(face.corners[0])) <= slack;
  });
  std::vector<Vec3> points;
  for (const std::vector<Vec3>& cut : side.cuts) points.insert(points.end(), cut.begin(), cut.end());
  if (bounded || points.empty()) return std::nullopt;
  PieceFace out{hull_in_plane(std::move(points), normal, slack), {}, normal, kind};
  const std::size_t count = out.corners.size();
  if (count < 3) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i)
    out.is_edge.push_back(kind == FaceKind::section &&
                          is_on_any(side.cuts, 0.5 * (out.corners[i] + out.corners[(i + 1) % count]), 1e3 * slack));
  return out;
}

std::optional<SolidPiece> half_of(const SolidPiece& piece, const CutPlane& plane, double sign, double slack,
                                  FaceKind kind) {
  const Side whole = faces_beside(piece, plane, sign, slack, kind == FaceKind::section);
  if (whole.faces.empty()) return std::nullopt;
  SolidPiece out{piece.body, whole.faces, piece.borders};
  const auto close = [&](const Side& side) {
    if (auto face = closing_face(side, plane, sign, slack, kind)) out.faces.push_back(std::move(*face));
  };
  if (kind == FaceKind::border)
    close(whole);
  else
    for (const SolidPiece& part : convex_pieces(piece, 1e3 * slack))
      close(faces_beside(part, plane, sign, slack, kind == FaceKind::section));
  return out;
}

/// A face that has something of the piece above its plane.
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

/// As half_of, and the border, which may have any shape, stays without a face.
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
  // Each cut takes one plane out of both parts, so that this ends; the bound is for faces that are not plane.
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
