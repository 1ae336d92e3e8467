// The values of a field: the part of it that persists between steps.
#pragma once

#include <vector>

namespace trilith {

/// Empty until a field is advanced or set for the first time; until then its cells have Field::start.
struct FieldState {
  double clock = 0;  ///< time of the field [s], which passes in processes, and in motions of a field that flows
  std::vector<double> value;     ///< [cell] temperature [degC]
  std::vector<double> supplied;  ///< [surrounding] heat that it has given to the cells [J]
};

}  // namespace trilith
