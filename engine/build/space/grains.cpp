#include "build/space/grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "base/schema.hpp"
#include "geometry/plane/random_convex.hpp"
#include "geometry/space/random_convex_3d.hpp"

namespace trilith {
namespace {

constexpr int most_in_clump = 1000, most_grains = 200000;
/// Width of a cell of the lattice over the diameter of the largest grain.
constexpr double cell_width = 1.01;

/// Every sphere must touch another one and must not lie within one.
void check_shape(const std::vector<Sphere>& spheres, const std::string& owner) {
  const auto count = static_cast<int>(spheres.size());
  if (count < 1 || count > most_in_clump)
    throw InputError(fmt::format("{}: has {} spheres, must be from 1 to {}", owner, count, most_in_clump));
  for (int i = 0; i < count; ++i)
    check_sphere(spheres[static_cast<std::size_t>(i)], fmt::format("{}: sphere {}", owner, i + 1));
  for (int i = 0; i < count && count > 1; ++i) {
    const Sphere& own = spheres[static_cast<std::size_t>(i)];
    double nearest = unbounded;
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      const Sphere& other = spheres[static_cast<std::size_t>(j)];
      const double apart = (own.centre - other.centre).norm();
      if (apart + own.radius <= other.radius)
        throw InputError(
            fmt::format("{}: sphere {} lies within sphere {}; leave it out or move it", owner, i + 1, j + 1));
      nearest = std::min(nearest, apart - own.radius - other.radius);
    }
    if (nearest > 1e-9 * own.radius)
      throw InputError(
          fmt::format("{}: sphere {} is {:.3g} m away from all others; spheres of a clump touch or overlap, so move it "
                      "closer or make it larger",
                      owner, i + 1, nearest));
  }
}

/// Radius of the sphere about the centroid of a clump that contains it.
double reach_of(const std::vector<Sphere>& spheres, const Vec3& centroid) {
  double reach = 0;
  for (const Sphere& s : spheres) reach = std::max(reach, (s.centre - centroid).norm() + s.radius);
  return reach;
}

class Pouring {
 public:
  explicit Pouring(const Pour& pour)
      : pour_(pour),
        owner_(builder_title("pour", pour.name)),
        bits_(static_cast<std::uint64_t>(static_cast<std::int64_t>(pour.seed))) {
    require_count(pour.count, 1, most_grains, owner_ + ": count");
    require_place(pour.low, owner_ + ": low corner"), require_place(pour.high, owner_ + ": high corner");
    if (!(pour.least > 0) || !(pour.most >= pour.least) || !(pour.most <= 1e12))
      throw InputError(
          fmt::format("{}: radius is from {:g} to {:g} m, must be above 0, and the first at most the second; try "
                      "radius = {{ 0.01, 0.02 }}",
                      owner_, pour.least, pour.most));
    if (!(pour.share >= 0 && pour.share <= 1))
      throw InputError(fmt::format("{}: share is {:g}, must be from 0 to 1", owner_, pour.share));
    if (!pour.shape.empty()) take_shape();
    lay_lattice();
  }

  std::vector<SolidPart> run() {
    std::vector<SolidPart> parts;
    for (int i = 0; i < pour_.count; ++i) parts.push_back(grain(i));
    return parts;
  }

 private:
  /// Scales the shape of clumps to a sphere of radius 1 about its centroid.
  void take_shape() {
    check_shape(pour_.shape, owner_ + ": clump");
    const Vec3 centroid = sphere_moments(pour_.shape).centroid;
    const double reach = reach_of(pour_.shape, centroid);
    for (const Sphere& s : pour_.shape) unit_.push_back({(s.centre - centroid) / reach, s.radius / reach});
  }

  void lay_lattice() {
    constexpr std::array<const char*, 3> along{"x", "y", "z"};
    const double width = 2 * cell_width * pour_.most;
    double room = 1;
    for (int k = 0; k < 3; ++k) {
      const double side = pour_.high[k] - pour_.low[k];
      if (!(side >= width))
        throw InputError(
            fmt::format("{}: its box is {:g} m wide in {}, but a grain of {:g} m needs {:g}; make the box wider or the "
                        "grains smaller",
                        owner_, side, along[static_cast<std::size_t>(k)], 2 * pour_.most, width));
      cells_[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::min(side / width, 1e6));
      room *= static_cast<double>(cells_[static_cast<std::size_t>(k)]);
      cell_[k] = side / static_cast<double>(cells_[static_cast<std::size_t>(k)]);
    }
    if (room < pour_.count)
      throw InputError(
          fmt::format("{}: its box has room for {:.0f} grains of up to {:g} m, but count asks for {}; make the box "
                      "higher, or count at most {:.0f}",
                      owner_, room, 2 * pour_.most, pour_.count, room));
  }

  /// Random radius, uniform by number, or uniform by volume: the number of grains then decreases with r^3, and 1 / r^2
  /// is uniform.
  double radius() {
    const double a = pour_.least, b = pour_.most, share = random_between(bits_, 0, 1);
    if (pour_.grading == Grading::number || a == b) return a + share * (b - a);
    return std::clamp(1 / std::sqrt((1 - share) / (a * a) + share / (b * b)), a, b);
  }

  SolidPart grain(int index) {
    const std::int64_t i = index, nx = cells_[0], ny = cells_[1];
    const std::int64_t column = i % nx, row = i / nx % ny, layer = i / (nx * ny);
    const Vec3 corner(static_cast<double>(column), static_cast<double>(row), static_cast<double>(layer));
    const double r = radius();
    Vec3 at;
    for (int k = 0; k < 3; ++k) {
      const double free = 0.5 * cell_[k] - r - 0.5 * (cell_width - 1) * pour_.least;
      at[k] = pour_.low[k] + (corner[k] + 0.5) * cell_[k] + random_between(bits_, -free, free);
    }
    SolidPart part;
    part.name = fmt::format("{}g{}", pour_.name.empty() ? "" : pour_.name + ".", index + 1);
    part.groups = {"grains"};
    if (!pour_.name.empty()) part.groups.push_back(pour_.name);
    if (unit_.empty() || random_between(bits_, 0, 1) >= pour_.share) {
      part.spheres = {{at, r}};
      return part;
    }
    part.groups.emplace_back("clumps");
    const Turn3 turn = turn_of(random_rotation(bits_));
    for (const Sphere& s : unit_) part.spheres.push_back({turn.apply(r * s.centre) + at, r * s.radius});
    return part;
  }

  const Pour& pour_;
  std::string owner_;
  std::mt19937_64 bits_;
  std::vector<Sphere> unit_;
  std::array<std::int64_t, 3> cells_{};
  Vec3 cell_ = Vec3::Zero();
};

}  // namespace

SolidPart build_clump(const Clump& clump) {
  const std::string owner = builder_title("clump", clump.name);
  check_shape(clump.spheres, owner);
  require_place(clump.at, owner + ": at");
  SolidPart part;
  part.name = clump.name, part.spheres = clump.spheres;
  place_part(part, checked_turn(clump.turn, owner), clump.at);
  return part;
}

std::vector<SolidPart> build_pour(const Pour& pour) {
  return Pouring(pour).run();
}

SolidParts Ball::parts() const {
  const Sphere sphere{at, radius};
  check_sphere(sphere, builder_title(kind, name));
  return one_part({name, {}, {}, {sphere}});
}

SolidParts Clump::parts() const {
  check_keys(*this, builder_title(kind, name));
  return one_part(build_clump(*this));
}

/// build_pour checks the radii together.
SolidParts Pour::parts() const {
  return {build_pour(*this), {}};
}

}  // namespace trilith
