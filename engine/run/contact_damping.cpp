#include "run/contact_damping.hpp"

#include <cmath>
#include <variant>

#include "model/pose.hpp"

namespace trilith {
namespace {

/// Contact area of a joint [m2].
double area_of(const Model<2>& model, const Joint& joint) {
  return (joint.place[1] - joint.place[0]).norm() * model.thickness;
}
double area_of(const Model<3>& /*model*/, const FaceJoint& joint) {
  return joint.area;
}

}  // namespace

template <int D>
std::vector<ContactDamping> contact_damping(const Model<D>& model, const std::vector<JointOf<D>>& joints) {
  std::vector<ContactDamping> all;
  for (const JointOf<D>& joint : joints) {
    const int law =
        model.law_of[model.bodies[joint.body_a].surface * model.surfaces + model.bodies[joint.body_b].surface];
    double yielding = 0;  // 1/m1 + 1/m2
    for (const int body : {joint.body_a, joint.body_b})
      if (model.body_moves(body)) yielding += 1 / body_mass(model, body);
    const double area = area_of(model, joint);
    if (law < 0 || !(yielding > 0)) continue;
    std::visit(
        [&](const auto& l) {
          // w = sqrt(k (1/m1 + 1/m2)); damping beta k is the share beta w / 2 of critical damping.
          const double frequency = std::sqrt(l.kn * area * yielding);
          all.push_back({joint.body_a, joint.body_b, law, frequency, 0.5 * l.beta * frequency});
        },
        model.laws[law]);
  }
  return all;
}

template std::vector<ContactDamping> contact_damping<2>(const Model<2>&, const std::vector<Joint>&);
template std::vector<ContactDamping> contact_damping<3>(const Model<3>&, const std::vector<FaceJoint>&);

}  // namespace trilith
