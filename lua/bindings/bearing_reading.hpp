// What m:bearing, m:bearing_type and m:seat share.
#pragma once

#include "handles.hpp"

namespace trilith::script {

/// Reads the law of each direction, in space of both horizontal ones too, and the limits. Problems are noted in `keys`.
template <int D>
void read_directions(Keys& keys, BearingSpecOf<D>& spec);

/// m:seat{ name =, body =, support =, at_end =, edge =, inward = }
int add_seat(lua_State* L);

}  // namespace trilith::script
