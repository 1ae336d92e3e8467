// Bodies separated by a small gap from their support.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/check/check.hpp"
#include "model/model.hpp"

namespace trilith {

/// Like check_held_up, but a gap up to 2 % of the smaller body's radius counts as touching. Adds to `notes` the
/// narrowest gap that alone supports a body, and the number of further ones.
template <int D>
void check_held_up_and_gaps(const Model<D>& model, const std::vector<std::uint8_t>& floating,
                            std::vector<std::string>& faults, std::vector<std::string>& notes,
                            const Newcomers& among = {});

}  // namespace trilith
