#include "geometry/space/crossing_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/hierarchical_hash_grid.hpp"

namespace trilith {
namespace {

/// Tests of edges against edges or faces after which the search ends.
constexpr double most_crossing_work = 3e7;

// An edge that begins above the plane of another face and ends below it passes through that face if the intersection x
// lies inside its loop (nonzero winding number) or on it.
//
//                 o from
//          _______|_______
//         /       |      /
//        /        x     /
//       /_________:____/
//                 :
//                 o to
class CrossingSearch {
 public:
  CrossingSearch(const Polyhedron& surface, double within) : surface_(surface), within_(within) {
    for (int f = 0; f < surface.faces.count(); ++f) planes_.push_back(plane_of(f));
  }

  std::optional<FaceCrossing> run() {
    HierarchicalHashGrid<3> boxes;
    boxes.reset(surface_.faces.count());
    for (int f = 0; f < surface_.faces.count() && work_ < most_crossing_work; ++f) {
      if (const auto at = loop_crossing(f)) return FaceCrossing{f, f, *at};
      const FatBox<3> box = box_of(f);
      std::vector<int> near;
      boxes.for_meeting(box, [&](int g) { near.push_back(g); });
      std::sort(near.begin(), near.end());
      for (const int g : near) {
        auto at = through(g, f);
        if (!at) at = through(f, g);
        if (at) return FaceCrossing{g, f, *at};
      }
      work_ += static_cast<double>(near.size());
      boxes.put(f, box);
    }
    return {};
  }

 private:
  /// The plane of a face, and its two axes of projection.
  struct FacePlane {
    Vec3 normal;  ///< unit normal; 0 for a face without area in every projection
    Vec3 on;
    Eigen::Index u, v;
  };

  [[nodiscard]] const Vec3& corner(int i) const { return surface_.corners[static_cast<std::size_t>(i)]; }

  /// The area vector of a loop that crosses itself may be 0: then the widest triangle at its first corner defines the
  /// plane.
  [[nodiscard]] FacePlane plane_of(int face) const {
    const auto loop = surface_.faces[face];
    Vec3 normal = area_vector(surface_.corners, loop);
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const Vec3 wide =
          0.5 * cross(Vec3(corner(loop[k - 1]) - corner(loop[0])), Vec3(corner(loop[k]) - corner(loop[0])));
      if (wide.norm() > 2 * normal.norm()) normal = wide;
    }
    const double length = normal.norm();
    FacePlane plane{length > 0 ? Vec3(normal / length) : Vec3::Zero(), corner(loop[0]), 0, 1};
    Eigen::Index along = 0;
    plane.normal.cwiseAbs().maxCoeff(&along);
    plane.u = (along + 1) % 3, plane.v = (along + 2) % 3;
    return plane;
  }

  [[nodiscard]] FatBox<3> box_of(int face) const {
    const auto loop = surface_.faces[face];
    Vec3 low = corner(loop[0]), high = low;
    for (const int i : loop) low = low.cwiseMin(corner(i)), high = high.cwiseMax(corner(i));
    FatBox<3> box;
    for (std::size_t k = 0; k < 3; ++k)
      box.low[k] = low[static_cast<Eigen::Index>(k)], box.high[k] = high[static_cast<Eigen::Index>(k)];
    return box;
  }

  [[nodiscard]] bool share_a_corner(int a, int b) const {
    const auto of_a = surface_.faces[a], of_b = surface_.faces[b];
    return std::any_of(of_a.begin(), of_a.end(),
                       [&](int i) { return std::find(of_b.begin(), of_b.end(), i) != of_b.end(); });
  }

  /// Intersection of an edge of face `a` with face `b`.
  std::optional<Vec3> through(int a, int b) {
    const auto loop = surface_.faces[a];
    const FacePlane& plane = planes_[static_cast<std::size_t>(b)];
    work_ += static_cast<double>(loop.size());
    if (plane.normal == Vec3::Zero() || share_a_corner(a, b)) return {};
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 &from = corner(loop[k]), &to = corner(loop[k + 1 == loop.size() ? 0 : k + 1]);
      const double start = plane.normal.dot(from - plane.on), end = plane.normal.dot(to - plane.on);
      if (std::min(start, end) > -within_ || std::max(start, end) < within_) continue;
      const Vec3 at = from + start / (start - end) * (to - from);
      if (holds(b, plane, at)) return at;
    }
    return {};
  }

  /// Whether a point in the plane of a face lies inside its loop or on it.
  bool holds(int face, const FacePlane& plane, const Vec3& at) {
    const auto loop = surface_.faces[face];
    work_ += static_cast<double>(loop.size());
    int turns = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 from = corner(loop[k]) - at, to = corner(loop[k + 1 == loop.size() ? 0 : k + 1]) - at,
                 side = to - from;
      const double share = std::clamp(-from.dot(side) / std::max(side.squaredNorm(), 1e-300), 0.0, 1.0);
      if ((from + share * side).norm() <= within_) return true;
      const double low = from[plane.v], high = to[plane.v];
      if ((low <= 0) == (high <= 0)) continue;
      if (from[plane.u] - low * side[plane.u] / side[plane.v] > 0) turns += high > low ? 1 : -1;
    }
    return turns != 0;
  }

  /// Crossing of two edges of one loop that are not neighbours.
  std::optional<Vec3> loop_crossing(int face) {
    const auto loop = surface_.faces[face];
    const FacePlane& plane = planes_[static_cast<std::size_t>(face)];
    const std::size_t n = loop.size();
    if (n < 4 || plane.normal == Vec3::Zero()) return {};
    work_ += static_cast<double>(n) * static_cast<double>(n);
    if (work_ > most_crossing_work) return {};
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t k = i + 2; k < n; ++k) {
        if (i == 0 && k + 1 == n) continue;
        const auto at = sides_cross({loop[i], loop[i + 1]}, {loop[k], loop[k + 1 == n ? 0 : k + 1]}, plane.normal);
        if (at) return at;
      }
    return {};
  }

  /// Each edge has its ends on opposite sides of the other, projected along `normal`.
  [[nodiscard]] std::optional<Vec3> sides_cross(const std::array<int, 2>& a, const std::array<int, 2>& b,
                                                const Vec3& normal) const {
    if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) return {};
    const Vec3 of_a = corner(a[1]) - corner(a[0]), of_b = corner(b[1]) - corner(b[0]);
    const auto beside = [&](const Vec3& side, int on, int i) {
      return normal.dot(cross(side, Vec3(corner(i) - corner(on)))) / std::max(side.norm(), 1e-300);
    };
    const double a0 = beside(of_b, b[0], a[0]), a1 = beside(of_b, b[0], a[1]);
    const double b0 = beside(of_a, a[0], b[0]), b1 = beside(of_a, a[0], b[1]);
    const bool crosses = std::min(a0, a1) < -within_ && std::max(a0, a1) > within_ && std::min(b0, b1) < -within_ &&
                         std::max(b0, b1) > within_;
    if (!crosses) return {};
    return Vec3(corner(a[0]) + a0 / (a0 - a1) * of_a);
  }

  const Polyhedron& surface_;
  double within_;
  std::vector<FacePlane> planes_;
  double work_ = 0;
};

}  // namespace

/// Each face is tested against the earlier faces whose boxes overlap its own.
std::optional<FaceCrossing> crossing_faces(const Polyhedron& surface, double within) {
  return CrossingSearch(surface, within).run();
}

}  // namespace trilith
