// What m:bearing and m:bearing_type share.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// Reads the law of each direction, in space of both horizontal ones too, and the limits. Problems are noted in `keys`.
template <int D>
void read_directions(Keys& keys, BearingSpecOf<D>& spec);

}  // namespace trilith::script
