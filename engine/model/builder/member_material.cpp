#include "model/builder/member_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "element/beam/fibre_beam_3d.hpp"

namespace trilith {
namespace {

const Material* material_named(const std::vector<Material>& materials, const std::string& name) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return found == materials.end() ? nullptr : &*found;
}

template <int D>
const std::string& name_of_material(const FrameMemberOf<D>& member, const std::string& body_material) {
  return member.material.empty() ? body_material : member.material;
}

double young_of(const Material& material) {
  return std::visit([](const auto& l) { return l.young; }, material.solid->law);
}

/// Bending stiffness of a beam over E that a softening hinge of the law works against [m3].
double least_bending(const FrameMember& member, const HingeLaw& /*law*/, double length) {
  return member.section.second_moment / length;
}
/// About y the hinge has across/sagging times the strength and softening.
double least_bending(const SpaceMember& member, const HingeLaw& law, double length) {
  const double about_z = member.section.second_moment[1],
               about_y = member.section.second_moment[0] * law.sagging / law.across;
  return std::min(about_z, about_y) / length;
}

/// Throws InputError if a hinge is incomplete, or softens faster than its beam of `length` [m] can follow.
template <int D>
void check_hinge(const FrameMemberOf<D>& member, int end, const HingeLaw& law, double young, double length,
                 bool consistent) {
  check_parameters(law), law.check();
  if (D == 3 && !(law.across > 0))
    throw InputError(
        fmt::format("end_hinge: in space it bends about both axes, and across is 0; give it the yield moment of "
                    "lateral bending, such as across = {:g}",
                    law.sagging));
  if (law.removes && consistent)
    throw InputError("end_hinge: a removed member keeps its mass at its nodes; leave out mass_matrix = \"consistent\"");
  if (member.pinned[end])
    throw InputError(fmt::format("end_hinge: its {} is pinned already", end == 0 ? "start" : "end"));
  check_softening(law, 2 * young * least_bending(member, law, length));
}

/// The fibres of a member form beams; `length` of one [m].
void check_fibres(const FrameMember& member, const MemberFibres& fibres, double length) {
  make_fibre_beam(make_fibres(for_length(fibres.spec, length)), length, member.pinned, 0, fibres.rule, fibres.stations);
}
void check_fibres(const SpaceMember& member, const MemberFibres& fibres, double length) {
  make_fibre_beam_in_space(make_fibres_in_space(for_length(fibres.spec, length)), length, member.pinned, {}, 1,
                           fibres.rule, fibres.stations);
}

/// Throws InputError, with `owner` in front, if a member cannot yield as specified. `length`: of its beams [m].
template <int D>
void check_yields(const FrameMemberOf<D>& member, double young, double length, bool consistent,
                  const std::string& owner) {
  try {
    if (const auto* const fibres = std::get_if<MemberFibres>(&member.yields)) check_fibres(member, *fibres, length);
    if (const auto* const hinges = std::get_if<MemberHinges>(&member.yields))
      for (const int end : {0, 1})
        if (const auto& law = hinges->end[end]) check_hinge(member, end, *law, young, length, consistent);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", owner, e.what()));
  }
}

BeamMaterial beam_material(const FrameMember& member, double young, double shear) {
  return {young, member.shear ? shear : 0.0};
}
BeamMaterial3 beam_material(const SpaceMember& member, double young, double shear) {
  return {young, shear, member.shear};
}

}  // namespace

template <int D>
void check_member_materials(const FrameSpecOf<D>& frame, const std::string& body_material,
                            const std::vector<Material>& materials, const std::string& owner) {
  for (const FrameMemberOf<D>& m : frame.members) {
    const std::string& name = name_of_material(m, body_material);
    const Material* const material = material_named(materials, name);
    if (material == nullptr && !name.empty())
      throw InputError(fmt::format("{}: there is no material '{}' for its member '{}'; make it before, by m:material",
                                   owner, name, name_of(frame, m)));
    if (material == nullptr || !material->solid)
      throw InputError(fmt::format("{}: its members need a material with a stiffness (E, nu); {} has none", owner,
                                   name.empty() ? "it" : "'" + name + "'"));
    if (!material->solid->is_elastic())
      throw InputError(
          fmt::format("{}: members need an elastic material, and '{}' is not elastic ({}); give one with E and nu, and "
                      "let members yield by a fibre_section or an end_hinge",
                      owner, name, describe(*material->solid)));
    check_yields(m, young_of(*material), length_of(frame, m) / m.divisions, frame.consistent,
                 fmt::format("{}: member '{}'", owner, name_of(frame, m)));
  }
}

template <int D>
std::vector<MemberMaterial<D>> member_materials(const FrameSpecOf<D>& frame, const FrameMass& mass,
                                                const std::vector<Material>& materials, const std::string& owner) {
  std::vector<MemberMaterial<D>> made;
  double sum = 0;
  for (const FrameMemberOf<D>& m : frame.members) {
    const Material& material = *material_named(materials, name_of_material(m, mass.material));
    const auto [young, poisson] =
        std::visit([](const auto& l) { return std::pair(l.young, l.poisson); }, material.solid->law);
    made.push_back({mass.density.value_or(material.density) * m.section.area,
                    beam_material(m, young, young / (2 * (1 + poisson))), material.solid->damping(), material.band,
                    material.solid->strain_limit});
    sum += made.back().mass * length_of(frame, m);
  }
  for (MemberMaterial<D>& m : made) {
    if (mass.mass) m.mass *= *mass.mass / sum;
    require_positive(m.mass, fmt::format("{}: mass of its members", owner), "kg/m");
  }
  return made;
}

double block_density(const FrameMass& mass, const std::vector<Material>& materials) {
  const Material* const own = material_named(materials, mass.material);
  return mass.density.value_or(own == nullptr ? 0 : own->density);
}

template void check_member_materials(const FrameSpecOf<2>& frame, const std::string& body_material,
                                     const std::vector<Material>& materials, const std::string& owner);
template void check_member_materials(const FrameSpecOf<3>& frame, const std::string& body_material,
                                     const std::vector<Material>& materials, const std::string& owner);
template std::vector<MemberMaterial<2>> member_materials(const FrameSpecOf<2>& frame, const FrameMass& mass,
                                                         const std::vector<Material>& materials,
                                                         const std::string& owner);
template std::vector<MemberMaterial<3>> member_materials(const FrameSpecOf<3>& frame, const FrameMass& mass,
                                                         const std::vector<Material>& materials,
                                                         const std::string& owner);

}  // namespace trilith
