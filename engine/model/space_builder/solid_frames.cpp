// Frames of the model builder in space: their checks, and the data of their members.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "model/names.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {
namespace {

const Material* material_called(const std::vector<Material>& materials, const std::string& name) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return found == materials.end() ? nullptr : &*found;
}

const std::string& material_of(const SolidSpec& spec, const SpaceMember& member) {
  return member.material.empty() ? spec.material : member.material;
}

/// Throws InputError if a hinge in space is incomplete, or softens faster than its beam of `length` [m] can follow.
void check_hinge(const SpaceMember& member, int end, double young, double length, bool consistent) {
  const HingeLaw& law = *member.hinge[static_cast<std::size_t>(end)];
  check_parameters(law), law.check();
  if (!(law.across > 0))
    throw InputError(
        "end_hinge: in space it bends about both axes, and across is 0; give it the yield moment of lateral bending, "
        "such as across = " +
        fmt::format("{:g}", law.sagging));
  if (law.removes && consistent)
    throw InputError("end_hinge: a removed member keeps its mass at its nodes; leave out mass_matrix = \"consistent\"");
  if (member.pinned[static_cast<std::size_t>(end)])
    throw InputError(fmt::format("end_hinge: its {} is pinned already", end == 0 ? "start" : "end"));
  // About y the hinge has across/sagging times the strength and softening.
  const double about_z = member.section.second_moment[1],
               about_y = member.section.second_moment[0] * law.sagging / law.across;
  check_softening(law, 2 * young * std::min(about_z, about_y) / length);
}

/// Throws InputError if a member cannot yield as specified. `length`: of its beams [m].
void check_yields(const SpaceMember& member, double young, double length, bool consistent, const std::string& owner) {
  try {
    if (member.fibres)
      make_fibre_beam_in_space(make_fibres_in_space(member.fibres->spec), 1, member.pinned, {}, 1, member.fibres->rule,
                               member.fibres->stations);
    for (const int end : {0, 1})
      if (member.hinge[static_cast<std::size_t>(end)]) check_hinge(member, end, young, length, consistent);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", owner, e.what()));
  }
}

}  // namespace

/// The initial skin becomes the pieces of the body, for bearings that must be near it.
void SolidModelBuilder::check_frame(SolidSpec& spec, const std::string& owner) const {
  begin_at_blocks(*spec.frame);
  check_space_frame(*spec.frame, owner);
  refuse_idle_holds(spec.supports, node_places(*spec.frame), owner);
  if (spec.density) require_positive(*spec.density, owner + ": density", "kg/m3");
  if (spec.mass) require_positive(*spec.mass, owner + ": mass", "kg");
  if (spec.density && spec.mass) throw InputError(owner + ": both density and mass are given; keep one");
  for (const SpaceMember& m : spec.frame->members) {
    const std::string& name = material_of(spec, m);
    const Material* const material = material_called(materials_, name);
    if (material == nullptr || !material->solid)
      throw InputError(fmt::format("{}: its members need a material with a stiffness (E, nu); {} has none", owner,
                                   name.empty() ? "it" : "'" + name + "'"));
    if (!material->solid->is_elastic())
      throw InputError(
          fmt::format("{}: members need an elastic material, and '{}' is not elastic ({}); let members "
                      "yield by a fibre_section or an end_hinge",
                      owner, name, describe(*material->solid)));
    const double young = std::visit([](const auto& l) { return l.young; }, material->solid->law);
    check_yields(m, young, length_of(*spec.frame, m) / m.divisions, spec.frame->consistent,
                 fmt::format("{}: member '{}'", owner, name_of(*spec.frame, m)));
  }
  spec.pieces.clear();
  for (const SpaceJoint& joint : spec.frame->joints)
    if (joint.has_block()) spec.pieces.push_back(joint.block);
  for (std::size_t m = 0; m < spec.frame->members.size(); ++m)
    for (const SkinStretch& stretch : skin_stretches(*spec.frame, m))
      for (const Polyhedron& solid : skin_solids(*spec.frame, m, stretch)) spec.pieces.push_back(solid);
}

/// If the body's mass is given, all masses of members are scaled to it.
SpaceFrameBody SolidModelBuilder::frame_body(const SolidSpec& spec) const {
  SpaceFrameBody out;
  out.name = spec.name, out.frame = *spec.frame, out.velocity = spec.velocity, out.spin = spec.spin;
  out.support = spec.support, out.supports = spec.supports;
  const Material* const own = material_called(materials_, spec.material);
  out.density = spec.density.value_or(own == nullptr ? 0 : own->density);
  double sum = 0;
  for (const SpaceMember& m : out.frame.members) {
    const Material& material = *material_called(materials_, material_of(spec, m));
    const auto [young, poisson] =
        std::visit([](const auto& l) { return std::pair(l.young, l.poisson); }, material.solid->law);
    out.material.push_back({spec.density.value_or(material.density) * m.section.area,
                            {young, young / (2 * (1 + poisson)), m.shear},
                            material.solid->damping(),
                            material.band,
                            material.solid->strain_limit});
    sum += out.material.back().mass * length_of(out.frame, m);
  }
  if (spec.mass)
    for (SpaceMemberMaterial& made : out.material) made.mass *= *spec.mass / sum;
  for (const SpaceMemberMaterial& made : out.material)
    require_positive(made.mass, fmt::format("body '{}': mass of its members", spec.name), "kg/m");
  return out;
}

}  // namespace trilith
