// The part of the ground below a model in space that is drawn.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "draw/scene/solid_piece.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

/// An AABB in world axes [m].
struct SpaceBox {
  Vec3 low, high;
};

/// The AABB of nearly all free bodies that are drawn, enlarged by its size, but at most the AABB of all of them: ground
/// beyond it is not relevant. None if no body is free.
std::optional<SpaceBox> box_of_free(const results::Header& header, const results::Placement& at,
                                    const std::vector<bool>& left_out);

/// The AABB of both.
std::optional<SpaceBox> joined(const std::optional<SpaceBox>& a, const std::optional<SpaceBox>& b);

/// Free pieces remain unchanged. Pieces for which `is_held` returns true are trimmed: a plate below all of `around`
/// ends at a border around it. So does a piece that extends beyond it by more than twice its size. Parts outside of the
/// border are removed; walls, piers and chutes remain whole. `around` extends down to the ground beneath it.
std::vector<SolidPiece> trimmed_ground(std::vector<SolidPiece> pieces,
                                       const std::function<bool(const SolidPiece&)>& is_held, const SpaceBox& around);

}  // namespace trilith::draw
