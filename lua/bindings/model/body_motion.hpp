// Where a body of a script's model is and how it moves, in the plane and in space alike.
#pragma once

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// Where a body is and how it moves, in the plane with z = 0 and turning about z.
struct BodyMotion {
  Vec3 place = Vec3::Zero(), moved = Vec3::Zero();  ///< of its centroid, and since the start [m]
  Vec3 turned = Vec3::Zero();                       ///< rotation vector since the start [rad]
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

/// Before the first stage, and of a body that is not in the model yet, as it was described.
BodyMotion motion_of(const BodyHandle& b);

}  // namespace trilith::script
