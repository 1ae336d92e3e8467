// The numbers of an element in Model::element_number, in order:
//
//     shape      8: nodes of the reference shape relative to their mean, x0, y0, x1, ... [m]
//     gradient   8: mean gradients of the shape functions, x0, y0, x1, ... [1/m]
//     stiffness  8 x 8, by columns, times the thickness [N/m]
//
// If the solid is inelastic, for each of its integration points also:
//
//     strain     8 x 3: column i has (xx, yy, xy) per unit of deformation i [1/m]
//     volume     1: area times thickness [m3]
#pragma once

#include "element/solid/plane_element.hpp"
#include "model/model.hpp"

namespace trilith {

inline constexpr int element_shape_numbers = 16, element_stiffness_numbers = 64, element_point_numbers = 25;

/// Strain field of an element's reference shape.
ElementStrain element_strain(std::span<const Vec2> corners, const Solid& solid);

/// Appends an element to the model: its numbers, the mass of its nodes, the rate bound of its body, and its batch.
/// `mass` is its total mass [kg].
void append_element(Model<2>& model, Element element, double density);

}  // namespace trilith
