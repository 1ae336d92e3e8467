// Temperatures of nodes, and water in joints, in each frame.
#pragma once

#include <vector>

#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Adds the values of heat and seepage to a header; nothing for a model without fields.
template <int D>
void describe_field_values(const Model<D>& model, results::Header& header);

/// Appends them at this instant, in the order of the header.
template <int D>
void take_field_values(const Instant<D>& now, std::vector<std::vector<double>>& values);

}  // namespace trilith
