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

/// A fall by less than this share of the least thickness is settling, not an impact.
constexpr double least_fall = 1e-3;
/// Pairs that are apart are ignored below this share of the energy limit of one impact, independent of how many close
/// together.
constexpr double quiet_part = 1.0 / 8;

/// Energy supplied so far, without the present kinetic energy, from the sums of the ledger [J].
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

/// Upper bound of the speed of a body relative to `common` at the end of a step [m/s].
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

/// Kinetic energy of all nodes that move [J].
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

/// The AABB of a piece in the frame of the broad-phase tree, enlarged by `by` [m].
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

/// Mortar bond between two pieces.
struct Held {
  double stiffness;  ///< [N/m]
  double strength;   ///< least energy that breaks the bond [J]
  bool pressed;      ///< mean normal traction is compressive
  bool softened;     ///< its stiffness in tension is lost in part, so that it closes as a dry joint
};

/// Bond over a length or area, from the parameters of its law.
Held held_over(const LawInUse& use, double size, bool pressed, bool softened) {
  return with_kernel(use, [&]<class K>(const K& law) {
    if constexpr (K::bonds) {
      const double pull = law.tension * law.tension / law.kn,
                   shear = law.ks > 0 ? law.cohesion * law.cohesion / law.ks : pull;
      return Held{law.kn * size, 0.5 * size * std::min(pull, shear), pressed, K::softens && softened};
    }
    return Held{};
  });
}
/// True if the memory of the law of a contact holds damage or another loss.
bool has_softened(const ContactHistory& contacts, const ContactLaw& law, std::size_t row) {
  return with_kernel({law}, [&]<class K>(const K& /*law*/) {
    const double* const numbers = contacts.law_numbers(row);
    return std::any_of(numbers, numbers + law_numbers<K>, [](double v) { return v != 0; });
  });
}
std::optional<Held> held_by_mortar(const Model<2>& model, const Work<2>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  if (row < 0 || work.contacts.memory[row].bonds == 0) return {};
  const FaceOverlap<double> faces = face_overlap(work, work.pairs[row]);
  const bool softened = has_softened(work.contacts, model.laws[work.pairs[row].law], static_cast<std::size_t>(row));
  return held_over(law_in_use(model, work.pairs[row].law), faces.shared, faces.gap_lo + faces.gap_hi < 0, softened);
}
std::optional<Held> held_by_mortar(const Model<3>& model, const Work<3>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  const JointMemory* joint = row < 0 ? nullptr : work.contacts.joint_at(static_cast<std::size_t>(row));
  if (joint == nullptr || joint->bonds == 0) return {};
  const JointPlan& plan = *joint->plan;
  return held_over({model.laws[work.pairs[row].law]}, plan.whole.area, joint->moved.at + plan.standing.at > 0,
                   !joint->sound);
}

/// True for two bodies with a contact law, of which at least one moves.
template <int D>
bool may_strike(const Model<D>& model, const State<D>& state, const ImpactWork& own, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  if (a == b || state.left[a] != 0 || state.left[b] != 0 || (own.mass[a] == 0 && own.mass[b] == 0)) return false;
  return model.law_of[model.bodies[a].surface * model.surfaces + model.bodies[b].surface] >= 0;
}

/// Speed that the present forces add to a body within the step [m/s].
template <int D>
double added_speed(const Model<D>& model, const Work<D>& work, int body, int node, double dt) {
  return model.body_moves(body) ? work.force[node].norm() / model.mass[node] * dt : 0;
}

/// True if traction acts between the two pieces.
template <int D>
bool touch_now(const Work<D>& work, ContactKey key) {
  const int row = work.contacts.find(key);
  return row >= 0 && (work.contacts.memory[static_cast<std::size_t>(row)].state & contact_touching) != 0;
}

/// Bound for two bodies from their centres alone. `never`: too far apart to meet within the step. `quiet`: the energy
/// of the relative motion, (m_a m_b / (m_a + m_b)) v^2, is negligible. `likely`: all others.
enum class Outlook { likely, quiet, never };

/// Outlook of two rigid bodies; pairs with other bodies are `likely`. `quiet`: negligible energy [J].
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

/// Lists the pairs of pieces that may meet within the step, of which one belongs to a body that could exceed the energy
/// limit. The keys are sorted and unique. `quiet`: see outlook.
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
      if (!work.search.boxes.holds(p)) continue;  // a piece outside the range of the tree meets nothing
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

/// Upper bounds of the relative speed [m/s] and acceleration [m/s2] of any points of two bodies.
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

/// Adds the impact of two rigid bodies that mortar connects. An intact bond is a linear spring in both senses and keeps
/// its energy while the step length is constant. A change of the step length from dt to dt' gains or loses m a^2 (dt'^2
/// - dt^2) / 8. The vibration recovers this error later, unless the bond breaks. So a vibrating bond counts as an
/// impact if its energy exceeds the fracture limit. The measure is constant over the vibration, because
/// steps that follow its phase would gain energy.
///
///     power = (k v^2 + mu a^2) / 2,    energy of the vibration = power mu / k > energy of the bond at its limit.
///
/// In compression, v is the closing or opening speed, so that sliding does not count. A bond that opens in tension is
/// about to break and can lose no more than its breaking energy. A softened bond is open without much stiffness, and
/// closes as a dry joint.
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
    if (!held.softened) return;
    const ApproachEstimate m = approach_estimate(model, state, work, first_piece(key), second_piece(key), dt);
    // The seats of a crack in space are apart, so that it closes a little later than its faces meet.
    if (!m.apart && m.speed > 0)
      work.impacts.blows.push_back({m.gap > 0 ? m.touches : 0, 0.5 * m.stiffness * m.speed * m.speed});
  }
}

/// Lists the start time and power of the impact of each pair. Returns the contact energy stored in them [J].
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

/// The longest time up to `dt` [s] for which all impacts that begin by then satisfy the budget, sum power time^2 <=
/// budget [J].
double time_for(std::vector<Blow>& blows, double dt, double budget) {
  // Stable insertion sort in place. Nearly all impacts have begun and keep their place, and std::stable_sort would
  // allocate memory within a step.
  const auto earlier = [](const Blow& a, const Blow& b) { return a.begins < b.begins; };
  for (auto at = blows.begin(); at != blows.end(); ++at)
    std::rotate(std::upper_bound(blows.begin(), at, *at, earlier), at, at + 1);
  double power = 0, time = dt;
  for (const Blow& blow : blows) {
    if (blow.begins >= time) return time;
    power += blow.power;
    const double allowed = std::sqrt(budget / power);
    // The step is not shorter than the start of this impact; it ends there.
    time = std::min(time, std::max(allowed, blow.begins));
  }
  return time;
}

}  // namespace

/// Upper bound of twice the kinetic energy of any body, with `fastest` [m/s] as the largest speed relative to the
/// ground [J]. It is unbounded if a body without mass moves differently from the ground.
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

/// Four checks, each made only if the one before leaves candidates: the fastest point of the model, the heaviest body,
/// each body, and the pairs of pieces of these bodies.
template <int D>
double impact_step(const Model<D>& model, const State<D>& state, Work<D>& work, double dt,
                   const ImpactOptions& options) {
  ImpactWork& own = work.impacts;
  // An impact of energy e misses e (w dt)^2 / 2 in closing and opening, and w dt is at most 2 safety.
  const double share = options.accuracy / (2 * options.safety * options.safety);
  const double settles = own.total * model.gravity.field.norm() * least_fall * std::min(model.least_thickness, 1.0);
  const double lost = dissipated(work), fallen = -work.given[EnergyTerm::gravity];
  double put_in = std::max({settles, lost, fallen});
  const double fastest = work.fastest + work.unbalanced / own.lightest * dt;
  if (!(own.total * fastest * fastest > share * put_in)) return dt;

  // Speeds are relative to a fixed body or to the ground motion.
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
    // For two bodies, m_a m_b (v_a - v_b)^2 / 2 (m_a + m_b) <= m_a v_a^2 / 2 + m_b v_b^2 / 2, so one of them has at
    // least half of it. A prescribed body that moves differently from the ground is assigned the mass of the whole
    // model.
    const double mass = own.mass[b] > 0 ? own.mass[b] : own.total;
    own.counts[b] = mass * speed * speed > share * put_in ? 1 : 0;
    any = any || own.counts[b] != 0;
  }
  if (!any) return dt;

  list_pairs(model, state, work, dt, quiet_part * share * put_in);
  put_in += list_blows(model, state, work, dt);
  put_in += list_bearing_impacts(model, state, work, dt);
  const double time = time_for(own.blows, dt, 2 * options.accuracy * put_in);
  // Lower limit: an impact with the whole energy at the highest frequency, w dt = 2 safety, requires no shorter step.
  const double shortest = dt * std::sqrt(2 * options.accuracy) / (2 * options.safety);
  return time < dt ? settled_step(std::max(time, std::min(dt, shortest)), 1) : dt;
}

template double impact_step(const Model<2>&, const State<2>&, Work<2>&, double, const ImpactOptions&);
template double impact_step(const Model<3>&, const State<3>&, Work<3>&, double, const ImpactOptions&);

}  // namespace trilith
