#include "geometry/space/overlap_3d.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "base/simd/lane_vectors.hpp"

namespace trilith {
namespace {

using Buffer3 = SolidOverlapBuffer;

// One solid is clipped by the half-spaces of the other one after the other (Sutherland and Hodgman 1974, in three
// dimensions). The solid is stored as points and, for each face, a run of directed edges. This is enough, because
// volumes and areas are sums over edges. Faces of a have numbers 0, 1, ..., faces of b are -1, -2, ..., so the surfaces
// of the two bodies can be distinguished afterwards.
/// The half-space below a face of a solid; `face`: number of a cut along it.
TRILITH_INLINE HalfSpace under_face(const PlacedSolid& solid, int f, int face) {
  const Vec3& normal = solid.normals[static_cast<std::size_t>(f)];
  return {normal, normal.dot(solid.corners[static_cast<std::size_t>(solid.solid->shape.faces[f][0])]), face};
}

/// Copies the faces of a solid that reach below a plane, unclipped, with their numbers from `number_of`.
template <class NumberOf>
void begin_with(const PlacedSolid& solid, const HalfSpace& half, NumberOf&& number_of, Buffer3& s) {
  s.points.assign(solid.corners.begin(), solid.corners.end());
  s.edges.clear(), s.faces.clear(), s.height.clear();
  for (const Vec3& p : s.points) s.height.push_back(half.normal.dot(p) - half.offset);
  const FaceLoops& faces = solid.solid->shape.faces;
  for (int f = 0; f < faces.count(); ++f) {
    const auto loop = faces[f];
    if (std::all_of(loop.begin(), loop.end(), [&](int i) { return s.height[static_cast<std::size_t>(i)] > 0; }))
      continue;
    int from = loop.back();
    for (const int to : loop) {
      s.edges.push_back({from, to});
      from = to;
    }
    s.faces.push_back({number_of(f), static_cast<int>(s.edges.size())});
  }
}

/// Corners of a solid in fours, up to the capacity; unused lanes repeat the last corner.
struct CornersInLanes {
  static constexpr std::size_t room = 8;
  std::array<Triple<Lanes>, room> four;
  std::size_t fours;
  std::span<const Vec3> rest;

  TRILITH_INLINE explicit CornersInLanes(const std::vector<Vec3>& corners)
      : fours(std::min(room, (corners.size() + lane_count - 1) / lane_count)) {
    const auto at = [&](std::size_t i) -> const Vec3& { return corners[std::min(i, corners.size() - 1)]; };
    for (std::size_t k = 0; k < fours; ++k) four[k] = four_of(at(4 * k), at(4 * k + 1), at(4 * k + 2), at(4 * k + 3));
    if (corners.size() > room * lane_count) rest = std::span(corners).subspan(room * lane_count);
  }
  /// The least product of the corners with a direction.
  [[nodiscard]] TRILITH_INLINE double lowest(const Vec3& up) const {
    const Triple<Lanes> n = four_of(up, up, up, up);
    Lanes least = n.dot(four[0]);
    for (std::size_t k = 1; k < fours; ++k) least = smaller<Lanes>(least, n.dot(four[k]));
    double of_all = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
    for (const Vec3& x : rest) of_all = std::min(of_all, up.dot(x));
    return of_all;
  }
};

/// The face of a solid below which another solid reaches least: height of the other's lowest corner above it [m],
/// negative where that solid reaches below all faces.
struct TopFace {
  double lowest = -std::numeric_limits<double>::infinity();
  int face = 0;
};

[[gnu::target_clones("avx2", "default")]] TopFace top_face(const PlacedSolid& solid, const PlacedSolid& other) {
  TopFace top;
  const CornersInLanes corners(other.corners);
  for (int f = 0; f < solid.solid->shape.faces.count() && top.lowest < 0; ++f) {
    const HalfSpace half = under_face(solid, f, f);
    const double least = corners.lowest(half.normal) - half.offset;
    if (least > top.lowest) top = {least, f};
  }
  return top;
}

/// Range of the heights of all points over the plane.
struct HeightRange {
  double lowest = 0, highest = 0;
};
HeightRange heights_over(const HalfSpace& half, Buffer3& s) {
  s.height.clear();
  HeightRange range;
  for (const Vec3& p : s.points) {
    const double h = half.normal.dot(p) - half.offset;
    range.lowest = std::min(range.lowest, h), range.highest = std::max(range.highest, h);
    s.height.push_back(h);
  }
  return range;
}

/// Keeps the points that are not above the plane and renumbers them.
void keep_points(Buffer3& s) {
  s.points_before.swap(s.points);
  s.points.clear(), s.number.clear();
  for (std::size_t i = 0; i < s.points_before.size(); ++i) {
    s.number.push_back(static_cast<int>(s.points.size()));
    if (s.height[i] <= 0) s.points.push_back(s.points_before[i]);
  }
}

/// Intersection of the edge from `inner` to `outer` with the plane: one point for both faces of the edge.
int cut_point(int inner, int outer, Buffer3& s) {
  const auto i = static_cast<std::size_t>(inner), o = static_cast<std::size_t>(outer);
  const double from = s.height[i], to = s.height[o];
  if (from == 0) return s.number[i];
  const auto known = std::find_if(s.cuts.begin(), s.cuts.end(),
                                  [&](const Buffer3::Cut& c) { return c.inner == inner && c.outer == outer; });
  if (known != s.cuts.end()) return known->point;
  const Vec3 &p = s.points_before[i], &q = s.points_before[o];
  s.points.push_back(p + (from / (from - to)) * (q - p));
  s.cuts.push_back({inner, outer, static_cast<int>(s.points.size()) - 1});
  return s.cuts.back().point;
}

void add_edge(std::vector<Buffer3::Edge>& edges, int from, int to) {
  if (from != to) edges.push_back({from, to});
}

/// Clips the edges of one face, `first` to `end` of the previous solid. The points where the rim leaves the half-space
/// and where it returns are joined through the first of these points, and the reversed edge is added to the lid. A
/// convex face leaves once. A face that lies in the plane up to rounding may leave several times and is closed all the
/// same.
void cut_face(int first, int end, Buffer3& s) {
  int pivot = -1;
  for (int i = first; i < end; ++i) {
    const auto [from, to] = s.edges_before[static_cast<std::size_t>(i)];
    const bool from_in = s.height[static_cast<std::size_t>(from)] <= 0;
    const bool to_in = s.height[static_cast<std::size_t>(to)] <= 0;
    if (from_in && to_in)
      s.edges.push_back({s.number[static_cast<std::size_t>(from)], s.number[static_cast<std::size_t>(to)]});
    if (from_in == to_in) continue;
    const int at = from_in ? cut_point(from, to, s) : cut_point(to, from, s);
    if (pivot < 0) pivot = at;
    if (from_in) {
      add_edge(s.edges, s.number[static_cast<std::size_t>(from)], at);
      add_edge(s.edges, at, pivot), add_edge(s.lid, pivot, at);
    } else {
      add_edge(s.edges, at, s.number[static_cast<std::size_t>(to)]);
      add_edge(s.edges, pivot, at), add_edge(s.lid, at, pivot);
    }
  }
}

// Sums over triangles (base, p, q) of all faces, seen from one point of the solid. With d = base . (p - base) x (q -
// base):
//
//     V = sum d / 6        centroid = sum d (base + p + q) / (4 sum d)
//     A = sum (p - base) x (q - base) / 2        moment = sum (base + p + q) x ((p - base) x (q - base)) / 6
//
// Each is an exact surface integral (Gauss's theorem) and depends on the reference point by rounding alone. A point of
// the solid is used because the overlap is small compared with its distance from the world's origin.
/// Six times the volume, with the bits of sum_up.
double six_volumes(const Buffer3& s) {
  const auto point = [&](int p) -> const Vec3& { return s.points[static_cast<std::size_t>(p)]; };
  const Vec3 origin = point(s.edges[0].from);
  double six = 0;
  int i = 0;
  for (const auto& [of, end] : s.faces) {
    const int about = s.edges[static_cast<std::size_t>(i)].from;
    const Vec3 base = point(about) - origin;
    for (; i < end; ++i) {
      const auto [from, to] = s.edges[static_cast<std::size_t>(i)];
      if (from == about || to == about) continue;  // no volume
      const Vec3 p = point(from) - origin, q = point(to) - origin;
      six += base.dot(cross(Vec3(p - base), Vec3(q - base)));
    }
  }
  return six;
}

/// Sums over the triangles between a point of each face and its edges; volumes are measured from one point of the
/// solid.
SolidOverlap sum_up(const Buffer3& s) {
  const Vec3 origin = s.points[static_cast<std::size_t>(s.edges[0].from)];
  double six = 0;
  Vec3 first = Vec3::Zero(), area = Vec3::Zero(), moment = Vec3::Zero();
  int i = 0;
  for (const auto& [of, end] : s.faces) {
    const Vec3 base = s.points[static_cast<std::size_t>(s.edges[static_cast<std::size_t>(i)].from)] - origin;
    for (; i < end; ++i) {
      const auto [from, to] = s.edges[static_cast<std::size_t>(i)];
      const Vec3 p = s.points[static_cast<std::size_t>(from)] - origin;
      const Vec3 q = s.points[static_cast<std::size_t>(to)] - origin;
      const Vec3 twice = cross(Vec3(p - base), Vec3(q - base)), sum = base + p + q;
      const double d = base.dot(twice);
      six += d;
      first += d * sum;
      if (of < 0) continue;
      area += 0.5 * twice;
      moment += cross(sum, twice) / 6;
    }
  }
  if (!(six > 0)) return {};
  const Vec3 arm = first / (4 * six);
  return {six / 6, origin + arm, area, moment - cross(arm, area)};
}

}  // namespace

// Clips the solid in the buffer: keeps the part that is not above the plane and closes it by a lid with the
// half-space's number. False where nothing is left. A solid that is not cut stays as it is, without a copy.
bool cut(const HalfSpace& half, Buffer3& s) {
  const HeightRange range = heights_over(half, s);
  if (range.highest <= 0) return true;
  if (range.lowest >= 0) return false;
  keep_points(s);
  s.edges_before.swap(s.edges), s.faces_before.swap(s.faces);
  s.edges.clear(), s.faces.clear(), s.lid.clear(), s.cuts.clear();
  int first = 0;
  for (const auto& [of, end] : s.faces_before) {
    const std::size_t before = s.edges.size();
    cut_face(first, end, s);
    if (s.edges.size() > before) s.faces.push_back({of, static_cast<int>(s.edges.size())});
    first = end;
  }
  s.edges.insert(s.edges.end(), s.lid.begin(), s.lid.end());
  if (!s.lid.empty()) s.faces.push_back({half.face, static_cast<int>(s.edges.size())});
  return true;
}

SolidMeasure measured(const SolidOverlapBuffer& buffer) {
  const SolidOverlap all = sum_up(buffer);
  return {all.volume, all.centroid};
}

namespace {

/// Clips a solid by all half-spaces of another, face `first` first; false where nothing is left.
template <class NumberOf, class NumberOfCut>
bool cut_from(const PlacedSolid& solid, const PlacedSolid& other, int first, NumberOf&& number_of,
              NumberOfCut&& number_of_cut, Buffer3& buffer) {
  const HalfSpace half = under_face(other, first, number_of_cut(first));
  begin_with(solid, half, number_of, buffer);
  if (!cut(half, buffer) || buffer.edges.empty()) return false;
  for (int f = 0; f < other.solid->shape.faces.count(); ++f)
    if (f != first && (!cut(under_face(other, f, number_of_cut(f)), buffer) || buffer.edges.empty())) return false;
  return true;
}

/// The intersection of two solids; false where it is empty. The first cut leaves least: it uses the face, of either
/// solid, below which the other reaches least. For a corner below a face, or an edge, nothing else remains to be cut,
/// and the following planes are tested against few points.
bool cut_by_all(const PlacedSolid& a, const PlacedSolid& b, Buffer3& buffer) {
  const auto of_a = [](int f) { return f; };
  const auto of_b = [](int f) { return -1 - f; };
  const TopFace top_b = top_face(b, a);
  if (top_b.lowest >= 0) return false;
  const TopFace top_a = top_face(a, b);
  if (top_a.lowest >= 0) return false;
  return top_a.lowest > top_b.lowest ? cut_from(b, a, top_a.face, of_b, of_a, buffer)
                                     : cut_from(a, b, top_b.face, of_a, of_b, buffer);
}

void clear(Buffer3& buffer) {
  buffer.points.clear(), buffer.edges.clear(), buffer.faces.clear();
}

}  // namespace

SolidOverlap solid_overlap(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer) {
  SolidOverlap out;
  if (cut_by_all(a, b, buffer)) out = sum_up(buffer);
  if (!(out.volume > 0)) clear(buffer);
  return out;
}

double shared_volume(const PlacedSolid& a, const PlacedSolid& b, SolidOverlapBuffer& buffer) {
  const double volume = cut_by_all(a, b, buffer) ? six_volumes(buffer) / 6 : 0;
  if (volume > 0) return volume;
  clear(buffer);
  return 0;
}

SharedFace shared_face(const SolidOverlapBuffer& buffer, int f, const Vec3& normal) {
  const int first = f == 0 ? 0 : buffer.faces[static_cast<std::size_t>(f) - 1].end;
  const int end = buffer.faces[static_cast<std::size_t>(f)].end;
  const Vec3 base = buffer.points[static_cast<std::size_t>(buffer.edges[static_cast<std::size_t>(first)].from)];
  double twice = 0;
  Vec3 moment = Vec3::Zero();
  for (int i = first; i < end; ++i) {
    const auto [from, to] = buffer.edges[static_cast<std::size_t>(i)];
    const Vec3 p = buffer.points[static_cast<std::size_t>(from)] - base;
    const Vec3 q = buffer.points[static_cast<std::size_t>(to)] - base;
    const double t = normal.dot(cross(p, q));
    twice += t;
    moment += t * (p + q);
  }
  if (!(twice > 0)) return {0, base};
  return {twice / 2, base + moment / (3 * twice)};
}

}  // namespace trilith
