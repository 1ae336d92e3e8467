// What the contacts of solids in space carry at this instant, for recording and for scripts.
#pragma once

#include "assembly/contact/contact_resultants.hpp"

namespace trilith {

/// Resultant of one contact in space.
struct SolidResultant {
  int row;             ///< of Work::pairs
  int body_a, body_b;  ///< force acts on body_b; body_a feels the opposite
  Vec3 point;          ///< where the normal force acts [m]
  Vec3 normal;         ///< from body_a to body_b, of length 1; 0 where it carries none
  Vec3 force;          ///< normal and shear [N]
  double area;         ///< in contact [m2]
  ContactHold hold;
};

/// Of the contact at `place` of Work::general_touching, as evaluated.
SolidResultant solid_resultant(const Model<3>& model, const Work<3>& work, std::size_t place);

}  // namespace trilith
