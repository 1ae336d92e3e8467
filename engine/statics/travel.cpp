#include "statics/travel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "assembly/implicit_turn.hpp"
#include "base/portable.hpp"
#include "base/quantity_text.hpp"
#include "model/check/held_up.hpp"

namespace trilith {
namespace {

/// Largest fall of a body as a share of its own height.
constexpr double most_fallen = 1;
/// Heights are computed only for bodies displaced by more than this share of their size.
constexpr double little_travel = 0.01;

double angle_between(double from, double to) {
  return std::abs(turn_between(from, to));
}
double angle_between(const UnitQuaternion& from, const UnitQuaternion& to) {
  return turn_between(from, to).norm();
}

/// True if the displacement of body `b` is checked.
template <int D>
bool is_asked(const Model<D>& model, const State<D>& state, const Placement<D>& from, int b) {
  const Body& body = model.bodies[b];
  const auto row = static_cast<std::size_t>(b);
  if (static_cast<std::size_t>(body.first_node + body.nodes) > from.position.size() || state.is_removed(row))
    return false;
  if (row < state.left.size() && state.left[row] != 0) return true;  // fixed where it left the bounds
  bool held = false;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      const Support s = model.support[n][k];
      if (s == Support::driven) return false;
      held = held || (k < D && s != Support::free);  // nodes of elements never turn
    }
  return model.body_moves(b) && (body.is_rigid() || !held);
}

/// First piece of a body and end of its pieces; pieces are in the order of bodies.
template <int D>
std::pair<int, int> pieces_of(const Model<D>& model, int b) {
  const auto [first, end] = std::equal_range(model.piece_body.begin(), model.piece_body.end(), b);
  return {static_cast<int>(first - model.piece_body.begin()), static_cast<int>(end - model.piece_body.begin())};
}

/// True for a single sphere, whose rotation does not matter.
template <int D>
bool is_sphere(const Model<D>& model, int b) {
  if constexpr (D == 2) return false;
  const auto [first, end] = pieces_of(model, b);
  return D == 3 && end - first == 1 && model.piece_solid[static_cast<std::size_t>(first)].is_sphere();
}

/// The extent of a rigid body along the unit vector `up`, in the position `from` [m].
template <int D>
double height_along(const Model<D>& model, const Placement<D>& from, int b, const Vec<D>& up) {
  double low = unbounded, high = -unbounded;
  const auto [first, end] = pieces_of(model, b);
  for (int corner = model.piece_first[first]; corner < model.piece_first[end]; ++corner) {
    const int skin = model.corner_skin[corner], n = model.skin_node[skin];
    const double at = up.dot(turn_of(from.rotation[n]).apply(model.skin_place[skin]));
    low = std::min(low, at), high = std::max(high, at);
  }
  return high > low ? high - low : 2 * model.body_radius[b];  // a sphere has one skin point
}

template <int D>
void measure_fall(const Model<D>& model, const State<D>& state, const Placement<D>& from, Travel& t) {
  const double g = model.gravity.field.norm();
  const int n = model.bodies[t.body].first_node;
  if (!model.bodies[t.body].is_rigid() || t.share < little_travel || !(g > 0)) return;
  const Vec<D> up = -model.gravity.field / g;
  const double fallen = up.dot(from.position[n] - state.position[n]);
  if (!(fallen > little_travel * model.body_radius[t.body])) return;
  t.fallen = fallen / height_along(model, from, t.body, up);
}

template <int D>
Travel travel_of(const Model<D>& model, const State<D>& state, const Placement<D>& from, int b) {
  const Body& body = model.bodies[b];
  const double radius = model.body_radius[b];
  Travel t;
  t.body = b;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    t.moved = std::max(t.moved, (state.position[n] - from.position[n]).norm());
  double chord = 0;
  if (body.is_rigid()) {
    t.turned = angle_between(from.rotation[body.first_node], state.rotation[body.first_node]);
    chord = 2 * radius * portable::sin(0.5 * std::min(t.turned, M_PI));
  }
  t.share = (t.moved + chord) / (2 * radius);
  if (chord > 0 && t.share > little_travel && is_sphere(model, b)) t.turned = 0, t.share = t.moved / (2 * radius);
  return t;
}

/// [body] true if it was supported at `from`.
template <int D>
std::vector<std::uint8_t> held_up_at(const Model<D>& model, const State<D>& state, const Placement<D>& from) {
  Model<D> then = model;
  std::copy(from.position.begin(), from.position.end(), then.start_position.begin());
  std::copy(from.rotation.begin(), from.rotation.end(), then.start_rotation.begin());
  std::vector<std::uint8_t> removed(model.bodies.size(), 0);
  for (std::size_t b = 0; b < removed.size(); ++b) {
    removed[b] = state.is_removed(b) ? 1 : 0;
    if (removed[b] != 0 || b >= state.left.size() || state.left[b] == 0) continue;
    // Fixed after it left the bounds.
    const Body& body = model.bodies[b];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) then.support[n].fill(Support::free);
  }
  return held_up_bodies(then, {0, &removed});
}

}  // namespace

template <int D>
Travel farthest_travel(const Model<D>& model, const State<D>& state, const Placement<D>& from) {
  Travel out;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_asked(model, state, from, b)) continue;
    const Travel t = travel_of(model, state, from, b);
    if (out.body < 0 || t.share > out.share) out = t;
  }
  return out;
}

template <int D>
Travel displaced_body(const Model<D>& model, const State<D>& state, const Placement<D>& from, double within) {
  Travel out;
  std::vector<std::uint8_t> held_up;  // computed at the first use
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (!is_asked(model, state, from, b)) continue;
    Travel t = travel_of(model, state, from, b);
    measure_fall(model, state, from, t);
    if (!(t.share > within || t.fallen > std::max(most_fallen, within))) continue;
    if (held_up.empty()) held_up = held_up_at(model, state, from);
    if (held_up[static_cast<std::size_t>(b)] == 0) continue;
    if (out.body < 0 || t.share > out.share) out = t;
  }
  return out;
}

std::string travel_text(const Travel& t) {
  std::string text = fmt::format("moved by {}", quantity_text(t.moved, "m"));
  if (t.turned > 0) text += fmt::format(" and rotated by {:.2g} rad", t.turned);
  return text + fmt::format(", {:.2g} of its size", t.share);
}

template Travel farthest_travel(const Model<2>&, const State<2>&, const Placement<2>&);
template Travel farthest_travel(const Model<3>&, const State<3>&, const Placement<3>&);
template Travel displaced_body(const Model<2>&, const State<2>&, const Placement<2>&, double);
template Travel displaced_body(const Model<3>&, const State<3>&, const Placement<3>&, double);

}  // namespace trilith
