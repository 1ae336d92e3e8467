// Masses of the bodies, which the limits of the time step at impacts refer to.
#pragma once

#include "model/model.hpp"
#include "model/work.hpp"

namespace trilith {

/// Fills the masses of work.impacts.
template <int D>
void list_masses(const Model<D>& model, Work<D>& work);

}  // namespace trilith
