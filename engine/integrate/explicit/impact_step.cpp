#include "integrate/explicit/impact_step.hpp"

#include "integrate/explicit/node_gain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "assembly/contact/contact_rows.hpp"
#include "broad_phase/solid_pairs.hpp"
#include "contact/joint/joint_plan.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "integrate/explicit/approach_estimate.hpp"
#include "integrate/explicit/bearing_impacts.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

/// What falls by less than this share of the least thickness strikes nothing: it settles.
constexpr double least_fall = 1e-3;
/// Of what one blow may be before it is looked at: two that lie apart and close so slowly that they have less are left
/// out, however fast they go together.
constexpr double quiet_part = 1.0 / 8;

/// What has been put in so far, but for what moves now, found from the ledger's sums [J].
template <int D>
double dissipated(const Work<D>& work) {
  double sum = 0;
  for (std::size_t i = 0; i < energy_term_info.size(); ++i)
    if (energy_term_info[i].dissipated) sum += work.given.value[i];
  return sum;
}

double spin_size(double spin) {
  return std::abs(spin);
}
double spin_size(const Vec3& spin) {
  return spin.norm();
}

/// How fast a body may be beside `common` by the end of a step [m/s].
template <int D>
double speed_of(const Model<D>& model, const State<D>& state, const Work<D>& work, std::size_t body,
                const Vec<D>& common, double dt) {
  const BodyRow& row = work.body[body];
  double most = 0;
  for (int n = row.node; n < row.node + row.nodes; ++n) {
    double speed = (state.velocity[n] - common).norm();
    if (row.layout != SkinLayout::node_each) speed += spin_size(state.spin[n]) * model.body_radius[body];
    if (model.moves(n)) speed += work.force[n].norm() / model.mass[n] * dt;
    most = std::max(most, speed);
  }
  return most;
}

double turning_energy(const Model<2>& model, const State<2>& state, int n) {
  return 0.5 * model.inertia[n] * state.spin[n] * state.spin[n];
}
double turning_energy(const Model<3>& model, const State<3>& state, int n) {
  return 0.5 * state.spin[n].dot(momentum_of(model.inertia[n], state.rotation[n], state.spin[n]));
}

/// Of all nodes that move [J].
template <int D>
double moving_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    if (!model.moves(n)) continue;
    sum += 0.5 * model.mass[n] * state.velocity[n].squaredNorm();
    if (state.spin[n] != nothing<Spin<D>>()) sum += turning_energy(model, state, n);
  }
  return sum;
}

/// The box that the tree of pieces would have a piece in, widened.
FatBox<2> reached_box(const Model<2>& model, const Work<2>& work, int piece, double by) {
  FatBox<2> box;
  box.low.fill(unbounded), box.high.fill(-unbounded);
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[c]];
    const Vec2 at = Vec2(s.x, s.y) - work.search.together;
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = at[static_cast<Eigen::Index>(k)];
      box.low[k] = std::min(box.low[k], x - by), box.high[k] = std::max(box.high[k], x + by);
    }
  }
  return box;
}
FatBox<3> reached_box(const Model<3>& /*model*/, const Work<3>& work, int piece, double by) {
  return widened(box_around(work.solids.placed[piece]), by);
}

/// What mortar holds two pieces with.
struct Held {
  double stiffness;  ///< [N/m]
  double strength;   ///< the least energy with which it breaks [J]
  bool pressed;      ///< in the mean
};

/// Of a bond over a length or area, by the numbers of its law.
Held held_over(const LawInUse& use, double size, bool pressed) {
  return with_kernel(use, [&]<class K>(const K& law) {
    if constexpr (K::bonds) {
      const double pull = law.tension * law.tension / law.kn,
                   shear = law.ks > 0 ? law.cohesion * law.cohesion / law.ks : pull;
      return Held{law.kn * size, 0.5 * size * std::min(pull, shear), pressed};
    }
    return Held{};
  });
}
std::optional<Held> held_by_mortar(const Model<2>& model, const Work<2>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  if (row < 0 || work.contacts.memory[row].bonds == 0) return {};
  const FaceOverlap<double> faces = face_overlap(work, work.pairs[row]);
  return held_over(law_in_use(model, work.pairs[row].law), faces.shared, faces.gap_lo + faces.gap_hi < 0);
}
std::optional<Held> held_by_mortar(const Model<3>& model, const Work<3>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  const JointMemory* joint = row < 0 ? nullptr : work.contacts.joint_at(static_cast<std::size_t>(row));
  if (joint == nullptr || joint->bonds == 0) return {};
  const JointPlan& plan = *joint->plan;
  return held_over({model.laws[work.pairs[row].law]}, plan.whole.area, joint->moved.at + plan.standing.at > 0);
}

/// Of two bodies, one of which moves, between which a law holds.
template <int D>
bool may_strike(const Model<D>& model, const State<D>& state, const ImpactWork& own, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  if (a == b || state.left[a] != 0 || state.left[b] != 0 || (own.mass[a] == 0 && own.mass[b] == 0)) return false;
  return model.law_of[model.bodies[a].surface * model.surfaces + model.bodies[b].surface] >= 0;
}

/// What the forces of now add to a body's speed within the step [m/s].
template <int D>
double added_speed(const Model<D>& model, const Work<D>& work, int body, int node, double dt) {
  return model.body_moves(body) ? work.force[node].norm() / model.mass[node] * dt : 0;
}

/// True where some stress goes from one piece to the other.
template <int D>
bool touch_now(const Work<D>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  return row >= 0 && (work.contacts.memory[static_cast<std::size_t>(row)].state & contact_touching) != 0;
}

/// What can be said of two bodies at once: at most how fast they close within the step, whether they are too far apart
/// for that, and whether the energy of it, (m_a m_b / (m_a + m_b)) v^2, is next to nothing.
enum class Outlook { likely, quiet, never };

/// Of rigid bodies; of others it is left open. `quiet`: energy that is next to nothing [J].
template <int D>
Outlook outlook(const Model<D>& model, const State<D>& state, const Work<D>& work, int a, int b, double quiet,
                double dt) {
  const Body &one = model.bodies[a], &other = model.bodies[b];
  if (!one.is_rigid() || !other.is_rigid()) return Outlook::likely;
  const int p = one.first_node, q = other.first_node;
  const double radius[2] = {model.body_radius[a], model.body_radius[b]};
  const double speed = (state.velocity[p] - state.velocity[q]).norm() + spin_size(state.spin[p]) * radius[0] +
                       spin_size(state.spin[q]) * radius[1] + added_speed(model, work, a, p, dt) +
                       added_speed(model, work, b, q, dt);
  const double reach = radius[0] + radius[1] + speed * dt;
  if ((state.position[p] - state.position[q]).squaredNorm() > reach * reach) return Outlook::never;
  const std::array<double, 2> mass{work.impacts.mass[a], work.impacts.mass[b]};
  const double both = mass[0] == 0 ? mass[1] : mass[1] == 0 ? mass[0] : mass[0] * mass[1] / (mass[0] + mass[1]);
  return both * speed * speed <= quiet ? Outlook::quiet : Outlook::likely;
}

/// Pairs of pieces one of which is of a body that could miss more than it may, and which may meet within the step: in
/// the order of their keys, each once. `quiet`: see outlook.
template <int D>
void list_pairs(const Model<D>& model, const State<D>& state, Work<D>& work, double dt, double quiet) {
  ImpactWork& own = work.impacts;
  own.key.clear();
  double fastest = 0;
  for (const double v : own.speed) fastest = std::max(fastest, v);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (own.counts[b] == 0) continue;
    const Body& body = model.bodies[b];
    for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) {
      const double by = (own.speed[b] + fastest) * dt;
      if (!work.search.boxes.holds(p)) continue;  // one out of all measure meets nothing
      work.search.boxes.for_meeting(reached_box(model, work, p, by), [&](int q) {
        if (!may_strike(model, state, own, p, q)) return;
        const ContactKey key = contact_key(std::min(p, q), std::max(p, q));
        const Outlook how = outlook(model, state, work, static_cast<int>(b), model.piece_body[q], quiet, dt);
        if (how == Outlook::likely || (how == Outlook::quiet && touch_now(work, key))) own.key.push_back(key);
      });
    }
  }
  std::sort(own.key.begin(), own.key.end());
  own.key.erase(std::unique(own.key.begin(), own.key.end()), own.key.end());
}

/// The speed and the acceleration of two bodies against each other, at most at any of their points [m/s], [m/s2].
template <int D>
std::array<double, 2> relative_motion(const Model<D>& model, const State<D>& state, const Work<D>& work, int a, int b) {
  Vec<D> speed = Vec<D>::Zero(), gain = Vec<D>::Zero();
  std::array<double, 2> turning{};
  for (const int body : {a, b}) {
    const int n = model.bodies[body].first_node;
    const double side = body == a ? -1 : 1;
    speed += side * state.velocity[n];
    turning[0] += spin_size(state.spin[n]) * model.body_radius[body];
    if (!model.body_moves(body)) continue;
    gain += side / model.mass[n] * work.force[n];
    turning[1] += angular_acceleration(work.moment[n], model.inertia[n]) * model.body_radius[body];
  }
  return {speed.norm() + turning[0], gain.norm() + turning[1]};
}

/// Two rigid bodies that mortar holds together. What holds is a spring both ways and keeps its energy however it
/// swings, as long as steps are alike; where they change, m a^2 (dt'^2 - dt^2) / 8 is lost or gained, which comes back
/// as it swings on, but not once the bond has broken. So it counts as a blow where it swings by more than it takes to
/// break it, by what is the same all along the swing: steps that followed its phases would feed it.
///
///     power = (k v^2 + mu a^2) / 2,    energy of the swing = power mu / k > energy of the bond at its limit
///
/// While it is pressed, v is that at which it closes or opens, so that what slides does not count. What has come out of
/// the swing open is about to break, and has no more to lose than that takes.
template <int D>
void add_held(const Model<D>& model, const State<D>& state, Work<D>& work, ContactKey key, const Held& held,
              double dt) {
  const int a = model.piece_body[first_piece(key)], b = model.piece_body[second_piece(key)];
  if (!model.bodies[a].is_rigid() || !model.bodies[b].is_rigid() || !(held.stiffness > 0)) return;
  const double one = work.impacts.mass[a], other = work.impacts.mass[b];
  const double mass = one == 0 ? other : other == 0 ? one : one * other / (one + other);
  const auto [speed, gain] = relative_motion(model, state, work, a, b);
  const double of_gain = 0.5 * mass * gain * gain, power = 0.5 * held.stiffness * speed * speed + of_gain;
  if (!(power * mass > held.stiffness * held.strength)) return;
  if (held.pressed) {
    const ApproachEstimate m = approach_estimate(model, state, work, first_piece(key), second_piece(key), dt);
    work.impacts.blows.push_back({0, 0.5 * held.stiffness * m.speed * m.speed + of_gain});
  } else {
    work.impacts.blows.push_back({0, std::min(power, held.strength / (dt * dt))});
  }
}

/// What each of the pairs asks for: from when on, and how much. Returns the energy that they have stored [J].
template <int D>
double list_blows(const Model<D>& model, const State<D>& state, Work<D>& work, double dt) {
  ImpactWork& own = work.impacts;
  own.blows.clear();
  double stored = 0;
  for (const ContactKey key : own.key) {
    if (const std::optional<Held> held = held_by_mortar(model, work, key)) {
      add_held(model, state, work, key, *held, dt);
      continue;
    }
    const ApproachEstimate m = approach_estimate(model, state, work, first_piece(key), second_piece(key), dt);
    if (m.apart) continue;
    const double depth = std::max(-m.gap, 0.0), force = m.stiffness * depth;
    stored += 0.5 * force * depth;
    own.blows.push_back({m.gap > 0 ? m.touches : 0, 0.5 * (m.stiffness * m.speed * m.speed + force * force / m.mass)});
  }
  return stored;
}

/// The longest time up to `dt` [s] within which all blows that have begun by its end keep to the budget,
/// sum power time^2 <= budget [J].
double time_for(std::vector<Blow>& blows, double dt, double budget) {
  // Sorted in place, equal ones in their order: nearly all have begun and stay where they are, and std::stable_sort
  // would ask for memory within a step.
  const auto earlier = [](const Blow& a, const Blow& b) { return a.begins < b.begins; };
  for (auto at = blows.begin(); at != blows.end(); ++at)
    std::rotate(std::upper_bound(blows.begin(), at, *at, earlier), at, at + 1);
  double power = 0, time = dt;
  for (const Blow& blow : blows) {
    if (blow.begins >= time) return time;
    power += blow.power;
    const double allowed = std::sqrt(budget / power);
    // Not before it has begun: the step then ends there.
    time = std::min(time, std::max(allowed, blow.begins));
  }
  return time;
}

}  // namespace

/// Twice the energy of motion that some body has at most, as none is faster than `fastest` [m/s] beside the ground. A
/// body that does not move and goes elsewhere than the ground has the mass of all: without bound [J].
template <int D>
double most_of_one(const Model<D>& model, const State<D>& state, const ImpactWork& own, const Vec<D>& common,
                   double fastest) {
  double heaviest = 0;
  for (std::size_t b = 0; b < own.mass.size(); ++b) {
    heaviest = std::max(heaviest, own.mass[b]);
    const int n = model.bodies[b].first_node;
    if (own.mass[b] == 0 && (state.velocity[n] != common || state.spin[n] != nothing<Spin<D>>())) return unbounded;
  }
  return heaviest * fastest * fastest;
}

/// Four looks, each only where the one before it left something: at the fastest point of all, at the
/// heaviest body, at each body, and at the pairs of pieces of those bodies.
template <int D>
double impact_step(const Model<D>& model, const State<D>& state, Work<D>& work, double dt,
                   const ImpactOptions& options) {
  ImpactWork& own = work.impacts;
  // A blow of the energy e misses e (w dt)^2 / 2 in closing and opening, and w dt is at most 2 safety.
  const double share = options.accuracy / (2 * options.safety * options.safety);
  const double settles = own.total * model.gravity.field.norm() * least_fall * std::min(model.least_thickness, 1.0);
  const double lost = dissipated(work), fallen = -work.given[EnergyTerm::gravity];
  double put_in = std::max({settles, lost, fallen});
  const double fastest = work.fastest + work.unbalanced / own.lightest * dt;
  if (!(own.total * fastest * fastest > share * put_in)) return dt;

  // Beside what stands, or goes with the ground.
  const Vec<D> common = own.still >= 0 ? state.velocity[own.still] : Vec<D>(Vec<D>::Zero());
  const double of_one = most_of_one(model, state, own, common, fastest + common.norm());
  if (!(of_one > share * put_in)) return dt;
  put_in = std::max(put_in, moving_energy(model, state) + lost);
  if (!(of_one > share * put_in)) return dt;
  own.speed.assign(own.mass.size(), 0), own.counts.assign(own.mass.size(), 0);
  bool any = false;
  for (std::size_t b = 0; b < own.mass.size(); ++b) {
    if (state.left[b] != 0) continue;
    const double speed = own.speed[b] = speed_of(model, state, work, b, common, dt);
    // Of two that meet, m_a m_b (v_a - v_b)^2 / 2 (m_a + m_b) <= m_a v_a^2 / 2 + m_b v_b^2 / 2: one has half of it.
    // What does not move and goes elsewhere than the ground has the mass of all.
    const double mass = own.mass[b] > 0 ? own.mass[b] : own.total;
    own.counts[b] = mass * speed * speed > share * put_in ? 1 : 0;
    any = any || own.counts[b] != 0;
  }
  if (!any) return dt;

  list_pairs(model, state, work, dt, quiet_part * share * put_in);
  put_in += list_blows(model, state, work, dt);
  put_in += list_bearing_impacts(model, state, work, dt);
  const double time = time_for(own.blows, dt, 2 * options.accuracy * put_in);
  // No more than a blow of all the energy asks for at the highest frequency there is, w dt = 2 safety.
  const double shortest = dt * std::sqrt(2 * options.accuracy) / (2 * options.safety);
  return time < dt ? settled_step(std::max(time, std::min(dt, shortest)), 1) : dt;
}

template double impact_step(const Model<2>&, const State<2>&, Work<2>&, double, const ImpactOptions&);
template double impact_step(const Model<3>&, const State<3>&, Work<3>&, double, const ImpactOptions&);

}  // namespace trilith
