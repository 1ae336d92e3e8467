// What m:bearing, m:bearing_type and m:seat share.
#pragma once

#include <array>
#include <cstdint>

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// What limits are that a given `limit` does not name.
enum class OtherLimits : std::uint8_t { none, kept };

/// Reads the law of each direction, in space of both horizontal ones too, and the limits; what is not given stays what
/// it is in `spec`. Problems are noted in `keys`.
template <int D>
void read_directions(Keys& keys, BearingSpecOf<D>& spec, OtherLimits others = OtherLimits::none);

/// Reads `becomes_from`, "start" or "here", for all directions or in a table for some: whether the bearing that follows
/// counts displacement from where it takes over. What is not given stays; problems are noted in `keys`.
template <int D>
void read_becomes_from(Keys& keys, std::array<bool, Space<D>::dofs>& from_here);

/// m:seat{ name =, body =, support =, at_end =, edge =, inward = }
int add_seat(lua_State* L);

}  // namespace trilith::script
