// Which bodies stand on something.
#pragma once

#include <cstdint>
#include <vector>

#include "model/check/check.hpp"

namespace trilith {

/// [body] 1 where the body touches, or is linked to, something that leads to a fixed or driven body as the model
/// starts.
template <int D>
std::vector<std::uint8_t> held_up_bodies(const Model<D>& model, const Newcomers& among = {});

}  // namespace trilith
