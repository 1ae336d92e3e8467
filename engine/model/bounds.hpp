// Default bounds of the region in which bodies are simulated.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "model/model.hpp"

namespace trilith {

/// Names of the two sides along each axis: in space x points right, y back and z up.
template <int D>
inline constexpr auto bound_names = [] {
  using Names = std::pair<std::string_view, std::string_view>;
  if constexpr (D == 2)
    return std::array{Names{"left", "right"}, Names{"bottom", "top"}};
  else
    return std::array{Names{"left", "right"}, Names{"front", "back"}, Names{"bottom", "top"}};
}();

/// Extends the box of all bodies at the start by ten times its largest side, and at least 100 m, on every side. Bodies
/// that fall past their ground, or are thrown, can land wherever there is ground, and none falls forever.
template <int D>
Bounds<D> default_bounds(const Model<D>& model);

/// Sets the model's bounds; infinite sides become the default ones. Throws InputError where a side is not beyond its
/// opposite.
template <int D>
void set_bounds(Model<D>& model, const Bounds<D>& chosen);

}  // namespace trilith
