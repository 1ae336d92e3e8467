// From a frame of a model in space to a scene: its solids as faces in the order in which they are painted.
#pragma once

#include <optional>

#include "draw/results_picture.hpp"
#include "draw/trimmed_ground.hpp"

namespace trilith::draw {

/// Fills the faces of a scene whose bodies are there without outlines, those outlines, and the axes of the world.
/// Ground that reaches far beyond `around`, the box of what is free, is cut off about it. `left_out[body]`: it is not
/// drawn. Throws InputError where the file tells of no faces, or the cut leaves nothing.
void add_solids(const results::Header& header, const results::Frame& frame, const SceneChoice& choice,
                const std::vector<bool>& left_out, const std::optional<SpaceBox>& around, Scene& scene);

/// Outlines, as seen, of free bodies at the start, of those that have moved since.
void add_solid_ghosts(const results::Header& header, const results::Frame& start, const results::Frame& frame,
                      const ViewAxes& view, Scene& scene);

}  // namespace trilith::draw
