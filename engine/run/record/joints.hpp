// Joints in the plane: faces of two bodies that lie on each other at the start, with the opening and slip of each.
#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// End of a joint: a point on the skin of each of the two bodies, between two of its skin points.
struct JointEnd {
  double share_a = 0, share_b = 0;  ///< position between a0 and a1, and between b0 and b1 [1]
  double gap = 0, slip = 0;         ///< offset of b's point from a's at the start, along normal and face [m]
};

/// Two faces that lie on each other at the start.
struct Joint {
  ContactKey contact = 0;  ///< key of its contact memory in State
  int body_a = -1, body_b = -1;
  int a0 = 0, a1 = 0, b0 = 0, b1 = 0;  ///< skin points of the two faces
  std::array<JointEnd, 2> end;
  std::array<Vec2, 2> place{Vec2::Zero(), Vec2::Zero()};  ///< positions of its ends at the start [m]
  std::uint32_t bonds = 0;                                ///< bits of the halves that are bonded at the start: 0, 1 or
                                                          ///< 2 bits
};

/// True if mortar bonds at least one end at the start.
inline bool is_bonded(const Joint& joint) {
  return joint.bonds != 0;
}

/// Opening and slip of a joint.
struct JointDisplacement {
  /// Largest displacement of a point of b's face along the normal of a's face; positive if open [m].
  double opening = 0;
  double slip = 0;  ///< slip of the middle along a's face; in the plane positive towards a's next corner [m]
};

/// All joints of the model in its initial position, sorted by contact. Joints that a bearing represents are omitted.
std::vector<Joint> find_joints(const Model<2>& model);
/// As above, for bodies positioned by `state`; only joints with a body from `first_body` on. `state` is their start.
std::vector<Joint> find_joints(const Model<2>& model, const State<2>& state, int first_body);

/// From the skin points in `work`, which must be evaluated at the present instant. For bodies far apart it is merely a
/// distance.
JointDisplacement joint_displacement(const Joint& joint, const Work<2>& work);
inline JointDisplacement joint_displacement(const Joint& joint, const Model<2>& /*model*/, const State<2>& /*state*/,
                                            const Work<2>& work) {
  return joint_displacement(joint, work);
}

/// Lost share of a joint's bond: 0 intact, 0.5 one half, 1 all; 0 for a joint without a bond.
double joint_damage(const Joint& joint, const State<2>& state);

/// Present positions of the joint's ends, on the skin of body a [m].
std::array<Vec2, 2> joint_place(const Joint& joint, const Work<2>& work);

}  // namespace trilith
