#include "model/space_builder/space_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "model/check/check.hpp"

namespace trilith {
namespace {

Vec3 along_of(const SpaceFrameSpec& spec, const SpaceMember& m) {
  return end_of(spec, m, 1) - end_of(spec, m, 0);
}

/// A block rotates about its centroid.
void check_block(const SpaceJoint& joint, const std::string& what) {
  check_convex(joint.block, what + ": its block");
  const Vec3 centroid = solid_moments(joint.block).centroid;
  if ((centroid - joint.place).norm() > 1e-9 * solid_size(joint.block.corners))
    throw InputError(
        fmt::format("{}: 'at' is not the centroid of its block, ({:g}, {:g}, {:g}); leave it out, and give the ends of "
                    "members by from_at and to_at",
                    what, centroid.x(), centroid.y(), centroid.z()));
  if (joint.density) require_positive(*joint.density, what + ": density", "kg/m3");
}

/// Intersection of the line from the block's centroid to `to` with its surface.
Vec3 way_out(const SpaceJoint& joint, const Vec3& to) {
  const Vec3 way = to - joint.place;
  double least = 1;
  const std::vector<Vec3> normals = face_normals(joint.block);
  for (int f = 0; f < joint.block.faces.count(); ++f) {
    const Vec3& on = joint.block.corners[static_cast<std::size_t>(joint.block.faces[f][0])];
    const Vec3& normal = normals[static_cast<std::size_t>(f)];
    if (const double towards = normal.dot(way); towards > 0)
      least = std::min(least, normal.dot(on - joint.place) / towards);
  }
  return joint.place + least * way;
}

void check_joint(const SpaceFrameSpec& spec, const SpaceJoint& joint, const std::string& owner) {
  const std::string what = fmt::format("{}: joint '{}'", owner, joint.name);
  if (!joint.place.allFinite()) throw InputError(what + ": its place is not finite");
  if (joint.has_block()) check_block(joint, what);
  require_not_negative(joint.mass, what + ": mass", "kg");
  require_not_negative(joint.inertia, what + ": inertia", "kg m2");
  const auto same =
      std::count_if(spec.joints.begin(), spec.joints.end(), [&](const SpaceJoint& j) { return j.name == joint.name; });
  if (same > 1) throw InputError(what + " is given twice; give each its own name");
}

/// Data that the plane does not need, and that may be missing in a section given by numbers.
void check_section(const Section3& s, const std::string& what) {
  if (!(s.area > 0) || !(s.second_moment[1] > 0))
    throw InputError(what +
                     " has a section without area or inertia; give section = trilith.rectangle_section{width =, depth "
                     "=} or another one");
  if (!(s.torsion > 0))
    throw InputError(what +
                     " has a section without a torsion constant, which is needed in space; give it torsion = [m4]");
  if (!(s.second_moment[0] > 0))
    throw InputError(what + " has a section without a second moment across; give it inertia_across = [m4]");
  if (s.profile.empty()) throw InputError(what + " has a section without a profile; give it width = [m]");
}

void check_member(const SpaceFrameSpec& spec, const SpaceMember& m, double size, const std::string& owner) {
  const auto joints = static_cast<int>(spec.joints.size());
  if (m.from < 0 || m.from >= joints || m.to < 0 || m.to >= joints)
    throw InputError(fmt::format("{}: a member ends at a joint that does not exist", owner));
  const std::string what = fmt::format("{}: member '{}'", owner, name_of(spec, m));
  if (m.from == m.to) throw InputError(what + " begins and ends at the same joint; name two");
  for (const std::size_t side : {0, 1})
    if (!end_of(spec, m, side).allFinite()) throw InputError(what + ": where it begins or ends is not finite");
  const double length = length_of(spec, m);
  if (!(length > 1e-6 * size))
    throw InputError(fmt::format("{} is {:g} m long; its ends must lie apart", what, length));
  check_section(m.section, what);
  if (m.divisions < 1 || m.divisions > 1000)
    throw InputError(fmt::format("{}: {} divisions, must be 1 to 1000", what, m.divisions));
  if (m.pinned[0] && m.pinned[1] && m.divisions < 2)
    throw InputError(
        what + " is pinned at both ends; give it at least two divisions, so that a middle node carries its rotation");
  if (!m.orientation) return;
  const Vec3 along = along_of(spec, m), &top = *m.orientation;
  if (!top.allFinite() || !(top.norm() > 0) || cross(top, along).norm() <= 1e-6 * top.norm() * along.norm())
    throw InputError(
        fmt::format("{}: its orientation ({:g}, {:g}, {:g}) is parallel to it or zero; give the direction of the top "
                    "of its section",
                    what, top.x(), top.y(), top.z()));
}

/// Every joint must be connected to the first one by members.
void check_connected(const SpaceFrameSpec& spec, const std::string& owner) {
  std::vector<int> group(spec.joints.size());
  std::iota(group.begin(), group.end(), 0);
  // The lowest number propagates along members; after as many passes as joints it has reached all connected ones.
  for (std::size_t pass = 0; pass < spec.joints.size(); ++pass)
    for (const SpaceMember& m : spec.members) {
      int &from = group[static_cast<std::size_t>(m.from)], &to = group[static_cast<std::size_t>(m.to)];
      from = to = std::min(from, to);
    }
  for (std::size_t j = 0; j < group.size(); ++j)
    if (group[j] != 0)
      throw InputError(
          fmt::format("{}: no member leads from joint '{}' to joint '{}'; make them two bodies, or add one", owner,
                      spec.joints[0].name, spec.joints[j].name));
}

bool is_tip(const SpaceFrameSpec& spec, std::size_t member, int joint) {
  if (spec.joints[static_cast<std::size_t>(joint)].has_block()) return false;
  for (std::size_t m = 0; m < spec.members.size(); ++m)
    if (m != member && (spec.members[m].from == joint || spec.members[m].to == joint)) return false;
  return true;
}

}  // namespace

std::string name_of(const SpaceFrameSpec& spec, const SpaceMember& m) {
  if (!m.name.empty()) return m.name;
  return fmt::format("{}-{}", spec.joints[static_cast<std::size_t>(m.from)].name,
                     spec.joints[static_cast<std::size_t>(m.to)].name);
}

Vec3 end_of(const SpaceFrameSpec& spec, const SpaceMember& m, std::size_t side) {
  return m.ends[side].value_or(spec.joints[static_cast<std::size_t>(side == 0 ? m.from : m.to)].place);
}

void begin_at_blocks(SpaceFrameSpec& spec) {
  const auto joints = static_cast<int>(spec.joints.size());
  for (SpaceMember& m : spec.members) {
    if (m.from < 0 || m.from >= joints || m.to < 0 || m.to >= joints) continue;
    const std::array joint{m.from, m.to};
    const std::array wanted{end_of(spec, m, 0), end_of(spec, m, 1)};
    for (const std::size_t side : {0, 1})
      if (const SpaceJoint& at = spec.joints[static_cast<std::size_t>(joint[side])]; !m.ends[side] && at.has_block())
        m.ends[side] = way_out(at, wanted[1 - side]);
  }
}

double length_of(const SpaceFrameSpec& spec, const SpaceMember& m) {
  return along_of(spec, m).norm();
}

void check_space_frame(const SpaceFrameSpec& spec, const std::string& owner) {
  if (spec.members.empty())
    throw InputError(owner + " has no member; give members = { { from = \"A\", to = \"B\", section = ... } }");
  for (const SpaceJoint& joint : spec.joints) check_joint(spec, joint, owner);
  std::vector<Vec3> places;
  for (const SpaceJoint& joint : spec.joints) places.push_back(joint.place);
  for (const SpaceMember& m : spec.members)
    for (const std::size_t side : {0, 1})
      if (m.ends[side]) places.push_back(*m.ends[side]);
  const double size = solid_size(places);
  for (std::size_t m = 0; m < spec.members.size(); ++m) {
    check_member(spec, spec.members[m], size, owner);
    for (std::size_t other = 0; other < m; ++other)
      if (name_of(spec, spec.members[other]) == name_of(spec, spec.members[m]))
        throw InputError(fmt::format("{}: there are two members '{}'; give each its own name", owner,
                                     name_of(spec, spec.members[m])));
  }
  check_connected(spec, owner);
}

UnitQuaternion member_axes(const SpaceFrameSpec& spec, const SpaceMember& m) {
  const Vec3 x = along_of(spec, m).normalized();
  const bool upright = std::abs(x.z()) > 1 - 1e-6;
  const Vec3 top = m.orientation.value_or(upright ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitZ()));
  const Vec3 z = cross(x, top).normalized();
  Eigen::Matrix3d axes;
  axes << x, cross(z, x), z;
  return rotation_of(axes);
}

int node_within(const SpaceFrameSpec& spec, std::size_t member, int i) {
  const SpaceMember& m = spec.members[member];
  if (i == 0) return m.from;
  if (i == m.divisions) return m.to;
  auto node = static_cast<int>(spec.joints.size()) + i - 1;
  for (std::size_t before = 0; before < member; ++before) node += spec.members[before].divisions - 1;
  return node;
}

std::vector<Vec3> node_places(const SpaceFrameSpec& spec) {
  std::vector<Vec3> places;
  for (const SpaceJoint& joint : spec.joints) places.push_back(joint.place);
  for (const SpaceMember& m : spec.members) {
    const Vec3 start = end_of(spec, m, 0);
    const Vec3 beam = length_of(spec, m) / m.divisions * turn_of(member_axes(spec, m)).x();
    for (int i = 1; i < m.divisions; ++i) places.emplace_back(start + i * beam);
  }
  return places;
}

/// From the middle of one beam to the middle of the next. The skin next to a pinned joint moves with the next node,
/// because the joint's rotation is not the member's.
std::vector<SkinStretch> skin_stretches(const SpaceFrameSpec& spec, std::size_t member) {
  const SpaceMember& m = spec.members[member];
  const double beam = length_of(spec, m) / m.divisions;
  std::vector<SkinStretch> out;
  for (int i = 0; i <= m.divisions; ++i)
    out.push_back({node_within(spec, member, i), std::max(i - 0.5, 0.0) * beam,
                   std::min(i + 0.5, static_cast<double>(m.divisions)) * beam, false, false});
  if (m.pinned[0]) out[1].from = 0, out.erase(out.begin());
  if (m.pinned[1]) out[out.size() - 2].to = out.back().to, out.pop_back();
  out.front().begins = is_tip(spec, member, m.from), out.back().ends = is_tip(spec, member, m.to);
  return out;
}

std::vector<Polyhedron> skin_solids(const SpaceFrameSpec& spec, std::size_t member, const SkinStretch& stretch) {
  const SpaceMember& m = spec.members[member];
  const Turn3 axes = turn_of(member_axes(spec, m));
  const Vec3 start = end_of(spec, m, 0) + stretch.from * axes.x();
  std::vector<Polyhedron> out;
  for (const std::vector<Vec2>& part : m.section.profile) {
    std::vector<Vec3> polygon;
    for (const Vec2& p : part) polygon.emplace_back(start + p.x() * axes.z() + p.y() * axes.y());
    out.push_back(extrusion(polygon, Vec3((stretch.to - stretch.from) * axes.x())));
  }
  return out;
}

}  // namespace trilith
