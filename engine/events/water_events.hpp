// Events of joints with uplift (load/water/uplift.hpp).
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// A joint that opens at its heel is flooded, and drained when it is closed there again. Writes State::flooded.
template <int D>
void water_events(const Model<D>& model, State<D>& state, Work<D>& work);

}  // namespace trilith
