// Colours by temperature, and by the pressure of the water in joints, of a results file.
#pragma once

#include <optional>
#include <vector>

#include "draw/scene/scene_picture.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

/// Temperature of each node [degC]; none where a body has none, and in a file without temperatures.
std::vector<std::optional<double>> temperatures_of_nodes(const results::Header& header, const results::Frame& frame);

/// Sets the values of free bodies to their temperature: the mean of their nodes, and in the plane one value for each
/// element. Throws InputError for a file without temperatures.
void colour_by_temperature(const results::ResultsReader& reader, const results::Frame& frame, Scene& scene);

/// Adds the cells of joints with water, with their pressure [Pa]. Throws InputError for a file without water in joints
/// between bodies.
void colour_by_water(const results::ResultsReader& reader, const results::Frame& frame, Scene& scene);

}  // namespace trilith::draw
