// Courses in time that wait while a load path is followed.
#pragma once

#include "model/model.hpp"

namespace trilith {

/// Shifts all that goes by time (motions, courses of loads, growth and turn of gravity) by `by` [s]: at a time later by
/// that much the model is as it was.
template <int D>
void postpone_courses(Model<D>& model, double by);

/// True where a body is still to follow a motion, or a load still to change, after `now` [s].
template <int D>
bool has_courses_to_come(const Model<D>& model, double now);

}  // namespace trilith
