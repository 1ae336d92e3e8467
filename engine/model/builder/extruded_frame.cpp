#include "model/builder/extruded_frame.hpp"

namespace trilith {
namespace {

Vec3 upright(const Vec2& p, double y = 0) {
  return {p.x(), y, p.y()};
}

/// A plane block, with its given thickness or its body's.
Polyhedron extruded_block(const FrameJoint& flat, double thickness) {
  const double depth = flat.thickness.value_or(thickness);
  std::vector<Vec3> near_side;
  for (const Vec2& p : flat.block) near_side.push_back(upright(p, -depth / 2));
  return extrusion(near_side, Vec3(0, depth, 0));
}

SpaceJoint extruded_joint(const FrameJoint& flat, const FrameExtrusion& extrusion) {
  SpaceJoint joint;
  joint.name = flat.name, joint.mass = flat.mass, joint.inertia = flat.inertia;
  joint.place = upright(flat.place);
  if (flat.has_block()) joint.block = extruded_block(flat, extrusion.thickness), joint.density = flat.density;
  const auto& s = flat.support;
  const auto also = [&](bool fixed) { return fixed || extrusion.held ? Support::fixed : Support::free; };
  const bool stays = s[0] == Support::fixed && s[1] == Support::fixed, straight = s[2] == Support::fixed;
  joint.support = {s[0], also(stays), s[1], also(straight), s[2], also(straight)};
  return joint;
}

/// The profile is the depth of the section times the thickness of the body, whatever the shape, as for contact in the
/// plane.
Section3 extruded_section(const FrameMember& flat, const FrameExtrusion& extrusion) {
  constexpr double shear_coefficient = 5.0 / 6;
  const Section& plane = flat.section;
  Section3 s = flat.in_space.value_or(Section3{});
  s.area = plane.area, s.second_moment[1] = plane.second_moment, s.shear_area[1] = plane.shear_area;
  if (!(s.shear_area[0] > 0)) s.shear_area[0] = shear_coefficient * plane.area;
  if (extrusion.held && !(s.second_moment[0] > 0)) s.second_moment[0] = plane.second_moment;
  if (extrusion.held && !(s.torsion > 0)) s.torsion = plane.second_moment;
  const double half = extrusion.thickness / 2;
  s.profile = {{{-half, -plane.below}, {half, -plane.below}, {half, plane.above}, {-half, plane.above}}};
  return s;
}

MemberFibres extruded_fibres(MemberFibres fibres, bool held) {
  std::array<int, 2>& cells = fibres.spec.cells;
  if (cells[0] == 0) cells[0] = fibres.spec.layers;
  if (held && cells[1] == 0) cells[1] = 1;
  return fibres;
}

MemberHinges extruded_hinges(MemberHinges hinges, bool held) {
  for (auto& hinge : hinges.end)
    if (hinge && held && !(hinge->across > 0)) hinge->across = hinge->sagging;
  return hinges;
}

SpaceMember extruded_member(const FrameSpec& spec, const FrameMember& flat, const FrameExtrusion& extrusion) {
  SpaceMember member;
  member.name = flat.name, member.from = flat.from, member.to = flat.to;
  member.section = extruded_section(flat, extrusion);
  const Vec2 along = end_of(spec, flat, 1) - end_of(spec, flat, 0);
  for (const std::size_t side : {0, 1})
    if (flat.ends[side]) member.ends[side] = upright(*flat.ends[side]);
  member.orientation = Vec3(-along.y(), 0, along.x());  // its top is to the left of its direction
  member.material = flat.material, member.divisions = flat.divisions;
  member.pinned = flat.pinned, member.shear = flat.shear;
  if (const auto* const fibres = std::get_if<MemberFibres>(&flat.yields))
    member.yields = extruded_fibres(*fibres, extrusion.held);
  if (const auto* const hinges = std::get_if<MemberHinges>(&flat.yields))
    member.yields = extruded_hinges(*hinges, extrusion.held);
  return member;
}

}  // namespace

SpaceFrameSpec extruded_frame(const FrameSpec& flat, const FrameExtrusion& extrusion) {
  SpaceFrameSpec out;
  out.consistent = flat.consistent;
  for (const FrameJoint& joint : flat.joints) out.joints.push_back(extruded_joint(joint, extrusion));
  for (const FrameMember& member : flat.members) out.members.push_back(extruded_member(flat, member, extrusion));
  return out;
}

}  // namespace trilith
