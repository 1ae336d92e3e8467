// What a picture of a results file shows beside bodies: cracks, stress, the line of thrust, displacements made larger.
#pragma once

#include <string>
#include <string_view>

#include "draw/scene/scene_picture.hpp"
#include "results/file/results.hpp"

namespace trilith::draw {

/// Displacements and turns since the start times `factor`; contacts are dropped, as they have no place then.
void magnify(const results::Header& header, results::Frame& frame, double factor);

/// Names that colour_by_stress takes: "minor", "major", "xx", "yy", "xy".
const std::vector<std::string>& stress_names();

/// Gives each free body its mean stress as its value. Throws InputError for another name, and where the file has none.
void colour_by_stress(const results::Header& header, const results::Frame& frame, std::string_view name, Scene& scene);

/// A mark on each joint that has lost some of its bond: opened where its opening is at least its slip, else slid.
/// Throws InputError where the file has no joints. Those of bodies that are not there (`left_out`: [body]) have none.
void add_cracks(const results::Header& header, const results::Frame& frame, const std::vector<bool>& left_out,
                Scene& scene);

/// The line of thrust through the bodies of `group`, in their order: the points in which the forces between neighbours
/// act, broken where two do not touch. Throws InputError where no body is in it.
void add_thrust_line(const results::Header& header, const results::Frame& frame, std::string_view group, Scene& scene);

}  // namespace trilith::draw
