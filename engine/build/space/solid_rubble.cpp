#include "build/space/solid_rubble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "geometry/plane/random_convex.hpp"
#include "geometry/space/cut_solid.hpp"

namespace trilith {
namespace {

/// Trial positions for each stone; a narrow solid covers only a share of its box.
constexpr std::size_t most_trials = 100000;

/// Smallest area of a face over the square of a stone's mean size.
constexpr double least_face = 1e-7;
/// Shortest edge over that size.
constexpr double least_edge = 1e-5;

/// The other points from near to far, sorted as far as needed.
class NearestFirst {
 public:
  NearestFirst(const std::vector<Vec3>& points, std::size_t of) {
    order_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i != of) order_.push_back({(points[i] - points[of]).squaredNorm(), i});
  }
  [[nodiscard]] bool has(std::size_t k) {
    if (k >= order_.size()) return false;
    if (k >= sorted_) {
      const std::size_t next = std::min(order_.size(), sorted_ + 40);
      std::partial_sort(order_.begin() + static_cast<std::ptrdiff_t>(sorted_),
                        order_.begin() + static_cast<std::ptrdiff_t>(next), order_.end());
      sorted_ = next;
    }
    return true;
  }
  [[nodiscard]] double distance(std::size_t k) const { return std::sqrt(order_[k].first); }
  [[nodiscard]] std::size_t point(std::size_t k) const { return order_[k].second; }

 private:
  std::vector<std::pair<double, std::size_t>> order_;
  std::size_t sorted_ = 0;
};

class SolidFilling {
 public:
  explicit SolidFilling(const SolidRubble& rubble)
      : rubble_(rubble),
        owner_(builder_title("rubble", rubble.name)),
        bits_(static_cast<std::uint64_t>(static_cast<std::int64_t>(rubble.seed))) {
    require_count(rubble_.stones, 1, 10000, owner_ + ": number of stones");
    require_count(rubble_.relaxations, 0, 100, owner_ + ": number of relaxations");
    if (!(rubble_.aspect >= 0.1 && rubble_.aspect <= 10))
      throw InputError(fmt::format("{}: aspect is {:g}, must be from 0.1 to 10", owner_, rubble_.aspect));
    take_solid();
    size_ = portable::pow(volume_ / rubble_.stones, 1.0 / 3);
    check_length(rubble_.joint, "joint");
    check_length(rubble_.jitter, "jitter");
    squeeze_ = Vec3(1 / rubble_.aspect, 1 / rubble_.aspect, 1);
  }

  std::vector<SolidPart> run() {
    scatter();
    for (int i = 0; i < rubble_.relaxations; ++i) relax();
    shift();
    return named();
  }

 private:
  void take_solid() {
    if (rubble_.within.corners.empty()) {
      require_place(rubble_.low, owner_ + ": low corner"), require_place(rubble_.high, owner_ + ": high corner");
      constexpr std::array<const char*, 3> along{"x", "y", "z"};
      for (int k = 0; k < 3; ++k)
        if (!(rubble_.high[k] > rubble_.low[k]))
          throw InputError(
              fmt::format("{}: its box reaches from {:g} to {:g} m in {}; the high corner must be above "
                          "the low one",
                          owner_, rubble_.low[k], rubble_.high[k], along[static_cast<std::size_t>(k)]));
      solid_ = box_between(rubble_.low, rubble_.high);
    } else {
      solid_ = rubble_.within;
    }
    check_convex(solid_, owner_);
    volume_ = solid_moments(solid_).volume;
    const std::vector<Vec3> normals = face_normals(solid_);
    for (int f = 0; f < solid_.faces.count(); ++f) {
      const Vec3& normal = normals[static_cast<std::size_t>(f)];
      sides_.push_back({normal, normal.dot(solid_.corners[static_cast<std::size_t>(solid_.faces[f][0])])});
    }
  }

  void check_length(double value, const char* what) const {
    require_not_negative(value, fmt::format("{}: {}", owner_, what), "m");
    if (value > size_ / 2)
      throw InputError(fmt::format("{}: {} is {:g} m, must be at most half a stone's mean size, {:g} m", owner_, what,
                                   value, size_ / 2));
  }

  [[nodiscard]] bool is_within(const Vec3& p) const {
    return std::all_of(sides_.begin(), sides_.end(),
                       [&](const CuttingPlane& side) { return side.normal.dot(p) < side.offset - 1e-6 * size_; });
  }

  Vec3 random_in_box(const Vec3& low, const Vec3& high) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = random_between(bits_, low[k], high[k]);
    return p;
  }

  /// Uniformly distributed over the solid, by rejection; without coincident points.
  void scatter() {
    Vec3 low = solid_.corners[0], high = low;
    for (const Vec3& p : solid_.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const auto stones = static_cast<std::size_t>(rubble_.stones);
    for (std::size_t trial = 0; points_.size() < stones; ++trial) {
      if (trial == most_trials * stones)
        throw InputError(
            fmt::format("{}: no room is found for {} stones, because the outline fills too little of the box around "
                        "it; give a wider outline, or fewer stones",
                        owner_, rubble_.stones));
      const Vec3 p = random_in_box(low, high);
      const auto too_near = [&](const Vec3& q) { return (p - q).norm() < 1e-2 * size_; };
      if (is_within(p) && std::none_of(points_.begin(), points_.end(), too_near)) points_.push_back(p);
    }
  }

  /// Distances are measured in a space compressed along x and y, so that cells with about equal sides there become
  /// wide.
  std::vector<Vec3> squeezed() const {
    std::vector<Vec3> made;
    for (const Vec3& p : points_) made.push_back(p.cwiseProduct(squeeze_));
    return made;
  }

  [[nodiscard]] double farthest(const Polyhedron& cell, const Vec3& from) const {
    double most = 0;
    for (const Vec3& p : cell.corners) most = std::max(most, (p.cwiseProduct(squeeze_) - from).squaredNorm());
    return std::sqrt(most);
  }

  /// Cuts the solid by the planes midway to the other points, nearest first, each offset. In the compressed space a
  /// point at a distance d cuts at d/2 minus the offset: once that is beyond the farthest remaining corner, no farther
  /// point can cut.
  [[nodiscard]] std::optional<Polyhedron> cell_of(const std::vector<Vec3>& points, std::size_t i,
                                                  double set_back) const {
    const double back = set_back * std::max(1.0, 1 / rubble_.aspect);
    std::optional<Polyhedron> cell = solid_;
    NearestFirst others(points, i);
    for (std::size_t k = 0; cell && others.has(k); ++k) {
      if (others.distance(k) / 2 - back > farthest(*cell, points[i])) break;
      const Vec3& other = points[others.point(k)];
      const Vec3 normal = (other - points[i]).cwiseProduct(squeeze_);
      const double length = normal.norm();
      const double offset = (other - points[i]).dot((other + points[i]) / 2);
      cell = cut_solid(*cell, {normal / length, offset / length - set_back}, 1e-11 * size_);
    }
    return cell;
  }

  void relax() {
    const std::vector<Vec3> points = squeezed();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const auto cell = cell_of(points, i, 0)) points_[i] = solid_moments(*cell).centroid;
  }

  /// A point that would leave the solid is not moved.
  void shift() {
    if (rubble_.jitter == 0) return;
    for (Vec3& p : points_) {
      const Vec3 moved = p + rubble_.jitter * random_in_box(Vec3::Constant(-1), Vec3::Constant(1));
      if (is_within(moved)) p = moved;
    }
  }

  [[nodiscard]] bool has_tiny_parts(const Polyhedron& cell) const {
    for (int f = 0; f < cell.faces.count(); ++f) {
      const auto loop = cell.faces[f];
      if (area_vector(cell.corners, loop).norm() < least_face * size_ * size_) return true;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 &from = cell.corners[static_cast<std::size_t>(loop[k])],
                   &to = cell.corners[static_cast<std::size_t>(loop[k + 1 == loop.size() ? 0 : k + 1])];
        if ((to - from).norm() < least_edge * size_) return true;
      }
    }
    return false;
  }

  /// Among very many stones a few have a very small face or edge. Their points are moved slightly until none has. Cells
  /// are recomputed if a moved point is or was near enough to cut them.
  std::vector<std::optional<Polyhedron>> cells_without_tiny_parts() {
    const double back = rubble_.joint / 2;
    std::vector<Vec3> points = squeezed(), moved;
    std::vector<std::optional<Polyhedron>> cells;
    for (std::size_t i = 0; i < points.size(); ++i) cells.push_back(cell_of(points, i, back));
    for (int round = 0; round < 100; ++round) {
      moved.clear();
      std::vector<char> due(cells.size(), 0);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!cells[i] || !has_tiny_parts(*cells[i])) continue;
        const Vec3 to = points_[i] + 0.02 * size_ * random_in_box(Vec3::Constant(-1), Vec3::Constant(1));
        if (!is_within(to)) continue;
        moved.push_back(points[i]);
        points_[i] = to, points[i] = to.cwiseProduct(squeeze_), due[i] = 1;
        moved.push_back(points[i]);
      }
      if (moved.empty()) break;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const double reach =
            cells[i] ? 2 * (farthest(*cells[i], points[i]) + back * std::max(1.0, 1 / rubble_.aspect)) : 0;
        if (due[i] != 0 ||
            std::any_of(moved.begin(), moved.end(), [&](const Vec3& p) { return (p - points[i]).norm() <= reach; }))
          cells[i] = cell_of(points, i, back);
      }
    }
    return cells;
  }

  std::vector<SolidPart> named() {
    std::vector<std::pair<Vec3, Polyhedron>> stones;
    for (auto& cell : cells_without_tiny_parts())
      if (cell) {
        const Vec3 centre = solid_moments(*cell).centroid;
        stones.emplace_back(centre, std::move(*cell));
      }
    std::stable_sort(stones.begin(), stones.end(), [](const auto& a, const auto& b) {
      return std::array{a.first.z(), a.first.y(), a.first.x()} < std::array{b.first.z(), b.first.y(), b.first.x()};
    });
    std::vector<SolidPart> parts;
    for (auto& [centre, stone] : stones) {
      parts.push_back({part_name(rubble_.name, fmt::format("r{}", parts.size() + 1)), {std::move(stone)}, {"stones"}});
      if (!rubble_.name.empty()) parts.back().groups.push_back(rubble_.name);
      check_convex(parts.back().pieces[0], fmt::format("{}, stone {}", owner_, parts.size()));
    }
    return parts;
  }

  const SolidRubble& rubble_;
  std::string owner_;
  std::mt19937_64 bits_;
  Polyhedron solid_;
  std::vector<CuttingPlane> sides_;
  double volume_ = 0, size_ = 0;
  Vec3 squeeze_ = Vec3::Ones();
  std::vector<Vec3> points_;
};

}  // namespace

std::vector<SolidPart> build_solid_rubble(const SolidRubble& rubble) {
  return SolidFilling(rubble).run();
}

SolidParts SolidRubble::parts() const {
  check_keys(*this, builder_title(kind, name));
  return {build_solid_rubble(*this), {}};
}

}  // namespace trilith
