// The numbers that an element in space has in Model::element_number, one after the other, n being its nodes:
//   shape      3 n: nodes of the reference shape from their mean [m]
//   gradient   3 n: mean gradients of the shape functions [1/m]
//   stiffness  3 n x 3 n, column by column [N/m]
// and where the solid is inelastic, for each of its points:
//   strain     6 x 3 n, column by column: what (xx, yy, zz, xy, yz, zx) follow from each deformation [1/m]
//   volume     1: that it stands for [m3]
#pragma once

#include <span>

#include "element/solid/space_element.hpp"
#include "model/model.hpp"

namespace trilith {

/// Numbers of one point of an element of `nodes`.
constexpr int space_point_numbers(int nodes) {
  return 18 * nodes + 1;
}

/// Strain field of an element's reference shape.
SpaceElementStrain element_strain(ElementShape shape, std::span<const Vec3> nodes, const Solid& solid);

/// Adds an element, whose nodes are in the model, with its numbers, its mass to that of its nodes, and its bound to
/// that of its body.
void append_element(Model<3>& model, SpaceElement element, double density);

/// Adds the piece that an element is for contact, with the fits of its faces. `surface`: [face] of its shape, which of
/// them are part of the skin of the body.
void append_element_piece(Model<3>& model, const SpaceElement& element, std::span<const std::uint8_t> surface);

}  // namespace trilith
