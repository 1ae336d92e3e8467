// Voronoi cells of points within a polygon, and the joining of corners that lie near each other.
#pragma once

#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// For each point the part of the outline (simple, counter-clockwise) that is nearer to it than to any other, by more
/// than `set_back` (m, not below 0; 0: cells touch): one polygon, or several or none where the outline is concave. By
/// cutting with the bisectors of the nearest points until no farther one can matter.
std::vector<std::vector<Polygon>> voronoi_cells(const Polygon& outline, const std::vector<Vec2>& points,
                                                double set_back);

/// Cells that fill an outline, made to share corners: corners nearer than `same` become one, and then faces shorter
/// than `least_edge` are taken out, shortest first, by joining their ends (in the middle; on the outline where one end
/// is on it; at its corner where one is there; not at all where both ends are held apart). A cell that loses all but
/// two corners is left out: its neighbours fill it.
std::vector<Polygon> join_corners(const std::vector<Polygon>& cells, const Polygon& outline, double same,
                                  double least_edge);

}  // namespace trilith
