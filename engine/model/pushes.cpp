#include "model/pushes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "load/load_curve.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/contact/skin_places.hpp"
#include "model/element/element_place.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// The axis of heights: y in the plane, z in space.
template <int D>
constexpr int upward = D - 1;

/// Height of the centre of mass at the start [m].
double start_height(const Model<2>& model, int body) {
  return body_start(model, body).y();
}
double start_height(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  double sum = 0;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.mass[n] * model.start_position[n].z();
  return sum / body_mass(model, body);
}

/// A body's part in a control before normalisation. `triangle`: by mass and height, like floors in a linear first mode.
template <int D>
double share_of(const Model<D>& model, int body, PushPattern pattern, double lowest) {
  switch (pattern) {
    case PushPattern::uniform:
      return 1;
    case PushPattern::mass:
      return body_mass(model, body);
    case PushPattern::triangle:
      return body_mass(model, body) * (start_height(model, body) - lowest);
  }
  return 1;
}

template <int D>
double lowest_of(const Model<D>& model, const std::vector<int>& bodies) {
  double lowest = unbounded;
  for (const int i : bodies)
    for (int s = model.bodies[i].first_skin; s < model.bodies[i].first_skin + model.bodies[i].skins; ++s)
      lowest = std::min(lowest, skin_start(model, s)[upward<D>]);
  return lowest;
}

/// Nodes with a smaller share of a point get none: it is rounding error of a weight.
constexpr double least_part = 1e-12;

/// A point of a deformable body: by the nodes to which it is attached. In space by the nodes of the element that
/// contains it, or for a frame by the nearest node, whose rotation moves the point.
void add_point_rows(const Model<2>& model, int body, const Vec2& at, double weight, std::vector<PushRow<2>>& rows) {
  const Attachment<2> attachment = tie_point(model, body, at, fmt::format("push of '{}'", model.bodies[body].name));
  for (int i = 0; i < attachment.nodes; ++i)
    if (std::abs(attachment.weight[i]) >= least_part)
      rows.push_back({attachment.node[i], attachment.turn[i], attachment.arm[i], weight * attachment.weight[i]});
}
void add_point_rows(const Model<3>& model, int body, const Vec3& at, double weight, std::vector<PushRow<3>>& rows) {
  if (!model.bodies[body].nodes_turn()) {
    const ElementShares shares = element_shares(model, body, at, fmt::format("push of '{}'", model.bodies[body].name));
    const SpaceElement& element = model.space_elements[static_cast<std::size_t>(shares.element)];
    for (int i = 0; i < info_of(element.shape).nodes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (std::abs(shares.share[k]) < least_part) continue;
      rows.push_back({element.node[k], element.node[k], Vec3::Zero(), weight * shares.share[k]});
    }
    return;
  }
  const int n = nearest_node(model, body, at);
  const Vec3 arm = at - model.start_position[n];
  rows.push_back({n, n, turn_of(model.start_rotation[n]).undo(arm), weight});
}

/// A point that moves with a rigid body: rejected far from it, as for a load.
template <int D>
void require_near_body(const Model<D>& model, int body, const Vec<D>& at) {
  const Body& b = model.bodies[body];
  const double size = 2 * model.body_radius[body];
  require_near<D>(at, (at - model.start_position[b.first_node]).norm() - 0.5 * size, size, b.name,
                  fmt::format("push of '{}'", b.name));
}

/// A rigid body by one row; a point of a deformable one by its nodes there; a whole deformable one by mass.
template <int D>
void add_body_rows(const Model<D>& model, int body, const std::optional<Vec<D>>& at, double weight,
                   std::vector<PushRow<D>>& rows) {
  const Body& b = model.bodies[body];
  const int first = b.first_node;
  if (b.is_rigid()) {
    Vec<D> arm = Vec<D>::Zero();
    if (at) require_near_body<D>(model, body, *at);
    if (at) arm = turn_of(model.start_rotation[first]).undo(*at - model.start_position[first]);
    rows.push_back({first, first, arm, weight});
    return;
  }
  if (at) return add_point_rows(model, body, *at, weight, rows);
  const double mass = body_mass(model, body);
  for (int n = first; n < first + b.nodes; ++n) rows.push_back({n, n, Vec<D>::Zero(), weight * model.mass[n] / mass});
}

/// Free in every direction in which the control has a component.
template <int D>
bool can_go(const Model<D>& model, const PushRow<D>& row, const Vec<D>& direction) {
  for (int k = 0; k < Space<D>::translations; ++k)
    if (std::abs(direction[k]) > 1e-12 && model.support[row.node][k] != Support::free) return false;
  return true;
}

}  // namespace

/// Weighted mean displacement of the controlled points along the direction.
template <int D>
double push_place(const State<D>& state, const Push<D>& push) {
  double sum = 0;
  for (const PushRow<D>& row : push.rows) {
    const Vec<D> place = state.position[row.node] + turn_of(state.rotation[row.turn]).apply(row.place);
    sum += row.weight * push.direction.dot(place);
  }
  return sum;
}

template <int D>
std::vector<PushRow<D>> push_rows(const Model<D>& model, const std::vector<int>& bodies,
                                  const std::optional<std::type_identity_t<Vec<D>>>& at, PushPattern pattern,
                                  const std::type_identity_t<Vec<D>>& direction) {
  if (bodies.empty()) throw InputError("push: no body is given");
  if (at && bodies.size() > 1) throw InputError("push: a point belongs to a single body, but several are given");
  const double lowest = lowest_of(model, bodies);
  double sum = 0;
  for (const int body : bodies) sum += share_of(model, body, pattern, lowest);
  std::vector<PushRow<D>> rows;
  for (const int body : bodies) {
    const std::size_t before = rows.size();
    add_body_rows<D>(model, body, at, share_of(model, body, pattern, lowest) / sum, rows);
    for (std::size_t i = before; i < rows.size(); ++i)
      if (!can_go<D>(model, rows[i], direction))
        throw InputError(
            fmt::format("push: body '{}' is held or driven in the direction in which it is to be pushed; "
                        "free it, or push others",
                        model.bodies[body].name));
  }
  return rows;
}

template <int D>
void add_push(Model<D>& model, const State<D>& state, const std::string& name, std::vector<PushRow<D>> rows,
              const std::type_identity_t<Vec<D>>& direction, const std::shared_ptr<const GroundMotion>& motion) {
  for (const Push<D>& other : model.pushes) {
    if (other.name == name)
      throw InputError(fmt::format("push: push '{}' exists already; release it, or give another name", name));
    for (const PushRow<D>& mine : rows)
      for (const PushRow<D>& row : other.rows)
        if (row.node == mine.node)
          throw InputError(fmt::format("push: body '{}' is pushed already by '{}'; release that push first",
                                       model.bodies[body_of_node(model, row.node)].name, other.name));
  }
  Push<D> push;
  push.name = name, push.rows = std::move(rows), push.direction = direction, push.start = state.time;
  push.motion = motion;
  push.origin = push_place(state, push) - push.motion->displacement(0);
  model.pushes.push_back(std::move(push));
}

/// Its force remains as fading loads at its points, so that the release excites no motion.
template <int D>
bool release_push(Model<D>& model, const State<D>& state, const Work<D>& work, const std::string& name, double fade) {
  const auto at =
      std::find_if(model.pushes.begin(), model.pushes.end(), [&](const Push<D>& p) { return p.name == name; });
  if (at == model.pushes.end()) return false;
  drop_faded(model, state.time);
  const auto index = static_cast<std::size_t>(at - model.pushes.begin());
  const double size = index < work.push_force.size() ? work.push_force[index] : 0;
  for (const PushRow<D>& row : at->rows) {
    if (size == 0 || !(fade > 0)) break;
    PointLoad<D> load;
    load.body = body_of_node(model, row.node), load.at = Attachment<D>::to_node(row.node, row.place);
    load.at.turn[0] = row.turn;
    load.force = size * row.weight * at->direction;
    load.curve = ramp_curve(state.time, 1, 0, fade, true);
    loads_of<PointLoad<D>>(model).push_back(std::move(load));
  }
  model.pushes.erase(at);
  return true;
}

template double push_place(const State<2>&, const Push<2>&);
template double push_place(const State<3>&, const Push<3>&);
template std::vector<PushRow<2>> push_rows(const Model<2>&, const std::vector<int>&, const std::optional<Vec2>&,
                                           PushPattern, const Vec2&);
template std::vector<PushRow<3>> push_rows(const Model<3>&, const std::vector<int>&, const std::optional<Vec3>&,
                                           PushPattern, const Vec3&);
template void add_push(Model<2>&, const State<2>&, const std::string&, std::vector<PushRow<2>>, const Vec2&,
                       const std::shared_ptr<const GroundMotion>&);
template void add_push(Model<3>&, const State<3>&, const std::string&, std::vector<PushRow<3>>, const Vec3&,
                       const std::shared_ptr<const GroundMotion>&);
template bool release_push(Model<2>&, const State<2>&, const Work<2>&, const std::string&, double);
template bool release_push(Model<3>&, const State<3>&, const Work<3>&, const std::string&, double);

}  // namespace trilith
