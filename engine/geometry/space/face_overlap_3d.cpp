#include "geometry/space/face_overlap_3d.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace trilith {
namespace {

constexpr int most_shared = 2 * max_face_corners;

/// A line in the plane; its left side is kept.
struct PlaneLine {
  Vec2 from, along;
  int edge;  ///< as in SharedPolygon::edge
};

/// Rounding may give a polygon of very short edges more corners than the buffer holds: the excess is dropped.
void add_corner(SharedPolygon& polygon, const Vec2& p, int edge) {
  if (polygon.count == most_shared) return;
  polygon.corner[static_cast<std::size_t>(polygon.count)] = p;
  polygon.edge[static_cast<std::size_t>(polygon.count++)] = edge;
}

// Two facing convex faces are intersected in the plane midway between them.
//
//         \  face b  /             corners of a projected to the mean plane,
//      ----\--------/----  c < 0   then clipped by the edges of b (Sutherland and Hodgman 1974);
//        ---\------/---            over the remainder the overlap c is linear
//      ------\----/------  c > 0
//           face a
//
/// Keeps the part of `polygon` to the left of the line; `spare` is scratch.
void clip_shared(SharedPolygon& polygon, const PlaneLine& line, SharedPolygon& spare) {
  std::array<double, most_shared> side;
  const auto n = static_cast<std::size_t>(polygon.count);
  double least = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 arm = polygon.corner[i] - line.from;
    side[i] = cross(line.along, arm);
    least = std::min(least, side[i]);
  }
  if (least >= 0) return;
  spare.count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 == n ? 0 : i + 1;
    const Vec2 &p = polygon.corner[i], &q = polygon.corner[next];
    const double at_p = side[i], at_q = side[next];
    if (at_p > 0 || (at_p == 0 && at_q >= 0)) add_corner(spare, p, polygon.edge[i]);
    if (at_p == 0 && at_q < 0) add_corner(spare, p, line.edge);
    if (at_p > 0 && at_q < 0) add_corner(spare, p + (at_p / (at_p - at_q)) * (q - p), line.edge);
    if (at_p < 0 && at_q > 0) add_corner(spare, p + (at_p / (at_p - at_q)) * (q - p), polygon.edge[i]);
  }
  polygon.count = spare.count;
  std::copy_n(spare.corner.begin(), spare.count, polygon.corner.begin());
  std::copy_n(spare.edge.begin(), spare.count, polygon.edge.begin());
}

/// With l = |na - nb|: na . n = -nb . n = l/2. Heights of the planes along n at a's first corner are 0 and -overlap.
/// Their gradients are opposite, so the mean plane stays midway.
MeanPlane mean_plane(const PlacedFace& a, const PlacedFace& b) {
  const Vec3 between = a.normal - b.normal, sum = a.normal + b.normal, apart = b.corners[0] - a.corners[0];
  const double scale = 2 / between.norm();
  MeanPlane plane;
  plane.normal = 0.5 * scale * between;
  const Vec3 edge = a.corners[1] - a.corners[0];
  plane.x = (edge - plane.normal.dot(edge) * plane.normal).normalized();
  plane.y = cross(plane.normal, plane.x);
  plane.overlap = scale * b.normal.dot(apart);
  plane.slope = Vec2(-scale * plane.x.dot(sum), -scale * plane.y.dot(sum));
  plane.origin = a.corners[0] - 0.5 * plane.overlap * plane.normal;
  return plane;
}

double twice_area(const SharedPolygon& polygon) {
  double twice = 0;
  for (int i = 2; i < polygon.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Vec2 p = polygon.corner[k - 1] - polygon.corner[0], q = polygon.corner[k] - polygon.corner[0];
    twice += cross(p, q);
  }
  return twice;
}

}  // namespace

bool face_overlap(const PlacedFace& a, const PlacedFace& b, FaceOverlap3& out) {
  const auto na = static_cast<int>(a.corners.size()), nb = static_cast<int>(b.corners.size());
  assert(na >= 3 && na <= max_face_corners && nb >= 3 && nb <= max_face_corners);
  out.shared.count = 0;
  if (!(a.normal.dot(b.normal) < 0)) return false;
  out.plane = mean_plane(a, b);
  for (int i = 0; i < na; ++i) add_corner(out.shared, out.plane.project(a.corners[static_cast<std::size_t>(i)]), i);
  SharedPolygon spare;
  // b runs the other way round: from each of its corners to the previous one
  Vec2 from = out.plane.project(b.corners[0]);
  for (int k = nb - 1; k >= 0 && out.shared.count > 0; --k) {
    const Vec2 to = out.plane.project(b.corners[static_cast<std::size_t>(k)]);
    clip_shared(out.shared, {from, to - from, -1 - k}, spare);
    from = to;
  }
  if (out.shared.count >= 3 && twice_area(out.shared) > 0) return true;
  out.shared.count = 0;
  return false;
}

namespace {

/// A corner and the overlap there.
struct OverlapCorner {
  Vec2 p;
  double c;
};

/// Over a triangle of area A the integral of a product of linear functions f and g is A/12 (sum f sum g + sum of f g).
void add_triangle(const OverlapCorner& u, const OverlapCorner& v, const OverlapCorner& w, FaceIntegrals& to) {
  const Vec2 uv = v.p - u.p, uw = w.p - u.p, sum = u.p + v.p + w.p;
  const double area = 0.5 * cross(uv, uw), share = area / 12, c = u.c + v.c + w.c;
  to.area += area;
  to.area_moment += (area / 3) * sum;
  to.xx += share * (sum.x() * sum.x() + u.p.x() * u.p.x() + v.p.x() * v.p.x() + w.p.x() * w.p.x());
  to.xy += share * (sum.x() * sum.y() + u.p.x() * u.p.y() + v.p.x() * v.p.y() + w.p.x() * w.p.y());
  to.yy += share * (sum.y() * sum.y() + u.p.y() * u.p.y() + v.p.y() * v.p.y() + w.p.y() * w.p.y());
  to.first += (area / 3) * c;
  to.first_moment += share * (c * sum + u.c * u.p + v.c * v.p + w.c * w.p);
  to.energy += 0.5 * share * (c * c + u.c * u.c + v.c * v.c + w.c * w.c);
}

/// For three linear functions f, g and h it is A/60 (sum f sum g sum h + sum f sum of g h + sum g sum of h f + sum h
/// sum of f g + 2 sum of f g h).
void add_triangle(const OverlapCorner& u, const OverlapCorner& v, const OverlapCorner& w, FaceMoments& to) {
  add_triangle(u, v, w, static_cast<FaceIntegrals&>(to));
  const Vec2 uv = v.p - u.p, uw = w.p - u.p, sum = u.p + v.p + w.p;
  const Vec2 weighted = u.c * u.p + v.c * v.p + w.c * w.p;
  const double share = cross(uv, uw) / 120, c = u.c + v.c + w.c, cu = c + 2 * u.c, cv = c + 2 * v.c, cw = c + 2 * w.c;
  const auto product = [&](int i, int j) {
    return share * (c * sum[i] * sum[j] + sum[i] * weighted[j] + sum[j] * weighted[i] + cu * u.p[i] * u.p[j] +
                    cv * v.p[i] * v.p[j] + cw * w.p[i] * w.p[j]);
  };
  to.first_xx += product(0, 0), to.first_xy += product(0, 1), to.first_yy += product(1, 1);
}

/// Corner i of the shared polygon and the overlap of the two planes there.
OverlapCorner corner_of(const FaceOverlap3& faces, int i) {
  const Vec2& p = faces.shared.corner[static_cast<std::size_t>(i)];
  return {p, faces.plane.overlap_at(p)};
}

/// A convex polygon and the overlap over it.
struct OverlapPolygon {
  std::span<const Vec2> corners;
  double overlap;
  const Vec2& slope;

  [[nodiscard]] OverlapCorner operator[](std::size_t i) const { return {corners[i], overlap + slope.dot(corners[i])}; }
  [[nodiscard]] std::size_t size() const { return corners.size(); }
};

OverlapPolygon polygon_of(const FaceOverlap3& faces) {
  return {{faces.shared.corner.data(), static_cast<std::size_t>(faces.shared.count)},
          faces.plane.overlap,
          faces.plane.slope};
}

FaceIntegrals over_all(const OverlapPolygon& polygon) {
  FaceIntegrals sum;
  if (polygon.size() < 3) return sum;
  const OverlapCorner first = polygon[0];
  OverlapCorner before = polygon[1];
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const OverlapCorner now = polygon[i];
    add_triangle(first, before, now, sum);
    before = now;
  }
  return sum;
}

// Corners of the part in contact are found in order; each one makes a triangle with the first and the previous one.
template <class Sums>
Sums in_contact(const OverlapPolygon& polygon) {
  Sums sum;
  int count = 0;
  OverlapCorner first{}, before{};
  const auto take = [&](const OverlapCorner& now) {
    if (count == 0) first = now;
    if (count >= 2) add_triangle(first, before, now, sum);
    before = now;
    ++count;
  };
  const std::size_t n = polygon.size();
  if (n < 3) return sum;
  OverlapCorner p = polygon[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const OverlapCorner q = polygon[i];
    if ((p.c > 0) != (q.c > 0)) take({p.p + (p.c / (p.c - q.c)) * (q.p - p.p), 0});
    if (q.c > 0) take(q);
    p = q;
  }
  return sum;
}

}  // namespace

FaceIntegrals integrals_over_all(const FaceOverlap3& faces) {
  return over_all(polygon_of(faces));
}

FaceIntegrals integrals_in_contact(const FaceOverlap3& faces) {
  return in_contact<FaceIntegrals>(polygon_of(faces));
}

FaceMoments moments_in_contact(const FaceOverlap3& faces) {
  return in_contact<FaceMoments>(polygon_of(faces));
}

FaceIntegrals integrals_over_all(std::span<const Vec2> corners, double overlap, const Vec2& slope) {
  return over_all({corners, overlap, slope});
}

FaceIntegrals integrals_in_contact(std::span<const Vec2> corners, double overlap, const Vec2& slope) {
  return in_contact<FaceIntegrals>({corners, overlap, slope});
}

/// The derivative of the overlap's energy divided by kn, as b moves in the mean plane. Edges of b carry c^2 / 2,
/// integrated exactly over the part of each edge in contact; the slope of c gives the other term.
Vec2 energy_by_sliding(const FaceOverlap3& faces) {
  Vec2 along_edges = Vec2::Zero();
  const int n = faces.shared.count;
  for (int i = 0; i < n; ++i) {
    if (faces.shared.edge[static_cast<std::size_t>(i)] >= 0) continue;
    const OverlapCorner p = corner_of(faces, i), q = corner_of(faces, i + 1 == n ? 0 : i + 1);
    if (p.c <= 0 && q.c <= 0) continue;
    const double cp = std::max(p.c, 0.0), cq = std::max(q.c, 0.0);
    const double closed = p.c > 0 && q.c > 0 ? 1 : (cp + cq) / std::abs(p.c - q.c);
    const Vec2 side = q.p - p.p;
    along_edges -= (closed / 6 * (cp * cp + cp * cq + cq * cq)) * left_of(side);
  }
  return along_edges - 0.5 * integrals_in_contact(faces).first * faces.plane.slope;
}

}  // namespace trilith
