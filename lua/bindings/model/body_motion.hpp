// Position and motion of a body of a script's model, in the plane and in space.
#pragma once

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// Position and motion of a body; in the plane z = 0 and the rotation is about z.
struct BodyMotion {
  Vec3 place = Vec3::Zero(), moved = Vec3::Zero();  ///< of its centroid, and displacement from the start [m]
  Vec3 turned = Vec3::Zero();                       ///< rotation vector from the start [rad]
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

/// Before the first stage, and for a body that is not in the model yet, from its description.
BodyMotion motion_of(const BodyHandle& b);

}  // namespace trilith::script
