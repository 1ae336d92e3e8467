// Rigid solids in space in contact: short model builders, and runs.
#pragma once

#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "assembly/evaluate.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "events/commit.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "model/energy.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith::testing {

/// A box of sides `sides` [m] about `centre`, rotated by `turn`.
inline Polyhedron box_at(const Vec3& sides, const Vec3& centre, const UnitQuaternion& turn = {}) {
  return placed(box_solid(-0.5 * sides, 0.5 * sides), turn, centre);
}

/// A body of one piece.
inline SolidBody stone(const std::string& name, const Polyhedron& shape, double density = 2000) {
  SolidBody body;
  body.name = name, body.pieces = {shape}, body.density = density;
  return body;
}
inline SolidBody fixed_stone(const std::string& name, const Polyhedron& shape) {
  SolidBody body = stone(name, shape);
  body.fixed = true;
  return body;
}

/// A run of solids with a fixed step.
class SolidRun {
 public:
  SolidRun(const Model<3>& model, double dt) : SolidRun(model, initial_state(model), dt) {}
  SolidRun(const Model<3>& model, const State<3>& state, double dt) : model_(model), state_(state) {
    options_.dt = dt;
    look();
  }
  /// Forces are up to date before and after.
  void step() {
    commit(model_, state_, work_);
    advance(model_, state_, work_, options_);
    look();
  }
  void run(double seconds) {
    const auto count = static_cast<int>(std::lround(seconds / options_.dt));
    for (int i = 0; i < count; ++i) step();
  }
  /// Steps with the damping of consolidation.
  void settle(double seconds) {
    options_.rest.share = 0.8;
    run(seconds);
    options_.rest.share = 0;
  }
  /// Steps until `done` returns true, for `most` [s] at most. Returns whether it did.
  bool run_until(double most, const std::function<bool()>& done) {
    for (const double end = state_.time + most; state_.time < end;) {
      step();
      if (done()) return true;
    }
    return false;
  }
  StepOptions& options() { return options_; }
  void drop_work() { work_ = {}, look(); }
  Model<3>& model() { return model_; }
  [[nodiscard]] const Model<3>& model() const { return model_; }
  State<3>& state() { return state_; }
  [[nodiscard]] const State<3>& state() const { return state_; }
  [[nodiscard]] const Work<3>& work() const { return work_; }
  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] Energy energy() const { return energy_now(model_, state_, work_, options_); }
  [[nodiscard]] double moving_energy() const { return energy()[EnergyTerm::kinetic]; }
  [[nodiscard]] Vec3 place(int body) const { return state_.position[static_cast<std::size_t>(body)]; }
  [[nodiscard]] Vec3 velocity(int body) const { return state_.velocity[static_cast<std::size_t>(body)]; }
  [[nodiscard]] Vec3 spin(int body) const { return state_.spin[static_cast<std::size_t>(body)]; }
  /// Rotation vector of a body since the start [rad].
  [[nodiscard]] Vec3 turned(int body) const {
    const auto b = static_cast<std::size_t>(body);
    return angle_of(state_.rotation[b] * inverse(model_.start_rotation[b]));
  }
  /// Momentum of all bodies [kg m/s].
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < state_.velocity.size(); ++n) sum += model_.mass[n] * state_.velocity[n];
    return sum;
  }
  /// Overlap volume of all pairs of adjacent pieces [m3].
  [[nodiscard]] double shared_volume() const {
    SolidOverlapBuffer room;
    double sum = 0;
    for (const NearPair& p : work_.pairs)
      sum += solid_overlap(work_.solids.placed[static_cast<std::size_t>(p.piece_a)],
                           work_.solids.placed[static_cast<std::size_t>(p.piece_b)], room)
                 .volume;
    return sum;
  }
  /// Angular momentum about the origin [kg m2/s]. Positions are half a step after the velocities, as leapfrog has them;
  /// the moment of m v does not change along v.
  [[nodiscard]] Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < state_.velocity.size(); ++n)
      sum += cross(state_.position[n], Vec3(model_.mass[n] * state_.velocity[n])) +
             momentum_of(model_.inertia[n], state_.rotation[n], state_.spin[n]);
    return sum;
  }

 private:
  /// Evaluates all forces of the next step, as Simulation does.
  void look() {
    evaluate(model_, state_, work_, state_.last_dt);
    add_inertia(model_, state_, work_, options_);
  }
  Model<3> model_;
  State<3> state_;
  Work<3> work_;
  StepOptions options_;
};

inline Frictional frictional(double kn, double ks, double mu, double beta = 0) {
  Frictional law;
  law.kn = kn, law.ks = ks, law.mu = mu, law.beta = beta;
  return law;
}

inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// Gravity of a plane tilted by `angle` [rad] towards an azimuth [rad]: gravity is tilted instead of the plane.
inline Vec3 tilted_gravity(double angle, double azimuth) {
  return standard_gravity *
         Vec3(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), -std::cos(angle));
}

}  // namespace trilith::testing
