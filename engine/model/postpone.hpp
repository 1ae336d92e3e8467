// Time courses that are suspended while a load path is followed.
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Shifts all functions of time (motions, load curves, growth and rotation of gravity) by `by` [s]: the model after
/// this time is as it was before.
template <int D>
void postpone_courses(Model<D>& model, double by);

/// True where a motion or a change of a load continues after `now` [s].
template <int D>
bool has_courses_to_come(const Model<D>& model, double now);

}  // namespace trilith
