#include "model/builder/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

/// Start or end of a member: at its joint, or at its offset from it.
Vec2 end_of(const FrameSpec& spec, const FrameMember& m, int side) {
  return m.ends[side].value_or(spec.joints[side == 0 ? m.from : m.to].place);
}

double size_of(const FrameSpec& spec) {
  std::vector<Vec2> places;
  for (const FrameJoint& j : spec.joints) places.push_back(j.place);
  for (const FrameMember& m : spec.members) places.push_back(end_of(spec, m, 0)), places.push_back(end_of(spec, m, 1));
  return polygon_size(places);
}

/// A block rotates about its centroid, and the outline of the frame follows its corners in the order of their angles.
void check_block(const FrameJoint& joint, const std::string& what) {
  const Polygon& p = joint.block;
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(cross(Vec2(p[(i + 1) % n] - p[i]), Vec2(p[(i + 2) % n] - p[(i + 1) % n])) > 0))
      throw InputError(what + ": its block must be convex, without corners in line; attach the rest to another joint");
  const Vec2 centroid = polygon_moments(p).centroid;
  if ((centroid - joint.place).norm() > 1e-9 * polygon_size(p))
    throw InputError(
        fmt::format("{}: 'at' is not the centroid of its block, ({:g}, {:g}); leave it out, and give the ends of "
                    "members by from_at and to_at",
                    what, centroid.x(), centroid.y()));
  if (joint.density) require_positive(*joint.density, what + ": density", "kg/m3");
  if (joint.thickness) require_positive(*joint.thickness, what + ": thickness", "m");
}

/// Intersection of the line from the block's centroid to `to` with its outline.
Vec2 way_out(const FrameJoint& joint, const Vec2& to) {
  const Vec2 way = to - joint.place;
  double least = 1;
  for (std::size_t i = 0; i < joint.block.size(); ++i) {
    const Vec2 &a = joint.block[i], &b = joint.block[(i + 1) % joint.block.size()];
    const double along = cross(Vec2(b - a), way);
    if (along < 0) least = std::min(least, cross(Vec2(b - a), Vec2(a - joint.place)) / along);
  }
  return joint.place + least * way;
}

void check_joint(const FrameSpec& spec, const FrameJoint& joint, const std::string& owner) {
  const std::string what = fmt::format("{}: joint '{}'", owner, joint.name);
  for (const double v : {joint.place.x(), joint.place.y(), joint.mass, joint.inertia}) require_finite(v, what);
  require_not_negative(joint.mass, what + ": mass", "kg");
  require_not_negative(joint.inertia, what + ": inertia", "kg m2");
  if (!joint.block.empty()) check_block(joint, what);
  const auto same =
      std::count_if(spec.joints.begin(), spec.joints.end(), [&](const FrameJoint& j) { return j.name == joint.name; });
  if (same > 1) throw InputError(what + " is given twice; give each its own name");
}

void check_member(const FrameSpec& spec, const FrameMember& m, double size, const std::string& owner) {
  const auto joints = static_cast<int>(spec.joints.size());
  if (m.from < 0 || m.from >= joints || m.to < 0 || m.to >= joints)
    throw InputError(fmt::format("{}: a member ends at a joint that does not exist", owner));
  const std::string what = fmt::format("{}: member '{}'", owner, name_of(spec, m));
  if (m.from == m.to) throw InputError(what + " begins and ends at the same joint; name two");
  for (const int side : {0, 1})
    for (const double v : {end_of(spec, m, side).x(), end_of(spec, m, side).y()}) require_finite(v, what + ": end");
  const double length = (end_of(spec, m, 1) - end_of(spec, m, 0)).norm();
  if (!(length > 1e-6 * size))
    throw InputError(fmt::format("{} is {:g} m long; its ends must lie apart", what, length));
  const Section& s = m.section;
  for (const double v : {s.area, s.second_moment, s.shear_area, s.depth()})
    if (!(v > 0 && std::isfinite(v)))
      throw InputError(what +
                       " has a section without area, inertia or depth; give section = "
                       "trilith.rectangle_section{width =, depth =} or another one");
  if (m.divisions < 1 || m.divisions > 1000)
    throw InputError(fmt::format("{}: {} divisions, must be 1 to 1000", what, m.divisions));
  if (m.pinned[0] && m.pinned[1] && m.divisions < 2)
    throw InputError(
        what + " is pinned at both ends; give it at least two divisions, so that a middle node carries its rotation");
}

/// Every joint must be connected to the first one by members.
void check_connected(const FrameSpec& spec, const std::string& owner) {
  std::vector<int> group(spec.joints.size());
  std::iota(group.begin(), group.end(), 0);
  // The lowest number propagates along members; after as many passes as joints it has reached all connected ones.
  for (std::size_t pass = 0; pass < spec.joints.size(); ++pass)
    for (const FrameMember& m : spec.members) group[m.from] = group[m.to] = std::min(group[m.from], group[m.to]);
  for (std::size_t j = 0; j < group.size(); ++j)
    if (group[j] != 0)
      throw InputError(
          fmt::format("{}: no member leads from joint '{}' to joint '{}'; make them two bodies, or add one", owner,
                      spec.joints[0].name, spec.joints[j].name));
}

/// A member's nodes between its joints: the joints' own nodes at the ends, new ones between. A pinned end's section
/// rotates with the next node, because the joint's rotation is not the member's.
void add_stations(const FrameSpec& spec, const FrameMember& m, FramePlan& plan) {
  const Vec2 from = end_of(spec, m, 0), to = end_of(spec, m, 1);
  std::vector<Station> stations{{m.from, from - spec.joints[m.from].place, m.from}};
  for (int i = 1; i < m.divisions; ++i) {
    const auto node = static_cast<int>(plan.node.size());
    plan.node.emplace_back(from + double(i) / m.divisions * (to - from));
    stations.push_back({node, Vec2::Zero(), node});
  }
  stations.push_back({m.to, to - spec.joints[m.to].place, m.to});
  if (m.pinned[0]) stations.front().turn = stations[1].node;
  if (m.pinned[1]) stations.back().turn = stations[stations.size() - 2].node;
  plan.stations.push_back(std::move(stations));
}

/// Traverses the frame counter-clockwise: along the right of a member, around the members at its far joint, and back
/// along its left. A member that closes a ring ends where the ring does.
///
///           c
///           |                From the tip a: the right of a-b, at b counter-clockwise from the arrival, so all around
///      a -- b -- d           b-d, then all around b-c, and back along the left of a-b.
class Tour {
 public:
  Tour(const FrameSpec& spec, FramePlan& plan)
      : spec_(spec), plan_(plan), been_(spec.members.size()), seen_(spec.joints.size()) {}

  void go_round(int joint, double arrival, int by) {
    seen_[joint] = 1;
    std::vector<std::pair<double, int>> next;
    for (int m = 0; m < static_cast<int>(spec_.members.size()); ++m)
      if (m != by && (spec_.members[m].from == joint || spec_.members[m].to == joint))
        next.emplace_back(angle_past(arrival, heading(m, joint)), m);
    std::sort(next.begin(), next.end());
    double last = 0;
    for (const auto& [angle, m] : next) {
      add_corners(joint, arrival, last, angle);
      last = angle;
      if (been_[m] == 0) visit(m, joint);
    }
    add_corners(joint, arrival, last, 8);
  }

 private:
  /// Direction in which a member leaves a joint [rad].
  [[nodiscard]] double heading(int m, int joint) const {
    const FrameMember& member = spec_.members[m];
    const Vec2 along = end_of(spec_, member, 1) - end_of(spec_, member, 0);
    return portable::atan2(along.y(), along.x()) + (member.from == joint ? 0 : M_PI);
  }
  /// Counter-clockwise angle from one direction to another, above 0 and at most a full turn.
  static double angle_past(double from, double to) {
    // The direction of arrival comes last, after a full turn.
    const double turn = std::fmod(to - from, 2 * M_PI);
    return turn > 1e-9 ? turn : turn + 2 * M_PI;
  }
  /// Corners of the joint's block, from one angle past the arrival to another.
  void add_corners(int joint, double arrival, double from, double to) {
    const FrameJoint& block = spec_.joints[joint];
    std::vector<std::pair<double, int>> there;
    for (int c = 0; c < static_cast<int>(block.block.size()); ++c) {
      const Vec2 arm = block.block[c] - block.place;
      const double angle = angle_past(arrival, portable::atan2(arm.y(), arm.x()));
      if (angle > from && angle <= to) there.emplace_back(angle, c);
    }
    std::sort(there.begin(), there.end());
    for (const auto& [angle, c] : there) plan_.outline.push_back({-1, -1, c, joint});
  }
  /// Stations along one side and back along the other; the members at the far joint are visited in between, once.
  void visit(int m, int joint) {
    been_[m] = 1;
    const FrameMember& member = spec_.members[m];
    const bool forward = member.from == joint;
    const int far = forward ? member.to : member.from, last = static_cast<int>(plan_.stations[m].size()) - 1;
    // Along the right of the traversal: side 0 if that is the member's own direction, else 1.
    for (int i = 0; i <= last; ++i) plan_.outline.push_back({m, forward ? i : last - i, forward ? 0 : 1});
    if (seen_[far] == 0) go_round(far, heading(m, far), m);
    for (int i = last; i >= 0; --i) plan_.outline.push_back({m, forward ? i : last - i, forward ? 1 : 0});
  }

  const FrameSpec& spec_;
  FramePlan& plan_;
  std::vector<std::uint8_t> been_, seen_;
};

}  // namespace

std::string name_of(const FrameSpec& spec, const FrameMember& member) {
  if (!member.name.empty()) return member.name;
  return fmt::format("{}-{}", spec.joints[member.from].name, spec.joints[member.to].name);
}

/// The traversal begins at a tip, where a member ends alone, if there is any.
FramePlan plan_frame(const FrameSpec& spec, const std::string& owner) {
  if (spec.members.empty()) throw InputError(owner + ": a frame without members; give at least one");
  for (const FrameJoint& joint : spec.joints) check_joint(spec, joint, owner);
  const double size = size_of(spec);
  for (const FrameMember& m : spec.members) check_member(spec, m, size, owner);
  check_connected(spec, owner);
  FramePlan plan;
  std::vector<int> meet(spec.joints.size());
  for (const FrameJoint& joint : spec.joints) plan.node.push_back(joint.place);
  for (const FrameMember& m : spec.members) add_stations(spec, m, plan), ++meet[m.from], ++meet[m.to];
  for (const FrameMember& m : spec.members)
    plan.is_tip.push_back(
        {meet[m.from] == 1 && spec.joints[m.from].block.empty(), meet[m.to] == 1 && spec.joints[m.to].block.empty()});
  const auto tip = std::find(meet.begin(), meet.end(), 1);
  const auto root = static_cast<int>(tip == meet.end() ? 0 : tip - meet.begin());
  Tour(spec, plan).go_round(root, 0, -1);
  return plan;
}

void begin_at_blocks(FrameSpec& spec) {
  for (FrameMember& m : spec.members) {
    const int joints = static_cast<int>(spec.joints.size());
    if (m.from < 0 || m.from >= joints || m.to < 0 || m.to >= joints) continue;
    const std::array joint{m.from, m.to};
    const std::array wanted{end_of(spec, m, 0), end_of(spec, m, 1)};
    for (const int side : {0, 1})
      if (!m.ends[side] && !spec.joints[joint[side]].block.empty())
        m.ends[side] = way_out(spec.joints[joint[side]], wanted[1 - side]);
  }
}

Vec2 section_edge(const FrameSpec& spec, const FramePlan& plan, int member, int side) {
  const std::vector<Station>& stations = plan.stations[member];
  const Vec2 left = left_of((plan.place_of(stations.back()) - plan.place_of(stations.front())).normalized());
  const Section& s = spec.members[member].section;
  return side == 0 ? Vec2(-s.below * left) : Vec2(s.above * left);
}

}  // namespace trilith
