// The turn of a body in space as it is read: a rotation vector that goes on where a shortest one would jump.
//
// A rotation does not say how often it has gone round. Two things do:
// - the quaternion of a node changes by small rotations and keeps its sign, so that one whole turn is told from none;
// - a drive counts the turn it makes.
// So the reading of a body whose turns are held or driven is continuous for any number of turns, and the reading of a
// body that turns freely up to one whole turn (2 pi), where the rotation vector starts again from the other side.
#pragma once

#include "model/pose.hpp"

namespace trilith {

/// Rotation vector of a body's turn since the start [rad].
Vec3 turn_reading(const Model<3>& model, const State<3>& state, int body);

/// Where a drive of direction `dof` of a body begins: its place [m] or turn reading [rad].
double drive_origin(const Model<2>& model, const State<2>& state, int body, int dof);
double drive_origin(const Model<3>& model, const State<3>& state, int body, int dof);

}  // namespace trilith
