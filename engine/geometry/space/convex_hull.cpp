#include "geometry/space/convex_hull.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Time grows as points times the number of created triangles; convexity checks take faces times corners.
constexpr std::size_t most_triangles = 5000;

struct HullTriangle {
  std::array<int, 3> corner;
  Vec3 normal;  ///< outward unit normal
  double area;
  int farthest = -1;  ///< point highest above it, by more than the tolerance; -1: none
  double above = 0;   ///< its height [m]
  bool sees = false;  ///< visible from the point that is added
};

// The hull grows point by point: quickhull (Barber, Dobkin and Huhdanpaa, ACM Trans. Math. Softw. 22, 1996). Each new
// triangle tests all points, because these solids have some dozen. Starting with a tetrahedron, the point farthest
// above any triangle is added:
//
//            * p                 * p
//           . .                 /|\        the triangles visible from p, one patch without holes, are removed;
//        __.___.__           __/ | \__     each edge of their rim makes a triangle with p
//       /  visible\         /         \    (seen from the side)
//
// Points within `tolerance` of the hull count as inside and see no triangle, so rounding makes no slivers.
class HullBuilder {
 public:
  HullBuilder(std::span<const Vec3> points, double tolerance, std::string_view owner)
      : points_(points), tolerance_(tolerance), owner_(owner) {}

  /// False where all points are coplanar.
  bool begin() {
    const auto [a, b, c, d] = spread_out();
    const Vec3 ab = at(b) - at(a), ac = at(c) - at(a);
    const double height = cross(ab, ac).normalized().dot(at(d) - at(a));
    if (!(std::abs(height) > tolerance_)) return false;
    const int second = height > 0 ? c : b, third = height > 0 ? b : c;
    add(a, second, third);
    add(a, third, d), add(third, second, d), add(second, a, d);
    return true;
  }

  void run() {
    // each round adds one permanent point, so there are no more rounds than points
    for (std::size_t round = 0; round < points_.size(); ++round) {
      const auto [point, triangle] = farthest();
      if (point < 0) return;
      see(static_cast<std::size_t>(triangle), at(point));
      take_in(point);
      if (triangles_.size() > most_triangles)
        throw InputError(
            fmt::format("{}: the hull of its {} points has more than {} faces; give fewer points of its surface, at "
                        "most a few hundred",
                        owner_, points_.size(), most_triangles));
    }
  }

  /// Merges coplanar triangles into faces, the largest triangles first.
  [[nodiscard]] FaceLoops faces() const {
    std::vector<int> face(triangles_.size(), -1);
    FaceLoops loops;
    for (std::size_t seed = largest_left(face); seed < face.size(); seed = largest_left(face)) {
      const int number = loops.count();
      std::vector<std::size_t> open{seed};
      face[seed] = number;
      while (!open.empty()) {
        const HullTriangle& t = triangles_[open.back()];
        open.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t next = across(t.corner[(k + 1) % 3], t.corner[k]);
          if (face[next] >= 0 || !in_plane(triangles_[seed], triangles_[next])) continue;
          face[next] = number;
          open.push_back(next);
        }
      }
      loops.add(rim(face, number));
    }
    return loops;
  }

 private:
  [[nodiscard]] const Vec3& at(int i) const { return points_[static_cast<std::size_t>(i)]; }

  void add(int a, int b, int c) {
    const Vec3 ab = at(b) - at(a), ac = at(c) - at(a), twice = cross(ab, ac);
    HullTriangle& t = triangles_.emplace_back(HullTriangle{{a, b, c}, twice.normalized(), 0.5 * twice.norm()});
    t.above = tolerance_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double by = height(t, points_[i]);
      if (by > t.above) t.above = by, t.farthest = static_cast<int>(i);
    }
  }

  [[nodiscard]] double height(const HullTriangle& t, const Vec3& p) const { return t.normal.dot(p - at(t.corner[0])); }

  /// The first point, then the farthest from it, from the line through both, and from the plane through the three.
  [[nodiscard]] std::array<int, 4> spread_out() const {
    std::array<int, 4> of{0, 0, 0, 0};
    const auto most = [&](auto&& measure) {
      int best = 0;
      for (int i = 1; i < static_cast<int>(points_.size()); ++i)
        if (measure(at(i)) > measure(at(best))) best = i;
      return best;
    };
    of[1] = most([&](const Vec3& p) { return (p - at(0)).squaredNorm(); });
    const Vec3 along = at(of[1]) - at(0);
    of[2] = most([&](const Vec3& p) { return cross(along, Vec3(p - at(0))).squaredNorm(); });
    const Vec3 normal = cross(along, Vec3(at(of[2]) - at(0)));
    of[3] = most([&](const Vec3& p) { return std::abs(normal.dot(p - at(0))); });
    return of;
  }

  struct PointOutside {
    int point, triangle;
  };
  [[nodiscard]] PointOutside farthest() const {
    PointOutside out{-1, -1};
    double most = tolerance_;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (triangles_[t].above > most) most = triangles_[t].above, out = {triangles_[t].farthest, static_cast<int>(t)};
    return out;
  }

  /// The triangle whose edge runs from `from` to `to`.
  [[nodiscard]] std::size_t across(int from, int to) const {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (triangles_[t].corner[k] == from && triangles_[t].corner[(k + 1) % 3] == to) return t;
    throw InputError(fmt::format("{}: its points are too close to each other for its size; remove duplicates", owner_));
  }

  /// Marks the triangles that see `p`, from `first` on to their neighbours: one connected patch without holes.
  void see(std::size_t first, const Vec3& p) {
    std::vector<std::size_t> open{first};
    triangles_[first].sees = true;
    while (!open.empty()) {
      const std::array<int, 3> corner = triangles_[open.back()].corner;
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        HullTriangle& next = triangles_[across(corner[(k + 1) % 3], corner[k])];
        if (next.sees || height(next, p) <= tolerance_) continue;
        next.sees = true;
        open.push_back(static_cast<std::size_t>(&next - triangles_.data()));
      }
    }
  }

  void take_in(int point) {
    std::vector<std::array<int, 2>> edges;
    for (const HullTriangle& t : triangles_)
      for (std::size_t k = 0; k < 3 && t.sees; ++k)
        if (!triangles_[across(t.corner[(k + 1) % 3], t.corner[k])].sees)
          edges.push_back({t.corner[k], t.corner[(k + 1) % 3]});
    std::erase_if(triangles_, [](const HullTriangle& t) { return t.sees; });
    for (const auto& [from, to] : edges) add(from, to, point);
  }

  [[nodiscard]] std::size_t largest_left(const std::vector<int>& face) const {
    std::size_t best = face.size();
    for (std::size_t t = 0; t < face.size(); ++t)
      if (face[t] < 0 && (best == face.size() || triangles_[t].area > triangles_[best].area)) best = t;
    return best;
  }

  [[nodiscard]] bool in_plane(const HullTriangle& plane, const HullTriangle& t) const {
    return std::all_of(t.corner.begin(), t.corner.end(),
                       [&](int i) { return std::abs(height(plane, at(i))) <= tolerance_; }) &&
           plane.normal.dot(t.normal) > 0;
  }

  /// Corners around the triangles of one face.
  [[nodiscard]] std::vector<int> rim(const std::vector<int>& face, int number) const {
    std::vector<std::array<int, 2>> edges;
    for (std::size_t t = 0; t < face.size(); ++t)
      for (std::size_t k = 0; k < 3 && face[t] == number; ++k) {
        const int from = triangles_[t].corner[k], to = triangles_[t].corner[(k + 1) % 3];
        if (face[across(to, from)] != number) edges.push_back({from, to});
      }
    std::vector<int> loop{edges[0][0]};
    for (int to = edges[0][1]; to != loop[0] && loop.size() < edges.size();) {
      loop.push_back(to);
      to = (*std::find_if(edges.begin(), edges.end(), [&](const auto& e) { return e[0] == loop.back(); }))[1];
    }
    return loop;
  }

  std::span<const Vec3> points_;
  double tolerance_;
  std::string_view owner_;
  std::vector<HullTriangle> triangles_;
};

/// Removes points where fewer than three faces meet: inside a face, or between the ends of an edge.
Polyhedron with_corners_used(std::span<const Vec3> points, const FaceLoops& faces) {
  std::vector<int> uses(points.size(), 0), number(points.size(), -1);
  for (const int i : faces.corner) ++uses[static_cast<std::size_t>(i)];
  Polyhedron solid;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (uses[i] < 3) continue;
    number[i] = static_cast<int>(solid.corners.size());
    solid.corners.push_back(points[i]);
  }
  for (int f = 0; f < faces.count(); ++f) {
    std::vector<int> loop;
    for (const int i : faces[f])
      if (number[static_cast<std::size_t>(i)] >= 0) loop.push_back(number[static_cast<std::size_t>(i)]);
    solid.faces.add(loop);
  }
  return solid;
}

}  // namespace

// The tolerance is `flat` times the size of the whole set. The final check allows four times as much, because each
// merged face may lie up to the tolerance off its plane.
Polyhedron convex_hull(std::span<const Vec3> points, std::string_view owner, double flat) {
  if (points.size() < 4) throw InputError(fmt::format("{}: has {} points, needs at least 4", owner, points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(points[i].cwiseAbs().array() <= 1e12).all())
      throw InputError(fmt::format("{}: point {} is ({:g}, {:g}, {:g}) m, must be finite and within 1e12 m", owner,
                                   i + 1, points[i].x(), points[i].y(), points[i].z()));
  HullBuilder hull(points, flat * solid_size(points), owner);
  if (!hull.begin())
    throw InputError(fmt::format("{}: all its points lie in one plane; give points on both sides of it", owner));
  hull.run();
  Polyhedron solid = with_corners_used(points, hull.faces());
  check_convex(solid, owner, 4 * flat);
  return solid;
}

}  // namespace trilith
