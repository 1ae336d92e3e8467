// Where the shear that two faces carried goes as mortar sets between them.
//
// Friction carried it where the faces press. Spread evenly over the joint (contact/joint/intact_joint.hpp) it may be
// more than the bond holds where they press little or stand apart, and the joint would break as it sets. Then it stays
// with the pressure: V and T are the force and the couple about the middle m of the joint, w_q the overlap at place q
// of a patch times a quarter of its area, c their centre,
//
//     f_q = w_q / (sum of w) V + (T - (c - m) x V) w_q / (sum of w |r - c|^2)  z x (r_q - c)
//
// which has the same sums, and is at most mu times the pressure where V was and its line goes through c.
#pragma once

#include "contact/joint/joint_memory.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Of a sound joint that has just been laid, with its shear: leaves it sound where nearly all of the bond's cohesion is
/// free everywhere, else gives the shear to its patches by their pressure.
void apply_setting_shear(JointMemory& joint, const ContactLaw& law);

}  // namespace trilith
