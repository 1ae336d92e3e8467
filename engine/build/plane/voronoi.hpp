// Voronoi cells of points within a polygon, and merging of nearby corners.
#pragma once

#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// For each point the part of the outline (simple, counter-clockwise) that is nearer to it than to any other by more
/// than `set_back` [m], not below 0; 0: cells touch. The result is one polygon, or several or none for a concave
/// outline. Cells are cut by the bisectors of the nearest points until no farther point can matter.
std::vector<std::vector<Polygon>> voronoi_cells(const Polygon& outline, const std::vector<Vec2>& points,
                                                double set_back);

/// Merges the corners of cells that fill an outline. Corners nearer than `same` are merged. Then faces shorter than
/// `least_edge` are removed, shortest first, by merging their ends: in the middle, on the outline if one end is on it,
/// or at its corner if one end is there. A face with two constrained ends remains. A cell with at most two remaining
/// corners is removed; its neighbours fill it.
std::vector<Polygon> join_corners(const std::vector<Polygon>& cells, const Polygon& outline, double same,
                                  double least_edge);

}  // namespace trilith
