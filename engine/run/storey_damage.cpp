#include "run/storey_damage.hpp"

#include <algorithm>
#include <cmath>

#include "run/recorded_fields.hpp"
#include "world/pose.hpp"

namespace trilith {
namespace {

bool holds(const std::vector<int>& rising, int body) {
  return std::binary_search(rising.begin(), rising.end(), body);
}

bool is_unit(const Body& body) {
  return std::find(body.groups.begin(), body.groups.end(), "units") != body.groups.end();
}

/// Joints between two bodies of the set that belong to the storey: apart where they opened or slipped beyond the limit.
void count_joints(const Model<2>& model, const Work<2>& work, const std::vector<int>& bodies,
                  const std::vector<Joint>& joints, double limit, StoreyDamage& damage) {
  for (const Joint& joint : joints) {
    if (storey_of(model, joint) != damage.storey || !holds(bodies, joint.body_a) || !holds(bodies, joint.body_b))
      continue;
    const JointMotion motion = joint_motion(joint, work);
    ++damage.joints;
    if (std::max(motion.opening, std::abs(motion.slip)) > limit) ++damage.joints_apart;
  }
}

}  // namespace

std::vector<StoreyDamage> damage_by_storey(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                           const std::vector<int>& bodies, const std::vector<Storey>& storeys,
                                           const std::vector<int>& base, const std::vector<Joint>& joints,
                                           const DamageLimits& limits) {
  std::vector<StoreyDamage> all;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    // A unit that goes with its floor is in place, however far that has gone.
    const double floor = mean_sway(model, state, i == 0 ? base : storeys[i - 1].top);
    StoreyDamage damage{.storey = storeys[i].number};
    bool any = false;
    for (const int body : storeys[i].bodies) {
      if (!holds(bodies, body)) continue;
      any = true;
      if (!is_unit(model.bodies[static_cast<std::size_t>(body)])) continue;
      const Vec2 moved = body_pose(model, state, body).place - body_start(model, body);
      ++damage.units;
      if (std::abs(moved.x() - floor) > limits.out_of_place || moved.y() < -limits.out_of_place)
        ++damage.units_out_of_place;
    }
    if (!any) continue;
    count_joints(model, work, bodies, joints, limits.apart, damage);
    all.push_back(damage);
  }
  return all;
}

}  // namespace trilith
