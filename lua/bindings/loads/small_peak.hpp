// A note on peak accelerations that are probably meant in g.
#pragma once

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// core.note_small_peak(owner, pga): prints the note of `owner` if pga [m/s2] is small for an earthquake and usual in
/// g.
int note_small_peak(lua_State* L);

}  // namespace trilith::script
