// Bodies of a model in space that may crack, and their parts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "model/builder/crack_mesh.hpp"
#include "model/builder/crack_rules.hpp"
#include "model/builder/extend.hpp"
#include "model/space_builder/crack_sections_space.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {
namespace {

std::vector<CrackPlane<3>> planes_of(const SolidSpec& spec) {
  return spec.mesh ? crack_planes(spec.cracks, *spec.mesh) : crack_planes(spec.cracks, spec.pieces.front());
}

/// A part with all that it takes from its body: the planes that cut it, except plane `number`. `cuts(plane)`: true if
/// it divides the part.
template <class Cuts>
SolidSpec solid_part_spec(const SolidSpec& whole, int number, Cuts&& cuts) {
  SolidSpec part = whole;
  part.groups.push_back(pieces_group(whole.name));
  part.density.reset();
  part.floating = true;
  part.velocity = part.spin = part.load = Vec3::Zero();
  part.first_part = -1;
  part.cracks = {};
  part.cracks.law = whole.cracks.law, part.cracks.where_met = true;
  const std::vector<CrackPlane<3>> planes = planes_of(whole);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (number_of(whole.cracks, i) == number || !cuts(planes[i])) continue;
    part.cracks.planes.push_back(planes[i]), part.cracks.numbers.push_back(number_of(whole.cracks, i));
  }
  return part;
}

/// The specifications of both parts without their names, behind the plane first.
std::array<SolidSpec, 2> rigid_parts(const SolidSpec& whole, double mass, const CrackSection<3>& section,
                                     const std::array<Polyhedron, 2>& solids) {
  std::array<SolidSpec, 2> parts;
  for (const std::size_t side : {0, 1}) {
    parts[side] = solid_part_spec(whole, section.number,
                                  [&](const CrackPlane<3>& of) { return parts_of(solids[side], of).has_value(); });
    parts[side].pieces = {solids[side]};
    parts[side].mass = side == 0 ? section.mass : mass - section.mass;
  }
  return parts;
}

/// Elements keep their density, and so the nodes of both parts the mass of the nodes of the body.
std::array<SolidSpec, 2> mesh_parts(const SolidSpec& whole, double density, const CrackSection<3>& section) {
  std::array<SolidSpec, 2> parts;
  for (const std::size_t side : {0, 1}) {
    const SpaceMesh mesh = part_of_mesh(*whole.mesh, *section.cut, side == 0).mesh;
    parts[side] = solid_part_spec(whole, section.number,
                                  [&](const CrackPlane<3>& of) { return mesh_plane_fault(mesh, of, 0).empty(); });
    CheckedSpaceMesh checked = check_space_mesh(mesh, "");
    parts[side].pieces = skin_of(checked);
    parts[side].mesh = std::move(checked.mesh);
    parts[side].mass.reset(), parts[side].density = density;
  }
  return parts;
}

/// The reason why a plane does not divide a body; "" if it does.
std::string plane_fault(const SolidSpec& spec, const CrackPlane<3>& plane, int number) {
  if (!spec.mesh)
    return parts_of(spec.pieces.front(), plane) ? "" : missed_plane_text(spec.pieces.front(), plane, number);
  const std::string fault = mesh_plane_fault(*spec.mesh, plane, number);
  return fault.empty() ? "" : "cracks: " + fault;
}

void check_planes(const SolidSpec& spec, const std::string& owner) {
  int number = 0;
  for (const CrackPlane<3>& plane : planes_of(spec)) {
    ++number;
    if (!(plane.normal.norm() > 0)) refuse_cracks(owner, fmt::format("the normal of plane {} has no length", number));
    if (spec.cracks.where_met) continue;
    if (const std::string fault = plane_fault(spec, plane, number); !fault.empty())
      throw InputError(owner + ": " + fault);
  }
}

/// A mesh may be held at some of its nodes, but not at all of them.
void check_mesh_cracks(const SolidSpec& spec, const std::string& owner) {
  if (std::any_of(spec.support.begin(), spec.support.begin() + 3, [](Support s) { return s != Support::free; }))
    refuse_cracks(
        owner,
        "all nodes of the body are held along an axis, so that no crack can open; hold some of them with hold "
        "= { { from = ..., to = ... } }, or give cracks = false");
  check_crack_support({}, spec.cracks.law, owner);
  check_planes(spec, owner);
}

}  // namespace

/// All that does not depend on laws, which may be added later.
void SolidModelBuilder::check_cracks(const SolidSpec& spec, const std::string& owner) {
  if (spec.cracks.empty()) return;
  if (spec.frame)
    refuse_cracks(owner,
                  "planes are for rigid bodies and bodies of elements, this one is a frame; give cracks = false, or "
                  "hinges that yield");
  if (spec.mesh) return check_mesh_cracks(spec, owner);
  if (!spec.spheres.empty())
    refuse_cracks(owner, "a body with spheres has no planes; give it the shape of a convex solid");
  if (spec.pieces.size() != 1)
    refuse_cracks(owner, fmt::format("the body has {} pieces, and planes are for bodies of one convex piece; make its "
                                     "pieces bodies, or give cracks = false",
                                     spec.pieces.size()));
  if (spec.moments) refuse_cracks(owner, "a rigid body of curved elements has no planes; give it a convex hull");
  if (spec.inertia)
    refuse_cracks(owner, "inertia is given, but the parts take theirs from their shapes; leave inertia out");
  check_crack_support(spec.support, spec.cracks.law, owner);
  check_planes(spec, owner);
}

/// Laws may be added after bodies, so their strengths are checked when the model is built.
void SolidModelBuilder::check_crack_laws(std::vector<std::string>& faults) const {
  for (const SolidSpec& spec : bodies_) {
    if (spec.cracks.empty()) continue;
    const std::string why = crack_law_fault(rules_, spec.cracks.law);
    if (why.empty()) continue;
    faults.push_back(fmt::format("body '{}': crack_law: {}", spec.name, why));
    return;
  }
}

std::vector<CrackingBody<3>> SolidModelBuilder::cracking(const Model<3>& model) const {
  std::vector<CrackingBody<3>> rows;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const SolidSpec& spec = bodies_[b];
    if (spec.cracks.empty()) continue;
    CrackingBody<3> row;
    row.body = static_cast<int>(b), row.law = rules_.law_row(spec.cracks.law);
    const auto n = static_cast<std::size_t>(model.bodies[b].first_node);
    const std::vector<CrackPlane<3>> planes = planes_of(spec);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const int number = number_of(spec.cracks, i);
      if (spec.mesh) {
        if (mesh_plane_fault(*spec.mesh, planes[i], number).empty())
          row.sections.push_back(mesh_section(*spec.mesh, planes[i], number));
      } else if (auto section =
                     crack_section(spec.pieces.front(), model.mass[n], model.start_rotation[n], planes[i], number)) {
        row.sections.push_back(std::move(*section));
      }
    }
    if (!row.sections.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

/// Rigid parts divide the mass by volume, so that the sum of both is the mass of the body. The remaining planes go to
/// the parts that they cut.
void SolidModelBuilder::crack(const Model<3>& model, int body, const CrackSection<3>& section) {
  const auto at = static_cast<std::size_t>(body);
  const SolidSpec whole = bodies_[at];
  const auto n = static_cast<std::size_t>(model.bodies[at].first_node);
  CrackPlane<3> plane{section.centre, section.normal};
  std::array<SolidSpec, 2> parts;
  if (section.cut) {
    parts = mesh_parts(whole, density_of(whole), section);
  } else {
    const Turn3 turn(model.start_rotation[n]);
    plane = {model.start_position[n] + turn.apply(section.centre), turn.apply(section.normal)};
    const auto solids = parts_of(whole.pieces.front(), plane);
    if (!solids) return;
    parts = rigid_parts(whole, model.mass[n], section, *solids);
  }
  rules_.inherit(whole.name, pieces_group(whole.name));
  rules_.set_contact(pieces_group(whole.name), pieces_group(whole.name), whole.cracks.law);
  bodies_[at].first_part = static_cast<int>(bodies_.size()), bodies_[at].parted_at = plane;
  for (const std::size_t side : {0, 1}) {
    parts[side].name = new_part_name(body_names_known_, bodies_, whole.name + (side == 0 ? ".a" : ".b"));
    parts[side].cracked_from = body;
    bodies_.push_back(std::move(parts[side]));
  }
}

Model<3> SolidModelBuilder::with_parts(const Model<3>& model) const {
  std::vector<std::string> faults;
  Model<3> grown = assemble_bodies(faults);
  if (!faults.empty()) throw InputError(faults.front());
  carry_conditions(model, grown);
  return grown;
}

}  // namespace trilith
