// Bodies of a model in space that may crack, and their parts.
#include <fmt/format.h>

#include "base/error.hpp"
#include "model/builder/crack_rules.hpp"
#include "model/builder/extend.hpp"
#include "model/space_builder/crack_sections_space.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {
namespace {

/// A part with all that it takes from its body: the planes that cut it, except plane `number`.
SolidSpec solid_part_spec(const SolidSpec& whole, int number, const Polyhedron& solid) {
  SolidSpec part = whole;
  part.groups.push_back(pieces_group(whole.name));
  part.pieces = {solid};
  part.density.reset();
  part.floating = true;
  part.velocity = part.spin = part.load = Vec3::Zero();
  part.first_part = -1;
  part.cracks = {};
  part.cracks.law = whole.cracks.law, part.cracks.where_met = true;
  const std::vector<CrackPlane<3>> planes = crack_planes(whole.cracks, whole.pieces.front());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (number_of(whole.cracks, i) == number || !parts_of(solid, planes[i])) continue;
    part.cracks.planes.push_back(planes[i]), part.cracks.numbers.push_back(number_of(whole.cracks, i));
  }
  return part;
}

}  // namespace

/// All that does not depend on laws, which may be added later.
void SolidModelBuilder::check_cracks(const SolidSpec& spec, const std::string& owner) {
  if (spec.cracks.empty()) return;
  if (spec.deforms() || spec.frame)
    refuse_cracks(owner,
                  "planes are for rigid bodies, this one deforms; give it body = \"rigid\", or several rigid or "
                  "deformable bodies with a bonded or cohesive law between them");
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
  int number = 0;
  for (const CrackPlane<3>& plane : crack_planes(spec.cracks, spec.pieces.front())) {
    ++number;
    if (!(plane.normal.norm() > 0)) refuse_cracks(owner, fmt::format("the normal of plane {} has no length", number));
    if (!spec.cracks.where_met && !parts_of(spec.pieces.front(), plane))
      throw InputError(owner + ": " + missed_plane_text(spec.pieces.front(), plane, number));
  }
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
    const std::vector<CrackPlane<3>> planes = crack_planes(spec.cracks, spec.pieces.front());
    for (std::size_t i = 0; i < planes.size(); ++i)
      if (auto section = crack_section(spec.pieces.front(), model.mass[n], model.start_rotation[n], planes[i],
                                       number_of(spec.cracks, i)))
        row.sections.push_back(std::move(*section));
    if (!row.sections.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

/// Mass by volume, so that the sum of both is the mass of the body. The remaining planes go to the parts that they cut.
void SolidModelBuilder::crack(const Model<3>& model, int body, const CrackSection<3>& section) {
  const auto at = static_cast<std::size_t>(body);
  const SolidSpec whole = bodies_[at];
  const auto n = static_cast<std::size_t>(model.bodies[at].first_node);
  const Turn3 turn(model.start_rotation[n]);
  const CrackPlane<3> plane{model.start_position[n] + turn.apply(section.centre), turn.apply(section.normal)};
  const auto solids = parts_of(whole.pieces.front(), plane);
  if (!solids) return;
  rules_.inherit(whole.name, pieces_group(whole.name));
  rules_.set_contact(pieces_group(whole.name), pieces_group(whole.name), whole.cracks.law);
  bodies_[at].first_part = static_cast<int>(bodies_.size()), bodies_[at].parted_at = plane;
  for (const std::size_t side : {0, 1}) {
    SolidSpec part = solid_part_spec(whole, section.number, (*solids)[side]);
    part.name = new_part_name(body_names_known_, bodies_, whole.name + (side == 0 ? ".a" : ".b"));
    part.mass = side == 0 ? section.mass : model.mass[n] - section.mass;
    part.cracked_from = body;
    bodies_.push_back(std::move(part));
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
