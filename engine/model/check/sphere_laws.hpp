// Parts of contact laws that spheres do not carry.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Adds a line to `notes` for each law that has a bond, mortar that crushes or another part that contact of spheres
/// does not carry, and holds for a body with spheres from body `first` on: which bodies, and a remedy.
void note_sphere_laws(const Model<3>& model, int first, std::vector<std::string>& notes);

}  // namespace trilith
