// Where bodies are followed unless the script says otherwise.
#pragma once

#include "world/model.hpp"

namespace trilith {

/// Ten times the extent of all bodies at the start around them on every side, and at least 100 m: what falls past its
/// ground, and what is thrown, comes to lie wherever there is anything to lie on, and nothing falls for ever.
Bounds<2> default_bounds(const Model<2>& model);

/// Gives the model these bounds; sides that are infinite become those of default_bounds. Throws InputError where one
/// side is not beyond its opposite.
void set_bounds(Model<2>& model, const Bounds<2>& chosen);

}  // namespace trilith
