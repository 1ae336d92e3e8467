// Bonds whose work an explicit step has skipped.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Adds an event bond_skipped to Work::events for each joint that missed more than a tenth of its fracture energy at
/// some place. The step is the explicit one evaluated last. A joint may miss more while this is a small share of the
/// kinetic energy of its bodies, as in any step. The value is the missing work of the whole joint [J]. It is below 0
/// where the step did more work than the law. Call it before the step is committed. `is_given`: the stage has a `dt`.
template <int D>
void add_skipped_bonds(const Model<D>& model, const State<D>& state, Work<D>& work, bool is_given);

}  // namespace trilith
