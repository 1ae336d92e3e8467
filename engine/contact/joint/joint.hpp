// Two solids whose faces mortar holds together: a bond over each patch of the area they shared as it set.
//
//        b                          What comes in: poses and motions of both bodies, what the joint remembers, law.
//    ____________________           What goes out: the forces, what is left of each patch's bond, and the energies
//   |____|____|____|_  _|           given off. Each patch opens, slips and turns with the two bodies and loses its
//        a       ->  crack from     bond for itself (contact/joint/joint_patch.hpp); one that has lost it presses and
//        rubs
//                    one side       where it stands.
//
// The joint ends, and the two go on as any other solids, once no patch holds and the faces have parted, slid by a
// hundredth of their width or turned further than faces that lie flat may.
#pragma once

#include "contact/joint/joint_memory.hpp"
#include "contact/joint/joint_plan.hpp"
#include "contact/space/solid_contact.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// What a joint gives in a step.
struct JointResponse {
  SolidResponse contact;  ///< its moment is about the middle of the joint, which is its centre
  bool ends = false;      ///< two other solids from now on, which `contact.memory` is for
  bool changed = false;   ///< a bond was lost, or damaged for the first time
};

/// One step. `before`: what the contact remembers; `after`: what the joint does then.
JointResponse respond_joint(const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                            const JointMemory& joint, const LawInUse& law, JointMemory& after);

/// Elastic energy of a joint, of its pressure and of its shear [J].
double joint_energy(const JointMemory& joint, const LawInUse& law);

/// The size of the force that a joint carried at its last step, of pressure, shear and their dampings, less what
/// softened as it slid in that step; `contact`: what its contact remembers of then [N].
double carried_force(const JointMemory& joint, const SolidMemory& contact, const LawInUse& law);

/// What happened to a joint between two instants.
JointChange joint_change(const JointMemory& before, const JointMemory& now);

/// Mortar of a law sets between faces as they stand, whole and undamaged. The shear that the contact carried stays
/// (contact/joint/setting_shear.hpp).
JointMemory set_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b, const SolidMemory& before,
                      const ContactLaw& law);

}  // namespace trilith
