// Resultants of the contacts in space at this instant, for recordings and scripts.
#pragma once

#include "assembly/contact/contact_resultants.hpp"

namespace trilith {

/// Resultant of one contact in space.
struct SolidResultant {
  int row;             ///< index in Work::pairs
  int body_a, body_b;  ///< the force acts on body_b, the opposite on body_a
  Vec3 point;          ///< point of action of the normal force [m]
  Vec3 normal;         ///< unit vector from body_a to body_b; 0 without force
  Vec3 force;          ///< normal force and shear [N]
  double area;         ///< contact area [m2]
  ContactHold hold;
};

/// Normal force and shear of the contact at `place` of Work::general_touching, on the second body [N].
Vec3 solid_force(const Work<3>& work, std::size_t place);

/// Resultant of the contact at `place` of Work::general_touching, as evaluated.
SolidResultant solid_resultant(const Model<3>& model, const State<3>& state, const Work<3>& work, std::size_t place);

}  // namespace trilith
