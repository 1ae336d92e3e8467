// Joints of solids in space: where plane faces of two bodies lie on each other at the start; how far each has opened
// and slipped since. As run/record/joints.hpp in the plane.
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "contact/joint/joint_plan.hpp"
#include "run/record/joints.hpp"

namespace trilith {

/// Two plane faces that lie on each other at the start.
struct FaceJoint {
  ContactKey contact = 0;  ///< its contact's memory in State
  int body_a = -1, body_b = -1;
  std::array<int, 2> contact_frame{};  ///< what its place in either body goes with (model/contact/contact_frame.hpp)
  JointSeat in_a, in_b;       ///< its place and axes there, the third from a to b: at the start one in the world
  std::vector<Vec2> outline;  ///< the polygon that the faces share, in these axes [m]
  Vec3 place = Vec3::Zero();  ///< its middle at the start [m]
  std::array<Vec3, 2> end{Vec3::Zero(), Vec3::Zero()};  ///< ... and where its longer axis ends [m]
  double area = 0;                                      ///< [m2]
  bool bonded = false;                                  ///< mortar held it at the start
};

inline bool is_bonded(const FaceJoint& joint) {
  return joint.bonded;
}

template <int D>
using JointOf = std::conditional_t<D == 2, Joint, FaceJoint>;

/// All joints of the model where it starts, in the order of their contacts. Joints that a bearing stands for, and those
/// of spheres, are left out.
std::vector<FaceJoint> find_joints(const Model<3>& model);
/// The same where its bodies are by `state`, of bodies from `first_body` on with any: their start.
std::vector<FaceJoint> find_joints(const Model<3>& model, const State<3>& state, int first_body);

/// Opening at the corner of the shared polygon where it is widest, and slip of its middle, as a length.
JointDisplacement joint_displacement(const FaceJoint& joint, const Model<3>& model, const State<3>& state,
                                     const Work<3>& work);

/// The share of its area whose bond is lost: 0 whole, 1 all; patches that soften count by what they have lost. 0 for a
/// joint without a bond.
double joint_damage(const FaceJoint& joint, const State<3>& state);

/// Where the joint's middle is now: on body a [m].
Vec3 joint_middle(const FaceJoint& joint, const Model<3>& model, const State<3>& state);

}  // namespace trilith
