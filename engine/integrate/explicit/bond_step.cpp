#include "integrate/explicit/bond_step.hpp"

#include "integrate/explicit/node_gain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "events/body_events.hpp"
#include "integrate/explicit/bond_places.hpp"
#include "integrate/explicit/drive_jumps.hpp"
#include "integrate/explicit/intact_bonds.hpp"
#include "integrate/explicit/skipped_bonds.hpp"
#include "integrate/explicit/stable_step.hpp"

namespace trilith {
namespace {

/// Shares of the displacement at which a bond is lost: opening in one step along the softening line, and overshoot of
/// the peak for softening and for brittle bonds.
constexpr double softening_share = 1.0 / 32, past_peak = 1.0 / 256, past_brittle_peak = 1.0 / 64;
/// Energy error that an explicit step may cause by being shortened, as a share of the fracture energy.
constexpr double shortened_share = 0.004;
/// A bond is considered this number of steps before its peak. It carries little force then, so shortened steps cause
/// little energy error.
constexpr double steps_ahead = 4;
/// Energy that an implicit step may miss, as a share of the fracture energy.
constexpr double missed_share = 0.01;
/// Energy that a given explicit step may miss without an event, as a share of the fracture energy.
constexpr double skipped_share = 0.1;
/// A step that is not given is reported where a bond opened by more than this multiple of the limit of the step.
constexpr double far_beyond = 2;
/// Energy that any step may miss, as a share of the kinetic energy of the relative motion of two bodies. Steps that are
/// not given stop at the shares of the fracture energy below, however fast the bodies are.
constexpr double kinetic_share = 1e-4, most_share = 1.0 / 64, most_missed_share = 0.02;
/// Bonds shorten no step below this share of its length.
constexpr double shortest_share = 1e-4;
/// Upper bound of the contribution of the angular acceleration to the acceleration of a point, over the acceleration of
/// the mass centre.
constexpr double turning_gain = 4;

/// Upper bound of the acceleration of any point of a rigid body [m/s2]. It is 0 for other bodies: their steps are short
/// compared with the time scale of their accelerations.
template <int D>
double acceleration_of(const Model<D>& model, const Work<D>& work, int body) {
  const Body& b = model.bodies[body];
  if (!b.is_rigid() || !model.body_moves(body)) return 0;
  const int n = b.first_node;
  return work.force[n].norm() / model.mass[n] +
         angular_acceleration(work.moment[n], model.inertia[n]) * model.body_radius[body];
}

/// Allowed energy error of the bond at the given speed [m/s], as a share of its fracture energy: `share`, or more up to
/// `most` while it stays within the share of the kinetic energy.
template <int D>
double allowed_share(const Work<D>& work, const PlacedBond& bond, double speed, double share, double most) {
  const double mass = mass_of_both(work, bond), energy = bond.curve.energy * bond.size;
  return energy > 0 ? std::max(share, std::min(most, kinetic_share * 0.5 * mass * speed * speed / energy)) : share;
}

/// Largest opening of a bond in one step at the given speed [m]. The step is also limited before the peak: if it is
/// then shortened, leapfrog gains or loses up to (step/peak)^2 / 4 of the elastic energy.
template <int D>
double way_of(const Work<D>& work, const PlacedBond& bond, double speed) {
  const BondCurve& c = bond.curve;
  const bool brittle = !(c.last > c.peak);
  const double share = allowed_share(work, bond, speed, brittle ? past_brittle_peak : past_peak, most_share);
  const double past = share * c.whole, elastic = 0.5 * c.top * c.peak;
  if (!brittle && bond.at >= c.peak - past) return std::max(share, softening_share) * c.whole;
  const double gain = allowed_share(work, bond, speed, shortened_share, most_share);
  const double up = c.peak * std::sqrt(4 * gain * c.energy / elastic);
  return std::max(past, std::min(c.peak - bond.at, up));
}

/// Longest time up to dt in which the bond does not pass its peak, or opens by its share along the softening line [s].
/// `jump`: increase of its rate at the start of this time [m/s].
template <int D>
double time_of(const Model<D>& model, const State<D>& state, const Work<D>& work, const PlacedBond& bond, double jump,
               double dt) {
  const double gain = acceleration_of(model, work, bond.body_a) + acceleration_of(model, work, bond.body_b);
  const double speed = bond.rate + 0.5 * (state.last_dt + dt) * gain + jump;
  if (!(speed > 0) || bond.at + steps_ahead * speed * dt <= bond.curve.peak) return dt;
  return std::min(dt, std::max(way_of(work, bond, speed) / speed, shortest_share * dt));
}

template <int D>
bool has_bonds(const Model<D>& model) {
  return std::any_of(model.laws.begin(), model.laws.end(), [](const ContactLaw& law) { return may_bond(law); });
}

/// Upper bound of the change of a bond's rate until the end of the next step [m/s].
template <int D>
double largest_gain(const State<D>& state, const Work<D>& work, double dt) {
  const double mass = work.impacts.lightest;
  if (!(mass > 0) || !(mass < std::numeric_limits<double>::max())) return 0;
  return 2 * turning_gain * work.unbalanced / mass * 0.5 * (state.last_dt + dt);
}

/// Updates the bound of the motion of all bonds since the last full check. False if a bond may need a shorter step.
template <int D>
bool is_far(const State<D>& state, const Work<D>& work, double dt, BondRoom& room) {
  room.speed += largest_gain(state, work, dt);
  room.room -= room.speed * dt;
  return room.room > steps_ahead * room.speed * dt || room.speed * dt < room.way;
}

/// The coming step of bonds: its length [s], and an upper bound of the change of their rates [m/s].
struct ComingStep {
  double dt, gain;
};

/// Calls f(PlacedBond) for each bond that may come near its peak within the step. Intact bonds that cannot only reduce
/// `room`, by bounds that take a fraction of the time.
template <class F>
void each_bond_near(const Model<2>& model, const State<2>& state, const Work<2>& work, ComingStep step,
                    const DriveJumps<2>& jumps, BondRoom& room, F&& f) {
  const std::vector<IntactBonds> laws = intact_bonds(model);
  const auto is_far_from_peak = [&](std::size_t row, const PlacedBond& bond, const auto& overlap, const auto& rates) {
    const IntactBonds& law = laws[static_cast<std::size_t>(work.pairs[row].law)];
    if (!is_intact(law, work.contacts, row)) return false;
    const IntactPlace place = intact_place(law, overlap, rates, work.contacts.memory[row]);
    const double speed = place.speed + jumps.between(bond.body_a, bond.body_b);
    if (!(place.room > steps_ahead * (speed + step.gain) * step.dt)) return false;
    room.room = std::min(room.room, place.room), room.speed = std::max(room.speed, speed);
    room.way = std::min(room.way, (law.soften ? past_peak : past_brittle_peak) * law.whole);
    return true;
  };
  each_bond_but(model, state, work, true, 0, is_far_from_peak, f);
}
template <class F>
void each_bond_near(const Model<3>& model, const State<3>& state, const Work<3>& work, ComingStep /*step*/,
                    const DriveJumps<3>& /*jumps*/, const BondRoom& /*room*/, F&& f) {
  each_bond(model, state, work, true, 0, f);
}

/// Longest path of a bond in one step, as steps that are not given have it [m].
template <int D>
double followed_path(const Work<D>& work, const PlacedBond& bond) {
  const bool brittle = !(bond.curve.last > bond.curve.peak);
  return allowed_share(work, bond, bond.rate, brittle ? past_brittle_peak : softening_share, most_share) *
         bond.curve.whole;
}

template <int D>
void tell_skipped(const State<D>& state, Work<D>& work, const SkippedBond& joint, bool is_given) {
  // A step that is not given may miss this work, unless the bond opened by far more than the limit of the step.
  const double within = is_given ? 0 : far_beyond * joint.longest;
  if (!(joint.most > 1) || state.last_dt <= within) return;
  Event e = event_now(state, EventType::bond_skipped, joint.bond.body_a, joint.bond.body_b);
  e.value = joint.missing;
  e.text = fmt::format("a step of {:.3g} s did {:.3g} J {} work than its law; {} at most {:.2g} s", state.last_dt,
                       std::abs(joint.missing), joint.missing > 0 ? "less" : "more",
                       is_given ? "leave dt out, or give" : "give a dt of", joint.longest);
  work.events.push_back(e);
}

}  // namespace

template <int D>
double bond_step(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt, BondRoom& room) {
  room.near = false;
  if (room.none) return dt;
  const bool changes = room.fresh || motions_change(model, state, dt);
  if (!changes && is_far(state, work, dt, room)) return dt;
  constexpr double far = std::numeric_limits<double>::max();
  const DriveJumps<D> jumps = changes ? DriveJumps<D>(model, state, dt) : DriveJumps<D>();
  room = {far, 0, far, !has_bonds(model), false, false};
  if (room.none) return dt;
  const double gain = largest_gain(state, work, dt);
  double time = dt;
  each_bond_near(model, state, work, {dt, gain}, jumps, room, [&](const PlacedBond& bond) {
    const BondCurve& c = bond.curve;
    if (!(c.top > 0)) return;
    const double jump = jumps.between(bond.body_a, bond.body_b);
    room.room = std::min(room.room, c.peak - bond.at);
    room.speed = std::max(room.speed, std::abs(bond.rate) + jump);
    room.way = std::min(room.way, (c.last > c.peak ? past_peak : past_brittle_peak) * c.whole);
    if (!(bond.at + steps_ahead * (std::abs(bond.rate) + gain + jump) * dt > c.peak)) return;
    room.near = true, time = std::min(time, time_of(model, state, work, bond, 0, dt));
    if (jump > 0) time = std::min(time, jumps.begins() + time_of(model, state, work, bond, jump, dt));
  });
  return time < dt ? settled_step(time, 1) : dt;
}

template <int D>
double bond_miss(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt) {
  if (!has_bonds(model)) return 0;
  double most = 0;
  each_bond(model, state, work, false, dt, [&](const PlacedBond& bond) {
    const double missed = bond.curve.missed(bond.at, bond.at + bond.rate * dt);
    if (!(missed > 0) || !(bond.curve.energy > 0)) return;
    const double allowed = allowed_share(work, bond, bond.rate, missed_share, most_missed_share);
    most = std::max(most, missed / (bond.curve.energy * allowed));
  });
  return most;
}

template <int D>
void add_skipped_bonds(const Model<D>& model, const State<D>& state, Work<D>& work, bool is_given) {
  SkippedBond joint;
  const double dt = state.last_dt;
  each_bond(model, state, work, false, dt, [&](const PlacedBond& bond) {
    if (bond.row != joint.bond.row) tell_skipped(state, work, std::exchange(joint, {}), is_given);
    joint.bond = bond;
    const double missing = bond.curve.missing(bond.at, bond.at + bond.rate * dt);
    if (missing == 0 || !(bond.curve.energy > 0)) return;
    const double allowed = allowed_share(work, bond, bond.rate, skipped_share, unbounded);
    joint.missing += missing * bond.share * bond.size;
    joint.most = std::max(joint.most, std::abs(missing) / (bond.curve.energy * allowed));
    joint.longest = std::min(joint.longest, followed_path(work, bond) / bond.rate);
  });
  tell_skipped(state, work, joint, is_given);
}

template void add_skipped_bonds(const Model<2>&, const State<2>&, Work<2>&, bool);
template void add_skipped_bonds(const Model<3>&, const State<3>&, Work<3>&, bool);
template double bond_step(const Model<2>&, const State<2>&, const Work<2>&, double, BondRoom&);
template double bond_step(const Model<3>&, const State<3>&, const Work<3>&, double, BondRoom&);
template double bond_miss(const Model<2>&, const State<2>&, const Work<2>&, double);
template double bond_miss(const Model<3>&, const State<3>&, const Work<3>&, double);

}  // namespace trilith
