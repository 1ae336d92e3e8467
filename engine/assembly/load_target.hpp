// The targets of loads (load/load_kind.hpp): places of an instant, and the nodes.
#pragma once

#include <vector>

#include "assembly/bearing_motion.hpp"
#include "load/list.hpp"
#include "model/model.hpp"
#include "model/pose.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Instant and places. Skin points are read from `work`, or follow from the state if it is nullptr.
template <int D>
struct LoadPlaces;
template <>
struct LoadPlaces<2> {
  const Model<2>& model;
  const State<2>& state;
  const Work<2>* work = nullptr;
  const ClosedJoints<2>* joints = nullptr;

  [[nodiscard]] double time() const { return state.time; }
  [[nodiscard]] double gravity() const { return -model.gravity.at(state.time).y(); }
  [[nodiscard]] const ClosedJoints<2>& closed() const { return *joints; }
  [[nodiscard]] Vec2 place_of(const Attachment<2>& at) const { return pose_at(model, state, at).place; }
  [[nodiscard]] Turn turn_of(const Attachment<2>& at) const { return Turn(pose_at(model, state, at).rotation); }
  [[nodiscard]] Vec2 velocity_of(const Attachment<2>& at) const { return pose_at(model, state, at).velocity; }
  [[nodiscard]] Vec2 skin(int i) const {
    if (work != nullptr) return {work->skin[i].x, work->skin[i].y};
    return state.position[model.skin_node[i]] + Turn(state.rotation[model.skin_turn[i]]).apply(model.skin_place[i]);
  }
};
template <>
struct LoadPlaces<3> {
  const Model<3>& model;
  const State<3>& state;
  const Work<3>* work = nullptr;
  const ClosedJoints<3>* joints = nullptr;

  [[nodiscard]] double time() const { return state.time; }
  [[nodiscard]] double gravity() const { return -model.gravity.at(state.time).z(); }
  [[nodiscard]] const ClosedJoints<3>& closed() const { return *joints; }
  [[nodiscard]] Vec3 place_of(const Attachment<3>& at) const { return point_of(model, state, at); }
  [[nodiscard]] Turn3 turn_of(const Attachment<3>& at) const {
    return trilith::turn_of(motion_of(model, state, at.node[0]).rotation);
  }
  [[nodiscard]] Vec3 velocity_of(const Attachment<3>& at) const {
    const BodyMotion frame = motion_of(model, state, at.node[0]);
    return frame.velocity + cross(frame.spin, Vec3(trilith::turn_of(frame.rotation).apply(at.arm[0])));
  }
};

/// Adds forces [N] and moments [N m] to the nodes.
template <int D>
struct LoadTarget;
template <>
struct LoadTarget<2> : LoadPlaces<2> {
  std::vector<Vec2>& force;
  std::vector<double>& moment;

  void push(const Attachment<2>& at, const Vec2& f, double m) { apply_force(model, state, at, f, m, force, moment); }
  /// The force acts on the node directly, its moment by the arm.
  void push_skin(int i, const Vec2& f) {
    const int n = model.skin_node[i];
    force[n] += f;
    const Vec2 x = skin(i);
    moment[model.skin_turn[i]] += cross(Vec2(x.x() - state.position[n].x(), x.y() - state.position[n].y()), f);
  }
};
template <>
struct LoadTarget<3> : LoadPlaces<3> {
  std::vector<Vec3>& force;
  std::vector<Vec3>& moment;

  void push(const Attachment<3>& at, const Vec3& f, const Vec3& m) {
    push_contact_frame(model, state, at.node[0], point_of(model, state, at), f, m, force, moment);
  }
};

}  // namespace trilith
