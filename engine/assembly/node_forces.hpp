// Forces of one node at an instant and the resulting velocity, shared by a step, its ledger and the pushes.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "assembly/step_options.hpp"
#include "base/rotation_3d.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// One number for each degree of freedom of a node: translations, then rotations. Plain doubles, because this runs for
/// every node in every step, and vectors of two are passed through memory.
template <int D>
using Dofs = std::array<double, Space<D>::dofs>;

/// Joins a translational and a rotational part.
inline Dofs<2> dofs_of(const Vec2& along, double about) {
  return {along.x(), along.y(), about};
}
inline Dofs<3> dofs_of(const Vec3& along, const Vec3& about) {
  return {along.x(), along.y(), along.z(), about.x(), about.y(), about.z()};
}
/// The translational part, and the rotational part.
template <std::size_t dofs>
auto along_of(const std::array<double, dofs>& v) {
  if constexpr (dofs == 3)
    return Vec2(v[0], v[1]);
  else
    return Vec3(v[0], v[1], v[2]);
}
template <std::size_t dofs>
auto about_of(const std::array<double, dofs>& v) {
  if constexpr (dofs == 3)
    return v[2];
  else
    return Vec3(v[3], v[4], v[5]);
}

template <int D>
Dofs<D> velocity_of(const State<D>& state, int n) {
  return dofs_of(state.velocity[n], state.spin[n]);
}

/// Masses, then the moment of inertia; in space the diagonal of its tensor in world axes.
inline Dofs<2> mass_of(const Model<2>& model, const State<2>& /*state*/, int n) {
  return {model.mass[n], model.mass[n], model.inertia[n]};
}
inline Dofs<3> mass_of(const Model<3>& model, const State<3>& state, int n) {
  const Turn3 turn(state.rotation[n]);
  const Vec3 x = turn.x().cwiseAbs2(), y = turn.y().cwiseAbs2(), z = turn.z().cwiseAbs2(), &own = model.inertia[n];
  return dofs_of(Vec3(Vec3::Constant(model.mass[n])), Vec3(own.x() * x + own.y() * y + own.z() * z));
}
/// Length that relates moments to forces: radius of gyration, in space the mean one; 0 for a point mass [m].
inline double gyration_of(const Model<2>& model, int n) {
  return std::sqrt(model.inertia[n] / model.mass[n]);
}
inline double gyration_of(const Model<3>& model, int n) {
  return std::sqrt(model.inertia[n].sum() / (3 * model.mass[n]));
}

/// Forces of one node at an instant on its free degrees of freedom, and the forces on its supports.
template <int D>
struct NodeForces {
  Dofs<D> force{}, weight{}, load{}, rest{}, mass{}, on_support{};
  Dofs<D> element_damping{};
  bool held = false, damped = false;  ///< some degree of freedom is not free; the node has dampings
};

/// Force of `share` times the `count` components from `first` on of `f`, against the same components of v.
template <int D>
void brake(const Dofs<D>& v, int first, int count, double share, NodeForces<D>& f) {
  double speed = 0, size = 0;
  for (int k = first; k < first + count; ++k) speed += v[k] * v[k], size += f.force[k] * f.force[k];
  speed = std::sqrt(speed), size = share * std::sqrt(size);
  for (int k = first; k < first + count; ++k)
    if (speed > 0) f.rest[k] = -size / speed * v[k];
}

/// Dampings of whole nodes. Mass damping is -mass_damping times momentum and angular momentum.
template <int D>
void add_dampings(const Model<D>& model, const State<D>& state, int n, const Dofs<D>& v, const RestDamping& rest,
                  NodeForces<D>& f) {
  constexpr int along = Space<D>::translations, all = Space<D>::dofs;
  if (rest.share > 0) {
    brake<D>(v, 0, along, rest.share, f);
    if constexpr (D == 2) {
      if (v[2] != 0) f.rest[2] = -std::copysign(rest.share * std::abs(f.force[2]), v[2]);
    } else {
      brake<D>(v, along, along, rest.share, f);
    }
  }
  for (int k = 0; k < along; ++k) f.mass[k] = -model.mass_damping * model.mass[n] * v[k];
  if constexpr (D == 2) {
    f.mass[2] = -model.mass_damping * model.inertia[n] * v[2];
  } else {
    const Vec3 momentum = momentum_of(model.inertia[n], state.rotation[n], state.spin[n]);
    for (int k = along; k < all; ++k) f.mass[k] = -model.mass_damping * momentum[k - along];
  }
  for (int k = 0; k < all; ++k) {
    if (model.support[n][k] != Support::free) f.mass[k] = 0;
    f.force[k] += f.rest[k] + f.mass[k];
  }
}

/// Damping forces along the axes on a node in the plane that is free along both: the corresponding part of
/// add_dampings.
struct PlaneDamping {
  Vec2 rest = Vec2::Zero(), mass = Vec2::Zero();  ///< N

  PlaneDamping() = default;
  [[gnu::always_inline]] PlaneDamping(const Model<2>& model, int n, const Vec2& v, const Vec2& force,
                                      const RestDamping& damping) {
    if (damping.share > 0) {
      const double speed = std::sqrt(v.x() * v.x() + v.y() * v.y()),
                   size = damping.share * std::sqrt(force.x() * force.x() + force.y() * force.y());
      if (speed > 0) rest = {-size / speed * v.x(), -size / speed * v.y()};
    }
    const double rate = -model.mass_damping * model.mass[n];
    mass = {rate * v.x(), rate * v.y()};
  }
  [[nodiscard]] Vec2 force() const { return {rest.x() + mass.x(), rest.y() + mass.y()}; }
};

/// External actions on nodes at one instant, computed once for all nodes.
template <int D>
struct Outside {
  Vec<D> field;                                  ///< [m/s2]
  const Vec<D>* load;                            ///< [node] N
  const Moment<D>* moment = nullptr;             ///< [node] N m; nullptr: none
  const Vec<D>* correction = nullptr;            ///< [node] N; nullptr: none
  const Moment<D>* correction_moment = nullptr;  ///< [node] N m

  Outside(const Model<D>& model, const State<D>& state, const Work<D>& work)
      : field(model.gravity.at(state.time)), load(model.load.data()) {
    if (!work.load.empty()) load = work.load.data(), moment = work.load_moment.data();
    if (!work.correction.empty())
      correction = work.correction.data(), correction_moment = work.correction_moment.data();
  }
};

/// Correction forces of pushes, which no damping may resist: see statics/displacement_control.hpp.
template <int D>
void add_correction(const Outside<D>& outside, const std::array<Support, Space<D>::dofs>& support, int n,
                    NodeForces<D>& f) {
  const Dofs<D> correction = dofs_of(outside.correction[n], outside.correction_moment[n]);
  for (int k = 0; k < Space<D>::dofs; ++k) {
    if (support[k] != Support::free) continue;
    f.force[k] += correction[k];
    f.load[k] += correction[k];
  }
}

template <int D>
[[gnu::always_inline]] inline NodeForces<D> node_forces(const Model<D>& model, const State<D>& state,
                                                        const Work<D>& work, int n, const Dofs<D>& v,
                                                        const Outside<D>& outside, const RestDamping& rest) {
  const Moment<D> none = nothing<Moment<D>>();
  NodeForces<D> f;
  const auto& support = model.support[n];
  const Dofs<D> total = dofs_of(work.force[n], work.moment[n]);
  const Dofs<D> weight = dofs_of(Vec<D>(model.mass[n] * outside.field), none);
  const Dofs<D> load = dofs_of(outside.load[n], outside.moment == nullptr ? none : outside.moment[n]);
  for (const Support s : support) f.held = f.held || s != Support::free;
  f.force = total, f.weight = weight, f.load = load;
  if (!work.element_damping.empty())
    f.element_damping =
        dofs_of(work.element_damping[n], work.element_damping_moment.empty() ? none : work.element_damping_moment[n]);
  for (int k = 0; k < Space<D>::dofs; ++k) {
    if (!f.held || support[k] == Support::free) continue;
    f.force[k] = f.weight[k] = f.load[k] = 0;
    f.on_support[k] = total[k] - weight[k] - load[k];
  }
  f.damped = rest.share > 0 || model.mass_damping > 0;
  if (f.damped) add_dampings(model, state, n, v, rest, f);
  if (outside.correction != nullptr) add_correction(outside, support, n, f);
  if (!work.added_inertia.empty())
    for (int k = 0; k < Space<D>::translations; ++k)
      (support[k] == Support::free ? f.force[k] : f.on_support[k]) += work.added_inertia[n][k];
  return f;
}

template <std::size_t dofs>
[[gnu::always_inline]] inline double dot(const std::array<double, dofs>& a, const std::array<double, dofs>& b) {
  double sum = a[0] * b[0];
  for (std::size_t k = 1; k < dofs; ++k) sum += a[k] * b[k];
  return sum;
}

/// Work of weight, loads, supports and dampings along `path`. The path of a step is half of the last step and half of
/// the next step around the instant of the forces, which is the true work of the scheme.
template <int D>
[[gnu::always_inline]] inline NodeWork work_of(const NodeForces<D>& f, const std::type_identity_t<Dofs<D>>& path) {
  NodeWork w{dot(f.weight, path), dot(f.load, path)};
  if (f.held) w.support = dot(f.on_support, path);
  w.element_damping = dot(f.element_damping, path);
  if (f.damped) w.rest = dot(f.rest, path), w.mass = dot(f.mass, path);
  return w;
}

/// Adds the work of one node's forces to the ledger.
template <int D>
[[gnu::always_inline]] inline void add_work(const NodeForces<D>& f, const std::type_identity_t<Dofs<D>>& path,
                                            Energy& given) {
  add(work_of(f, path), given);
}

/// Coordinate of degree of freedom k of a node [m] or [rad].
inline double place_along(const State<2>& state, int n, int k) {
  return k == 2 ? state.rotation[n] : state.position[n][k];
}
inline double place_along(const State<3>& state, int n, int k) {
  return k >= 3 ? angle_of(state.rotation[n])[k - 3] : state.position[n][k];
}

/// Rotation by a drive about its world axis from one time to another [rad]. In space rotations about several axes do
/// not add up to an orientation, so a drive returns an increment.
inline double driven_turn(const Drive& drive, double from, double to) {
  return drive.motion->displacement(to - drive.start) - drive.motion->displacement(from - drive.start);
}

/// Velocity of a driven degree of freedom that reaches the prescribed value at the end of the step.
template <int D>
double driven_velocity(const Model<D>& model, const State<D>& state, int n, int k, double dt) {
  const Drive& drive = model.drives[model.drive_of[n][k]];
  if (D == 3 && k >= Space<D>::translations) return driven_turn(drive, state.time, state.time + dt) / dt;
  const double now = place_along(state, n, k);
  return (drive.origin + drive.motion->displacement(state.time + dt - drive.start) - now) / dt;
}

/// World axes about which a node is free to turn.
inline std::array<bool, 3> free_turns(const Model<3>& model, int n) {
  const auto& s = model.support[n];
  return {s[3] == Support::free, s[4] == Support::free, s[5] == Support::free};
}

/// Velocity about half a step later: free degrees of freedom by their forces, driven ones by their motion, 0 for fixed
/// ones.
template <int D>
[[gnu::always_inline]] inline Dofs<D> speed_ahead(const Model<D>& model, const State<D>& state, int n, const Dofs<D>& v,
                                                  const NodeForces<D>& f, double span, double dt) {
  Dofs<D> next{};
  for (int k = 0; k < Space<D>::translations; ++k)
    if (model.support[n][k] == Support::free) next[k] = v[k] + f.force[k] / model.mass[n] * span;
  if constexpr (D == 2) {
    if (model.support[n][2] == Support::free) next[2] = v[2] + f.force[2] / model.inertia[n] * span;
  }
  for (int k = 0; k < Space<D>::dofs; ++k)
    if (model.support[n][k] == Support::driven) next[k] = driven_velocity(model, state, n, k, dt);
  if constexpr (D == 3) {
    const Vec3 spin = spin_ahead(model.inertia[n], state.rotation[n], about_of(v), about_of(f.force), span,
                                 free_turns(model, n), about_of(next));
    for (int k = 3; k < 6; ++k) next[k] = spin[k - 3];
  }
  return next;
}

}  // namespace trilith
