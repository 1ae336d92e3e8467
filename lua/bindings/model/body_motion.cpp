#include "bindings/model/body_motion.hpp"

#include "model/pose.hpp"
#include "model/space_builder/space_builder.hpp"
#include "model/turn_reading.hpp"

namespace trilith::script {
namespace {

Vec3 lifted(const Vec2& v) {
  return {v.x(), v.y(), 0};
}

/// A body that has cracked is read at its centroid, which its part carries.
BodyMotion motion_on_part(const PlaneModel& m, int body, int part) {
  const Simulation<2>& s = *m.if_built();
  const Pose pose = body_pose(s.model(), s.state(), part);
  const Vec2 start = body_start(s.model(), body);
  const Vec2 arm = Turn(pose.rotation).apply(Vec2(start - body_start(s.model(), part)));
  const Vec2 place = pose.place + arm, velocity = pose.velocity + cross(pose.spin, arm);
  return {lifted(place), lifted(place - start), {0, 0, pose.rotation}, lifted(velocity), {0, 0, pose.spin}};
}

BodyMotion motion_in_plane(const PlaneModel& m, int body) {
  if (const int part = m.heir_of(body); part >= 0) return motion_on_part(m, body, part);
  const BodySpec& spec = m.spec(body);
  const Simulation<2>* s = m.has_body(body) ? m.if_built() : nullptr;
  const Pose pose = s != nullptr ? body_pose(s->model(), s->state(), body)
                                 : Pose{moments_of(spec).centroid, 0, spec.velocity, spec.spin};
  const Vec2 moved = s != nullptr ? Vec2(pose.place - body_start(s->model(), body)) : Vec2(Vec2::Zero());
  return {lifted(pose.place), lifted(moved), {0, 0, pose.rotation}, lifted(pose.velocity), {0, 0, pose.spin}};
}

/// As motion_on_part. The rotation is the rotation of the part from the start.
BodyMotion motion_on_solid_part(const SpaceModel& m, int body, int part) {
  const Simulation<3>& s = *m.if_built();
  const Model<3>& model = s.model();
  const auto start_of_body = [&](int b) {
    return model.start_position[static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(b)].first_node)];
  };
  const Pose3 pose = body_pose(model, s.state(), part);
  const Vec3 start = start_of_body(body);
  const Vec3 arm = turn_of(pose.turned).apply(Vec3(start - start_of_body(part)));
  const Vec3 place = pose.place + arm, velocity = pose.velocity + cross(pose.spin, arm);
  return {place, Vec3(place - start), turn_reading(model, s.state(), part), velocity, pose.spin};
}

BodyMotion motion_in_space(const SpaceModel& m, int body) {
  if (const int part = m.heir_of(body); part >= 0) return motion_on_solid_part(m, body, part);
  const Simulation<3>* s = m.has_body(body) ? m.if_built() : nullptr;
  if (s == nullptr) {
    const SolidSpec& spec = m.spec(body);
    const Vec3 centre = spec.mesh      ? centre_of(*spec.mesh)
                        : spec.moments ? spec.moments->centroid
                                       : mass_of(spec.pieces, 1, spec.spheres).centroid;
    return {centre, Vec3::Zero(), Vec3::Zero(), spec.velocity, spec.spin};
  }
  const Pose3 pose = body_pose(s->model(), s->state(), body);
  return {pose.place, pose.moved, turn_reading(s->model(), s->state(), body), pose.velocity, pose.spin};
}

}  // namespace

BodyMotion motion_of(const BodyHandle& b) {
  if (const PlaneModel* plane = as_plane(b.model())) return motion_in_plane(*plane, b.index);
  return motion_in_space(static_cast<const SpaceModel&>(b.model()), b.index);
}

}  // namespace trilith::script
