// Checks of a model before it runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "world/model.hpp"

namespace trilith {

/// Throws InputError where two bodies that may touch overlap deeper at the start than `allowed` times the smaller one's
/// size; names them and the depth. Shallower overlaps are noted. All pairs are looked at, the deepest is reported.
void check_overlaps(const Model<2>& model, double allowed, std::vector<std::string>& notes);

/// Throws InputError where gravity acts on a free body that neither touches, nor is linked to, anything that leads to a
/// fixed or driven body. `floating`: [body] 1 where that is meant.
void check_held_up(const Model<2>& model, const std::vector<std::uint8_t>& floating);

}  // namespace trilith
