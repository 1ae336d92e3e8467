#include "world/pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "body/solid_element.hpp"

namespace trilith {
namespace {

/// Nodes of a body or an element, with weights that sum to 1.
struct Cloud {
  std::span<const int> node;
  std::span<const double> weight;
};

/// The turn that takes `from` nearest to `to`, both from their weighed means; its rate for the velocities of `to`.
struct BestTurn {
  double dot = 0, turn = 0;
  [[nodiscard]] double angle() const { return dot != 0 || turn != 0 ? portable::atan2(turn, dot) : 0; }
  [[nodiscard]] double size() const { return portable::hypot(dot, turn); }
};

Vec2 mean_start(const Model<2>& model, const Cloud& c) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < c.node.size(); ++i) sum += c.weight[i] * model.start_position[c.node[i]];
  return sum;
}
Vec2 mean_now(const State<2>& state, const Cloud& c) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < c.node.size(); ++i) sum += c.weight[i] * state.position[c.node[i]];
  return sum;
}

BestTurn best_turn(const Model<2>& model, const State<2>& state, const Cloud& c) {
  const Vec2 start = mean_start(model, c), now = mean_now(state, c);
  BestTurn best;
  for (std::size_t i = 0; i < c.node.size(); ++i) {
    const Vec2 from = model.start_position[c.node[i]] - start, to = state.position[c.node[i]] - now;
    best.dot += c.weight[i] * from.dot(to);
    best.turn += c.weight[i] * cross(from, to);
  }
  return best;
}

/// Rotation and spin of a cloud; the spin is the rate of the rotation.
void set_turn(const Model<2>& model, const State<2>& state, const Cloud& c, Pose& pose) {
  const BestTurn best = best_turn(model, state, c);
  pose.rotation = best.angle();
  const Turn turn(pose.rotation);
  const Vec2 start = mean_start(model, c);
  double sum = 0;
  for (std::size_t i = 0; i < c.node.size(); ++i)
    sum += c.weight[i] * cross(turn.apply(Vec2(model.start_position[c.node[i]] - start)), state.velocity[c.node[i]]);
  pose.spin = best.size() > 0 ? sum / best.size() : 0;
}

struct BodyCloud {
  std::vector<int> node;
  std::vector<double> weight;
  BodyCloud(const Model<2>& model, int body) {
    const Body& b = model.bodies[body];
    const double mass = body_mass(model, body);
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
      node.push_back(n);
      weight.push_back(model.mass[n] / mass);
    }
  }
  [[nodiscard]] Cloud view() const { return {node, weight}; }
};

constexpr std::array<double, 4> quarters{0.25, 0.25, 0.25, 0.25};
constexpr std::array<double, 3> thirds{1.0 / 3, 1.0 / 3, 1.0 / 3};

Cloud cloud_of(const Element& e) {
  const auto nodes = static_cast<std::size_t>(e.nodes);
  return {std::span(e.node).first(nodes),
          e.nodes == 4 ? std::span<const double>(quarters) : std::span<const double>(thirds)};
}

}  // namespace

double body_mass(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.mass[n];
  return sum;
}

Vec2 body_start(const Model<2>& model, int body) {
  if (!model.bodies[body].deforms()) return model.start_position[model.bodies[body].first_node];
  return mean_start(model, BodyCloud(model, body).view());
}

double body_inertia(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (!b.deforms()) return model.inertia[b.first_node];
  const Vec2 centre = body_start(model, body);
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    sum += model.mass[n] * (model.start_position[n] - centre).squaredNorm();
  return sum;
}

Pose body_pose(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  const int n = b.first_node;
  if (!b.deforms()) return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  const BodyCloud nodes(model, body);
  Pose pose;
  pose.place = mean_now(state, nodes.view());
  for (std::size_t i = 0; i < nodes.node.size(); ++i) pose.velocity += nodes.weight[i] * state.velocity[nodes.node[i]];
  set_turn(model, state, nodes.view(), pose);
  return pose;
}

int body_of_node(const Model<2>& model, int node) {
  const auto after = std::upper_bound(model.bodies.begin(), model.bodies.end(), node,
                                      [](int n, const Body& b) { return n < b.first_node; });
  return static_cast<int>(after - model.bodies.begin()) - 1;
}

Vec2 skin_start(const Model<2>& model, int skin) {
  const int n = model.skin_node[skin];
  return model.start_position[n] + Turn(model.start_rotation[n]).apply(model.skin_place[skin]);
}

Anchor tie_point(const Model<2>& model, int body, const Vec2& at, const std::string& owner) {
  const Body& b = model.bodies[body];
  if (!b.deforms()) return {body, -1, at - model.start_position[b.first_node]};
  Anchor best{body, -1, Vec2::Zero()};
  double least = unbounded;
  for (int e = 0; e < static_cast<int>(model.elements.size()); ++e) {
    const Element& element = model.elements[e];
    if (element.body != body) continue;
    std::vector<Vec2> corners;
    for (int i = 0; i < element.nodes; ++i) corners.push_back(model.start_position[element.node[i]]);
    const ElementPoint found = nearest_in_element(corners, at);
    if (found.distance < least) best.element = e, best.place = found.natural, least = found.distance;
  }
  if (least > 0.02 * model.body_radius[body])
    throw InputError(
        fmt::format("{}: the point ({:g}, {:g}) is {:.3g} m away from '{}', which deforms, so there is nothing to tie "
                    "it to; give a "
                    "point in it or on its edge, or make it body = \"rigid\"",
                    owner, at.x(), at.y(), least, b.name));
  return best;
}

Pose anchor_pose(const Model<2>& model, const State<2>& state, const Anchor& anchor) {
  if (anchor.element < 0) {
    const int n = model.bodies[anchor.body].first_node;
    const Vec2 arm = Turn(state.rotation[n]).apply(anchor.place);
    return {state.position[n] + arm, state.rotation[n], state.velocity[n] + cross(state.spin[n], arm), state.spin[n]};
  }
  const Element& e = model.elements[anchor.element];
  const auto share = shape_functions(static_cast<std::size_t>(e.nodes), anchor.place);
  Pose pose;
  for (int i = 0; i < e.nodes; ++i) {
    pose.place += share[i] * state.position[e.node[i]];
    pose.velocity += share[i] * state.velocity[e.node[i]];
  }
  set_turn(model, state, cloud_of(e), pose);
  return pose;
}

void add_at_anchor(const Model<2>& model, const State<2>& state, const Anchor& anchor, const Vec2& force, double moment,
                   std::vector<Vec2>& node_force, std::vector<double>& node_moment) {
  if (anchor.element < 0) {
    const int n = model.bodies[anchor.body].first_node;
    node_force[n] += force;
    node_moment[n] += cross(Turn(state.rotation[n]).apply(anchor.place), force) + moment;
    return;
  }
  const Element& e = model.elements[anchor.element];
  const auto share = shape_functions(static_cast<std::size_t>(e.nodes), anchor.place);
  const Cloud cloud = cloud_of(e);
  const BestTurn best = best_turn(model, state, cloud);
  const Turn turn(best.angle());
  const Vec2 start = mean_start(model, cloud);
  const double couple = best.size() > 0 ? moment / best.size() : 0;
  for (int i = 0; i < e.nodes; ++i)
    node_force[e.node[i]] += share[i] * force + couple * cloud.weight[i] *
                                                    left_of(turn.apply(Vec2(model.start_position[e.node[i]] - start)));
}

}  // namespace trilith
