// Planes on which rigid bodies may crack, in tables of scripts.
#pragma once

#include "bindings/core/handles.hpp"
#include "model/crack_planes.hpp"

namespace trilith::script {

/// cracks = , crack_law = ; `cracks` remains unchanged where they are not given. Problems are noted in `keys`.
void read_cracks(Keys& keys, CrackSpec<2>& cracks);
void read_cracks(Keys& keys, CrackSpec<3>& cracks);

}  // namespace trilith::script
