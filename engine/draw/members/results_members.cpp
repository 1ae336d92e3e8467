#include "draw/members/results_members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

using results::BeamRow;
using results::Frame;
using results::Header;
using results::MemberRow;
using results::MemberValues;
using results::Placement;

namespace {

Vec3 end_of_beam(const Placement& at, const BeamRow& beam, int end) {
  const double* const arm = end == 0 ? beam.arm_a : beam.arm_b;
  return at.at(end == 0 ? beam.node_a : beam.node_b, Vec3(arm[0], arm[1], arm[2]));
}

/// Unit vector from the start to the end of a beam.
Vec3 along_of(const Placement& at, const BeamRow& beam) {
  return (end_of_beam(at, beam, 1) - end_of_beam(at, beam, 0)).normalized();
}

/// Unit vector to the top of a beam's section, perpendicular to its chord.
Vec3 up_of(const Placement& at, const BeamRow& beam) {
  const Vec3 up = at.at(beam.node_a, Vec3(beam.up[0], beam.up[1], beam.up[2])) - at.node(beam.node_a);
  const Vec3 along = along_of(at, beam);
  const Vec3 square = up - along.dot(up) * along;
  return square.norm() > 0 ? Vec3(square.normalized()) : up;
}

Vec2 plane(const Vec3& p) {
  return {p.x(), p.y()};
}

/// The nearest points of the body's outline across the axis at an end of a beam, at the start.
MemberDepth depth_at(const Header& header, const Placement& start, const BeamRow& beam, int end) {
  const results::BodyRow& body = header.bodies[header.members[beam.member].body];
  const Vec3 from = end_of_beam(start, beam, end), along = along_of(start, beam), up = up_of(start, beam);
  const double slack = 1e-6 * beam.length;
  MemberDepth out;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    const Vec3 arm = start.vertex(v) - from;
    const double high = arm.dot(up);
    if (std::abs(arm.dot(along)) > slack || std::abs(high) <= slack) continue;
    double& depth = high > 0 ? out.above : out.below;
    if (depth == 0 || std::abs(high) < depth) depth = std::abs(high);
  }
  return out;
}

/// From an inner node if there is any, where only this member has outline points.
MemberDepth depth_of(const Header& header, const Placement& start, const MemberRow& member) {
  const BeamRow& first = header.beams[member.first_beam];
  MemberDepth out;
  for (const int end : {member.beam_count > 1 ? 1 : 0, 1, 0})
    if (out = depth_at(header, start, first, end); out.is_known()) break;
  return out;
}

/// Axis of a member with its left edge and its right edge, from start to end.
struct Strip {
  std::vector<Vec2> axis, left, right;
  [[nodiscard]] std::vector<Vec2> polygon() const {
    std::vector<Vec2> out = right;
    out.insert(out.end(), left.rbegin(), left.rend());
    return out;
  }
};

Strip strip_of(const Header& header, const Placement& at, const MemberRow& member, const MemberDepth& depth) {
  Strip out;
  std::vector<Vec2> normal;
  for (int i = member.first_beam; i < member.first_beam + member.beam_count; ++i) {
    const BeamRow& beam = header.beams[i];
    const Vec2 along = plane(along_of(at, beam));
    normal.emplace_back(-along.y(), along.x());
    if (out.axis.empty()) out.axis.push_back(plane(end_of_beam(at, beam, 0)));
    out.axis.push_back(plane(end_of_beam(at, beam, 1)));
  }
  for (std::size_t i = 0; i < out.axis.size(); ++i) {
    const Vec2 sum = normal[i > 0 ? i - 1 : 0] + normal[std::min(i, normal.size() - 1)];
    const Vec2 across = sum.norm() > 0 ? Vec2(sum.normalized()) : normal[std::min(i, normal.size() - 1)];
    out.left.push_back(out.axis[i] + depth.above * across);
    out.right.push_back(out.axis[i] - depth.below * across);
  }
  return out;
}

/// End of a member at a joint, seen from the joint: its direction, and the points of its edges on both sides.
struct JointEnd {
  Vec2 along, left, right;
  double angle;
};

JointEnd end_at_joint(const Strip& strip, bool at_start) {
  const std::size_t last = strip.axis.size() - 1, here = at_start ? 0 : last, next = at_start ? 1 : last - 1;
  const Vec2 along = (strip.axis[next] - strip.axis[here]).normalized();
  const double angle = portable::atan2(along.y(), along.x());
  if (at_start) return {along, strip.left[0], strip.right[0], angle};
  return {along, strip.right[last], strip.left[last], angle};
}

/// Fills the outer corner between two members: where their outer edges meet, but at most three depths from the joint.
std::vector<Vec2> corner(const Vec2& joint, const JointEnd& a, const JointEnd& b) {
  constexpr double sharpest = 3;
  const double turn = cross(a.along, b.along);
  const double depth = std::max((a.left - joint).norm(), (b.right - joint).norm());
  std::vector<Vec2> out{joint, a.left};
  if (std::abs(turn) > 1e-3) {
    const Vec2 tip = a.left + cross(Vec2(b.right - a.left), b.along) / turn * a.along;
    if ((tip - joint).norm() < sharpest * depth) out.push_back(tip);
  }
  out.push_back(b.right);
  return out;
}

/// Adds the outer corners of a joint, between neighbouring members more than half a turn apart.
void add_corners(const Vec2& joint, std::vector<JointEnd> ends, std::vector<std::vector<Vec2>>& parts) {
  if (ends.size() < 2) return;
  std::sort(ends.begin(), ends.end(), [](const JointEnd& a, const JointEnd& b) { return a.angle < b.angle; });
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const JointEnd &a = ends[i], &b = ends[(i + 1) % ends.size()];
    const double gap = b.angle - a.angle + (i + 1 == ends.size() ? 2 * M_PI : 0);
    if (gap > M_PI + 0.01) parts.push_back(corner(joint, a, b));
  }
}

/// Ends of the members at the joints of one frame.
struct JointEnds {
  Vec2 place;
  std::vector<JointEnd> ends;
};

HingeMark mark_of(const results::MemberRow& member, results::MemberState state) {
  switch (state) {
    case results::MemberState::lost:
      return HingeMark::lost;
    case results::MemberState::removed:
      return HingeMark::removed;
    case results::MemberState::yielded:
      return member.yields == "fibres" ? HingeMark::fibres : HingeMark::yielded;
    case results::MemberState::elastic:
      break;
  }
  return HingeMark::elastic;
}

/// Adds the diagram of a member; `value(beam, end)`.
template <class Value>
void add_diagram(const Header& header, const Placement& at, const MemberRow& member,
                 const results::MemberQuantity& quantity, const Projection& flat, const Value& value, Scene& scene) {
  SceneDiagram out;
  for (int i = member.first_beam; i < member.first_beam + member.beam_count; ++i) {
    const BeamRow& beam = header.beams[i];
    const Vec3 up = up_of(at, beam);
    const Vec3 side = quantity.across ? cross(along_of(at, beam), up) : up;
    for (const int end : {0, 1}) {
      out.axis.push_back(flat(end_of_beam(at, beam, end)));
      out.towards.push_back(flat(quantity.side * side));
      out.value.push_back(value(static_cast<std::size_t>(i), end));
    }
  }
  scene.diagrams.push_back(std::move(out));
}

}  // namespace

std::vector<MemberDepth> member_depths(const Header& header) {
  std::vector<MemberDepth> out(header.members.size());
  if (header.dim != 2) return out;
  const Frame first = results::start_frame(header);
  const Placement start(header, first);
  for (std::size_t m = 0; m < out.size(); ++m) out[m] = depth_of(header, start, header.members[m]);
  return out;
}

std::vector<std::vector<std::vector<Vec2>>> member_parts(const Header& header, const Frame& frame) {
  std::vector<std::vector<std::vector<Vec2>>> parts(header.bodies.size());
  if (header.members.empty() || header.dim != 2) return parts;
  const Frame first = results::start_frame(header);
  const Placement start(header, first), at(header, frame);
  std::map<std::pair<int, std::string>, JointEnds> joints;
  for (const MemberRow& member : header.members) {
    const MemberDepth depth = depth_of(header, start, member);
    if (!depth.is_known()) continue;
    const Strip strip = strip_of(header, at, member, depth);
    parts[member.body].push_back(strip.polygon());
    for (const bool at_start : {true, false}) {
      const BeamRow& beam = header.beams[at_start ? member.first_beam : member.first_beam + member.beam_count - 1];
      JointEnds& joint = joints[{member.body, at_start ? member.from : member.to}];
      joint.place = plane(at.node(at_start ? beam.node_a : beam.node_b));
      joint.ends.push_back(end_at_joint(strip, at_start));
    }
  }
  for (const auto& [key, joint] : joints) add_corners(joint.place, joint.ends, parts[key.first]);
  return parts;
}

MemberEnvelope member_envelope(const results::ResultsReader& reader, const results::MemberQuantity& quantity,
                               double begin, double end) {
  const Header& header = reader.header();
  MemberEnvelope out;
  const std::vector<double>& times = reader.frame_times();
  for (std::size_t f = 0; f < times.size(); ++f) {
    if (times[f] < begin || times[f] > end) continue;
    const Frame frame = reader.frame(f);
    const MemberValues values(header, frame);
    for (std::size_t i = 0; i < header.beams.size(); ++i) {
      const std::array now{values.force(i, 0, quantity), values.force(i, 1, quantity)};
      if (out.low.size() <= i) out.low.push_back(now), out.high.push_back(now);
      for (const std::size_t e : {0, 1}) {
        out.low[i][e] = std::min(out.low[i][e], now[e]);
        out.high[i][e] = std::max(out.high[i][e], now[e]);
      }
    }
  }
  if (out.low.empty())
    throw InputError(fmt::format("no frame of '{}' lies from {:g} s to {:g} s", reader.path().string(), begin, end));
  return out;
}

void add_diagrams(const Header& header, const Frame& frame, const results::MemberQuantity& quantity,
                  const MemberEnvelope* envelope, const std::vector<bool>& left_out, const Projection& flat,
                  Scene& scene) {
  if (header.members.empty())
    throw InputError(
        "the file has no members; diagrams of section forces are drawn of beams and frames (m:beam, m:frame)");
  const Placement at(header, frame);
  const MemberValues values(header, frame);
  for (const MemberRow& member : header.members) {
    if (left_out[member.body]) continue;
    const auto add = [&](const auto& value) { add_diagram(header, at, member, quantity, flat, value, scene); };
    if (envelope == nullptr) {
      add([&](std::size_t beam, int end) { return values.force(beam, end, quantity); });
      continue;
    }
    add([&](std::size_t beam, int end) { return std::max(0.0, envelope->high[beam][static_cast<std::size_t>(end)]); });
    add([&](std::size_t beam, int end) { return std::min(0.0, envelope->low[beam][static_cast<std::size_t>(end)]); });
  }
  scene.diagram_label = quantity.label + (envelope == nullptr ? "" : ", envelope");
  scene.diagram_unit = quantity.unit;
}

void add_hinges(const Header& header, const Frame& frame, const std::vector<bool>& left_out, const Projection& flat,
                Scene& scene) {
  if (header.members.empty()) return;
  const Placement at(header, frame);
  const MemberValues values(header, frame);
  const auto inward = [&](const Vec3& way) {
    const Vec2 shown = flat(way);
    return shown.norm() > 1e-9 ? Vec2(shown.normalized()) : Vec2(Vec2::Zero());
  };
  for (const MemberRow& member : header.members) {
    if (left_out[member.body] || member.yields == "elastic") continue;
    const int last = member.first_beam + member.beam_count - 1;
    if (member.yields == "hinges") {
      for (const int end : {0, 1}) {
        if (!(member.yield_rotation[end] > 0)) continue;
        const int beam = end == 0 ? member.first_beam : last;
        const BeamRow& row = header.beams[beam];
        const double into = end == 0 ? 1 : -1;
        scene.hinges.push_back({flat(end_of_beam(at, row, end)), inward(into * along_of(at, row)),
                                mark_of(member, values.state(static_cast<std::size_t>(beam), end))});
      }
      continue;
    }
    for (int i = member.first_beam; i <= last; ++i) {
      const results::MemberState state = values.state(static_cast<std::size_t>(i), 0);
      if (state == results::MemberState::elastic) continue;
      const BeamRow& row = header.beams[i];
      const Vec3 middle = 0.5 * (end_of_beam(at, row, 0) + end_of_beam(at, row, 1));
      scene.hinges.push_back({flat(middle), Vec2::Zero(), mark_of(member, state)});
    }
  }
}

}  // namespace trilith::draw
