// Loads of the present instant on the nodes.
#include "assembly/bearing_motion.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "load/forces.hpp"
#include "model/pose.hpp"

namespace trilith {

void apply_load(const Model<2>& model, const State<2>& state, const PointLoad<2>& p, std::vector<Vec2>& node_force,
                std::vector<double>& node_moment) {
  const double share = p.curve.at(state.time);
  if (share == 0) return;
  // A following load rotates with its attachment.
  const Vec2 force = p.follows ? Turn(pose_at(model, state, p.at).rotation).apply(p.force) : p.force;
  apply_force(model, state, p.at, share * force, share * p.moment, node_force, node_moment);
}

/// In space a following load rotates with the body, and so does its moment.
void apply_load(const Model<3>& model, const State<3>& state, const PointLoad<3>& p, std::vector<Vec3>& node_force,
                std::vector<Vec3>& node_moment) {
  const double share = p.curve.at(state.time);
  if (share == 0) return;
  const int n = p.at.node[0];
  const Turn3 turn = turn_of(motion_of(model, state, n).rotation);
  const Vec3 force = share * (p.follows ? turn.apply(p.force) : p.force),
             moment = share * (p.follows ? turn.apply(p.moment) : p.moment);
  push_contact_frame(model, state, n, point_of(model, state, p.at), force, moment, node_force, node_moment);
}

/// A pressure over a face is distributed to its two skin points by the shares of the face that it covers, and from
/// there to their nodes: the force directly, its moment by the arm.
void apply_load(const Model<2>& model, const State<2>& state, const FaceLoad<2>& f, const Work<2>& work,
                std::vector<Vec2>& node_force, std::vector<double>& node_moment) {
  const double share = f.curve.at(state.time);
  if (share == 0) return;
  const SkinMotion<2>&a = work.skin[f.skin_a], &b = work.skin[f.skin_b];
  const Vec2 full = share * face_force(f, a, b);
  const auto add = [&](int skin, const SkinMotion<2>& at, double part) {
    const int n = model.skin_node[skin];
    const Vec2 force = part * full;
    node_force[n] += force;
    node_moment[model.skin_turn[skin]] +=
        cross(Vec2(at.x - state.position[n].x(), at.y - state.position[n].y()), force);
  };
  add(f.skin_a, a, f.share[0]);
  add(f.skin_b, b, f.share[1]);
}

Vec2 face_force(const FaceLoad<2>& load, const SkinMotion<2>& a, const SkinMotion<2>& b) {
  return load.follows ? Vec2(load.pressure * load.depth * left_of(Vec2(b.x - a.x, b.y - a.y))) : load.dead;
}

namespace {

/// Sets the steady loads of the model; false if there are no others. Empty arrays mean no loads beyond the steady ones,
/// and assemble_forces and the nodes read the arrays of the model.
template <int D>
bool begin_loads(const Model<D>& model, Work<D>& work) {
  if (!model.loaded()) {
    if (work.load.empty()) return false;
    work.load.clear(), work.load_moment.clear(), work.correction.clear(), work.correction_moment.clear();
    work.push_force.clear();
    return false;
  }
  work.load.assign(model.load.begin(), model.load.end());
  work.load_moment.assign(model.load.size(), nothing<Moment<D>>());
  work.correction.clear(), work.correction_moment.clear();
  work.push_force.assign(model.pushes.size(), 0);
  return true;
}

}  // namespace

/// In space there are point loads only.
void apply_loads(const Model<3>& model, const State<3>& state, Work<3>& work) {
  if (!begin_loads(model, work)) return;
  for (const PointLoad<3>& p : model.point_loads) apply_load(model, state, p, work.load, work.load_moment);
}

void apply_loads(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!begin_loads(model, work)) return;
  for (const PointLoad<2>& p : model.point_loads) apply_load(model, state, p, work.load, work.load_moment);
  for (const FaceLoad<2>& f : model.face_loads) apply_load(model, state, f, work, work.load, work.load_moment);
}

}  // namespace trilith
