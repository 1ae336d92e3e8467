#include "model/builder/frame_ends.hpp"

#include <algorithm>
#include <array>

#include "model/builder/frame_outline.hpp"

namespace trilith {
namespace {

/// Bottom and top of a member's section at one of its stations [m].
std::array<Vec2, 2> section_at(const FrameSpec& spec, const FramePlan& plan, int member, std::size_t station) {
  const Vec2 place = plan.place_of(plan.stations[static_cast<std::size_t>(member)][station]);
  return {place + section_edge(spec, plan, member, 0), place + section_edge(spec, plan, member, 1)};
}

/// The piece of a member's first or last beam, counter-clockwise.
Polygon beam_at(const FrameSpec& spec, const FramePlan& plan, int member, int side) {
  const std::size_t stations = plan.stations[static_cast<std::size_t>(member)].size();
  const std::size_t first = side == 0 ? 0 : stations - 2;
  const auto near = section_at(spec, plan, member, first), far = section_at(spec, plan, member, first + 1);
  return {near[0], far[0], far[1], near[1]};
}

/// Whether a convex polygon contains both ends of a section, including its boundary.
bool covers(const Polygon& piece, const std::array<Vec2, 2>& section) {
  const double rounding = 1e-6 * polygon_size(piece);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Vec2 side = piece[(i + 1) % piece.size()] - piece[i];
    for (const Vec2& x : section)
      if (cross(side, Vec2(x - piece[i])) < -rounding * side.norm()) return false;
  }
  return true;
}

}  // namespace

bool end_is_face(const FrameSpec& spec, const FramePlan& plan, int member, int side) {
  const auto row = static_cast<std::size_t>(member), end = static_cast<std::size_t>(side);
  if (plan.is_tip[row][end]) return true;
  const FrameMember& own = spec.members[row];
  const int joint = side == 0 ? own.from : own.to;
  const auto section = section_at(spec, plan, member, side == 0 ? 0 : plan.stations[row].size() - 1);
  const Polygon& block = spec.joints[static_cast<std::size_t>(joint)].block;
  if (!block.empty() && covers(block, section)) return false;
  for (int m = 0; m < static_cast<int>(spec.members.size()); ++m) {
    if (m == member) continue;
    const FrameMember& other = spec.members[static_cast<std::size_t>(m)];
    if (other.from == joint && covers(beam_at(spec, plan, m, 0), section)) return false;
    if (other.to == joint && covers(beam_at(spec, plan, m, 1), section)) return false;
  }
  return true;
}

}  // namespace trilith
