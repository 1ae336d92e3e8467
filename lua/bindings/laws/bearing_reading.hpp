// Common readers of m:bearing, m:bearing_type and m:seat.
#pragma once

#include <array>
#include <cstdint>

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// Treatment of limits that a given `limit` does not name.
enum class OtherLimits : std::uint8_t { none, kept };

/// Reads the law of each direction, in space also the law of both horizontal ones, and the limits; missing values of
/// `spec` remain unchanged. Problems are noted in `keys`.
template <int D>
void read_directions(Keys& keys, BearingSpecOf<D>& spec, OtherLimits others = OtherLimits::none);

/// Reads `becomes_from`, "start" or "here", for all directions or in a table for some: whether the displacement of the
/// successor counts from where it takes over. Missing values remain unchanged; problems are noted in `keys`.
template <int D>
void read_becomes_from(Keys& keys, std::array<bool, Space<D>::dofs>& from_here);

/// m:seat{ name =, body =, support =, at_end =, edge =, inward = }
int add_seat(lua_State* L);

}  // namespace trilith::script
