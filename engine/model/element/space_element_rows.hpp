// The numbers of an element in space in Model::element_number, in order, with n nodes:
//
//     shape      3 n: nodes of the reference shape relative to their mean [m]
//     gradient   3 n: mean gradients of the shape functions [1/m]
//     stiffness  3 n x 3 n, by columns [N/m]
//
// If the solid is inelastic, for each of its integration points also:
//
//     strain     6 x 3 n, by columns: (xx, yy, zz, xy, yz, zx) per unit of each deformation [1/m]
//     volume     1: weight of the point [m3]
#pragma once

#include <span>

#include "element/solid/space_element.hpp"
#include "model/model.hpp"

namespace trilith {

/// Numbers for one point of an element with `nodes` nodes.
constexpr int space_point_numbers(int nodes) {
  return 18 * nodes + 1;
}

/// Strain field of an element's reference shape.
SpaceElementStrain element_strain(ElementShape shape, std::span<const Vec3> nodes, const Solid& solid);

/// Appends an element, whose nodes are in the model: its numbers, the mass of its nodes, and the rate bound of its
/// body.
void append_element(Model<3>& model, SpaceElement element, double density);

/// Appends the contact piece of an element, with the fits of its faces. `surface`: [face] of its shape, which of them
/// belong to the body's skin.
void append_element_piece(Model<3>& model, const SpaceElement& element, std::span<const std::uint8_t> surface);

}  // namespace trilith
