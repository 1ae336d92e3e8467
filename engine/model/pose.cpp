#include "model/pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
#include "element/corotation_3d.hpp"
#include "element/solid/plane_element.hpp"
#include "geometry/plane/polygon.hpp"
#include "geometry/space/face_distance.hpp"
#include "model/contact/skin_places.hpp"
#include "model/element/one_element.hpp"

namespace trilith {
namespace {

/// Nodes of a body or an element, with weights whose sum is 1.
struct Cloud {
  std::span<const int> node;
  std::span<const double> weight;
};

/// Least-squares rotation of `from` to `to`, both relative to their weighted means, and its rate for the velocities of
/// `to`. It maximises the sum of w to . R from: tan(angle) = sum w (from x to) / sum w (from . to), r = `size` is the
/// root of the sum of both squared.
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
template <class Nodes>
Vec2 mean_now(const Nodes& state, const Cloud& c) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < c.node.size(); ++i) sum += c.weight[i] * state.position[c.node[i]];
  return sum;
}

template <class Nodes>
BestTurn best_turn(const Model<2>& model, const Nodes& state, const Cloud& c) {
  const Vec2 start = mean_start(model, c), now = mean_now(state, c);
  BestTurn best;
  for (std::size_t i = 0; i < c.node.size(); ++i) {
    const Vec2 from = model.start_position[c.node[i]] - start, to = state.position[c.node[i]] - now;
    best.dot += c.weight[i] * from.dot(to);
    best.turn += c.weight[i] * cross(from, to);
  }
  return best;
}

/// Rotation of a cloud and its rate, the spin: d(angle)/dt = sum w (R from) x v / r.
template <class Nodes>
void set_turn(const Model<2>& model, const Nodes& state, const Cloud& c, Pose& pose) {
  const BestTurn best = best_turn(model, state, c);
  pose.rotation = best.angle();
  const Turn turn(pose.rotation);
  const Vec2 start = mean_start(model, c);
  double sum = 0;
  for (std::size_t i = 0; i < c.node.size(); ++i)
    sum += c.weight[i] * cross(turn.apply(Vec2(model.start_position[c.node[i]] - start)), state.velocity[c.node[i]]);
  pose.spin = best.size() > 0 ? sum / best.size() : 0;
}

/// The nodes of a body, weighted by their masses: its position is its centre of mass.
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

/// The nodes of an element, with equal weights for its rotation.
Cloud cloud_of(const Attachment<2>& attachment) {
  const auto nodes = static_cast<std::size_t>(attachment.nodes);
  return {std::span(attachment.node).first(nodes),
          attachment.nodes == 4 ? std::span<const double>(quarters) : std::span<const double>(thirds)};
}

/// For nodes with rotations, which the arms follow.
template <class Nodes>
Pose pose_of_sections(const Nodes& state, const Attachment<2>& attachment) {
  Pose pose;
  for (int i = 0; i < attachment.nodes; ++i) {
    const int n = attachment.node[i], t = attachment.turn[i];
    const Vec2 arm = Turn(state.rotation[t]).apply(attachment.arm[i]);
    pose.place += attachment.weight[i] * (state.position[n] + arm);
    pose.velocity += attachment.weight[i] * (state.velocity[n] + cross(state.spin[t], arm));
    pose.rotation += attachment.weight[i] * state.rotation[t];
    pose.spin += attachment.weight[i] * state.spin[t];
  }
  return pose;
}

/// The element of a mesh that contains a point, or with the nearest edge, and its distance from it [m]. The shape
/// functions there are the weights, so the point moves with the element.
std::pair<Attachment<2>, double> tie_to_elements(const Model<2>& model, int body, const Vec2& at) {
  Attachment<2> best;
  best.turns = false;
  double least = unbounded;
  for (const Element& element : model.elements) {
    if (element.body != body) continue;
    std::vector<Vec2> corners;
    for (int i = 0; i < element.nodes; ++i) corners.push_back(model.start_position[element.node[i]]);
    const ElementPoint found = nearest_in_element(corners, at);
    if (!(found.distance < least)) continue;
    least = found.distance;
    best.nodes = element.nodes;
    best.weight = shape_functions(static_cast<std::size_t>(element.nodes), found.natural);
    std::copy_n(element.node.begin(), element.nodes, best.node.begin());
  }
  return {best, least};
}

/// The two sections of a frame that enclose a point, or are nearest to it. The point keeps its relative position
/// between them and its arm across. So a point of the skin stays on the face that joins the two.
///
///     skin 3 ------------------ 2
///          |         x          |
///     from | - - - - - - - - -> | along
///          0 ------------------ 1
///
/// The height of the point over the line of centres is the arm of both ends. Its relative position along the line gives
/// their weights.
std::pair<Attachment<2>, double> tie_to_sections(const Model<2>& model, int body, const Vec2& at) {
  Attachment<2> best;
  double least = unbounded;
  for (int piece = model.bodies[body].first_piece; piece < model.bodies[body].first_piece + model.bodies[body].pieces;
       ++piece) {
    const int* const skin = &model.corner_skin[model.piece_first[piece]];  // bottom and top: 0 - 1 below 3 - 2
    const auto middle = [&](int low, int high) {
      return Vec2(0.5 * (skin_start(model, skin[low]) + skin_start(model, skin[high])));
    };
    const Vec2 from = middle(0, 3), along = middle(1, 2) - from;
    const double share = std::clamp(along.dot(at - from) / along.squaredNorm(), 0.0, 1.0);
    const Vec2 across = left_of(along).normalized();
    const double half = 0.5 * (skin_start(model, skin[3]) - skin_start(model, skin[0])).norm();
    const Vec2 beside = at - (from + share * along);
    const double height = std::clamp(across.dot(beside), -half, half), distance = (beside - height * across).norm();
    if (!(distance < least)) continue;
    least = distance;
    best.nodes = 2;
    for (const std::size_t end : {0, 1}) {
      const int corner = skin[end];
      best.node[end] = model.skin_node[corner], best.turn[end] = model.skin_turn[corner];
      best.weight[end] = end == 0 ? 1 - share : share;
      const Vec2 station = end == 0 ? from : Vec2(from + along);
      best.arm[end] = station + beside - model.start_position[best.node[end]];
    }
  }
  return {best, least};
}

}  // namespace

template <int D>
double body_mass(const Model<D>& model, int body) {
  const Body& b = model.bodies[body];
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.mass[n];
  return sum;
}

Vec2 body_start(const Model<2>& model, int body) {
  if (model.bodies[body].is_rigid()) return model.start_position[model.bodies[body].first_node];
  return mean_start(model, BodyCloud(model, body).view());
}

/// About the centre of mass: the nodes' own inertia plus m r^2.
double body_inertia(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (b.is_rigid()) return model.inertia[b.first_node];
  const Vec2 centre = body_start(model, body);
  double sum = 0;
  // One element has its own inertia, several have the inertia of the nodal masses.
  if (is_one_element(model, body)) {
    const Element& element = first_element(model.elements, body);
    Polygon outline;
    for (int i = 0; i < element.nodes; ++i) outline.push_back(model.start_position[element.node[i]]);
    const PolygonMoments shape = polygon_moments(outline);
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.mass[n];
    return sum * shape.second_moment / shape.area;
  }
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    sum += model.inertia[n] + model.mass[n] * (model.start_position[n] - centre).squaredNorm();
  return sum;
}

Pose body_pose(const Model<2>& model, const State<2>& state, int body) {
  const Body& b = model.bodies[body];
  const int n = b.first_node;
  if (b.is_rigid()) return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  const BodyCloud nodes(model, body);
  Pose pose;
  pose.place = mean_now(state, nodes.view());
  for (std::size_t i = 0; i < nodes.node.size(); ++i) pose.velocity += nodes.weight[i] * state.velocity[nodes.node[i]];
  set_turn(model, state, nodes.view(), pose);
  return pose;
}

namespace {

/// F = sum m x X' (sum m X X')^-1 with positions relative to their means, x now and X at the start: the mean
/// deformation gradient. Its rotation, and the spin by element/corotation_3d.hpp.
void fit_turn(const Model<3>& model, const State<3>& state, const Body& body, Pose3& pose) {
  const Vec3 start = pose.place - pose.moved;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero(), mixed = second;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const Vec3 from = model.start_position[n] - start;
    second += model.mass[n] * from * from.transpose();
    mixed += model.mass[n] * (state.position[n] - pose.place) * from.transpose();
  }
  const Eigen::Matrix3d inverse = second.inverse();
  const FittedTurn turn = fitted_turn(mixed * inverse);
  Vec3 sum = Vec3::Zero();
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const Vec3 gradient = model.mass[n] * (inverse * (model.start_position[n] - start));
    sum += cross(gradient, Vec3(turn.axes.transpose() * state.velocity[n]));
  }
  pose.turned = rotation_of(turn.axes), pose.spin = turn.axes * (turn.couple * sum);
}

}  // namespace

Pose3 body_pose(const Model<3>& model, const State<3>& state, int body) {
  const Body& b = model.bodies[body];
  const int first = b.first_node;
  const UnitQuaternion turned = state.rotation[first] * inverse(model.start_rotation[first]);
  if (b.is_rigid())
    return {state.position[first], state.position[first] - model.start_position[first], turned, state.velocity[first],
            state.spin[first]};
  const double mass = body_mass(model, body);
  Pose3 pose;
  for (int n = first; n < first + b.nodes; ++n) {
    const double share = model.mass[n] / mass;
    pose.place += share * state.position[n], pose.velocity += share * state.velocity[n];
    pose.moved += share * (state.position[n] - model.start_position[n]);
  }
  pose.turned = turned, pose.spin = state.spin[first];
  if (!b.nodes_turn()) fit_turn(model, state, b, pose);
  return pose;
}

int nearest_node(const Model<3>& model, int body, const Vec3& at) {
  const Body& b = model.bodies[body];
  int best = b.first_node;
  for (int n = b.first_node + 1; n < b.first_node + b.nodes; ++n)
    if ((model.start_position[n] - at).squaredNorm() < (model.start_position[best] - at).squaredNorm()) best = n;
  return best;
}

int contact_frame_near(const Model<3>& model, int body, const Vec3& at) {
  const Body& b = model.bodies[body];
  if (b.nodes_turn()) return nearest_node(model, body, at);
  int best = 0;
  double least = unbounded;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    const ConvexSolid& solid = model.piece_solid[p];
    const Vec3 point = at - model.start_position[model.node_of_piece(p)];
    for (int f = 0; f < solid.shape.faces.count(); ++f) {
      if (!solid.is_surface(f)) continue;
      const double distance = face_distance(solid.shape.corners, solid.shape.faces[f], point);
      if (distance < least) least = distance, best = model.carrier_of(p, f);
    }
  }
  return best;
}

Attachment<3> tie_point(const Model<3>& model, int body, const Vec3& at) {
  const int contact_frame = contact_frame_near(model, body, at);
  const BodyMotion start = start_of(model, contact_frame);
  return Attachment<3>::to_node(contact_frame, turn_of(start.rotation).undo(Vec3(at - start.place)));
}

/// Nodes are stored body by body.
template <int D>
int body_of_node(const Model<D>& model, int node) {
  const auto after = std::upper_bound(model.bodies.begin(), model.bodies.end(), node,
                                      [](int n, const Body& b) { return n < b.first_node; });
  return static_cast<int>(after - model.bodies.begin()) - 1;
}

Attachment<2> tie_point(const Model<2>& model, int body, const Vec2& at, const std::string& owner) {
  const Body& b = model.bodies[body];
  if (b.is_rigid())
    return Attachment<2>::to_node(
        b.first_node, Turn(model.start_rotation[b.first_node]).undo(Vec2(at - model.start_position[b.first_node])));
  const auto [attachment, distance] =
      b.nodes_turn() ? tie_to_sections(model, body, at) : tie_to_elements(model, body, at);
  // Tolerance for rounding and rough input; a larger distance means that another position was intended.
  if (distance > 0.02 * model.body_radius[body])
    throw InputError(
        fmt::format("{}: the point ({:g}, {:g}) is {:.3g} m away from '{}', which deforms, so it cannot be attached; "
                    "give a point in it or on its edge, or make it body = \"rigid\"",
                    owner, at.x(), at.y(), distance, b.name));
  return attachment;
}

namespace {

/// Nodes at the beginning of the last step.
struct NodesBefore {
  const std::vector<Vec2>& position;
  const std::vector<double>& rotation;
  const std::vector<Vec2>& velocity;
  const std::vector<double>& spin;
};

template <class Nodes>
Pose pose_of(const Model<2>& model, const Nodes& state, const Attachment<2>& attachment) {
  if (attachment.is_rigid()) {
    const int n = attachment.node[0];
    const Vec2 arm = Turn(state.rotation[n]).apply(attachment.arm[0]);
    return {state.position[n] + arm, state.rotation[n], state.velocity[n] + cross(state.spin[n], arm), state.spin[n]};
  }
  if (attachment.turns) return pose_of_sections(state, attachment);
  Pose pose;
  for (int i = 0; i < attachment.nodes; ++i) {
    pose.place += attachment.weight[i] * state.position[attachment.node[i]];
    pose.velocity += attachment.weight[i] * state.velocity[attachment.node[i]];
  }
  set_turn(model, state, cloud_of(attachment), pose);
  return pose;
}

}  // namespace

Pose pose_at(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment) {
  return pose_of(model, state, attachment);
}

/// Previous velocities are not stored: the ones used here are the present ones.
Pose pose_before(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment) {
  return pose_of(model, NodesBefore{state.position_before, state.rotation_before, state.velocity, state.spin},
                 attachment);
}

/// The transpose of pose_at: a force is distributed to the nodes by their weights, a moment as the forces that are
/// conjugate to the least-squares rotation.
void apply_force(const Model<2>& model, const State<2>& state, const Attachment<2>& attachment, const Vec2& force,
                 double moment, std::vector<Vec2>& node_force, std::vector<double>& node_moment) {
  if (attachment.turns) {
    for (int i = 0; i < attachment.nodes; ++i) {
      const int t = attachment.turn[i];
      const Vec2 arm = Turn(state.rotation[t]).apply(attachment.arm[i]);
      node_force[attachment.node[i]] += attachment.weight[i] * force;
      node_moment[t] += attachment.weight[i] * (cross(arm, force) + moment);
    }
    return;
  }
  const Cloud cloud = cloud_of(attachment);
  const BestTurn best = best_turn(model, state, cloud);
  const Turn turn(best.angle());
  const Vec2 start = mean_start(model, cloud);
  // Forces w left_of(R from) on the nodes have the moment r about their mean, and no resultant.
  const double couple = best.size() > 0 ? moment / best.size() : 0;
  for (int i = 0; i < attachment.nodes; ++i)
    node_force[attachment.node[i]] +=
        attachment.weight[i] * force +
        couple * cloud.weight[i] * left_of(turn.apply(Vec2(model.start_position[attachment.node[i]] - start)));
}

template double body_mass(const Model<2>&, int);
template double body_mass(const Model<3>&, int);
template int body_of_node(const Model<2>&, int);
template int body_of_node(const Model<3>&, int);

}  // namespace trilith
