// Conversion of a frame of a model in space to a scene: faces in painting order.
#pragma once

#include <optional>

#include "draw/results/results_picture.hpp"
#include "draw/results/solid_cracks.hpp"
#include "draw/results/trimmed_ground.hpp"

namespace trilith::draw {

/// View of the polyhedra.
struct SolidsView {
  ViewDirection from = {};
  std::optional<CutPlane> cut = std::nullopt;     ///< the part on the eye's side is omitted
  std::optional<SpaceBox> around = std::nullopt;  ///< AABB of the free bodies, around which the ground is cut off
  std::vector<SolidCrack> cracks = {};
  std::vector<std::optional<double>> node_value = {};  ///< [node] of bodies whose faces have their own values; or empty
};

/// Fills the faces and outlines of a scene that contains its bodies, and the world axes. `left_out[body]`: the body is
/// not drawn. Throws InputError if the file has no faces, or if the cut leaves nothing.
void add_solids(const results::Header& header, const results::Frame& frame, const SolidsView& shown,
                const std::vector<bool>& left_out, Scene& scene);

/// Adds the visible initial outlines of free bodies that have moved.
void add_solid_ghosts(const results::Header& header, const results::Frame& start, const results::Frame& frame,
                      const ViewAxes& view, Scene& scene);

}  // namespace trilith::draw
