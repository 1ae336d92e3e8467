#include "world/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr double extents_around = 10, least_margin = 100;  // [1], [m]

}  // namespace

/// The box of all skin at the start, and around it ten times its larger side, at least 100 m.
Bounds<2> default_bounds(const Model<2>& model) {
  Bounds<2> box{Vec2::Constant(unbounded), Vec2::Constant(-unbounded)};
  for (std::size_t i = 0; i < model.skin_place.size(); ++i) {
    const int n = model.skin_node[i];
    const Vec2 x = model.start_position[n] + Turn(model.start_rotation[n]).apply(model.skin_place[i]);
    box.low = box.low.cwiseMin(x), box.high = box.high.cwiseMax(x);
  }
  if (model.skin_place.empty()) return {};
  const Vec2 margin = Vec2::Constant(std::max(least_margin, extents_around * (box.high - box.low).maxCoeff()));
  return {box.low - margin, box.high + margin};
}

void set_bounds(Model<2>& model, const Bounds<2>& chosen) {
  Bounds<2> out = default_bounds(model);
  constexpr std::array low_names{"left", "bottom"}, high_names{"right", "top"};
  for (const int k : {0, 1}) {
    // Sides that are not given are the preset ones.
    if (std::isfinite(chosen.low[k])) out.low[k] = chosen.low[k];
    if (std::isfinite(chosen.high[k])) out.high[k] = chosen.high[k];
    if (!(out.low[k] < out.high[k]))
      throw InputError(fmt::format("bounds: '{}' is {:g} m, must be below '{}', which is {:g} m",
                                   low_names[static_cast<std::size_t>(k)], out.low[k],
                                   high_names[static_cast<std::size_t>(k)], out.high[k]));
  }
  model.bounds = out;
}

}  // namespace trilith
