// Damage of a building by storey: joints that have come apart, and displaced units.
#pragma once

#include <vector>

#include "run/findings.hpp"

namespace trilith {

/// Displacements beyond which a joint is apart and a unit is out of place.
struct DamageLimits {
  double apart = 0.0127;         ///< opening, or slip in either sense, of a joint [m]: half an inch
  double out_of_place = 0.0254;  ///< displacement of a unit [m]: an inch
};

struct StoreyDamage {
  int storey = 0;              ///< storey number, from 1 at the bottom
  int joints = 0;              ///< number of joints at the start
  int joints_apart = 0;        ///< joints that opened or slipped by more than the limit
  int units = 0;               ///< bodies of the group "units"
  int units_out_of_place = 0;  ///< units whose centroid moved by more than the limit sideways, relative to the floor
                               ///< below the storey, or downward from the start
};

/// Damage of the storeys that `bodies` (sorted) belong to, lowest first. Joints lie between two of these bodies and
/// belong to the storey that storey_between() returns. A storey stands on the top of the storey below, or on the base.
/// `work` must be evaluated at the present instant.
template <int D>
std::vector<StoreyDamage> damage_by_storey(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const std::vector<int>& bodies, const Findings<D>& findings,
                                           const DamageLimits& limits);

}  // namespace trilith
