#include "extruded_model.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "build/solid_part.hpp"

namespace trilith::script {
namespace {

/// A point or a direction of the plane, at depth `y`.
Vec3 in_space(const Vec2& p, double y = 0) {
  return {p.x(), y, p.y()};
}

/// Nodes of the far side, then of the near one; corners run counter-clockwise as the near side is looked at.
SpaceMesh extruded_mesh(const Mesh& flat, double half, const std::string& owner) {
  SpaceMesh mesh;
  const auto nodes = static_cast<int>(flat.node.size());
  for (const double y : {half, -half})
    for (const Vec2& p : flat.node) mesh.node.push_back(in_space(p, y));
  for (const std::array<int, 4>& element : flat.element) {
    if (corners_of(element) == 3)
      throw InputError(owner +
                       " has triangles, which have no element in space when extruded; mesh it by quadrilaterals");
    SpaceCell& cell = mesh.cell.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) cell.node[i] = element[i], cell.node[i + 4] = element[i] + nodes;
  }
  return mesh;
}

bool strains_in_plane(const BodySpec& flat, const std::vector<Material>& materials) {
  for (const Material& m : materials)
    if (m.name == flat.material) return m.solid && m.solid->plane == Plane::strain;
  return false;
}

/// Held, elements in plane stress keep their far side in its plane, and so do not turn out of it; their near side may
/// come forward as they grow thicker.
void hold_elements(const BodySpec& flat, bool strain, double half, bool held, SolidSpec& spec) {
  const auto& s = flat.support;
  spec.support = {s[0], held && strain ? Support::fixed : Support::free, s[1], s[2], s[2], s[2]};
  if (held && !strain) {
    const Vec3 reach = Vec3(unbounded, 0, unbounded);
    spec.supports.push_back(
        {Vec3(0, half, 0) - reach, Vec3(0, half, 0) + reach, {Support::free, Support::fixed, Support::free}});
  }
  for (const NodeSupport& hold : flat.supports)
    spec.supports.push_back({in_space(hold.low, -unbounded),
                             in_space(hold.high, unbounded),
                             {hold.support[0], Support::free, hold.support[1]}});
}

void hold_rigid(const BodySpec& flat, bool held, SolidSpec& spec) {
  const auto& s = flat.support;
  const bool fixed = s[0] == Support::fixed && s[1] == Support::fixed && s[2] == Support::fixed;
  const Support across = held || fixed ? Support::fixed : Support::free;
  spec.support = {s[0], across, s[1], across, s[2], across};
}

/// Counter-clockwise in the plane is against the turn about y, which points away from who looks at it.
SolidSpec extruded_body(const BodySpec& flat, const PlaneModel& plane, bool held) {
  const std::string owner = fmt::format("extruded: body '{}'", flat.name);
  if (flat.frame)
    throw InputError(owner +
                     " is a frame, whose sections do not say how they bend across and twist; add it to a model in "
                     "space by m:frame");
  const double half = flat.thickness.value_or(plane.builder.thickness) / 2;
  SolidSpec spec;
  spec.name = flat.name, spec.material = flat.material, spec.groups = flat.groups;
  spec.density = flat.density, spec.mass = flat.mass;
  if (flat.weight) spec.mass = *flat.weight / standard_gravity;
  spec.velocity = in_space(flat.velocity), spec.load = in_space(flat.load), spec.spin = {0, -flat.spin, 0};
  spec.floating = flat.floating;
  if (flat.mesh) {
    spec.mesh = extruded_mesh(*flat.mesh, half, owner);
    spec.form.kind = BodyKind::mesh;
    hold_elements(flat, strains_in_plane(flat, plane.materials), half, held, spec);
  } else {
    spec.pieces = prisms_between(flat.outline, OutlinePlane::upright, -half, half);
    hold_rigid(flat, held, spec);
  }
  return spec;
}

/// A fresh link led one way resists as one led the other way.
bool acts_alike_both_ways(const DirectionLaw& law) {
  const auto force = [](const auto& l, double displacement) {
    return l.respond(DirectionMotion{displacement, displacement, 1, 1}, DirectionMemory{}).force();
  };
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.respond(DirectionMotion{}, DirectionMemory{}); })
          for (const double d : {1e-4, 1e-2, 1.0, 1e2})
            if (!(force(l, d) == -force(l, -d))) return false;
        return true;
      },
      law);
}

/// `along` is turned from x by the angle of the plane, about the axis that looks out of it.
BearingSpecOf<3> extruded_bearing(const BearingSpec& flat) {
  if (!acts_alike_both_ways(flat.law[turning]))
    throw InputError(
        fmt::format("extruded: bearing '{}': its law of turning resists one way otherwise than the other, and "
                    "turns count the other way in space; add it to the model in space by m:bearing",
                    flat.name));
  BearingSpecOf<3> spec;
  spec.name = flat.name, spec.body_a = flat.body_a, spec.body_b = flat.body_b;
  spec.point_a = in_space(flat.point_a), spec.point_b = in_space(flat.point_b);
  spec.angle = rotation_by({0, -flat.angle, 0});
  constexpr std::array<std::size_t, 3> direction{0, 2, 4};  // along, axial and turning_across of Directions<3>
  for (std::size_t k = 0; k < direction.size(); ++k)
    spec.law[direction[k]] = flat.law[k], spec.limit[direction[k]] = flat.limit[k],
    spec.next_from_here[direction[k]] = flat.next_from_here[k];
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
          fmt::format("body '{}': its moment of inertia is that of its solid, not the one given in the "
                      "plane",
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
