// Thickness of bodies where they may be hit: the reference length of overlaps.
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Computes piece_thickness and least_thickness of a model that has its pieces and contact table, in its initial state.
///
/// The thickness of a single-piece body is the piece's least width. In a body of several pieces the thickness of a
/// piece is the least thickness of the body behind the middle of its surface edges. It is at least the piece's own
/// least width, because an inner cut is not an end of the body.
void find_thickness(Model<2>& model);

}  // namespace trilith
