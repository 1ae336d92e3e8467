// Supports of some nodes of a deformable body or a frame: the nodes inside a box at the start.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/space.hpp"
#include "model/model.hpp"

namespace trilith {

/// Holds the nodes of a deformable body or a frame that are inside a box at the start.
template <int D>
struct NodeSupportOf {
  Vec<D> low = Vec<D>::Zero(), high = Vec<D>::Zero();  ///< opposite corners [m]; a side may be infinite
  std::array<Support, D> support{};                    ///< x, y and, in space, z; free: unchanged
};

/// True if `place` [m] is inside the box, with a tolerance of 1e-9 of the diagonal of its finite sides.
template <int D>
bool is_supported_at(const NodeSupportOf<D>& hold, const Vec<D>& place) {
  const Vec<D> low = hold.low.cwiseMin(hold.high), high = hold.low.cwiseMax(hold.high), side = high - low;
  const double reach = 1e-9 * side.array().isFinite().select(side, 0).matrix().norm();
  return ((place - low).array() >= -reach).all() && ((high - place).array() >= -reach).all();
}

using NodeSupport = NodeSupportOf<2>;
using SpaceNodeSupport = NodeSupportOf<3>;

/// Throws InputError, with `owner` in front, for a box without any of the nodes [m]: it probably uses other axes or
/// units.
void refuse_idle_holds(std::span<const SpaceNodeSupport> holds, std::span<const Vec3> nodes, const std::string& owner);

}  // namespace trilith
