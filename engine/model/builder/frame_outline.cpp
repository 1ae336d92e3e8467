#include "model/builder/frame_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// Traverses the frame counter-clockwise: along the right of a member, around the members at its far joint, and back
/// along its left. A member that closes a ring ends where the ring does.
///
///           c
///           |                From the tip a: the right of a-b, at b counter-clockwise from the arrival, so all around
///      a -- b -- d           b-d, then all around b-c, and back along the left of a-b.
class Tour {
 public:
  Tour(const FrameSpec& spec, const FramePlan& plan)
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
  [[nodiscard]] const std::vector<OutlinePoint>& outline() const { return outline_; }

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
    for (const auto& [angle, c] : there) outline_.push_back({-1, -1, c, joint});
  }
  /// Stations along one side and back along the other; the members at the far joint are visited in between, once.
  void visit(int m, int joint) {
    been_[m] = 1;
    const FrameMember& member = spec_.members[m];
    const bool forward = member.from == joint;
    const int far = forward ? member.to : member.from, last = static_cast<int>(plan_.stations[m].size()) - 1;
    // Along the right of the traversal: side 0 if that is the member's own direction, else 1.
    for (int i = 0; i <= last; ++i) outline_.push_back({m, forward ? i : last - i, forward ? 0 : 1});
    if (seen_[far] == 0) go_round(far, heading(m, far), m);
    for (int i = last; i >= 0; --i) outline_.push_back({m, forward ? i : last - i, forward ? 1 : 0});
  }

  const FrameSpec& spec_;
  const FramePlan& plan_;
  std::vector<OutlinePoint> outline_;
  std::vector<std::uint8_t> been_, seen_;
};

}  // namespace

/// The traversal begins at a tip, where a member ends alone, if there is any.
std::vector<OutlinePoint> frame_outline(const FrameSpec& spec, const FramePlan& plan) {
  std::vector<int> meet(spec.joints.size());
  for (const FrameMember& m : spec.members) ++meet[m.from], ++meet[m.to];
  const auto tip = std::find(meet.begin(), meet.end(), 1);
  Tour tour(spec, plan);
  tour.go_round(static_cast<int>(tip == meet.end() ? 0 : tip - meet.begin()), 0, -1);
  return tour.outline();
}

Vec2 section_edge(const FrameSpec& spec, const FramePlan& plan, int member, int side) {
  const std::vector<StationOf<2>>& stations = plan.stations[member];
  const Vec2 left = left_of((plan.place_of(stations.back()) - plan.place_of(stations.front())).normalized());
  const Section& s = spec.members[member].section;
  return side == 0 ? Vec2(-s.below * left) : Vec2(s.above * left);
}

Vec2 place_of(const FrameSpec& spec, const FramePlan& plan, const OutlinePoint& point) {
  if (point.joint >= 0) return spec.joints[point.joint].block[point.side];
  return plan.place_of(plan.stations[point.member][point.station]) + section_edge(spec, plan, point.member, point.side);
}

}  // namespace trilith
