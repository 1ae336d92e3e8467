// Two solids whose faces are bonded by mortar: a bond over each patch of the area that they shared when it set.
//
//          b
//      ____________________
//     |____|____|____|_  _|
//          a       ->  crack from one side
//
// Input: poses and motions of both bodies, the joint's memory, the law. Output: forces, the remaining bond of each
// patch, and the dissipated energies. Each patch opens, slips and turns with the two bodies and loses its bond
// separately (contact/joint/joint_patch.hpp). A patch without bond carries pressure and friction in place.
//
// The joint ends, and the two become ordinary solids, once no patch is bonded and the faces have moved away. They have
// if they are separated, have slid by a hundredth of their width, or are tilted more than faces that lie flat.
#pragma once

#include <vector>

#include "contact/joint/joint_memory.hpp"
#include "contact/joint/joint_plan.hpp"
#include "contact/space/solid_contact.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Result of a joint step.
struct JointResponse {
  SolidResponse contact;  ///< its moment is about the centroid of the joint, which is its centre
  bool ends = false;      ///< ordinary solids from now on; `contact.memory` is for them
  bool changed = false;   ///< a bond was lost, or damaged for the first time
};

/// One step. `before`: the contact's memory; `after`: the joint's memory after the step.
JointResponse respond_joint(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                            const JointMemory& joint, const LawInUse& law, JointMemory& after);

/// Elastic energy of a joint, of its pressure and of its shear [J].
double joint_energy(const JointMemory& joint, const LawInUse& law);

/// Normal stresses of a joint without damping, compression positive: force [N], and moment about the origin of the
/// joint [N m]. One for each patch, or one for the whole joint while it is intact.
std::vector<PatchStress> patch_stresses(const JointMemory& joint, const LawInUse& law);

/// Magnitude of the joint's force in its last step [N]: pressure, shear and both dampings, minus the part that softened
/// by sliding in that step. `contact`: the contact's memory before that step.
double carried_force(const JointMemory& joint, const SolidMemory& contact, const LawInUse& law);

/// Events of a joint between two instants.
JointChange joint_change(const JointMemory& before, const JointMemory& now);

/// Mortar of a law sets between faces in their present position, undamaged. The shear carried by the contact is kept
/// (contact/joint/setting_shear.hpp).
JointMemory set_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                      const ContactLaw& law);

}  // namespace trilith
