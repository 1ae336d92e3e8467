#include "model/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

constexpr double extents_around = 10, least_margin = 100;  // [1], [m]

}  // namespace

/// The box of all skin at the start, extended by ten times its larger side, at least 100 m.
template <int D>
Bounds<D> default_bounds(const Model<D>& model) {
  Bounds<D> box{Vec<D>::Constant(unbounded), Vec<D>::Constant(-unbounded)};
  double most = 0;
  for (std::size_t i = 0; i < model.skin_place.size(); ++i) {
    const Vec<D> x = skin_start(model, static_cast<int>(i));
    box.low = box.low.cwiseMin(x), box.high = box.high.cwiseMax(x);
  }
  for (const ConvexSolid& piece : model.piece_solid)  // spheres extend beyond their one point
    if (piece.is_sphere()) most = std::max(most, piece.radius);
  box.low.array() -= most, box.high.array() += most;
  if (model.skin_place.empty()) return {};
  const Vec<D> margin = Vec<D>::Constant(std::max(least_margin, extents_around * (box.high - box.low).maxCoeff()));
  return {box.low - margin, box.high + margin};
}

template <int D>
void set_bounds(Model<D>& model, const Bounds<D>& chosen) {
  Bounds<D> out = default_bounds(model);
  for (int k = 0; k < D; ++k) {
    // Sides that are not given use the defaults.
    if (std::isfinite(chosen.low[k])) out.low[k] = chosen.low[k];
    if (std::isfinite(chosen.high[k])) out.high[k] = chosen.high[k];
    if (!(out.low[k] < out.high[k]))
      throw InputError(fmt::format("bounds: '{}' is {:g} m, must be below '{}', which is {:g} m",
                                   bound_names<D>[static_cast<std::size_t>(k)].first, out.low[k],
                                   bound_names<D>[static_cast<std::size_t>(k)].second, out.high[k]));
  }
  model.bounds = out;
}

template Bounds<2> default_bounds(const Model<2>&);
template void set_bounds(Model<2>&, const Bounds<2>&);
template Bounds<3> default_bounds(const Model<3>&);
template void set_bounds(Model<3>&, const Bounds<3>&);

}  // namespace trilith
