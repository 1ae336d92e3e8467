// Joints: where faces of two bodies lie on each other at the start; how far each has opened and slipped since.
#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// An end of a joint: a point on the skin of each of the two bodies, between two of its skin points.
struct JointEnd {
  double share_a = 0, share_b = 0;  ///< of the way from a0 to a1, from b0 to b1 [1]
  double gap = 0, slip = 0;         ///< of b's point from a's at the start, along normal and face [m]
};

/// Two faces that lie on each other at the start.
struct Joint {
  ContactKey contact = 0;  ///< its contact's memory in State
  int body_a = -1, body_b = -1;
  int a0 = 0, a1 = 0, b0 = 0, b1 = 0;  ///< skin points of the two faces
  std::array<JointEnd, 2> end;
  std::array<Vec2, 2> place{Vec2::Zero(), Vec2::Zero()};  ///< of its ends at the start [m]
  std::uint32_t bonds = 0;                                ///< halves that are bonded at the start: 0, 1 or 2 bits
};

/// Whether mortar held it at the start, at one of its ends at least.
inline bool is_bonded(const Joint& joint) {
  return joint.bonds != 0;
}

/// What became of a joint.
struct JointDisplacement {
  /// The farthest distance of a point of b's face from where it was, along the normal of a's; + is open [m].
  double opening = 0;
  double slip = 0;  ///< of the middle along a's face; in the plane + towards a's next corner [m]
};

/// All joints of the model where it starts, sorted by contact. Joints that a bearing stands for are left out.
std::vector<Joint> find_joints(const Model<2>& model);
/// The same where its bodies are by `state`, of bodies from `first_body` on with any: their start.
std::vector<Joint> find_joints(const Model<2>& model, const State<2>& state, int first_body);

/// From the places of the skin points in `work`, which must be those of the present instant. Once the bodies have come
/// far apart it says how far, no more.
JointDisplacement joint_displacement(const Joint& joint, const Work<2>& work);
inline JointDisplacement joint_displacement(const Joint& joint, const Model<2>& /*model*/, const State<2>& /*state*/,
                                            const Work<2>& work) {
  return joint_displacement(joint, work);
}

/// The part of a joint's bond that is lost: 0 whole, 0.5 one half, 1 all; 0 for a joint without a bond.
double joint_damage(const Joint& joint, const State<2>& state);

/// Where the joint's ends are now: on the skin of body a [m].
std::array<Vec2, 2> joint_place(const Joint& joint, const Work<2>& work);

}  // namespace trilith
