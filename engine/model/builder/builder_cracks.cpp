// Bodies of a plane model that may crack, and their parts.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "model/builder/builder.hpp"
#include "model/builder/crack_mesh.hpp"
#include "model/builder/crack_sections.hpp"
#include "model/builder/extend.hpp"
#include "model/names.hpp"

namespace trilith {
namespace {

const Polygon& solid_of(const BodySpec& spec) {
  return spec.solid.empty() ? spec.outline : spec.solid;
}

bool is_deformable(const BodySpec& spec) {
  return !spec.frame && info_of(spec.kind).resistance == Resistance::elements;
}

/// A part with all that it takes from its body: the planes that cut it, except plane `number`. `cuts(plane)`: true if
/// it divides the part.
template <class Cuts>
BodySpec part_spec(const BodySpec& whole, int number, Cuts&& cuts) {
  BodySpec part = whole;
  part.groups.push_back(pieces_group(whole.name));
  part.density.reset(), part.weight.reset();
  part.floating = true;
  part.velocity = part.load = Vec2::Zero(), part.spin = 0;
  part.first_part = -1;
  part.cracks = {};
  part.cracks.law = whole.cracks.law, part.cracks.where_met = true;
  const std::vector<CrackPlane<2>> planes = crack_planes(whole.cracks, solid_of(whole));
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (number_of(whole.cracks, i) == number || !cuts(planes[i])) continue;
    part.cracks.planes.push_back(planes[i]), part.cracks.numbers.push_back(number_of(whole.cracks, i));
  }
  return part;
}

/// The reason why a plane does not divide a body; "" if it does.
std::string plane_fault(const BodySpec& spec, const CrackPlane<2>& plane, int number) {
  if (!is_deformable(spec)) return parts_of(spec.outline, plane) ? "" : missed_plane_text(spec.outline, plane, number);
  const std::string fault = mesh_plane_fault(*spec.mesh, plane, number);
  return fault.empty() ? "" : "cracks: " + fault;
}

void check_planes(const BodySpec& spec, const std::string& owner) {
  int number = 0;
  for (const CrackPlane<2>& plane : crack_planes(spec.cracks, spec.outline)) {
    ++number;
    if (!(plane.normal.norm() > 0)) refuse_cracks(owner, fmt::format("the normal of plane {} has no length", number));
    if (spec.cracks.where_met) continue;
    if (const std::string fault = plane_fault(spec, plane, number); !fault.empty())
      throw InputError(owner + ": " + fault);
  }
}

/// A mesh may be held at some of its nodes, but not at all of them.
void check_mesh_cracks(const BodySpec& spec, const std::string& owner) {
  if (spec.support[0] != Support::free || spec.support[1] != Support::free)
    refuse_cracks(
        owner,
        "all nodes of the body are held along an axis, so that no crack can open; hold some of them with hold "
        "= { { from = ..., to = ... } }, or give cracks = false");
  check_crack_support({}, spec.cracks.law, owner);
}

}  // namespace

/// All that does not depend on laws, which may be added later.
void ModelBuilder::check_cracks(const BodySpec& spec, const std::string& owner) {
  if (spec.cracks.empty()) return;
  if (spec.frame)
    refuse_cracks(owner,
                  "planes are for rigid bodies and bodies of elements, this one is a frame; give cracks = false, or "
                  "hinges that yield");
  if (is_deformable(spec)) {
    check_mesh_cracks(spec, owner);
    check_planes(spec, owner);
    return;
  }
  if (spec.mesh)
    refuse_cracks(owner, "a rigid body of a mesh has no planes; give it an outline, or make its pieces bodies");
  if (spec.inertia)
    refuse_cracks(owner, "inertia is given, but the parts take theirs from their shapes; leave inertia out");
  check_crack_support(spec.support, spec.cracks.law, owner);
  check_planes(spec, owner);
}

/// Laws may be added after bodies, so their strengths are checked when the model is built.
void ModelBuilder::check_crack_laws(std::vector<std::string>& faults) const {
  for (const BodySpec& spec : bodies_) {
    if (spec.cracks.empty()) continue;
    const std::string why = crack_law_fault(rules_, spec.cracks.law);
    if (why.empty()) continue;
    faults.push_back(fmt::format("body '{}': crack_law: {}", spec.name, why));
    return;
  }
}

std::vector<CrackingBody<2>> ModelBuilder::cracking(const Model<2>& model) const {
  std::vector<CrackingBody<2>> rows;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodySpec& spec = bodies_[b];
    if (spec.cracks.empty()) continue;
    CrackingBody<2> row;
    row.body = static_cast<int>(b), row.law = rules_.law_row(spec.cracks.law);
    row.depth = spec.thickness.value_or(thickness);
    const double mass = model.mass[static_cast<std::size_t>(model.bodies[b].first_node)];
    const std::vector<CrackPlane<2>> planes = crack_planes(spec.cracks, solid_of(spec));
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const int number = number_of(spec.cracks, i);
      if (!is_deformable(spec)) {
        if (const auto section = crack_section(solid_of(spec), mass, planes[i], number))
          row.sections.push_back(*section);
      } else if (mesh_plane_fault(*spec.mesh, planes[i], number).empty()) {
        row.sections.push_back(mesh_section(*spec.mesh, planes[i], number));
      }
    }
    if (!row.sections.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

/// Mass by area, so that the sum of both is the mass of the body. The remaining planes go to the parts that they cut.
void ModelBuilder::crack(const Model<2>& model, int body, const CrackSection<2>& section, const CrackOpening& opening) {
  const auto at = static_cast<std::size_t>(body);
  const BodySpec whole = bodies_[at];
  const Vec2 centroid = moments_of(whole).centroid;
  const CrackPlane<2> plane{centroid + section.middle(), section.normal};
  const auto solids = parts_of(solid_of(whole), plane);
  const auto skins = parted_outlines(whole.outline, centroid, section, opening);
  if (!solids || !skins) return;
  rules_.inherit(whole.name, pieces_group(whole.name));
  rules_.set_contact(pieces_group(whole.name), pieces_group(whole.name), whole.cracks.law);
  bodies_[at].first_part = static_cast<int>(bodies_.size()), bodies_[at].parted_at = plane;
  const double mass = model.mass[static_cast<std::size_t>(model.bodies[at].first_node)];
  for (const std::size_t side : {0, 1}) {
    BodySpec part = part_spec(whole, section.number,
                              [&](const CrackPlane<2>& of) { return parts_of((*solids)[side], of).has_value(); });
    part.name = new_part_name(body_names_known_, bodies_, whole.name + (side == 0 ? ".a" : ".b"));
    part.outline = (*skins)[side], part.solid = (*solids)[side];
    part.mass = side == 0 ? section.mass : mass - section.mass;
    part.cracked_from = body;
    bodies_.push_back(std::move(part));
  }
}

namespace {

/// [node] of a mesh that parts.
struct PartedNodes {
  const std::vector<double>&mass, &behind;  // [kg]; share of it in the part behind
  const std::vector<Vec2>& apart;           // distance of both copies [m]
};

/// Places and masses of the nodes of a part, whose checked mesh has other numbers than `piece`.
void set_part_nodes(const MeshPart<Mesh>& piece, bool is_behind, const PartedNodes& whole, BodySpec& part) {
  part.node_mass.assign(part.mesh->node.size(), 0);
  for (std::size_t e = 0; e < piece.mesh.element.size(); ++e)
    for (int i = 0; i < corners_of(piece.mesh.element[e]); ++i) {
      const auto at = static_cast<std::size_t>(piece.mesh.element[e][i]);
      const auto n = static_cast<std::size_t>(piece.node[at]);
      const auto own = static_cast<std::size_t>(part.mesh->element[e][i]);
      const double share = is_behind ? whole.behind[n] : 1 - whole.behind[n];
      part.node_mass[own] = share * whole.mass[n];
      part.mesh->node[own] = piece.mesh.node[at] + (is_behind ? share - 1 : 1 - share) * whole.apart[n];
    }
  std::copy_n(part.mesh->node.begin(), part.outline.size(), part.outline.begin());
  part.mass = std::accumulate(part.node_mass.begin(), part.node_mass.end(), 0.0);
}

}  // namespace

/// Nodes keep the mass of their elements, so that mass, momentum and centre of mass remain. An opening is small: it
/// sets the faces apart, and changes the elements at them by its ratio to their size.
void ModelBuilder::crack_mesh(int body, const CrackSection<2>& section, const std::vector<Vec2>& opening) {
  const auto at = static_cast<std::size_t>(body);
  const BodySpec whole = bodies_[at];
  const MeshCut& cut = *section.cut;
  Model<2> lone;
  append_deformable(whole, lone);
  rules_.inherit(whole.name, pieces_group(whole.name));
  rules_.set_contact(pieces_group(whole.name), pieces_group(whole.name), whole.cracks.law);
  bodies_[at].first_part = static_cast<int>(bodies_.size());
  bodies_[at].parted_at = {section.middle(), section.normal};
  const std::vector<double> behind = shares_behind(*whole.mesh, cut);
  std::vector<Vec2> apart(whole.mesh->node.size(), Vec2::Zero());
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) apart[static_cast<std::size_t>(cut.nodes[i])] = opening[i];
  for (const bool is_behind : {true, false}) {
    const MeshPart<Mesh> piece = part_of_mesh(*whole.mesh, cut, is_behind);
    BodySpec part = part_spec(whole, section.number, [&](const CrackPlane<2>& plane) {
      return mesh_plane_fault(piece.mesh, plane, 0).empty();
    });
    part.name = new_part_name(body_names_known_, bodies_, whole.name + (is_behind ? ".a" : ".b"));
    part.mesh = piece.mesh;
    take_checked_mesh(part, fmt::format("body '{}'", part.name));
    set_part_nodes(piece, is_behind, {lone.mass, behind, apart}, part);
    part.cracked_from = body;
    bodies_.push_back(std::move(part));
  }
}

Model<2> ModelBuilder::with_parts(const Model<2>& model) const {
  std::vector<std::string> faults;
  Model<2> grown = assemble_bodies(faults);
  if (!faults.empty()) throw InputError(faults.front());
  carry_conditions(model, grown);
  return grown;
}

}  // namespace trilith
