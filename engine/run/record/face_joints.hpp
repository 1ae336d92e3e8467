// Joints in space: plane faces of two bodies that lie on each other at the start, with the opening and slip of each.
// The plane version is run/record/joints.hpp.
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "contact/joint/joint_plan.hpp"
#include "run/record/joints.hpp"

namespace trilith {

/// Two plane faces that lie on each other at the start.
struct FaceJoint {
  ContactKey contact = 0;  ///< key of its contact memory in State
  int body_a = -1, body_b = -1;
  std::array<int, 2> contact_frame{};  ///< contact frames that its place moves with, by body
                                       ///< (model/contact/contact_frame.hpp)
  JointSeat in_a, in_b;       ///< place and axes in each frame, the third axis from a to b; equal in the world at the
                              ///< start
  std::vector<Vec2> outline;  ///< polygon that the faces share, in these axes [m]
  Vec3 place = Vec3::Zero();  ///< middle of the polygon at the start [m]
  std::array<Vec3, 2> end{Vec3::Zero(), Vec3::Zero()};  ///< ends of its longer axis at the start [m]
  double area = 0;                                      ///< [m2]
  bool bonded = false;                                  ///< bonded by mortar at the start
};

inline bool is_bonded(const FaceJoint& joint) {
  return joint.bonded;
}

template <int D>
using JointOf = std::conditional_t<D == 2, Joint, FaceJoint>;

/// All joints of the model in its initial position, in the order of their contacts. Joints that a bearing represents
/// and joints of spheres are omitted.
std::vector<FaceJoint> find_joints(const Model<3>& model);
/// As above, for bodies positioned by `state`; only joints with a body from `first_body` on. `state` is their start.
std::vector<FaceJoint> find_joints(const Model<3>& model, const State<3>& state, int first_body);

/// Opening at the widest corner of the shared polygon, and slip of its middle as a length.
JointDisplacement joint_displacement(const FaceJoint& joint, const Model<3>& model, const State<3>& state,
                                     const Work<3>& work);

/// Share of the area without bond: 0 intact, 1 fully lost. Softening patches count by their loss of strength. 0 for a
/// joint without a bond.
double joint_damage(const FaceJoint& joint, const State<3>& state);

/// Present position of the joint's middle, on body a [m].
Vec3 joint_middle(const FaceJoint& joint, const Model<3>& model, const State<3>& state);

}  // namespace trilith
