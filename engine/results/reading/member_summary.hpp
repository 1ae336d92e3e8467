// Extremes of the members of frames over a run: section forces, yielding, ductility demand and drift.
#pragma once

#include <optional>
#include <vector>

#include "results/reading/member_values.hpp"
#include "results/reading/reader.hpp"

namespace trilith::results {

/// A value with its time [s] and its place along the member [m].
struct MemberExtreme {
  double value = 0, time = 0, along = 0;
};

struct MemberSummary {
  std::vector<MemberExtreme> low, high;      ///< of each of member_quantities(dim)
  MemberState state = MemberState::elastic;  ///< worst state of its ends in the last frame
  int yielded = 0, can_yield = 0;            ///< hinges or beams of fibres that have yielded, and their number
  MemberExtreme deformation;                 ///< largest magnitude: plastic rotation [rad] or curvature [1/m]
  std::optional<double> ductility;           ///< demand, see member_summaries; none: it has not yielded
  std::optional<MemberExtreme> drift;        ///< of an upright member: see member_summaries
};

/// Over all recorded frames, [member]. Ductility demand of fibres: the largest curvature over the curvature at which
/// the first fibre of the member yielded (figure 2 of its first event member.yielded). Of a hinge: 1 + plastic rotation
/// over the chord rotation at yield, M L / (6 EI). Drift of a member within 45 degrees of the vertical: displacement of
/// its end relative to its start, horizontally, over its height.
std::vector<MemberSummary> member_summaries(const ResultsReader& reader, const std::vector<EventRow>& events);

}  // namespace trilith::results
