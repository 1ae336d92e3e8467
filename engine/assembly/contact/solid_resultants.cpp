#include "assembly/contact/solid_resultants.hpp"

#include <cmath>

#include "contact/joint/area_limit.hpp"
#include "contact/joint/shear_3d.hpp"

namespace trilith {

/// Resultant of a contact in space, split along its normal: f = N n + T with the shear T of the sliding element. It
/// slides if T equals the limit of its whole area up to rounding, shear and couple about the normal combined
/// (contact/joint/friction_limit.hpp).
SolidResultant solid_resultant(const Model<3>& model, const Work<3>& work, std::size_t place) {
  const GeneralContact<3>& contact = work.general_touching[place];
  const NearPair& pair = work.pairs[contact.row];
  const SlidingForce& shear = work.contacts.memory[contact.row].shear;
  const double normal = contact.force.norm(), mu = std::visit([](const auto&l) { return l.mu; }, model.laws[pair.law]),
               limit = (1 - 1e-9) * mu * normal;
  const Vec3& n = work.contacts.memory[contact.row].normal;  // mortar may be in tension
  const JointMemory* joint = work.contacts.joint_at(static_cast<std::size_t>(contact.row));
  const bool bonded = joint != nullptr && joint->bonds != 0;
  const ContactArea& area = work.solids.areas[static_cast<std::size_t>(contact.row)];
  const AreaLimit friction(limit, n, contact.centre - area.middle, area.radius, area.friction_arm, area.arm);
  const Vec3 along = shear.total - n.dot(shear.total) * n;
  return {contact.row,
          model.piece_body[pair.piece_a],
          model.piece_body[pair.piece_b],
          contact.centre,
          n,
          contact.force - along,
          contact.size,
          bonded                           ? ContactHold::bonded
          : friction.is_below(shear.total) ? ContactHold::sliding
                                           : ContactHold::sticking};
}

}  // namespace trilith
