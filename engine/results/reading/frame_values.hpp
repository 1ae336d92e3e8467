// Values of one field of a frame, by name.
#pragma once

#include <string_view>
#include <vector>

#include "results/reading/reader.hpp"

namespace trilith::results {

/// Values of the field `name`; nullptr if it was not recorded.
inline const std::vector<double>* values_of(const Header& header, const Frame& frame, std::string_view name) {
  for (std::size_t i = 0; i < header.fields.size() && i < frame.fields.size(); ++i)
    if (header.fields[i].name == name) return &frame.fields[i];
  return nullptr;
}

}  // namespace trilith::results
