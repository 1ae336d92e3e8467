// Mass of a body in a results file.
#pragma once

#include "results/file/results.hpp"

namespace trilith::results {

/// Sum over the nodes of `body`, a row of `header` [kg].
inline double mass_of(const Header& header, const BodyRow& body) {
  double mass = 0;
  for (int n = body.first_node; n < body.first_node + body.node_count; ++n) mass += header.node_mass[n];
  return mass;
}

}  // namespace trilith::results
