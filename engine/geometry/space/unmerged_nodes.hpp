// The remedy for a mesh with unconnected parts, for messages.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace trilith {

/// Coincident nodes (within 1e-9 of the mesh's size) are to be merged; if there are none, each part is a separate body.
template <class Vec>
std::string unmerged_nodes(const std::vector<Vec>& nodes) {
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nodes[a].x() < nodes[b].x(); });
  double size = 0;
  for (const Vec& node : nodes) size = std::max(size, (node - nodes.front()).norm());
  const double near = 1e-9 * size;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && nodes[order[j]].x() - nodes[order[i]].x() <= near; ++j)
      if ((nodes[order[j]] - nodes[order[i]]).norm() <= near)
        return fmt::format(
            "nodes {} and {} are at the same place: merge such nodes in the mesh generator (in Gmsh: Coherence), or "
            "make each part a body",
            std::min(order[i], order[j]) + 1, std::max(order[i], order[j]) + 1);
  return "make each part a body";
}

}  // namespace trilith
