// Rigid bodies in space without contact: models built directly, and runs of them.
#pragma once

#include <array>

#include "assembly/evaluate.hpp"
#include "base/rotation_3d.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"

namespace trilith::testing {

/// One rigid body: principal moments [kg m2], rotation of its axes, its spin in world axes [rad/s]. Its skin points are
/// the ends of its axes, at 1 m.
inline Model<3> free_body(double mass, const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin) {
  Model<3> model;
  model.mass = {mass}, model.inertia = {inertia};
  model.support.resize(1), model.support[0].fill(Support::free);
  model.drive_of.resize(1), model.drive_of[0].fill(-1);
  model.start_position = {Vec3::Zero()}, model.start_rotation = {rotation};
  model.start_velocity = {Vec3::Zero()}, model.start_spin = {spin};
  model.load = {Vec3::Zero()};
  model.skin_place = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  model.skin_node = model.skin_turn = {0, 0, 0};
  Body body;
  body.name = "body", body.skins = 3;
  model.bodies = {body}, model.body_radius = {1};
  return model;
}

/// A run of a model with a fixed step.
class FreeRun {
 public:
  FreeRun(const Model<3>& model, double dt) : FreeRun(model, initial_state(model), dt) {}
  FreeRun(const Model<3>& model, const State<3>& state, double dt) : model_(model), state_(state) {
    options_.dt = dt;
    evaluate(model_, state_, work_, dt);
    commit(model_, state_, work_);
  }
  void step() {
    advance(model_, state_, work_, options_);
    evaluate(model_, state_, work_, options_.dt);
    commit(model_, state_, work_);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  [[nodiscard]] const State<3>& state() const { return state_; }
  [[nodiscard]] const Work<3>& work() const { return work_; }
  [[nodiscard]] Energy energy() const { return energy_now(model_, state_, work_, options_); }
  /// In world axes [kg m2/s].
  [[nodiscard]] Vec3 momentum() const { return momentum_of(model_.inertia[0], state_.rotation[0], state_.spin[0]); }
  /// In body axes [rad/s].
  [[nodiscard]] Vec3 own_spin() const { return Turn3(state_.rotation[0]).undo(state_.spin[0]); }

 private:
  Model<3> model_;
  State<3> state_;
  Work<3> work_;
  StepOptions options_;
};

}  // namespace trilith::testing
