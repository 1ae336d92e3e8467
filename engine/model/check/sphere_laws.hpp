// Parts of contact laws that sphere contact does not support.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Adds a line to `notes` for each law with a bond, crushing mortar or another part that sphere contact does not
/// support. It must hold for a body with spheres from body `first` on. The line names the bodies and a remedy.
void note_sphere_laws(const Model<3>& model, int first, std::vector<std::string>& notes);

}  // namespace trilith
