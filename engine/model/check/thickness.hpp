// How thick bodies are where they may be hit: what an overlap is deep or shallow against.
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Fills piece_thickness and least_thickness of a model whose pieces and contact table are there, as it starts.
///
/// A body of one piece is as thick as the piece's least width. Of a body of several, a piece is as thick as the body is
/// behind the middle of those of its edges that are surface, where that is least; but no thinner than its own least
/// width, for an inner cut is no end of the body.
void find_thickness(Model<2>& model);

}  // namespace trilith
