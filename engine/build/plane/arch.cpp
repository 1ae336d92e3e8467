#include "build/plane/arch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "geometry/plane/random_convex.hpp"

namespace trilith {
namespace {

constexpr double quarter = std::numbers::pi / 2;

/// A position along the arch. From the last radial joint to a pointed crown, intrados and extrados rotate by different
/// angles; `to_crown` is the fraction of this segment.
struct Mark {
  int side;      ///< -1 left, +1 right
  double angle;  ///< from the vertical through the centre of its circle [rad]; of the last joint if to_crown > 0
  double to_crown = 0;
};

double crown_angle(const Arch& arch, double radius) {
  return portable::asin(arch.offset / radius);
}

///           crown          Each side has its own circle, with its centre c on the other side of the middle:
///          .-'|`-.         x = side (r sin(angle) - offset), y = r cos(angle). The sides meet where the sine is
///        .'   |   `.       offset / r, at a different angle for each r. Towards a pointed crown `to_crown` is the
///       +---c-+-c---+      fraction of the segment to that angle.
Vec2 point_at(const Arch& arch, const Mark& mark, double radius) {
  if (mark.to_crown == 1) return arch.centre + Vec2(0, std::sqrt(radius * radius - arch.offset * arch.offset));
  double angle = mark.angle;
  if (mark.to_crown > 0) angle += mark.to_crown * (crown_angle(arch, radius) - angle);
  return arch.centre + Vec2(mark.side * (radius * portable::sin(angle) - arch.offset), radius * portable::cos(angle));
}

double inner(const Arch& arch) {
  return arch.radius - arch.thickness / 2;
}

void check_numbers(const Arch& arch, const std::string& owner) {
  check_keys(arch, owner);
  if (arch.key != 1 && arch.voussoirs % 2 == 0)
    throw InputError(fmt::format("{}: a key is given, but {} voussoirs have no middle one; give an odd number", owner,
                                 arch.voussoirs));
}

void check(const Arch& arch, const std::string& owner) {
  check_numbers(arch, owner);
  if (arch.thickness >= 2 * arch.radius)
    throw InputError(fmt::format("{}: thickness is {:g} m, must be below twice the mid radius of {:g} m", owner,
                                 arch.thickness, arch.radius));
  if (arch.half_angle > quarter)
    throw InputError(
        fmt::format("{}: half opening angle is {:g} rad, must be at most pi/2 = {:g} rad (a semicircle); "
                    "give the angle from the crown to a springing, in radians",
                    owner, arch.half_angle, quarter));
  if (arch.offset >= inner(arch))
    throw InputError(
        fmt::format("{}: offset of the centres is {:g} m, must be below the inner radius of {:g} m; otherwise the two "
                    "sides do not meet",
                    owner, arch.offset, inner(arch)));
  if (crown_angle(arch, inner(arch)) >= arch.half_angle)
    throw InputError(fmt::format("{}: half opening angle is {:g} rad, must be above {:g} rad, where the two sides meet",
                                 owner, arch.half_angle, crown_angle(arch, inner(arch))));
  const double edge_angle = 2 * arch.half_angle / (arch.voussoirs * arch.sub_edges);
  if (edge_angle > 1.01 * quarter)
    throw InputError(
        fmt::format("{}: one straight edge spans {:g} rad, must be at most pi/2; give more voussoirs or "
                    "sub-edges",
                    owner, edge_angle));
}

/// Joint angles of one side from the crown outwards, beginning with the joint of the key or the crown. The joints are
/// evenly spaced along the mid line: from the crown to the springing there are `count` voussoirs and, for an odd
/// number, half of the key.
std::vector<double> joint_angles(const Arch& arch, const std::string& owner) {
  const bool odd = arch.voussoirs % 2 == 1;
  const int count = arch.voussoirs / 2;  // whole voussoirs of a side
  const double crown = crown_angle(arch, arch.radius), way = arch.half_angle - crown;
  const double first = odd ? arch.key / 2 : 0;
  std::vector<double> angles;
  for (int i = 0; i <= count; ++i) angles.push_back(crown + way * (i + first) / (count + first));
  // A joint beyond the crown of the intrados would cut the other side.
  if (odd || arch.offset > 0) {
    const double last = odd ? angles.front() : angles[1];
    if (last <= crown_angle(arch, inner(arch)))
      throw InputError(
          fmt::format("{}: the joints next to the crown meet within the arch; give fewer voussoirs, less "
                      "thickness, or an odd number of voussoirs with a wider key",
                      owner));
  }
  if (arch.jitter > way / (count + first) * arch.radius / 4)
    throw InputError(fmt::format("{}: jitter is {:g} m, must be at most a quarter of a voussoir, {:g} m", owner,
                                 arch.jitter, way / (count + first) * arch.radius / 4));
  return angles;
}

/// Joint angles; the ends, and a crown without key, are not moved by jitter.
struct Joints {
  std::vector<double> left, right;  ///< from the crown outwards [rad]
};

Joints moved_joints(const Arch& arch, const std::vector<double>& angles) {
  Joints joints{angles, angles};
  if (arch.jitter == 0) return joints;
  std::mt19937_64 bits(static_cast<std::uint64_t>(static_cast<std::int64_t>(arch.seed)));
  for (std::vector<double>* side : {&joints.left, &joints.right})
    for (std::size_t i = arch.voussoirs % 2 == 1 ? 0 : 1; i + 1 < side->size(); ++i)
      (*side)[i] += random_between(bits, -arch.jitter, arch.jitter) / arch.radius;
  return joints;
}

/// Positions of voussoir i of one side, counted from the crown, from its inner to its outer joint. Next to a pointed
/// crown without key the positions are fractions of the segment to the crown, because it lies at no common angle.
std::vector<Mark> side_marks(const Arch& arch, const std::vector<double>& joints, std::size_t i, int side) {
  const int k = arch.sub_edges;
  const double from = joints[i], to = joints[i + 1];
  const bool at_crown = i == 0 && arch.voussoirs % 2 == 0 && arch.offset > 0;
  std::vector<Mark> marks;
  for (int j = 0; j < k; ++j) {
    const double share = static_cast<double>(j) / k;
    marks.push_back(at_crown ? Mark{side, to, 1 - share} : Mark{side, from + share * (to - from)});
  }
  marks.push_back({side, to});
  return marks;
}

/// Positions of the middle voussoir from left to right: under a pointed crown up the left side and down the right side,
/// otherwise in even steps of the angle.
std::vector<Mark> key_marks(const Arch& arch, double left, double right) {
  const int k = arch.sub_edges;
  std::vector<Mark> marks;
  if (arch.offset > 0) {
    for (int j = 0; j <= k; ++j) marks.push_back({-1, left, static_cast<double>(j) / k});
    for (int j = k - 1; j >= 0; --j) marks.push_back({1, right, static_cast<double>(j) / k});
    return marks;
  }
  for (int j = 0; j <= k; ++j) {
    const int twice = 2 * j - k;
    const double middle = (right - left) / 2, half = (right + left) / 2;
    marks.push_back({1, middle + half * twice / k});
  }
  // the same joints as in the neighbours
  marks.front() = {-1, left}, marks.back() = {1, right};
  return marks;
}

Part make_voussoir(const Arch& arch, int number, const std::vector<Mark>& marks) {
  const double low = inner(arch), high = arch.radius + arch.thickness / 2;
  Part part{part_name(arch.name, fmt::format("v{}", number)), {}, {"voussoirs"}};
  // from left to right along the intrados and back along the extrados is clockwise
  for (const Mark& mark : marks) part.outline.push_back(point_at(arch, mark, low));
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) part.outline.push_back(point_at(arch, *mark, high));
  return part;
}

/// Block behind the springing joint of one side, between two radii.
Part make_abutment(const Arch& arch, int side, double low, double high, double depth) {
  const Mark springing{side, arch.half_angle};
  const Vec2 inside = point_at(arch, springing, low), outside = point_at(arch, springing, high);
  // Away from the arch, perpendicular to the springing joint.
  const Vec2 behind = (-side * depth) * left_of((outside - inside).normalized());
  Polygon outline{inside, inside + behind, outside + behind, outside};
  if (side < 0) outline = {outside, outside + behind, inside + behind, inside};
  return {part_name(arch.name, side < 0 ? "left" : "right"), std::move(outline), {"abutments"}};
}

void add_abutments(const Arch& arch, const std::string& owner, std::vector<Part>& parts) {
  const double low = inner(arch), high = arch.radius + arch.thickness / 2;
  const double depth = arch.abutment_depth == 0 ? arch.thickness : arch.abutment_depth;
  require_positive(depth, owner + ": abutment depth", "m");
  const double margin = arch.abutment_margin.value_or(std::min(arch.thickness, low) / 2);
  if (!(margin >= 0))
    throw InputError(fmt::format("{}: abutment margin is {:g} m, must be finite and not below 0", owner, margin));
  if (margin >= low)
    throw InputError(
        fmt::format("{}: abutment margin is {:g} m, must be below the inner radius of {:g} m", owner, margin, low));
  for (const int side : {-1, 1}) parts.push_back(make_abutment(arch, side, low - margin, high + margin, depth));
}

}  // namespace

void set_span_and_rise(Arch& arch, double span, double rise) {
  const std::string owner = builder_title("arch", arch.name);
  require_positive(span, owner + ": span", "m");
  require_positive(rise, owner + ": rise", "m");
  require_positive(arch.thickness, owner + ": thickness", "m");
  // A rise above half of the span requires two circles that meet in a point.
  const double half = span / 2;
  const bool pointed = rise > half;
  // Pythagoras: segmental (low - rise)^2 + half^2 = low^2; pointed low - offset = half and low^2 - offset^2 = rise^2
  const double low = pointed ? (rise * rise / half + half) / 2 : (half * half / rise + rise) / 2;
  arch.offset = pointed ? low - half : 0;
  arch.half_angle = rise >= half ? quarter : portable::asin(half / low);
  arch.radius = low + arch.thickness / 2;
}

Arch with_span_and_rise(Arch arch) {
  if (arch.span.has_value() != arch.rise.has_value())
    throw InputError(builder_title("arch", arch.name) + ": span and rise go together; give both or neither");
  if (arch.span) set_span_and_rise(arch, *arch.span, *arch.rise);
  return arch;
}

std::vector<Part> Arch::parts() const {
  return build_arch(*this);
}

std::vector<Part> build_arch(const Arch& given) {
  const Arch arch = with_span_and_rise(given);
  const std::string owner = builder_title("arch", arch.name);
  check(arch, owner);
  const Joints joints = moved_joints(arch, joint_angles(arch, owner));
  const auto count = static_cast<std::size_t>(arch.voussoirs / 2);
  std::vector<Part> parts;
  int number = 0;
  for (std::size_t i = count; i > 0; --i) {
    std::vector<Mark> marks = side_marks(arch, joints.left, i - 1, -1);
    std::reverse(marks.begin(), marks.end());
    parts.push_back(make_voussoir(arch, ++number, marks));
  }
  if (arch.voussoirs % 2 == 1) {
    parts.push_back(make_voussoir(arch, ++number, key_marks(arch, joints.left.front(), joints.right.front())));
    parts.back().groups.emplace_back("key");
  }
  for (std::size_t i = 0; i < count; ++i)
    parts.push_back(make_voussoir(arch, ++number, side_marks(arch, joints.right, i, 1)));
  if (arch.abutments) add_abutments(arch, owner, parts);
  return parts;
}

std::vector<Part> build_profile(Arch arch, std::string_view owner) {
  arch.name = {};
  try {
    return build_arch(arch);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", owner, e.what()));
  }
}

}  // namespace trilith
