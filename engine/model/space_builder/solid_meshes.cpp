// Bodies of finite elements of the model builder in space: their checks, and their data.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "model/names.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {
namespace {

/// A solid law for the plane alone would give an arbitrary out-of-plane response.
void require_space_form(const Solid& solid, const std::string& owner) {
  if (has_space_form(solid.law)) return;
  std::string others;
  SolidLaws::for_each([&]<class L>() {
    if constexpr (acts_in_space<L>) others += fmt::format("{}{}", others.empty() ? "" : ", ", L::name);
  });
  throw InputError(
      fmt::format("{} is {}, which has only equations of plane stress and plane strain, none for elements in space. "
                  "Use one of {}, or give it respond(strain, memory) for space (law/material/tensor_form.hpp)",
                  owner, std::visit([](const auto& l) { return l.name; }, solid.law), others));
}

const Solid& solid_of(const std::vector<Material>& materials, const SolidSpec& spec, const std::string& owner) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == spec.material; });
  if (found == materials.end() || !found->solid)
    throw InputError(fmt::format("{}: it deforms, so it needs a material with a stiffness (E, nu); {} has none", owner,
                                 spec.material.empty() ? "it" : "'" + spec.material + "'"));
  require_space_form(*found->solid, fmt::format("{}: its material '{}'", owner, spec.material));
  return *found->solid;
}

/// A larger grid takes minutes and gigabytes before anything is visible.
constexpr double most_grid_elements = 200'000;

void require_grid(const SpaceForm& form, const std::string& owner) {
  constexpr int wedges_of_a_brick = 2, tetrahedra_of_a_brick = 6;
  const auto [x, y, z] = form.divisions;
  const int of_a_brick = form.element == ElementShape::brick   ? 1
                         : form.element == ElementShape::wedge ? wedges_of_a_brick
                                                               : tetrahedra_of_a_brick;
  const double elements = static_cast<double>(x) * y * z * of_a_brick;
  if (elements > most_grid_elements)
    throw InputError(
        fmt::format("{}: its mesh of {} x {} x {} would have {:g} elements, at most {:g} are made; divide its "
                    "sides less",
                    owner, x, y, z, elements, most_grid_elements));
}

}  // namespace

/// Meshes of solids with one piece are made here. The skin becomes the pieces of the body, for bearings that must be
/// near it.
void SolidModelBuilder::check_mesh_body(SolidSpec& spec, const std::string& owner) {
  (void)solid_of(materials_, spec, owner);
  if (!spec.spheres.empty())
    throw InputError(owner + ": spheres do not deform; leave out the elements, or make it a mesh");
  const auto turn = [&](int k) { return spec.support[static_cast<std::size_t>(3 + k)] != Support::free; };
  const bool held =
      std::none_of(spec.support.begin(), spec.support.begin() + 3, [](Support s) { return s == Support::free; });
  if ((turn(0) || turn(1) || turn(2)) && !held)
    throw InputError(owner + ": its nodes have no rotation to hold; hold x, y and z of some of them");
  if (!spec.mesh) {
    if (spec.pieces.size() != 1)
      throw InputError(fmt::format(
          "{}: it has {} pieces, and elements are made of one that is a brick; leave it rigid, or give it a mesh",
          owner, spec.pieces.size()));
    require_grid(spec.form, owner);
    spec.mesh = mesh_of(spec.pieces[0], spec.form, owner);
  }
  CheckedSpaceMesh checked = check_space_mesh(std::move(*spec.mesh), owner);
  notes_.insert(notes_.end(), checked.notes.begin(), checked.notes.end());
  spec.pieces = skin_of(checked);
  spec.mesh = std::move(checked.mesh);
  refuse_idle_holds(spec.supports, spec.mesh->node, owner);
}

SpaceMeshBody SolidModelBuilder::mesh_body(const SolidSpec& spec) const {
  SpaceMeshBody out;
  out.name = spec.name;
  out.mesh = check_space_mesh(*spec.mesh, fmt::format("body '{}'", spec.name));
  out.solid = solid_of(materials_, spec, fmt::format("body '{}'", spec.name));
  out.density = density_of(spec);
  std::copy_n(spec.support.begin(), 3, out.support.begin());
  out.supports = spec.supports, out.velocity = spec.velocity, out.spin = spec.spin;
  return out;
}

}  // namespace trilith
