// Rows of solids whose faces may lie flat, four into the lanes of their kernel (contact/flat_contact.hpp) and out
// again.
#pragma once

#include <array>

#include "base/lane_vectors.hpp"
#include "contact/flat_contact.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// What a lane came to, out of lanes.
inline void store_flat(const FlatResponses& out, int lane, SolidAnswer& answer, SolidMemory& memory,
                       ContactArea& area) {
  answer.joint_changed = false;
  answer.touching = out.presses[lane] != 0;
  answer.lost_damping = out.lost_damping[lane], answer.lost_friction = out.lost_friction[lane];
  answer.lost_fracture = 0;
  if (!answer.touching) {
    memory = {};
    return;
  }
  answer.moment_a = lane_of(out.moment_a, lane), answer.moment_b = lane_of(out.moment_b, lane);
  answer.force = lane_of(out.force, lane), answer.normal_force = lane_of(out.normal_force, lane);
  answer.centre = lane_of(out.centre, lane), answer.area = out.area[lane], answer.depth = out.depth[lane];
  area.middle = lane_of(out.middle, lane), area.normal = lane_of(out.normal, lane), area.area = out.area[lane];
  area.radius = out.radius[lane], area.friction_arm = out.friction_arm[lane];
  area.arm[0] = lane_of(out.arm[0], lane), area.arm[1] = lane_of(out.arm[1], lane);
  area.face_a = area.face_b = -1;
  const FlatMemory& m = out.memory;
  memory.shear = {lane_of(m.shear.elastic, lane), lane_of(m.shear.total, lane), m.shear.area[lane]};
  memory.normal = lane_of(m.normal, lane), memory.damping = lane_of(m.damping, lane);
  memory.damping_moment = lane_of(m.damping_moment, lane);
  memory.slip = m.slip[lane], memory.state = contact_touching | contact_general;
}

/// All that the kernel of flat faces asks of four rows, in a step of `dt` [s].
void load_flat(const State<3>& state, const Work<3>& work, const std::array<int, lane_count>& row, double dt,
               FlatContacts& in);

}  // namespace trilith
