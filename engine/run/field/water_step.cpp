#include "run/field/water_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "assembly/field/joint_water.hpp"

namespace trilith {
namespace {

/// Sums of the stiffness of springs on one body, over mass: [1/s2]. Of a rigid body: of its motion along and about the
/// normal, as a spring k at the arm r adds k (1/m + r^2/I) at most.
double rate_on_rigid(const Model<2>& model, const State<2>& state, int node, const WaterSpring& water) {
  const auto n = static_cast<std::size_t>(node);
  const double arm = cross(Vec2(water.at - state.position[n]), water.normal), half = 0.5 * water.length;
  const double k = water.stiffness * water.length;
  return k * (1 / model.mass[n] + (arm * arm + half * half / 3) / model.inertia[n]);
}

/// Of a body of elements: a node of the face takes at most the stiffness of its edges.
double rate_on_nodes(const Model<2>& model, const std::array<int, 2>& skin, const WaterSpring& water) {
  double most = 0;
  for (const int s : skin) {
    const auto n = static_cast<std::size_t>(model.skin_node[static_cast<std::size_t>(s)]);
    if (model.mass[n] > 0) most = std::max(most, 0.5 * water.stiffness * water.length / model.mass[n]);
  }
  return 2 * most;  // a node has an edge on either side
}

}  // namespace

double step_with_water(const Model<2>& model, const State<2>& state, double other) {
  const std::vector<WaterSpring> springs = water_springs(model, state);
  if (springs.empty()) return other;
  std::vector<double> rigid(model.bodies.size(), 0), nodes(model.bodies.size(), 0);
  for (const WaterSpring& water : springs) {
    const std::array<int, 2> body{water.body_a, water.body_b};
    for (const std::size_t side : {0, 1}) {
      const auto b = static_cast<std::size_t>(body[side]);
      if (!model.body_moves(body[side])) continue;
      // A spring between two bodies that move counts twice, as (a - b)^2 <= 2 a^2 + 2 b^2.
      const double weight = model.body_moves(body[1 - side]) ? 2 : 1;
      if (model.bodies[b].is_rigid())
        rigid[b] += weight * rate_on_rigid(model, state, model.bodies[b].first_node, water);
      else
        nodes[b] = std::max(nodes[b], weight * rate_on_nodes(model, water.skin[side], water));
    }
  }
  double most = 0;
  for (std::size_t b = 0; b < rigid.size(); ++b) most = std::max({most, rigid[b], nodes[b]});
  return 1 / std::sqrt(1 / (other * other) + 0.25 * most);
}

double step_with_water(const Model<3>& /*model*/, const State<3>& /*state*/, double other) {
  return other;
}

}  // namespace trilith
