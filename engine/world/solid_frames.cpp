// Frames of a builder of models in space: what they are checked for, and what their members are made of.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "world/names.hpp"
#include "world/solid_model_builder.hpp"

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

/// Throws InputError where a member cannot be of fibres as it says.
void check_fibres(const SpaceMember& member, const std::string& owner) {
  if (!member.fibres) return;
  try {
    make_fibre_beam_in_space(make_fibres_in_space(member.fibres->spec), 1, member.pinned, {}, 1, member.fibres->rule,
                             member.fibres->stations);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", owner, e.what()));
  }
}

/// Where the body holds a degree of freedom, all of its joints are held.
SpaceFrameSpec with_supports(const SolidSpec& spec) {
  SpaceFrameSpec frame = *spec.frame;
  for (SpaceJoint& joint : frame.joints)
    for (std::size_t k = 0; k < 6; ++k)
      if (spec.support[k] != Support::free) joint.support[k] = spec.support[k];
  return frame;
}

}  // namespace

/// Its skin, where it stands, becomes the pieces of the body: for bearings that want to be near it.
void SolidModelBuilder::check_frame(SolidSpec& spec, const std::string& owner) const {
  check_space_frame(*spec.frame, owner);
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
          fmt::format("{}: the material of members is elastic, and '{}' is not ({}); members yield by a fibre_section",
                      owner, name, describe(*material->solid)));
    if (material->band)
      throw InputError(fmt::format(
          "{}: material '{}' is damped over a band, which members in space are not yet; give it damping =", owner,
          name));
    check_fibres(m, owner);
  }
  spec.pieces.clear();
  for (std::size_t m = 0; m < spec.frame->members.size(); ++m)
    for (const SkinStretch& stretch : skin_stretches(*spec.frame, m))
      for (const Polyhedron& solid : skin_solids(*spec.frame, m, stretch)) spec.pieces.push_back(solid);
}

/// Where the body's mass is given, all masses of members are scaled to it.
SpaceFrameBody SolidModelBuilder::frame_body(const SolidSpec& spec) const {
  SpaceFrameBody out;
  out.name = spec.name, out.frame = with_supports(spec), out.velocity = spec.velocity, out.spin = spec.spin;
  double sum = 0;
  for (const SpaceMember& m : out.frame.members) {
    const Material& material = *material_called(materials_, material_of(spec, m));
    const auto [young, poisson] =
        std::visit([](const auto& l) { return std::pair(l.young, l.poisson); }, material.solid->law);
    out.material.push_back({spec.density.value_or(material.density) * m.section.area,
                            {young, young / (2 * (1 + poisson)), m.shear},
                            material.solid->damping()});
    sum += out.material.back().mass * length_of(out.frame, m);
  }
  if (spec.mass)
    for (SpaceMemberMaterial& made : out.material) made.mass *= *spec.mass / sum;
  for (const SpaceMemberMaterial& made : out.material)
    require_positive(made.mass, fmt::format("body '{}': mass of its members", spec.name), "kg/m");
  return out;
}

}  // namespace trilith
