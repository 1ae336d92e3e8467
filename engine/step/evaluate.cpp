#include "step/evaluate.hpp"

#include <algorithm>
#include <cmath>

#include "body/rigid.hpp"
#include "detect/pairs.hpp"
#include "step/stable_step.hpp"
#include "world/pose.hpp"

namespace trilith {

void evaluate(const Model<2>& model, State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  place(model, state, work);
  clock.mark(StepPart::place);
  find(model, state, work);
  clock.mark(StepPart::find);
  work.given = state.given;
  // Rows that are not worked on hold an empty memory, before and after: those that turned last are cleared here.
  for (const int row : work.turned) work.memory[row] = {};
  work.turned.clear();
  std::fill(work.skin_force.begin(), work.skin_force.end(), Vec2::Zero());
  clock.mark(StepPart::place);
  respond_faces(model, state, work, dt, times);
  clock.skip();
  respond_general(model, state, work, dt);
  clock.mark(StepPart::general);
  respond_bearings(model, state, work, dt);
  clock.mark(StepPart::bearings);
  resist(model, state, work);
  clock.mark(StepPart::resist);
  push(model, state, work);
  sum(model, state, work);
  clock.mark(StepPart::sum);
}

namespace {

/// place of a deformable body: its skin points are its nodes. Returns the largest speed squared.
double place_nodes(const State<2>& state, const Body& body, Work<2>& work) {
  double fastest = 0;
  for (int i = 0; i < body.skins; ++i) {
    const Vec2 &x = state.position[body.first_node + i], &v = state.velocity[body.first_node + i];
    work.skin[body.first_skin + i] = {x.x(), x.y(), v.x(), v.y()};
    fastest = std::max(fastest, v.squaredNorm());
  }
  return fastest;
}

/// A bearing with an end on a deformable body. Its force acts on both bodies along one line, through b's point.
void add_bearing(const Model<2>& model, const State<2>& state, Work<2>& work, std::size_t i) {
  const Bearing<2>& b = model.bearings[i];
  const Anchor a = anchor_a(b), at_b = anchor_b(b);
  const Vec2 f = work.bearing_force[i];
  const Vec2 between = anchor_pose(model, state, at_b).place - anchor_pose(model, state, a).place;
  const double moment = work.bearing_moment[i];
  add_at_anchor(model, state, at_b, f, moment, work.force, work.moment);
  add_at_anchor(model, state, a, -f, -cross(between, f) - moment, work.force, work.moment);
}

/// spread of a deformable body, and what its elements give.
void spread_nodes(const Body& body, Work<2>& work) {
  for (int i = 0; i < body.nodes; ++i) {
    const int n = body.first_node + i;
    work.force[n] = work.skin_force[body.first_skin + i] + work.element_force[n] + work.element_damping[n];
    work.moment[n] = 0;
  }
}

}  // namespace

void place(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.skin.resize(model.skin_place.size());
  work.skin_force.resize(model.skin_place.size());
  double fastest = 0, fastest_moving = 0;
  for (const Body& body : model.bodies) {
    const int n = body.first_node;
    if (body.deforms()) {
      const double speed2 = place_nodes(state, body, work);
      fastest = std::max(fastest, speed2);
      if (model.body_moves(static_cast<int>(&body - model.bodies.data())))
        fastest_moving = std::max(fastest_moving, speed2);
      continue;
    }
    const NodeMotion node{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
    const auto first = static_cast<std::size_t>(body.first_skin), count = static_cast<std::size_t>(body.skins);
    const double speed2 = place_rigid(node, std::span(model.skin_place).subspan(first, count),
                                      std::span(work.skin).subspan(first, count));
    fastest = std::max(fastest, speed2);
    if (model.moves(n)) fastest_moving = std::max(fastest_moving, speed2);
  }
  work.fastest = std::sqrt(fastest);
  work.fastest_moving = std::sqrt(fastest_moving);
  work.travel += work.fastest * state.last_dt;
}

namespace {

/// Brings State::contact into step with the pairs just found: kept memories move, the rest start empty.
void carry_memories(State<2>& state, const Work<2>& work) {
  std::vector<ContactKey> keys(work.pairs.size());
  std::vector<ContactMemory> memories(work.pairs.size());
  std::size_t old = 0;
  for (std::size_t row = 0; row < keys.size(); ++row) {
    keys[row] = contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b);
    while (old < state.contact.size() && state.contact[old] < keys[row]) ++old;
    if (old < state.contact.size() && state.contact[old] == keys[row]) memories[row] = state.memory[old];
  }
  state.contact = std::move(keys);
  state.memory = std::move(memories);
}

}  // namespace

void find(const Model<2>& model, State<2>& state, Work<2>& work) {
  if (!pairs_outdated(model, state, work)) return;
  if (!work.valid) bound_faces(model, work);
  find_pairs(model, state, work);
  carry_memories(state, work);
  work.memory.assign(work.pairs.size(), {});
  work.turned.clear();
  work.general_now.reserve(work.pairs.size());
  work.general_touching.reserve(work.pairs.size());
  work.turned.reserve(work.pairs.size());
}

void sum(const Model<2>& model, const State<2>& state, Work<2>& work) {
  const auto nodes = static_cast<std::size_t>(model.nodes());
  work.force.resize(nodes);
  work.moment.resize(nodes);
  const Vec2 field = model.gravity.at(state.time);
  const bool loaded = !work.load.empty();
  const std::vector<Vec2>& load = loaded ? work.load : model.load;
  double unbalanced = 0, carried = 0;
  for (const Body& body : model.bodies) {
    if (body.deforms()) {
      spread_nodes(body, work);
      continue;
    }
    const int n = body.first_node;
    const auto first = static_cast<std::size_t>(body.first_skin), count = static_cast<std::size_t>(body.skins);
    Vec2 force = Vec2::Zero();
    double moment = 0;
    spread_rigid(state.position[n], std::span<const SkinMotion>(work.skin).subspan(first, count),
                 std::span<const Vec2>(work.skin_force).subspan(first, count), force, moment);
    work.force[n] = force;
    work.moment[n] = moment;
  }
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    const Bearing<2>& b = model.bearings[i];
    if (b.element_a >= 0 || b.element_b >= 0) {
      add_bearing(model, state, work, i);
      continue;
    }
    const int na = model.bodies[b.body_a].first_node, nb = model.bodies[b.body_b].first_node;
    const Vec2 point = state.position[nb] + Turn(state.rotation[nb]).apply(b.point_b);
    const Vec2& f = work.bearing_force[i];
    work.force[nb] += f;
    work.force[na] -= f;
    work.moment[nb] += cross(Vec2(point - state.position[nb]), f) + work.bearing_moment[i];
    work.moment[na] -= cross(Vec2(point - state.position[na]), f) + work.bearing_moment[i];
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    const Vec2 steady = model.mass[n] * field + load[n];
    const double reacts = work.force[n].norm();
    work.force[n] += steady;
    if (loaded) work.moment[n] += work.load_moment[n];
    if (!model.moves(static_cast<int>(n))) continue;
    carried = std::max({carried, reacts, steady.norm()});
    Vec2 left = work.force[n];
    for (const int k : {0, 1})
      if (model.support[n][k] != Support::free) left[k] = 0;
    unbalanced = std::max(unbalanced, left.norm());
  }
  work.unbalanced = unbalanced;
  work.carried = carried;
}

}  // namespace trilith
