// Contents of a picture of a results file in addition to bodies: cracks, stress, the line of thrust, magnified
// displacements.
#pragma once

#include <string>
#include <string_view>

#include "draw/scene/scene_picture.hpp"
#include "results/file/results.hpp"

namespace trilith::draw {

/// Multiplies displacements and rotations from the start by `factor`; contacts are removed, because they have no
/// position then.
void magnify(const results::Header& header, results::Frame& frame, double factor);

/// Names of stresses: "minor", "major", "xx", "yy", "xy", in space also "zz", "yz", "zx".
const std::vector<std::string>& stress_names();
/// Text of one of them in a legend.
std::string stress_label(std::string_view name, int dim);

/// Sets the value of each free body to its mean stress. Throws InputError for another name, and without stress in the
/// file.
void colour_by_stress(const results::Header& header, const results::Frame& frame, std::string_view name, Scene& scene);

/// Adds a mark for each joint that has lost part of its bond: opened if its opening is at least its slip, otherwise
/// slid. Throws InputError if the file has no joints. Joints of bodies that are not drawn (`left_out`: [body]) are
/// omitted.
void add_cracks(const results::Header& header, const results::Frame& frame, const std::vector<bool>& left_out,
                Scene& scene);

/// Adds the line of thrust through the bodies of `group`, in their order: the points of action of the forces between
/// neighbours, interrupted between neighbours without contact. Throws InputError if the group is empty.
void add_thrust_line(const results::Header& header, const results::Frame& frame, std::string_view group, Scene& scene);

}  // namespace trilith::draw
