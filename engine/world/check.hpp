// Checks of a model before it runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "world/model.hpp"

namespace trilith {

/// A fault for each two bodies that may touch and overlap deeper at the start than `allowed` times the smaller one's
/// size: their names and the depth, the deepest for its size first. Where there is none, the deepest is noted.
template <int D>
void check_overlaps(const Model<D>& model, double allowed, std::vector<std::string>& faults,
                    std::vector<std::string>& notes);

/// A fault for each free body on which gravity acts and that neither touches, nor is linked to, anything that leads to
/// a fixed or driven body. `floating`: [body] 1 where that is meant.
template <int D>
void check_held_up(const Model<D>& model, const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults);

}  // namespace trilith
