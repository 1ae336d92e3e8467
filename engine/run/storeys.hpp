// Storeys of a building, from the groups "storey 1", "storey 2", ... of its bodies: drift.
#pragma once

#include <string>
#include <vector>

#include "world/model.hpp"
#include "world/state.hpp"

namespace trilith {

struct Storey {
  int number = 0;
  std::vector<int> bodies;        ///< all of it
  std::vector<int> top;           ///< its slabs (group "slabs" or "slab"), or else its topmost bodies
  double bottom = 0, height = 0;  ///< at the start, from the top of the storey below (or its own lowest point) [m]
};

/// Lowest first; a storey without a body in between is not there. Bodies of several walls that stand beside each other
/// with the same groups make one storey.
std::vector<Storey> find_storeys(const Model<2>& model);

/// Bodies the structure stands on: group "base", or where there is none all that are not free to move along x.
std::vector<int> find_base(const Model<2>& model);

/// Number of the storey that a group names ("storey 2"), 0: none does.
int storey_in(const std::vector<std::string>& groups);

/// Number of the storey that `body` belongs to, 0: none.
int storey_of(const Model<2>& model, int body);

/// Mean horizontal displacement of the bodies' nodes since the start [m]; 0 for none.
double mean_sway(const Model<2>& model, const State<2>& state, const std::vector<int>& bodies);

/// Horizontal displacement of a storey's top against that of the storey below, or of the base [m]. `index` into
/// `storeys`.
double storey_drift(const Model<2>& model, const State<2>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index);

/// Of the topmost storey against the base [m]; 0 without storeys.
double top_drift(const Model<2>& model, const State<2>& state, const std::vector<Storey>& storeys,
                 const std::vector<int>& base);

}  // namespace trilith
