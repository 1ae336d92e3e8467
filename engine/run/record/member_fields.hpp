// Members of frames in a results file: their rows in the header, and their forces and yielding in each frame.
#pragma once

#include <vector>

#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// Adds the members and beams of all frames to a header that contains the bodies. It also adds fields of the frames,
/// each with a row for each beam.
/// `member_force`: in the plane normal force, shear force, moment at its start, moment at its end [N, N m]. In space
/// normal force, shear along y and z, torque, moments about y and z at its start, then at its end. Signs as in
/// readings/member_forces.hpp.
/// `member_state`: of both ends, 0 elastic, 1 yielded, 2 without moment, 3 removed. Only if a member can yield.
/// `member_deformation`: of both ends, plastic rotation of a hinge [rad], or largest curvature of the fibre sections in
/// that half [1/m]. In space the length of both components. Only if a member can yield.
template <int D>
void describe_members(const Model<D>& model, results::Header& header);

/// Appends the values of these fields at this instant.
template <int D>
void take_members(const Instant<D>& now, std::vector<std::vector<double>>& fields);

/// The second figure of an event member.yielded: the largest curvature along the beam of fibres at the event's place
/// [1/m], or the chord rotation at which a hinge yields [rad].
template <int D>
results::Figure figure_at_yield(const Instant<D>& now, const Event& event);

}  // namespace trilith
