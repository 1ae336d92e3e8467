// Quantities that colour bodies in a picture of a results file, in the plane and in space.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/scene/scene_picture.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

/// Sets the value of each free body by one of colour_names() other than "group". The displacement is of its first node
/// from the start. The damage is the mean lost share of the bonds of its joints. The pressure, in space only, is the
/// largest mean pressure of its contacts. Temperature and water: see draw/results/field_colours.hpp. Throws InputError
/// for an unknown name, and where the file does not have the data.
void colour_bodies(const results::ResultsReader& reader, const results::Frame& frame, const std::string& by,
                   Scene& scene);

/// Sets the value of each free body of a model in space to a component of its mean stress, or a principal value:
/// "minor" or "major". Of bodies with elements the stress is recorded. Of rigid bodies it follows from the contact
/// forces: the sum of arm times force over the volume (Love 1892, Weber 1966), without weight and inertia.
void colour_by_space_stress(const results::Header& header, const results::Frame& frame, std::string_view name,
                            Scene& scene);

}  // namespace trilith::draw
