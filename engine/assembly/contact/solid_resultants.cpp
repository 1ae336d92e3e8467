#include "assembly/contact/solid_resultants.hpp"

#include <cmath>

#include "contact/joint/area_limit.hpp"
#include "contact/joint/shear_3d.hpp"

namespace trilith {
namespace {

/// Friction that a contact holds at most, by its law at its pressure and slip rate, which has its turning along the
/// normal [N].
double solid_friction(const Model<3>& model, const State<3>& state, const GeneralContact<3>& contact,
                      const NearPair& pair, const Vec3& n, const ContactArea& area) {
  return with_kernel({model.laws[pair.law], model.thickness, 0}, [&](const auto& law) {
    return friction_limit_of(law, contact.force.norm(), contact.size, [&] {
      const auto velocity = [&](int piece) { return motion_of(model, state, model.carrier_of(piece)); };
      const auto a = velocity(pair.piece_a), b = velocity(pair.piece_b);
      Vec3 rate = b.velocity + cross(b.spin, Vec3(area.middle - b.place)) - a.velocity -
                  cross(a.spin, Vec3(area.middle - a.place));
      rate += (area.radius * n.dot(Vec3(b.spin - a.spin)) - n.dot(rate)) * n;
      return rate.norm();
    });
  });
}

}  // namespace

Vec3 solid_force(const Work<3>& work, std::size_t place) {
  const GeneralContact<3>& contact = work.general_touching[place];
  const SolidMemory& memory = work.contacts.memory[contact.row];
  const Vec3 &n = memory.normal, &total = memory.shear.total;  // mortar may be in tension
  return contact.force - (total - n.dot(total) * n);
}

/// Resultant of a contact in space, split along its normal: f = N n + T with the shear T of the sliding element. It
/// slides if T equals the limit of its whole area up to rounding, shear and couple about the normal combined
/// (contact/joint/friction_limit.hpp).
SolidResultant solid_resultant(const Model<3>& model, const State<3>& state, const Work<3>& work, std::size_t place) {
  const GeneralContact<3>& contact = work.general_touching[place];
  const NearPair& pair = work.pairs[contact.row];
  const SlidingForce& shear = work.contacts.memory[contact.row].shear;
  const Vec3& n = work.contacts.memory[contact.row].normal;
  const JointMemory* joint = work.contacts.joint_at(static_cast<std::size_t>(contact.row));
  const bool bonded = joint != nullptr && joint->bonds != 0;
  const ContactArea& area = work.solids.areas[static_cast<std::size_t>(contact.row)];
  const double limit = (1 - 1e-9) * solid_friction(model, state, contact, pair, n, area);
  const AreaLimit friction(limit, n, contact.centre - area.middle, area.radius, area.friction_arm, area.arm);
  return {contact.row,
          model.piece_body[pair.piece_a],
          model.piece_body[pair.piece_b],
          contact.centre,
          n,
          solid_force(work, place),
          contact.size,
          bonded                           ? ContactHold::bonded
          : friction.is_below(shear.total) ? ContactHold::sliding
                                           : ContactHold::sticking};
}

}  // namespace trilith
