// Where bodies are followed unless the script says otherwise.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "model/model.hpp"

namespace trilith {

/// What the two sides along each axis are called: in space x runs to the right, y to the back and z up.
template <int D>
inline constexpr auto bound_names = [] {
  using Names = std::pair<std::string_view, std::string_view>;
  if constexpr (D == 2)
    return std::array{Names{"left", "right"}, Names{"bottom", "top"}};
  else
    return std::array{Names{"left", "right"}, Names{"front", "back"}, Names{"bottom", "top"}};
}();

/// Ten times the extent of all bodies at the start around them on every side, and at least 100 m: what falls past its
/// ground, and what is thrown, comes to lie wherever there is anything to lie on, and nothing falls for ever.
template <int D>
Bounds<D> default_bounds(const Model<D>& model);

/// Gives the model these bounds; sides that are infinite become those of default_bounds. Throws InputError where one
/// side is not beyond its opposite.
template <int D>
void set_bounds(Model<D>& model, const Bounds<D>& chosen);

}  // namespace trilith
