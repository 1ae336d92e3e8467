#include "build/space/dome.hpp"

#include <fmt/format.h>

#include <array>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

void check_dome(const Dome& dome, const std::string& owner) {
  require_positive(dome.radius, owner + ": radius", "m");
  require_positive(dome.thickness, owner + ": thickness", "m");
  if (dome.thickness >= 2 * dome.radius)
    throw InputError(fmt::format("{}: thickness is {:g} m, must be below twice the radius, {:g} m", owner,
                                 dome.thickness, 2 * dome.radius));
  require_count(dome.rings, 1, 1000, owner + ": number of rings");
  require_count(dome.sectors, 3, 1000, owner + ": number of sectors");
  require_buildable(static_cast<double>(dome.rings) * dome.sectors, owner);
  require_positive(dome.springing, owner + ": colatitude of the springing", "rad");
  require_positive(dome.crown, owner + ": colatitude of the crown", "rad");
  if (dome.springing > std::numbers::pi / 2 * (1 + 1e-12))
    throw InputError(fmt::format("{}: colatitude of the springing is {:g} rad, must be at most pi/2; angles are in rad",
                                 owner, dome.springing));
  if (dome.crown >= dome.springing)
    throw InputError(
        fmt::format("{}: colatitude of the crown is {:g} rad, must be below the colatitude of the springing, {:g} rad",
                    owner, dome.crown, dome.springing));
  require_finite(dome.phase, owner + ": phase");
  require_place(dome.centre, owner + ": centre");
}

/// Corners of a dome, each computed once.
class DomeGrid {
 public:
  explicit DomeGrid(const Dome& dome) : sectors_(static_cast<std::size_t>(dome.sectors)) {
    for (int k = 0; k <= dome.rings; ++k) {
      const auto [sine, cosine] =
          portable::sine_cosine(dome.springing + (dome.crown - dome.springing) * k / dome.rings);
      for (const double r : {dome.radius - dome.thickness / 2, dome.radius + dome.thickness / 2})
        for (int j = 0; j < dome.sectors; ++j) {
          const auto about = portable::sine_cosine(dome.phase + 2 * std::numbers::pi * j / dome.sectors);
          corners_.push_back(dome.centre + r * Vec3(sine * about.cosine, sine * about.sine, cosine));
        }
    }
  }

  /// Corner of bed `ring` (from 0), inside or outside, at joint `sector` (cyclic).
  [[nodiscard]] const Vec3& at(int ring, bool outside, int sector) const {
    const std::size_t row = 2 * static_cast<std::size_t>(ring) + (outside ? 1 : 0);
    return corners_[row * sectors_ + static_cast<std::size_t>(sector) % sectors_];
  }

  /// The bed below ring `ring` of one sector, counter-clockwise seen from above.
  [[nodiscard]] std::array<Vec3, 4> bed(int ring, int sector) const {
    return {at(ring, false, sector), at(ring, true, sector), at(ring, true, sector + 1), at(ring, false, sector + 1)};
  }

 private:
  std::size_t sectors_;
  std::vector<Vec3> corners_;
};

}  // namespace

std::vector<SolidPart> build_dome(const Dome& dome) {
  const std::string owner = builder_title("dome", dome.name);
  check_dome(dome, owner);
  const DomeGrid grid(dome);
  std::vector<SolidPart> parts;
  const auto add = [&](const std::string& piece, std::vector<Polyhedron> pieces, std::vector<std::string> groups) {
    if (!dome.name.empty()) groups.push_back(dome.name);
    parts.push_back({part_name(dome.name, piece), std::move(pieces), std::move(groups)});
  };
  for (int k = 0; k < dome.rings; ++k)
    for (int j = 0; j < dome.sectors; ++j)
      add(fmt::format("r{}.s{}", k + 1, j + 1), lofted(grid.bed(k, j), grid.bed(k + 1, j)),
          {"voussoirs", fmt::format("ring {}", k + 1), fmt::format("sector {}", j + 1)});
  if (dome.top == DomeTop::key) {
    std::vector<Vec3> low, high;
    for (int j = 0; j < dome.sectors; ++j)
      low.push_back(grid.at(dome.rings, false, j)), high.push_back(grid.at(dome.rings, true, j));
    add("key", lofted(low, high), {"key"});
  }
  return parts;
}

SolidParts Dome::parts() const {
  check_keys(*this, builder_title(kind, name));
  return {build_dome(*this), {}};
}

}  // namespace trilith
