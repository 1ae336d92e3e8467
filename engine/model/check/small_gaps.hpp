// Bodies that a small gap alone parts from what holds them up.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/check/check.hpp"
#include "model/model.hpp"

namespace trilith {

/// As check_held_up: a gap of up to 2 % of the smaller body's radius counts as touching. `notes` gets the narrowest of
/// the gaps that alone hold a body up, and how many more there are.
template <int D>
void check_held_up_and_gaps(const Model<D>& model, const std::vector<std::uint8_t>& floating,
                            std::vector<std::string>& faults, std::vector<std::string>& notes,
                            const Newcomers& among = {});

}  // namespace trilith
