// Damping ratios of the contacts of a model in its initial position.
#pragma once

#include <vector>

#include "run/record/face_joints.hpp"

namespace trilith {

struct ContactDamping {
  int body_a = -1, body_b = -1;
  int law = -1;          ///< index into Model::laws
  double frequency = 0;  ///< natural frequency of the two bodies against each other along the normal: sqrt(kn
                         ///< area/mass) [rad/s]
  double share = 0;      ///< share of critical damping: beta times frequency over 2 [1]
};

/// Damping ratio of each joint that has a law and at least one free body. The mass is the mass of the moving body, or
/// m1 m2/(m1 + m2) if both move.
template <int D>
std::vector<ContactDamping> contact_damping(const Model<D>& model, const std::vector<JointOf<D>>& joints);

}  // namespace trilith
