// Distribution of the shear carried by two faces when mortar sets between them.
//
// Friction carried it where the faces press. Distributed evenly over the joint (contact/joint/intact_joint.hpp) it may
// exceed the bond's strength where the pressure is low or the faces are apart, and the joint would break as it sets. In
// this case the shear is distributed like the pressure. With force V and couple T about the centroid m of the joint,
// w_q the overlap at point q of a patch times a quarter of its area, and c their centre:
//
//     f_q = w_q / (sum of w) V + (T - (c - m) x V) w_q / (sum of w |r - c|^2)  z x (r_q - c).
//
// This has the same sums, and is at most mu times the pressure if V was and its line passes through c.
#pragma once

#include "contact/joint/joint_memory.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// For an intact joint with shear that has just set. It stays intact if nearly all of the bond's cohesion is unused
/// everywhere; otherwise the shear is distributed to its patches in proportion to their pressure.
void apply_setting_shear(JointMemory& joint, const ContactLaw& law);

}  // namespace trilith
