// Materials of bodies, by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "element/band_damping.hpp"
#include "law/material/list.hpp"

namespace trilith {

struct Material {
  std::string name;
  double density = 0;                              ///< [kg/m3], above 0
  std::optional<Solid> solid = std::nullopt;       ///< required by deformable bodies
  std::optional<BandDamping> band = std::nullopt;  ///< for members of frames
};

/// Throws InputError for a name used in `others`, and a density that is not above 0; adds unusual values to `notes`.
void check_material(const Material& material, const std::vector<Material>& others, std::vector<std::string>& notes);
/// Throws InputError, which begins with `owner`, where `materials` has none named `name`.
void require_material(const std::vector<Material>& materials, const std::string& name, const std::string& owner);

}  // namespace trilith
