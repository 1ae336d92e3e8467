// Private to view/: natural modes of a results file, for the page to play.
#pragma once

#include "results/reading/reader.hpp"
#include "view/bytes.hpp"
#include "view/json_text.hpp"

namespace trilith::view {

/// Blocks of M modes and N nodes: mode_position [M, 2 N] and mode_rotation [M, N], where the nodes stood;
/// mode_displacement [M, 2 N] and mode_turn [M, N], how they move, as large as a picture shows them. Of a model in
/// space positions and displacements are [M, 3 N], rotations quaternions [M, 4 N] and turns rotation vectors [M, 3 N].
/// What each mode is goes to `json` under "modes".
void write_modes(const results::ResultsReader& reader, JsonText& json, std::vector<ViewBlock>& blocks);

}  // namespace trilith::view
