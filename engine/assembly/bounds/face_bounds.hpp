// Stiffness bounds of bodies in contact along their stiffest faces. With them the step is short enough for a contact
// that forms before the next estimate of the stable step.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Fills work.face_bound (each body in contact along its stiffest face) and work.around_bound.
void bound_faces(const Model<2>& model, Work<2>& work);
void bound_faces(const Model<3>& model, Work<3>& work);

}  // namespace trilith
