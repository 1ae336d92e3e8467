// How much of critical damping the contacts of a model have as it stands at its start.
#pragma once

#include <vector>

#include "run/record/face_joints.hpp"

namespace trilith {

struct ContactDamping {
  int body_a = -1, body_b = -1;
  int law = -1;          ///< index into Model::laws
  double frequency = 0;  ///< of the two bodies against each other along the normal: sqrt(kn area/mass) [rad/s]
  double share = 0;      ///< of critical damping: beta times frequency over 2 [1]
};

/// Of each joint in which a body is free to move and a law holds. The mass is that of the one that moves, or m1 m2/(m1
/// + m2) where both do.
template <int D>
std::vector<ContactDamping> contact_damping(const Model<D>& model, const std::vector<JointOf<D>>& joints);

}  // namespace trilith
