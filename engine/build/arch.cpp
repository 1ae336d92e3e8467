#include "build/arch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

void check(const Arch& arch, const std::string& owner) {
  require_count(arch.voussoirs, 1, 10000, owner + ": number of voussoirs");
  require_count(arch.sub_edges, 1, 1000, owner + ": number of sub-edges");
  require_positive(arch.radius, owner + ": radius", "m");
  require_positive(arch.thickness, owner + ": thickness", "m");
  require_finite(arch.centre.x(), owner + ": centre x");
  require_finite(arch.centre.y(), owner + ": centre y");
  require_positive(arch.half_angle, owner + ": half opening angle", "rad");
  if (arch.thickness >= 2 * arch.radius)
    throw InputError(fmt::format("{}: thickness is {:g} m, must be below twice the mid radius of {:g} m", owner,
                                 arch.thickness, arch.radius));
  if (arch.half_angle > std::numbers::pi / 2)
    throw InputError(
        fmt::format("{}: half opening angle is {:g} rad, must be at most pi/2 = {:g} rad (a semicircle); "
                    "give the angle from the crown to a springing, in radians",
                    owner, arch.half_angle, std::numbers::pi / 2));
  const double edge_angle = 2 * arch.half_angle / (arch.voussoirs * arch.sub_edges);
  if (edge_angle > 1.01 * std::numbers::pi / 2)
    throw InputError(
        fmt::format("{}: one straight edge spans {:g} rad, must be at most pi/2; give more voussoirs or "
                    "sub-edges",
                    owner, edge_angle));
}

/// Direction from the centre at mark i of `marks` along the arch, left springing to right. The angle is antisymmetric
/// about the crown to the bit, and so are its sine and cosine taken of its size.
Vec2 mark_direction(int i, int marks, double half_angle) {
  const int twice = 2 * i - marks;
  const double size = half_angle * std::abs(twice) / marks;
  const double s = std::sin(size);
  return {twice < 0 ? -s : s, std::cos(size)};
}

struct Springing {
  double low, high, depth;  ///< radii between which the abutment's face runs, and its depth behind it
};

/// Block behind the springing joint along `joint` (unit, from the centre); `side` -1 left, +1 right.
Polygon abutment_outline(const Arch& arch, const Springing& springing, const Vec2& joint, int side) {
  const Vec2 behind = (-side * springing.depth) * left_of(joint);
  const Vec2 inner = arch.centre + springing.low * joint, outer = arch.centre + springing.high * joint;
  if (side > 0) return {inner, inner + behind, outer + behind, outer};
  return {outer, outer + behind, inner + behind, inner};
}

void add_abutments(const Arch& arch, const std::string& owner, double low, double high, const std::vector<Vec2>& marks,
                   std::vector<Part>& parts) {
  const double depth = arch.abutment_depth == 0 ? arch.thickness : arch.abutment_depth;
  require_positive(depth, owner + ": abutment depth", "m");
  require_finite(arch.abutment_margin, owner + ": abutment margin");
  const double margin = arch.abutment_margin < 0 ? std::min(arch.thickness, low) / 2 : arch.abutment_margin;
  if (margin >= low)
    throw InputError(
        fmt::format("{}: abutment margin is {:g} m, must be below the inner radius of {:g} m", owner, margin, low));
  const Springing springing{low - margin, high + margin, depth};
  parts.push_back({part_name(arch.name, "left"), abutment_outline(arch, springing, marks.front(), -1), {"abutments"}});
  parts.push_back({part_name(arch.name, "right"), abutment_outline(arch, springing, marks.back(), 1), {"abutments"}});
}

}  // namespace

std::vector<Part> build_arch(const Arch& arch) {
  const std::string owner = builder_title("arch", arch.name);
  check(arch, owner);
  const int k = arch.sub_edges, count = arch.voussoirs * k;
  const double low = arch.radius - arch.thickness / 2, high = arch.radius + arch.thickness / 2;
  std::vector<Vec2> marks;
  for (int i = 0; i <= count; ++i) marks.push_back(mark_direction(i, count, arch.half_angle));

  std::vector<Part> parts;
  for (int v = 0; v < arch.voussoirs; ++v) {
    Part part{part_name(arch.name, fmt::format("v{}", v + 1)), {}, {"voussoirs"}};
    const auto from = marks.begin() + v * k, to = from + k + 1;
    // left to right along the intrados is counter-clockwise only with the extrados coming back
    for (auto mark = from; mark != to; ++mark) part.outline.push_back(arch.centre + low * *mark);
    for (auto mark = to; mark != from; --mark) part.outline.push_back(arch.centre + high * *(mark - 1));
    parts.push_back(std::move(part));
  }
  if (arch.abutments) add_abutments(arch, owner, low, high, marks, parts);
  return parts;
}

}  // namespace trilith
