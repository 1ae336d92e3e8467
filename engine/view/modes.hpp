// Private to view/: natural modes of a results file, for animation in the page.
#pragma once

#include "results/reading/reader.hpp"
#include "view/bytes.hpp"
#include "view/json_text.hpp"

namespace trilith::view {

/// Blocks of M modes and N nodes: mode_position [M, 2 N] and mode_rotation [M, N], the positions of the nodes;
/// mode_displacement [M, 2 N] and mode_turn [M, N], the mode shapes, with the scale of pictures. For a model in space
/// positions and displacements are [M, 3 N], rotations quaternions [M, 4 N] and turns rotation vectors [M, 3 N]. The
/// descriptions of the modes are written to `json` under "modes".
void write_modes(const results::ResultsReader& reader, JsonText& json, std::vector<ViewBlock>& blocks);

}  // namespace trilith::view
