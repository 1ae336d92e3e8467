// Materials of the members of a frame: mass, elasticity and damping along each member, in the plane and in space.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "element/band_damping.hpp"
#include "element/beam/beam_element.hpp"
#include "element/beam/beam_element_3d.hpp"
#include "model/builder/frame.hpp"
#include "model/material.hpp"

namespace trilith {

/// Material data of a member.
template <int D>
struct MemberMaterial {
  double mass;  ///< [kg/m]
  std::conditional_t<D == 2, BeamMaterial, BeamMaterial3> elastic;
  double damping;  ///< [s]
  std::optional<BandDamping> band;
  double strain_limit;
};

/// Masses of a frame without its joints. At most one of density and mass is given.
struct FrameMass {
  std::string material;           ///< of members and blocks without their own
  std::optional<double> density;  ///< of all members and blocks instead of their materials' [kg/m3]
  std::optional<double> mass;     ///< of all members, to which their masses are scaled [kg]
};

/// Throws InputError, with `owner` in front, if a member has no elastic material or cannot yield as specified.
template <int D>
void check_member_materials(const FrameSpecOf<D>& frame, const std::string& body_material,
                            const std::vector<Material>& materials, const std::string& owner);

/// Data of each member; for a frame that has been checked. Throws InputError if a mass is not above 0.
template <int D>
std::vector<MemberMaterial<D>> member_materials(const FrameSpecOf<D>& frame, const FrameMass& mass,
                                                const std::vector<Material>& materials, const std::string& owner);

/// Density of the blocks of joints without their own [kg/m3]; 0 if there is none.
double block_density(const FrameMass& mass, const std::vector<Material>& materials);

}  // namespace trilith
