// Deformable and rigid boxes in space of one soft material, for the physics tests.
#pragma once

#include <array>
#include <string>

#include "physics/space/space_solids.hpp"

namespace trilith::testing {

inline constexpr std::array<Support, 6> all_fixed{Support::fixed, Support::fixed, Support::fixed,
                                                  Support::fixed, Support::fixed, Support::fixed};

inline SolidSpec rigid_box(const std::string& name, const Polyhedron& box) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {box}, spec.material = "soft";
  return spec;
}

inline SolidSpec fixed_box(const std::string& name, const Polyhedron& box) {
  SolidSpec spec = rigid_box(name, box);
  spec.support = all_fixed;
  return spec;
}

/// Bodies of one soft material with one contact law for all pairs.
inline SolidModelBuilder soft_world(const ContactLaw& law, double young, double poisson, double damping = 0,
                                    double density = 2000) {
  SolidModelBuilder builder;
  builder.add_material(elastic_in("soft", density, young, poisson, damping));
  builder.add_law("law", law);
  builder.set_contact("*", "*", "law");
  return builder;
}

}  // namespace trilith::testing
