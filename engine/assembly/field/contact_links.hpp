// Links of a field across contacts, from the contacts of an evaluation.
#pragma once

#include <vector>

#include "field/field.hpp"
#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Links of all closed parts of joints between bodies with cells, merged. Two faces are closed where their gap is at
/// most closed_gap, or where mortar holds; a joint that a bearing replaces has no link. The flow through a face is
/// integrated with the shape functions of both sides, so that faces of meshes need not match. Pairs, skin points or
/// placed solids, and trial memories of contacts must be up to date.
std::vector<FieldLink> contact_links(const Field& field, const Model<2>& model, const Work<2>& work);
std::vector<FieldLink> contact_links(const Field& field, const Model<3>& model, const Work<3>& work);

}  // namespace trilith
