#include "model/builder/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {
namespace {

double size_of(const std::vector<Vec2>& places) {
  return polygon_size(places);
}
double size_of(const std::vector<Vec3>& places) {
  return solid_size(places);
}

std::string text_of(const Vec2& x) {
  return fmt::format("({:g}, {:g})", x.x(), x.y());
}
std::string text_of(const Vec3& x) {
  return fmt::format("({:g}, {:g}, {:g})", x.x(), x.y(), x.z());
}

/// Diagonal of the box around all joints and ends of members [m].
template <int D>
double size_of(const FrameSpecOf<D>& spec) {
  std::vector<Vec<D>> places;
  for (const FrameJointOf<D>& j : spec.joints) places.push_back(j.place);
  for (const FrameMemberOf<D>& m : spec.members)
    for (const int side : {0, 1}) places.push_back(end_of(spec, m, side));
  return size_of(places);
}

// The block of a joint: its corners, its centroid after the check of its shape, and the share of the way from the
// centroid to `to` that lies within it.

const std::vector<Vec2>& corners_of(const Polygon& block) {
  return block;
}
const std::vector<Vec3>& corners_of(const Polyhedron& block) {
  return block.corners;
}

/// The outline of the frame follows the corners in the order of their angles about the joint.
Vec2 checked_centroid(const Polygon& p, const std::string& what) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(cross(Vec2(p[(i + 1) % n] - p[i]), Vec2(p[(i + 2) % n] - p[(i + 1) % n])) > 0))
      throw InputError(what + ": its block must be convex, without corners in line; attach the rest to another joint");
  return polygon_moments(p).centroid;
}
Vec3 checked_centroid(const Polyhedron& block, const std::string& what) {
  check_convex(block, what + ": its block");
  return solid_moments(block).centroid;
}

double share_within(const Polygon& block, const Vec2& centroid, const Vec2& to) {
  const Vec2 way = to - centroid;
  double least = 1;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Vec2 &a = block[i], &b = block[(i + 1) % block.size()];
    const double along = cross(Vec2(b - a), way);
    if (along < 0) least = std::min(least, cross(Vec2(b - a), Vec2(a - centroid)) / along);
  }
  return least;
}
double share_within(const Polyhedron& block, const Vec3& centroid, const Vec3& to) {
  const Vec3 way = to - centroid;
  double least = 1;
  const std::vector<Vec3> normals = face_normals(block);
  for (int f = 0; f < block.faces.count(); ++f) {
    const Vec3& on = block.corners[static_cast<std::size_t>(block.faces[f][0])];
    const Vec3& normal = normals[static_cast<std::size_t>(f)];
    if (const double towards = normal.dot(way); towards > 0)
      least = std::min(least, normal.dot(on - centroid) / towards);
  }
  return least;
}

/// A block rotates about its centroid.
template <int D>
void check_block(const FrameJointOf<D>& joint, const std::string& what) {
  const Vec<D> centroid = checked_centroid(joint.block, what);
  if ((centroid - joint.place).norm() > 1e-9 * size_of(corners_of(joint.block)))
    throw InputError(
        fmt::format("{}: 'at' is not the centroid of its block, {}; leave it out, and give the ends of members by "
                    "from_at and to_at",
                    what, text_of(centroid)));
  if (joint.density) require_positive(*joint.density, what + ": density", "kg/m3");
  if (joint.thickness) require_positive(*joint.thickness, what + ": thickness", "m");
}

template <int D>
void check_joint(const FrameSpecOf<D>& spec, const FrameJointOf<D>& joint, const std::string& owner) {
  const std::string what = fmt::format("{}: joint '{}'", owner, joint.name);
  for (const double v : joint.place) require_finite(v, what);
  require_not_negative(joint.mass, what + ": mass", "kg");
  require_not_negative(joint.inertia, what + ": inertia", "kg m2");
  if (joint.has_block()) check_block(joint, what);
  const auto same = std::count_if(spec.joints.begin(), spec.joints.end(),
                                  [&](const FrameJointOf<D>& j) { return j.name == joint.name; });
  if (same > 1) throw InputError(what + " is given twice; give each its own name");
}

constexpr const char* no_section =
    " has a section without area, inertia or depth; give section = trilith.rectangle_section{width =, depth =} or "
    "another one";

void check_section(const FrameMember& m, const Vec2& /*along*/, const std::string& what) {
  const Section& s = m.section;
  for (const double v : {s.area, s.second_moment, s.shear_area, s.depth()})
    if (!(v > 0 && std::isfinite(v))) throw InputError(what + no_section);
}

/// A section given by numbers may lack data that only members in space need.
void check_section(const SpaceMember& m, const Vec3& along, const std::string& what) {
  const Section3& s = m.section;
  if (!(s.area > 0) || !(s.second_moment[1] > 0)) throw InputError(what + no_section);
  if (!(s.torsion > 0))
    throw InputError(what +
                     " has a section without a torsion constant, which is needed in space; give it torsion = [m4]");
  if (!(s.second_moment[0] > 0))
    throw InputError(what + " has a section without a second moment across; give it inertia_across = [m4]");
  if (s.profile.empty()) throw InputError(what + " has a section without a profile; give it width = [m]");
  if (!m.orientation) return;
  const Vec3& top = *m.orientation;
  if (!top.allFinite() || !(top.norm() > 0) || cross(top, along).norm() <= 1e-6 * top.norm() * along.norm())
    throw InputError(
        fmt::format("{}: its orientation {} is parallel to it or zero; give the direction of the top of its section",
                    what, text_of(top)));
}

template <int D>
void check_member(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& m, double size, const std::string& owner) {
  const std::string what = fmt::format("{}: member '{}'", owner, name_of(spec, m));
  if (m.from == m.to) throw InputError(what + " begins and ends at the same joint; name two");
  for (const int side : {0, 1})
    for (const double v : end_of(spec, m, side)) require_finite(v, what + ": end");
  const double length = length_of(spec, m);
  if (!(length > 1e-6 * size))
    throw InputError(fmt::format("{} is {:g} m long; its ends must lie apart", what, length));
  check_section(m, end_of(spec, m, 1) - end_of(spec, m, 0), what);
  if (m.divisions < 1 || m.divisions > 1000)
    throw InputError(fmt::format("{}: {} divisions, must be 1 to 1000", what, m.divisions));
  if (m.pinned[0] && m.pinned[1] && m.divisions < 2)
    throw InputError(
        what + " is pinned at both ends; give it at least two divisions, so that a middle node carries its rotation");
}

template <int D>
bool has_joints(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& m) {
  const auto joints = static_cast<int>(spec.joints.size());
  return m.from >= 0 && m.from < joints && m.to >= 0 && m.to < joints;
}

template <int D>
void check_members(const FrameSpecOf<D>& spec, const std::string& owner) {
  for (const FrameMemberOf<D>& m : spec.members)
    if (!has_joints(spec, m)) throw InputError(fmt::format("{}: a member ends at a joint that does not exist", owner));
  const double size = size_of(spec);
  std::set<std::string> names;
  for (const FrameMemberOf<D>& m : spec.members) {
    check_member(spec, m, size, owner);
    const std::string name = name_of(spec, m);
    if (!names.insert(name).second)
      throw InputError(fmt::format("{}: there are two members '{}'; give each its own name", owner, name));
  }
}

/// Every joint must be connected to the first one by members.
template <int D>
void check_connected(const FrameSpecOf<D>& spec, const std::string& owner) {
  std::vector<int> group(spec.joints.size());
  std::iota(group.begin(), group.end(), 0);
  // The lowest number propagates along members; after as many passes as joints it has reached all connected ones.
  for (std::size_t pass = 0; pass < spec.joints.size(); ++pass)
    for (const FrameMemberOf<D>& m : spec.members) group[m.from] = group[m.to] = std::min(group[m.from], group[m.to]);
  for (std::size_t j = 0; j < group.size(); ++j)
    if (group[j] != 0)
      throw InputError(
          fmt::format("{}: no member leads from joint '{}' to joint '{}'; make them two bodies, or add one", owner,
                      spec.joints[0].name, spec.joints[j].name));
}

/// The node after `i` beams of a member [m]. In space it lies exactly on the axis of the member's skin.
Vec2 inner_node(const FrameSpec& spec, const FrameMember& m, int i) {
  const Vec2 from = end_of(spec, m, 0), to = end_of(spec, m, 1);
  return from + static_cast<double>(i) / m.divisions * (to - from);
}
Vec3 inner_node(const SpaceFrameSpec& spec, const SpaceMember& m, int i) {
  const Vec3 beam = length_of(spec, m) / m.divisions * turn_of(member_axes(spec, m)).x();
  return end_of(spec, m, 0) + i * beam;
}

/// A member's nodes between its joints: the joints' own nodes at the ends, new ones between. A pinned end's section
/// rotates with the next node, because the joint's rotation is not the member's.
template <int D>
void add_stations(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& m, FramePlanOf<D>& plan) {
  const auto arm = [&](int side, int joint) { return Vec<D>(end_of(spec, m, side) - spec.joints[joint].place); };
  std::vector<StationOf<D>> stations{{m.from, arm(0, m.from), m.from}};
  for (int i = 1; i < m.divisions; ++i) {
    const auto node = static_cast<int>(plan.node.size());
    plan.node.push_back(inner_node(spec, m, i));
    stations.push_back({node, Vec<D>::Zero(), node});
  }
  stations.push_back({m.to, arm(1, m.to), m.to});
  if (m.pinned[0]) stations.front().turn = stations[1].node;
  if (m.pinned[1]) stations.back().turn = stations[stations.size() - 2].node;
  plan.stations.push_back(std::move(stations));
}

}  // namespace

template <int D>
std::string name_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& member) {
  if (!member.name.empty()) return member.name;
  return fmt::format("{}-{}", spec.joints[member.from].name, spec.joints[member.to].name);
}

template <int D>
Vec<D> end_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& m, int side) {
  return m.ends[side].value_or(spec.joints[side == 0 ? m.from : m.to].place);
}

template <int D>
double length_of(const FrameSpecOf<D>& spec, const FrameMemberOf<D>& m) {
  return (end_of(spec, m, 1) - end_of(spec, m, 0)).norm();
}

template <int D>
FramePlanOf<D> plan_frame(const FrameSpecOf<D>& spec, const std::string& owner) {
  if (spec.members.empty())
    throw InputError(owner +
                     ": a frame without members; give members = { { from = \"A\", to = \"B\", section = ... } }");
  for (const FrameJointOf<D>& joint : spec.joints) check_joint(spec, joint, owner);
  check_members(spec, owner);
  check_connected(spec, owner);
  FramePlanOf<D> plan;
  std::vector<int> meet(spec.joints.size());
  for (const FrameJointOf<D>& joint : spec.joints) plan.node.push_back(joint.place);
  for (const FrameMemberOf<D>& m : spec.members) add_stations(spec, m, plan), ++meet[m.from], ++meet[m.to];
  const auto is_tip = [&](int joint) { return meet[joint] == 1 && !spec.joints[joint].has_block(); };
  for (const FrameMemberOf<D>& m : spec.members) plan.is_tip.push_back({is_tip(m.from), is_tip(m.to)});
  return plan;
}

template <int D>
void begin_at_blocks(FrameSpecOf<D>& spec) {
  for (FrameMemberOf<D>& m : spec.members) {
    if (!has_joints(spec, m)) continue;
    const std::array joint{m.from, m.to};
    const std::array wanted{end_of(spec, m, 0), end_of(spec, m, 1)};
    for (const int side : {0, 1}) {
      const FrameJointOf<D>& at = spec.joints[joint[side]];
      if (m.ends[side] || !at.has_block()) continue;
      const Vec<D>& to = wanted[1 - side];
      m.ends[side] = at.place + share_within(at.block, at.place, to) * (to - at.place);
    }
  }
}

UnitQuaternion member_axes(const SpaceFrameSpec& spec, const SpaceMember& m) {
  const Vec3 x = Vec3(end_of(spec, m, 1) - end_of(spec, m, 0)).normalized();
  const bool upright = std::abs(x.z()) > 1 - 1e-6;
  const Vec3 top = m.orientation.value_or(upright ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ()));
  const Vec3 z = cross(x, top).normalized();
  Eigen::Matrix3d axes;
  axes << x, cross(z, x), z;
  return rotation_of(axes);
}

template FramePlanOf<2> plan_frame(const FrameSpecOf<2>& spec, const std::string& owner);
template FramePlanOf<3> plan_frame(const FrameSpecOf<3>& spec, const std::string& owner);
template void begin_at_blocks(FrameSpecOf<2>& spec);
template void begin_at_blocks(FrameSpecOf<3>& spec);
template std::string name_of(const FrameSpecOf<2>& spec, const FrameMemberOf<2>& member);
template std::string name_of(const FrameSpecOf<3>& spec, const FrameMemberOf<3>& member);
template Vec<2> end_of(const FrameSpecOf<2>& spec, const FrameMemberOf<2>& member, int side);
template Vec<3> end_of(const FrameSpecOf<3>& spec, const FrameMemberOf<3>& member, int side);
template double length_of(const FrameSpecOf<2>& spec, const FrameMemberOf<2>& member);
template double length_of(const FrameSpecOf<3>& spec, const FrameMemberOf<3>& member);

}  // namespace trilith
