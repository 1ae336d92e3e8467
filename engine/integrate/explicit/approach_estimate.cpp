#include "integrate/explicit/approach_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "broad_phase/moving_piece.hpp"
#include "contact/space/solid_pressure.hpp"
#include "geometry/space/separation_parts.hpp"
#include "integrate/explicit/node_gain.hpp"
#include "law/contact/list.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {
namespace {

/// The part of a piece within a depth of its outermost point along a direction, and the extent of that part across it.
template <int D>
struct Front {
  double outermost = -unbounded;                            ///< along the direction [m]
  double fastest = -unbounded;                              ///< largest velocity of a corner along the direction now
                                                            ///< [m/s]
  double gain = -unbounded;                                 ///< largest acceleration of a corner along the direction
                                                            ///< [m/s2]
  std::array<double, static_cast<std::size_t>(D - 1)> low;  ///< least and largest coordinate across the direction [m]
  std::array<double, static_cast<std::size_t>(D - 1)> high;
};

/// Unit vectors: the direction, and D - 1 axes across it.
template <int D>
using Axes = std::array<Vec<D>, static_cast<std::size_t>(D)>;

Axes<2> axes_of(const Vec2& n) {
  return {n, left_of(n)};
}
Axes<3> axes_of(const Vec3& n) {
  const Vec3 across = line_across(n);
  return {n, across, cross(n, across)};
}

/// A piece with its present position and motion. `gain`: accelerations of its corners [m/s2]. `radius`: of a sphere
/// around its single corner, otherwise 0 [m]. `mass`: infinite if the piece does not move [kg].
template <int D>
struct Side;
template <>
struct Side<2> {
  const MovingPiece& piece;
  std::array<Vec2, max_piece_corners> gains;
  double radius, mass;
  [[nodiscard]] std::size_t corners() const { return static_cast<std::size_t>(piece.corners); }
  [[nodiscard]] const Vec2& at(std::size_t i) const { return piece.at[i]; }
  [[nodiscard]] const Vec2& velocity(std::size_t i) const { return piece.velocity[i]; }
  [[nodiscard]] const Vec2& gain(std::size_t i) const { return gains[i]; }
  [[nodiscard]] std::size_t edges() const { return corners(); }
  [[nodiscard]] std::array<std::size_t, 2> edge(std::size_t e) const { return {e, e + 1 == corners() ? 0 : e + 1}; }
};
template <>
struct Side<3> {
  const PlacedSolid& placed;
  BodyMotion motion;
  NodeGain<3> gains;
  double radius, mass;
  [[nodiscard]] std::size_t corners() const { return placed.corners.size(); }
  [[nodiscard]] const Vec3& at(std::size_t i) const { return placed.corners[i]; }
  [[nodiscard]] Vec3 velocity(std::size_t i) const { return motion.velocity_at(placed.corners[i]); }
  [[nodiscard]] Vec3 gain(std::size_t i) const { return gains.at(placed.corners[i] - motion.place); }
  [[nodiscard]] std::size_t edges() const { return placed.solid->edges.size(); }
  [[nodiscard]] std::array<std::size_t, 2> edge(std::size_t e) const {
    const SolidEdge& edge = placed.solid->edges[e];
    return {static_cast<std::size_t>(edge.from), static_cast<std::size_t>(edge.to)};
  }
};

/// The front of a piece: all that lies within `depth` [m] of its outermost point. `along`: 1, or -1 for the opposite
/// direction. `behind`: half of the last step [s], because velocities refer to its middle.
template <int D>
Front<D> front_of(const Side<D>& side, const Axes<D>& axes, double along, double depth, double behind) {
  Front<D> front;
  front.low.fill(unbounded), front.high.fill(-unbounded);
  std::array<double, 64> stored;
  const auto reach_at = [&](std::size_t i) { return along * axes[0].dot(side.at(i)) + side.radius; };
  for (std::size_t i = 0; i < side.corners(); ++i) {
    const double at = reach_at(i);
    if (i < stored.size()) stored[i] = at;
    front.outermost = std::max(front.outermost, at);
  }
  const auto reach = [&](std::size_t i) { return i < stored.size() ? stored[i] : reach_at(i); };
  // A sphere: radius of the cap of this depth, at most the radius of its equator.
  const double half = std::sqrt(2 * side.radius * std::min(depth, side.radius)), level = front.outermost - depth;
  const auto add = [&](const Vec<D>& x) {
    for (std::size_t k = 0; k < front.low.size(); ++k) {
      const double across = axes[k + 1].dot(x);
      front.low[k] = std::min(front.low[k], across - half), front.high[k] = std::max(front.high[k], across + half);
    }
  };
  for (std::size_t i = 0; i < side.corners(); ++i) {
    if (reach(i) < level) continue;
    const double gain = along * axes[0].dot(side.gain(i));
    front.fastest = std::max(front.fastest, along * axes[0].dot(side.velocity(i)) + behind * gain);
    front.gain = std::max(front.gain, gain);
    add(side.at(i));
  }
  if (!(depth < unbounded)) return front;  // all corners are in front
  // Points where edges cross the level.
  for (std::size_t e = 0; e < side.edges(); ++e) {
    const auto [i, j] = side.edge(e);
    const double from = reach(i) - level, to = reach(j) - level;
    if ((from < 0) == (to < 0)) continue;
    add(side.at(i) + from / (from - to) * (side.at(j) - side.at(i)));
  }
  return front;
}

/// Length (plane) or area (space) that two fronts share [m], [m2]. It is at least the size of a dent as wide as it is
/// deep.
template <int D>
double shared(const Front<D>& a, const Front<D>& b, double depth) {
  double measure = 1;
  for (std::size_t k = 0; k < a.low.size(); ++k)
    measure *= std::max(depth, std::min(a.high[k], b.high[k]) - std::max(a.low[k], b.low[k]));
  return measure;
}

/// Iterates the contact of two convex sides along `normal`. `kn`: stiffness by length or area. `behind`: see front_of.
/// The depth depends on the shared area, and the area depends on the depth. The first pass takes the whole extent of
/// both pieces; the next passes take the fronts within a depth that approaches its own result.
template <int D>
ApproachEstimate meet(const Side<D>& a, const Side<D>& b, const Vec<D>& normal, double kn, double behind, double dt) {
  constexpr int looks = 4;
  const Axes<D> axes = axes_of(normal);
  ApproachEstimate m;
  m.mass = 1 / (1 / a.mass + 1 / b.mass);
  double depth = unbounded;
  for (int look = 0; look < looks; ++look) {
    const Front<D> of_a = front_of(a, axes, 1, depth, behind), of_b = front_of(b, axes, -1, depth, behind);
    const double now = of_a.fastest + of_b.fastest, gain = of_a.gain + of_b.gain;
    m.gap = -of_b.outermost - of_a.outermost;
    m.speed = now;
    // Part of the corners is not faster than all of them.
    m.apart = m.gap > 0 && !(m.gap < farthest(now, gain, dt));
    if (m.apart) break;
    if (m.gap > 0) m.speed = speed_at_touch(m.gap, now, gain), m.touches = time_to_touch(m.gap, now, gain);
    m.stiffness = kn * shared(of_a, of_b, look == 0 ? 0 : depth);
    if (!(m.stiffness > 0)) break;
    // Elastic impact: depth v sqrt(m/k), in addition to the present overlap.
    const double found = std::max(-m.gap, 0.0) + std::abs(m.speed) * std::sqrt(m.mass / m.stiffness);
    depth = look == 0 ? found : std::sqrt(depth * found);
  }
  return m;
}

template <int D>
double closing_stiffness(const Model<D>& model, int p, int q) {
  const auto surface = [&](int piece) { return model.bodies[model.piece_body[piece]].surface; };
  const int law = model.law_of[surface(p) * model.surfaces + surface(q)];
  return with_kernel({model.laws[law], model.thickness, 0},
                     [](const auto& kernel) { return kernel.tangent(0).normal; });
}

/// Mass of the whole body if it is rigid; otherwise the masses at the corners of the piece [kg].
double piece_mass(const Model<2>& model, int piece) {
  const Body& body = model.bodies[model.piece_body[piece]];
  if (!model.body_moves(model.piece_body[piece])) return unbounded;
  if (body.is_rigid()) return model.mass[body.first_node];
  double sum = 0;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
    sum += model.mass[model.skin_node[model.corner_skin[c]]];
  return sum;
}
double piece_mass(const Model<3>& model, int piece) {
  if (!model.body_moves(model.piece_body[piece])) return unbounded;
  if (!model.is_fitted(piece)) return model.mass[model.node_of_piece(piece)];
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)])];
  double sum = 0;
  for (int i = 0; i < whole.nodes; ++i) sum += model.mass[whole.node[static_cast<std::size_t>(i)]];
  return sum;
}

/// Accelerations of the corners of a piece [m/s2].
std::array<Vec2, max_piece_corners> gains_of(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                             int piece, const MovingPiece& now, double dt) {
  std::array<Vec2, max_piece_corners> out;
  int known = -1;
  NodeGain<2> gain;
  for (int c = 0; c < now.corners; ++c) {
    const int skin = model.corner_skin[model.piece_first[piece] + c], n = model.skin_node[skin];
    if (n != known) gain = gain_of(model, state, work, n, dt), known = n;
    out[c] = gain.at(now.at[c] - state.position[n]);
  }
  return out;
}
/// Acceleration of the node of a piece, or of the mean of the nodes that its contact frame is fitted to.
NodeGain<3> gain_of_piece(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece, double dt) {
  if (!model.is_fitted(piece)) return gain_of(model, state, work, model.node_of_piece(piece), dt);
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)])];
  NodeGain<3> mean;
  for (int i = 0; i < whole.nodes; ++i)
    mean.along += gain_of(model, state, work, whole.node[static_cast<std::size_t>(i)], dt).along / whole.nodes;
  return mean;
}

/// Keeps the outward normal of `a` along which `b` lies farthest from the faces of `a`.
void look_along_edges(const MovingPiece& a, const MovingPiece& b, double turned, double& most, Vec2& normal) {
  for (int i = 0; i < a.corners; ++i) {
    const Vec2 n = -left_of(Vec2(a.at[(i + 1) % a.corners] - a.at[i])).normalized();
    double least = unbounded;
    for (int j = 0; j < b.corners; ++j) least = std::min(least, n.dot(b.at[j] - a.at[i]));
    if (least > most) most = least, normal = turned * n;
  }
}

/// Unit vector from a to b, of which one is a sphere: the line between two centres, or the normal of the face farthest
/// from a centre.
Vec3 sphere_normal(const PlacedSolid& a, const PlacedSolid& b) {
  if (a.solid->is_sphere() && b.solid->is_sphere()) {
    const Vec3 way = b.corners[0] - a.corners[0];
    return way.squaredNorm() > 0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ());
  }
  const PlacedSolid &sphere = a.solid->is_sphere() ? a : b, &other = a.solid->is_sphere() ? b : a;
  double most = -unbounded;
  Vec3 normal = Vec3::UnitZ();
  for (int f = 0; f < other.solid->shape.faces.count(); ++f) {
    const double height = -depth_below(other, f, sphere.corners[0]);
    if (height > most) most = height, normal = other.normals[static_cast<std::size_t>(f)];
  }
  return a.solid->is_sphere() ? Vec3(-normal) : normal;
}

/// Largest distance of a corner from the point that its motion refers to [m].
double farthest_corner(const Side<3>& side) {
  double most = 0;
  for (const Vec3& x : side.placed.corners) most = std::max(most, (x - side.motion.place).squaredNorm());
  return std::sqrt(most);
}

/// True if meet() finds the pieces apart along every direction in which they are apart by `gap` [m] or more: the bound
/// of their motion toward each other is the same for all directions.
bool stay_apart(const Side<3>& a, const Side<3>& b, double gap, double behind, double dt) {
  const double rounding = 1e-9 * (a.placed.solid->size + b.placed.solid->size) +
                          1e-13 * (a.motion.place.cwiseAbs().maxCoeff() + b.motion.place.cwiseAbs().maxCoeff());
  if (!(gap > rounding)) return false;
  const double arm_a = farthest_corner(a), arm_b = farthest_corner(b);
  const Vec3 gain = a.gains.along - b.gains.along;
  const double speed = Vec3(a.motion.velocity - b.motion.velocity + behind * gain).norm() +
                       Vec3(a.motion.spin + behind * a.gains.about).norm() * arm_a +
                       Vec3(b.motion.spin + behind * b.gains.about).norm() * arm_b;
  const double more = gain.norm() + a.gains.about.norm() * arm_a + b.gains.about.norm() * arm_b;
  return gap > rounding + (1 + 1e-9) * farthest(speed, more, dt);
}

}  // namespace

ApproachEstimate approach_estimate(const Model<2>& model, const State<2>& state, const Work<2>& work, int p, int q,
                                   double dt) {
  const MovingPiece a = moving_piece(model, state, p), b = moving_piece(model, state, q);
  double most = -unbounded;
  Vec2 normal = Vec2::UnitX();
  look_along_edges(a, b, 1, most, normal);
  look_along_edges(b, a, -1, most, normal);
  const auto side = [&](const MovingPiece& moving, int piece) {
    return Side<2>{moving, gains_of(model, state, work, piece, moving, dt), 0, piece_mass(model, piece)};
  };
  return meet<2>(side(a, p), side(b, q), normal, closing_stiffness(model, p, q), 0.5 * state.last_dt, dt);
}

ApproachEstimate approach_estimate(const Model<3>& model, const State<3>& state, const Work<3>& work, int p, int q,
                                   double dt) {
  const PlacedSolid &a = work.solids.placed[p], &b = work.solids.placed[q];
  const auto side = [&](const PlacedSolid& placed, int piece) {
    return Side<3>{placed, motion_of(model, state, model.carrier_of(piece)),
                   gain_of_piece(model, state, work, piece, dt), placed.solid->radius, piece_mass(model, piece)};
  };
  const Side<3> of_a = side(a, p), of_b = side(b, q);
  const double behind = 0.5 * state.last_dt;
  Vec3 normal;
  if (a.solid->is_sphere() || b.solid->is_sphere()) {
    normal = sphere_normal(a, b);
  } else {
    // Most pairs on the list do not meet within the step, and their faces alone show it.
    const Separation3 faces = face_separation(a, b);
    if (stay_apart(of_a, of_b, faces.distance, behind, dt)) {
      ApproachEstimate none;
      none.gap = faces.distance, none.apart = true;
      return none;
    }
    normal = separation_beyond(a, b, faces).axis;
  }
  return meet<3>(of_a, of_b, normal, closing_stiffness(model, p, q), behind, dt);
}

}  // namespace trilith
