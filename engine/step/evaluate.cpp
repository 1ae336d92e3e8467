#include "step/evaluate.hpp"

#include <algorithm>
#include <cmath>

#include "body/rigid.hpp"
#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/stable_step.hpp"
#include "world/pose.hpp"

namespace trilith {
namespace {

void forget(const State<2>& state, Work<2>& work, int row) {
  work.memory[row] = {};
  std::fill_n(trial_law_numbers(state, work, row), law_number_counts[state.law_row[row].place], 0.0);
}

}  // namespace

void evaluate(const Model<2>& model, State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  place(model, state, work);
  clock.mark(StepPart::place);
  find(model, state, work);
  clock.mark(StepPart::find);
  work.given = state.given;
  // Rows that are not worked on hold an empty memory, before and after: those that turned last are cleared here.
  for (const int row : work.turned) forget(state, work, row);
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
double place_nodes(const State<2>& state, const BodyRow& body, Work<2>& work) {
  double fastest = 0;
  for (int i = 0; i < body.skins; ++i) {
    const Vec2 &x = state.position[body.node + i], &v = state.velocity[body.node + i];
    work.skin[body.skin + i] = {x.x(), x.y(), v.x(), v.y()};
    fastest = std::max(fastest, v.squaredNorm());
  }
  return fastest;
}

/// place of a rigid body.
double place_body(const Model<2>& model, const State<2>& state, const BodyRow& body, Work<2>& work) {
  const int n = body.node;
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  return place_rigid({state.position[n], state.rotation[n], state.velocity[n], state.spin[n]},
                     std::span(model.skin_place).subspan(first, count), std::span(work.skin).subspan(first, count));
}

void list_bodies(const Model<2>& model, Work<2>& work) {
  work.body.clear();
  for (const Body& b : model.bodies) work.body.push_back({b.first_node, b.nodes, b.first_skin, b.skins, b.deforms()});
}

/// True where some node of the body is free to move.
bool moves(const Model<2>& model, const BodyRow& body) {
  for (int n = body.node; n < body.node + body.nodes; ++n)
    if (model.moves(n)) return true;
  return false;
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
void spread_nodes(const BodyRow& body, Work<2>& work) {
  for (int i = 0; i < body.nodes; ++i) {
    const int n = body.node + i;
    work.force[n] = work.skin_force[body.skin + i] + work.element_force[n] + work.element_damping[n];
    work.moment[n] = 0;
  }
}

}  // namespace

void place(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!work.valid) list_bodies(model, work);
  work.skin.resize(model.skin_place.size());
  work.skin_force.resize(model.skin_place.size());
  double fastest = 0, fastest_moving = 0;
  for (const BodyRow& body : work.body) {
    const double speed2 = body.deforms ? place_nodes(state, body, work) : place_body(model, state, body, work);
    fastest = std::max(fastest, speed2);
    if (speed2 > fastest_moving && moves(model, body)) fastest_moving = speed2;
  }
  work.fastest = std::sqrt(fastest);
  work.fastest_moving = std::sqrt(fastest_moving);
  work.travel += work.fastest * state.last_dt;
}

namespace {

/// Where the laws of the pairs keep what they remember.
std::vector<LawRow> law_rows(const Model<2>& model, const Work<2>& work) {
  std::vector<LawRow> rows(work.pairs.size());
  std::uint32_t numbers = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t place = model.laws[work.pairs[row].law].index();
    rows[row] = {static_cast<std::uint32_t>(place), numbers};
    numbers += law_number_counts[place];
  }
  return rows;
}

/// Brings State::contact into step with the pairs just found: kept memories move, the rest start empty. What a law
/// remembers is of no use to one of another kind.
void carry_memories(const Model<2>& model, State<2>& state, const Work<2>& work) {
  State<2> now;
  now.contact.resize(work.pairs.size());
  now.memory.resize(work.pairs.size());
  now.law_row = law_rows(model, work);
  if (!now.law_row.empty())
    now.law_memory.resize(now.law_row.back().first + law_number_counts[now.law_row.back().place]);
  std::size_t old = 0;
  for (std::size_t row = 0; row < now.contact.size(); ++row) {
    const ContactKey key = now.contact[row] = contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b);
    while (old < state.contact.size() && state.contact[old] < key) ++old;
    if (old == state.contact.size() || state.contact[old] != key) continue;
    now.memory[row] = state.memory[old];
    if (now.law_row[row].place != state.law_row[old].place) continue;
    std::copy_n(state.law_numbers(old), law_number_counts[now.law_row[row].place], now.law_numbers(row));
  }
  state.contact = std::move(now.contact);
  state.memory = std::move(now.memory);
  state.law_row = std::move(now.law_row);
  state.law_memory = std::move(now.law_memory);
}

}  // namespace

void find(const Model<2>& model, State<2>& state, Work<2>& work) {
  if (!pairs_outdated(model, state, work)) return;
  if (!work.valid) bound_faces(model, work);
  find_pairs(model, state, work);
  carry_memories(model, state, work);
  work.memory.assign(work.pairs.size(), {});
  work.law_memory.assign(state.law_memory.size(), 0);
  work.turned.clear();
  work.general_now.reserve(work.pairs.size());
  work.general_touching.reserve(work.pairs.size());
  work.turned.reserve(work.pairs.size());
}

namespace {

/// spread of a rigid body.
void spread_body(const State<2>& state, const BodyRow& body, Work<2>& work) {
  const auto first = static_cast<std::size_t>(body.skin), count = static_cast<std::size_t>(body.skins);
  const NodeLoad load =
      spread_rigid(state.position[body.node], std::span<const SkinMotion>(work.skin).subspan(first, count),
                   std::span<const Vec2>(work.skin_force).subspan(first, count));
  work.force[body.node] = {load.x, load.y};
  work.moment[body.node] = load.moment;
}

/// A bearing between two rigid bodies, or with an end on a deformable one.
void spread_bearing(const Model<2>& model, const State<2>& state, Work<2>& work, std::size_t i) {
  const Bearing<2>& b = model.bearings[i];
  if (b.element_a >= 0 || b.element_b >= 0) return add_bearing(model, state, work, i);
  const int na = model.bodies[b.body_a].first_node, nb = model.bodies[b.body_b].first_node;
  const Vec2 point = state.position[nb] + Turn(state.rotation[nb]).apply(b.point_b);
  const Vec2& f = work.bearing_force[i];
  work.force[nb] += f;
  work.force[na] -= f;
  work.moment[nb] += cross(Vec2(point - state.position[nb]), f) + work.bearing_moment[i];
  work.moment[na] -= cross(Vec2(point - state.position[na]), f) + work.bearing_moment[i];
}

double squared_size(const LanePair& v) {
  const LanePair squares = v * v;
  return squares[0] + squares[1];
}

/// Adds what acts on the nodes from outside, and finds the largest forces carried and left over. Sizes are compared
/// squared; the root keeps their order.
void add_outside(const Model<2>& model, const Vec2& field, Work<2>& work) {
  const bool loaded = !work.load.empty();
  const Vec2* load = loaded ? work.load.data() : model.load.data();
  const LanePair pull{field.x(), field.y()};
  double unbalanced = 0, carried = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const LanePair reacts = load_pair(work.force[n].data()), steady = model.mass[n] * pull + load_pair(load[n].data());
    LanePair left = reacts + steady;
    store_pair(work.force[n].data(), left);
    if (loaded) work.moment[n] += work.load_moment[n];
    if (!model.moves(n)) continue;
    carried = std::max(carried, std::max(squared_size(reacts), squared_size(steady)));
    for (const int k : {0, 1})
      if (model.support[n][k] != Support::free) left[k] = 0;
    unbalanced = std::max(unbalanced, squared_size(left));
  }
  work.unbalanced = std::sqrt(unbalanced);
  work.carried = std::sqrt(carried);
}

}  // namespace

void sum(const Model<2>& model, const State<2>& state, Work<2>& work) {
  work.force.resize(model.mass.size());
  work.moment.resize(model.mass.size());
  for (const BodyRow& body : work.body) {
    if (body.deforms)
      spread_nodes(body, work);
    else
      spread_body(state, body, work);
  }
  for (std::size_t i = 0; i < model.bearings.size(); ++i) spread_bearing(model, state, work, i);
  add_outside(model, model.gravity.at(state.time), work);
}

}  // namespace trilith
