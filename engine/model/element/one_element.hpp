// Bodies of one finite element, which have the rotary inertia of the body (assembly/element/rotary_inertia.hpp).
#pragma once

#include <vector>

#include "model/model.hpp"

namespace trilith {

/// True for a body of one element with corrected rotary inertia: a quad or triangle, in space a brick or a tetrahedron
/// of four nodes. False for a mesh of one quadrilateral or brick: a part of a mesh that has cracked keeps the inertia
/// of its nodal masses, so that its angular momentum remains.
bool is_one_element(const Model<2>& model, int body);
bool is_one_element(const Model<3>& model, int body);

/// The first element of a body that has elements.
template <class E>
const E& first_element(const std::vector<E>& elements, int body);

}  // namespace trilith
