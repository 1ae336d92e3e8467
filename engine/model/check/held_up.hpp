// Finds the supported bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "model/check/check.hpp"

namespace trilith {

/// [body] 1 if the body is connected, by contact or links, to a fixed or driven body at the start.
template <int D>
std::vector<std::uint8_t> held_up_bodies(const Model<D>& model, const Newcomers& among = {});

}  // namespace trilith
