#include "shape/overlap_3d.hpp"

#include <algorithm>

namespace trilith {
namespace {

using Buffer3 = SolidOverlapBuffer;

// The part that two convex solids share is a, cut by the half-spaces of b one after the other (Sutherland and Hodgman
// 1974, in three dimensions). A solid in the making is its points, and of each face a run of directed edges; nothing
// else is needed, as volumes and areas are sums over edges. Faces of a keep their numbers (0, 1, ...), those from b are
// -1, -2, ...; so that what each body is pressed on can be told apart afterwards.
void begin_with(const PlacedSolid& solid, Buffer3& s) {
  s.points.assign(solid.corners.begin(), solid.corners.end());
  s.edges.clear(), s.faces.clear();
  const FaceLoops& faces = solid.solid->shape.faces;
  for (int f = 0; f < faces.count(); ++f) {
    const auto loop = faces[f];
    int from = loop.back();
    for (const int to : loop) {
      s.edges.push_back({from, to});
      from = to;
    }
    s.faces.push_back({f, static_cast<int>(s.edges.size())});
  }
}

/// Heights of all points over the plane; the range of them.
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

/// Keeps the points that are not above the plane, with their new numbers.
void keep_points(Buffer3& s) {
  s.points_before.swap(s.points);
  s.points.clear(), s.number.clear();
  for (std::size_t i = 0; i < s.points_before.size(); ++i) {
    s.number.push_back(static_cast<int>(s.points.size()));
    if (s.height[i] <= 0) s.points.push_back(s.points_before[i]);
  }
}

/// Where the edge from `inner` to `outer` passes through the plane: one point for both faces of the edge.
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

/// Edges of one face, from `first` to `end` of those before the cut. Where the rim leaves the half-space and where it
/// comes back are joined by way of the first of these points, and the same edge turned round becomes the lid's. A
/// convex face leaves once; one that lies in the plane but for rounding may leave more often and is closed all the
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

// Sums over triangles (base, p, q) of all faces, seen from one point of the solid, d = base . (p - base) x (q - base):
//
//   V = sum d / 6        centroid = sum d (base + p + q) / (4 sum d)
//   A = sum (p - base) x (q - base) / 2        moment = sum (base + p + q) x ((p - base) x (q - base)) / 6
//
// Each is a surface integral by Gauss's theorem, exact, and independent of the point but for rounding, which is why
// it is one of the solid's own: the overlap is small beside its distance from the origin of the world.
/// Six times the volume, as sum_up has it.
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

/// Sums over the triangles between a point of each face and its edges; volumes from one point of the solid.
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

// Comes in: a solid in the buffer. Goes out: what of it is not above the plane, closed by a lid that has the number of
// the half-space. False where nothing is left; a solid that is not touched is left as it is, without a copy.
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

/// Cuts `a` by all half-spaces of b; false where nothing is left.
bool cut_by_all(const PlacedSolid& a, const PlacedSolid& b, Buffer3& buffer) {
  begin_with(a, buffer);
  const FaceLoops& faces = b.solid->shape.faces;
  for (int f = 0; f < faces.count(); ++f) {
    const Vec3& normal = b.normals[static_cast<std::size_t>(f)];
    const double offset = normal.dot(b.corners[static_cast<std::size_t>(faces[f][0])]);
    if (!cut({normal, offset, -1 - f}, buffer) || buffer.edges.empty()) return false;
  }
  return true;
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
