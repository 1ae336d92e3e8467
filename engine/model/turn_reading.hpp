// Reading of the rotation of a body in space: a rotation vector that is continuous where the shortest one would jump.
//
// A rotation matrix does not determine the number of full turns. Two other data do. The quaternion of a node changes by
// small rotations and keeps its sign, so one full turn differs from none. A drive integrates its rotation. So the
// reading is continuous for any number of turns of a body whose rotations are held or driven. For a freely rotating
// body it is continuous up to one full turn (2 pi), where the rotation vector restarts from the other side.
#pragma once

#include "model/pose.hpp"

namespace trilith {

/// Rotation vector of a body from the start [rad].
Vec3 turn_reading(const Model<3>& model, const State<3>& state, int body);

/// Start value of a drive along direction `dof` of a body: its position [m] or rotation reading [rad].
double drive_origin(const Model<2>& model, const State<2>& state, int body, int dof);
double drive_origin(const Model<3>& model, const State<3>& state, int body, int dof);

}  // namespace trilith
