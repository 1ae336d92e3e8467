#include "bindings/model/extruded_model.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "build/space/solid_part.hpp"
#include "law/bearing/mirrored.hpp"
#include "model/builder/crack_sections.hpp"
#include "model/builder/extruded_frame.hpp"

namespace trilith::script {
namespace {

/// A point or a direction of the plane, at depth `y`.
Vec3 in_space(const Vec2& p, double y = 0) {
  return {p.x(), y, p.y()};
}

bool strains_in_plane(const BodySpec& flat, const std::vector<Material>& materials) {
  for (const Material& m : materials)
    if (m.name == flat.material) return m.solid && m.solid->plane == Plane::strain;
  return false;
}

/// Boxes that fix nodes extend over the whole depth.
void hold_nodes(const BodySpec& flat, SolidSpec& spec) {
  for (const NodeSupport& hold : flat.supports)
    spec.supports.push_back({in_space(hold.low, -unbounded),
                             in_space(hold.high, unbounded),
                             {hold.support[0], Support::free, hold.support[1]}});
}

/// With `held`, elements in plane stress keep their far side in its plane, and so do not rotate out of it; their near
/// side may move as they grow thicker.
void hold_elements(const BodySpec& flat, bool strain, double half, bool held, SolidSpec& spec) {
  const auto& s = flat.support;
  spec.support = {s[0], held && strain ? Support::fixed : Support::free, s[1], s[2], s[2], s[2]};
  if (held && !strain) {
    const Vec3 reach = Vec3(unbounded, 0, unbounded);
    spec.supports.push_back(
        {Vec3(0, half, 0) - reach, Vec3(0, half, 0) + reach, {Support::free, Support::fixed, Support::free}});
  }
  hold_nodes(flat, spec);
}

void hold_rigid(const BodySpec& flat, bool held, SolidSpec& spec) {
  const auto& s = flat.support;
  const bool fixed = s[0] == Support::fixed && s[1] == Support::fixed && s[2] == Support::fixed;
  const Support across = held || fixed ? Support::fixed : Support::free;
  spec.support = {s[0], across, s[1], across, s[2], across};
}

void hold_frame(const BodySpec& flat, bool held, SolidSpec& spec) {
  hold_rigid(flat, held, spec);
  hold_nodes(flat, spec);
}

/// The planes of a body in the plane stand upright in space. Held bodies do not crack.
void take_planes(const BodySpec& flat, bool held, SolidSpec& spec) {
  if (flat.cracks.empty()) return;
  if (held)
    throw InputError(
        fmt::format("extruded: body '{}' has crack planes, and a body that is held in its plane does not crack; give "
                    "held = false, or cracks = false in the model in the plane",
                    flat.name));
  for (const CrackPlane<2>& plane : crack_planes(flat.cracks, flat.outline))
    spec.cracks.planes.push_back({in_space(plane.point), in_space(plane.normal)});
  spec.cracks.law = flat.cracks.law, spec.cracks.where_met = flat.cracks.where_met;
}

/// A counter-clockwise rotation in the plane is negative about y, which points away from the viewer.
SolidSpec extruded_body(const BodySpec& flat, const PlaneModel& plane, bool held) {
  const double half = flat.thickness.value_or(plane.builder.thickness) / 2;
  SolidSpec spec;
  spec.name = flat.name, spec.material = flat.material, spec.groups = flat.groups;
  spec.density = flat.density, spec.mass = flat.mass;
  if (flat.weight) spec.mass = *flat.weight / standard_gravity;
  spec.velocity = in_space(flat.velocity), spec.load = in_space(flat.load), spec.spin = {0, -flat.spin, 0};
  spec.floating = flat.floating;
  if (flat.frame) {
    spec.frame = extruded_frame(*flat.frame, {2 * half, held});
    hold_frame(flat, held, spec);
  } else if (flat.mesh) {
    // From the far side to the near one: elements are counter-clockwise seen from the near side.
    SpaceMesh mesh = extruded(*flat.mesh, Vec3::UnitX(), Vec3::UnitZ(), Vec3(0, half, 0), Vec3(0, -half, 0));
    if (flat.kind == BodyKind::rigid) {
      spec.pieces = solids_of(mesh);
      hold_rigid(flat, held, spec);
      return spec;
    }
    spec.mesh = std::move(mesh);
    spec.form.kind = BodyKind::mesh;
    hold_elements(flat, strains_in_plane(flat, plane.materials), half, held, spec);
  } else {
    spec.pieces = prisms_between(flat.outline, OutlinePlane::upright, -half, half);
    hold_rigid(flat, held, spec);
    take_planes(flat, held, spec);
  }
  return spec;
}

/// `along` is rotated from x by the angle of the plane, about the axis that points out of it; rotations have the
/// opposite sign.
BearingSpecOf<3> extruded_bearing(const BearingSpec& flat) {
  BearingSpecOf<3> spec;
  spec.name = flat.name, spec.body_a = flat.body_a, spec.body_b = flat.body_b;
  spec.point_a = in_space(flat.point_a), spec.point_b = in_space(flat.point_b);
  spec.angle = rotation_by({0, -flat.angle, 0});
  constexpr std::array<std::size_t, 3> direction{0, 2, 4};  // along, axial and turning_across of Directions<3>
  for (std::size_t k = 0; k < direction.size(); ++k)
    spec.law[direction[k]] = flat.law[k], spec.limit[direction[k]] = flat.limit[k],
    spec.next_from_here[direction[k]] = flat.next_from_here[k];
  spec.law[direction[turning]] = mirrored(flat.law[turning]);
  spec.replaces_contact = flat.replaces_contact, spec.contact_after = flat.contact_after;
  spec.becomes_bearing = flat.becomes_bearing, spec.starts_waiting = flat.starts_waiting;
  return spec;
}

void take_conditions(const ModelBuilder& flat, SolidModelBuilder& out) {
  out.gravity = in_space(flat.gravity);
  out.mass_damping = flat.mass_damping, out.impact_speed = flat.impact_speed, out.apart_time = flat.apart_time;
  out.still_speed = flat.still_speed, out.still_time = flat.still_time, out.overlap_allowed = flat.overlap_allowed;
  out.bounds.low = in_space(flat.bounds.low, -unbounded), out.bounds.high = in_space(flat.bounds.high, unbounded);
}

}  // namespace

std::shared_ptr<SpaceModel> extruded_model(const PlaneModel& plane, const std::string& name,
                                           const PlaneExtrusion& extrusion) {
  auto space = std::make_shared<SpaceModel>(name);
  const ModelBuilder& flat = plane.builder;
  take_conditions(flat, space->builder);
  for (const Material& m : plane.materials) space->builder.add_material(m);
  space->builder.take_contacts(flat.contact_rules());
  for (const BodySpec& body : flat.bodies()) {
    space->builder.add_body(extruded_body(body, plane, extrusion.held));
    if (body.inertia)
      space->builder.note(
          fmt::format("body '{}': its moment of inertia follows from its solid, not from the value "
                      "given in the plane",
                      body.name));
  }
  for (const BearingSpec& bearing : flat.bearings()) space->builder.add_bearing(extruded_bearing(bearing));
  for (const SeatSpec& seat : flat.seats())
    space->builder.add_seat(
        {seat.name, seat.body, seat.support, in_space(seat.end), in_space(seat.edge), in_space(seat.inward)});
  space->laws = plane.laws, space->materials = plane.materials;
  space->bearings = plane.bearings, space->seats = plane.seats;
  space->threads = plane.threads;
  return space;
}

}  // namespace trilith::script
