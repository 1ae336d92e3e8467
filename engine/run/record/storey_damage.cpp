#include "run/record/storey_damage.hpp"

#include <algorithm>
#include <cmath>

#include "model/pose.hpp"

namespace trilith {
namespace {

bool holds(const std::vector<int>& rising, int body) {
  return std::binary_search(rising.begin(), rising.end(), body);
}

bool is_unit(const Body& body) {
  return std::find(body.groups.begin(), body.groups.end(), "units") != body.groups.end();
}

/// Displacement of a body's centroid from the start [m].
Vec2 way_of(const Model<2>& model, const State<2>& state, int body) {
  return body_pose(model, state, body).place - body_start(model, body);
}
Vec3 way_of(const Model<3>& model, const State<3>& state, int body) {
  return body_pose(model, state, body).moved;
}

/// True if a unit has moved sideways relative to the floor that carries it, or downward from the start, by more than
/// the limit.
template <int D>
bool is_out_of_place(const Vec<D>& way, const Vec<D>& floor, double limit) {
  return std::abs(level_part(Vec<D>(way - floor))) > limit || way[D - 1] < -limit;
}

/// Counts the joints of a storey between two bodies of the set. A joint is apart if it opened or slipped beyond the
/// limit.
template <int D>
void count_joints(const Model<D>& model, const State<D>& state, const Work<D>& work, const std::vector<int>& bodies,
                  const std::vector<JointOf<D>>& joints, double limit, StoreyDamage& damage) {
  for (const JointOf<D>& joint : joints) {
    if (!holds(bodies, joint.body_a) || !holds(bodies, joint.body_b)) continue;
    if (storey_between(model, joint.body_a, joint.body_b) != damage.storey) continue;
    const JointDisplacement moved = joint_displacement(joint, model, state, work);
    ++damage.joints;
    if (std::max(moved.opening, std::abs(moved.slip)) > limit) ++damage.joints_apart;
  }
}

}  // namespace

template <int D>
std::vector<StoreyDamage> damage_by_storey(const Model<D>& model, const State<D>& state, const Work<D>& work,
                                           const std::vector<int>& bodies, const Findings<D>& findings,
                                           const DamageLimits& limits) {
  std::vector<StoreyDamage> all;
  const std::vector<Storey>& storeys = findings.storeys;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    const Vec<D> floor = mean_displacement(model, state, i == 0 ? findings.base : storeys[i - 1].top);
    StoreyDamage damage{.storey = storeys[i].number};
    bool any = false;
    for (const int body : storeys[i].bodies) {
      if (!holds(bodies, body)) continue;
      any = true;
      if (!is_unit(model.bodies[static_cast<std::size_t>(body)])) continue;
      ++damage.units;
      if (is_out_of_place<D>(way_of(model, state, body), floor, limits.out_of_place)) ++damage.units_out_of_place;
    }
    if (!any) continue;
    count_joints(model, state, work, bodies, findings.joints, limits.apart, damage);
    all.push_back(damage);
  }
  return all;
}

template std::vector<StoreyDamage> damage_by_storey(const Model<2>&, const State<2>&, const Work<2>&,
                                                    const std::vector<int>&, const Findings<2>&, const DamageLimits&);
template std::vector<StoreyDamage> damage_by_storey(const Model<3>&, const State<3>&, const Work<3>&,
                                                    const std::vector<int>&, const Findings<3>&, const DamageLimits&);

}  // namespace trilith
