// What m:bearing and m:bearing_type share.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// Reads the laws along, axial and turning, and the limit of each. Problems are noted in `keys`.
void read_directions(Keys& keys, BearingSpec& spec);

}  // namespace trilith::script
