// Thermal strain of elements and beams: their deformation without stress as a function of their temperatures.
#pragma once

#include "field/field.hpp"
#include "model/model.hpp"

namespace trilith {

/// Shape functions of the nodes of an element, a column each, at its integration points, a row each.
Eigen::MatrixXd point_values(const Element& e);
Eigen::MatrixXd point_values(const SpaceElement& e);

/// Adds the rows of the elements or beams of a body whose cells exist. Throws InputError for a material that yields in
/// plane strain.
void add_free_shapes(Field& field, const Model<2>& model, const FieldBody& row);
void add_free_shapes(Field& field, const Model<3>& model, const FieldBody& row);

}  // namespace trilith
