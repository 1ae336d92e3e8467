// What became of a building, storey by storey: joints that came apart, units that left their place.
#pragma once

#include <vector>

#include "run/findings.hpp"

namespace trilith {

/// From which displacement on a joint is apart and a unit is out of place.
struct DamageLimits {
  double apart = 0.0127;         ///< opening, or slip either way, of a joint [m]: half an inch
  double out_of_place = 0.0254;  ///< way of a unit [m]: an inch
};

struct StoreyDamage {
  int storey = 0;              ///< its number, from 1 at the bottom
  int joints = 0;              ///< those that were there at the start
  int joints_apart = 0;        ///< opened or slipped by more than the limit since then
  int units = 0;               ///< bodies of its group "units"
  int units_out_of_place = 0;  ///< whose centroid has moved sideways, against what the storey stands on, by more than
                               ///< the limit, or has come down by more than it since the start
};

/// Of the storeys that `bodies` (rising) belong to, lowest first; joints are those between two of them, and of the
/// storey that storey_between() says. A storey stands on the top of the one below, or on the base. `work` must be of
/// the present instant.
template <int D>
std::vector<StoreyDamage> damage_by_storey(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const std::vector<int>& bodies, const Findings<D>& findings,
                                           const DamageLimits& limits);

}  // namespace trilith
