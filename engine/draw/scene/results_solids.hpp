// From a frame of a model in space to a scene: its solids as faces in the order in which they are painted.
#pragma once

#include <optional>

#include "draw/scene/results_picture.hpp"
#include "draw/scene/solid_cracks.hpp"
#include "draw/scene/trimmed_ground.hpp"

namespace trilith::draw {

/// How solids are shown.
struct SolidsView {
  ViewDirection from = {};
  std::optional<CutPlane> cut = std::nullopt;     ///< what is on the eye's side of it is left out
  std::optional<SpaceBox> around = std::nullopt;  ///< the box of what is free, about which ground is cut off
  std::vector<SolidCrack> cracks = {};
};

/// Fills the faces of a scene whose bodies are there without outlines, those outlines, and the axes of the world.
/// `left_out[body]`: it is not drawn. Throws InputError where the file tells of no faces, or the cut leaves nothing.
void add_solids(const results::Header& header, const results::Frame& frame, const SolidsView& shown,
                const std::vector<bool>& left_out, Scene& scene);

/// Outlines, as seen, of free bodies at the start, of those that have moved since.
void add_solid_ghosts(const results::Header& header, const results::Frame& start, const results::Frame& frame,
                      const ViewAxes& view, Scene& scene);

}  // namespace trilith::draw
