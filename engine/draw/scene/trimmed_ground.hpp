// How much of the ground under a model in space belongs into its picture.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "draw/scene/solid_piece.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

/// A box with its sides along the axes of the world [m].
struct SpaceBox {
  Vec3 low, high;
};

/// The box of nearly all bodies that are free and not left out, and as far again around it, but no larger than the box
/// of all: beyond it ground is of no interest. nullopt where no body is free.
std::optional<SpaceBox> box_of_free(const results::Header& header, const results::Placement& at,
                                    const std::vector<bool>& left_out);

/// The box around both.
std::optional<SpaceBox> joined(const std::optional<SpaceBox>& a, const std::optional<SpaceBox>& b);

/// Pieces that are free as they are; of those that `is_held` says: a plate that lies under all of `around` ends at a
/// border about it, and so does what reaches more than twice as far beyond it as it is large; what lies outside of the
/// border is left out; walls, piers, a chute stay whole. `around` goes down to the ground beneath it.
std::vector<SolidPiece> trimmed_ground(std::vector<SolidPiece> pieces,
                                       const std::function<bool(const SolidPiece&)>& is_held, const SpaceBox& around);

}  // namespace trilith::draw
