// Stiffness bounds of bodies lying on their stiffest faces: a contact that forms before the next estimate of the stable
// step finds a step that is short enough.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Fills work.face_bound (every body on its stiffest face) and work.around_bound.
void bound_faces(const Model<2>& model, Work<2>& work);
void bound_faces(const Model<3>& model, Work<3>& work);

}  // namespace trilith
