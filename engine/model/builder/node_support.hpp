// Which nodes of a deformable body or a frame are held: those that stand in a box at the start.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/space.hpp"
#include "model/model.hpp"

namespace trilith {

/// Holds the nodes of a deformable body or a frame that stand in a box at the start.
template <int D>
struct NodeSupportOf {
  Vec<D> low = Vec<D>::Zero(), high = Vec<D>::Zero();  ///< opposite corners [m]; a side may be without end
  std::array<Support, D> support{};                    ///< x, y and, in space, z; free leaves as it is
};

/// True where `place` [m] is in the box, or out of it by rounding: 1e-9 of the diagonal of its sides that end.
template <int D>
bool is_supported_at(const NodeSupportOf<D>& hold, const Vec<D>& place) {
  const Vec<D> low = hold.low.cwiseMin(hold.high), high = hold.low.cwiseMax(hold.high), side = high - low;
  const double reach = 1e-9 * side.array().isFinite().select(side, 0).matrix().norm();
  return ((place - low).array() >= -reach).all() && ((high - place).array() >= -reach).all();
}

using NodeSupport = NodeSupportOf<2>;
using SpaceNodeSupport = NodeSupportOf<3>;

/// Throws InputError, with `owner` in front, for a box that holds none of the nodes [m]: it is a place in the wrong
/// axes or unit.
void refuse_idle_holds(std::span<const SpaceNodeSupport> holds, std::span<const Vec3> nodes, const std::string& owner);

}  // namespace trilith
