// Bearings: relative motion of two points in the axes of the first body, with one law per direction, or one law for
// both horizontal directions.
#include <algorithm>
#include <cmath>

#include "assembly/bearing_motion.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "assembly/slip_reversal_error.hpp"
#include "law/bearing/dish.hpp"

namespace trilith {
namespace {

/// Order of the directions: friction along the seat needs the axial force first.
template <int D>
constexpr auto direction_order = [] {
  if constexpr (D == 2)
    return std::array{axial, along, turning};
  else
    return std::array{2, 0, 1, 3, 4, 5};
}();

/// A direction without a law has no force. Each law depends on the motion in its own direction alone.
DirectionResponse respond(const DirectionLaw& law, const DirectionMotion& motion, const DirectionMemory& before) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (std::is_same_v<std::decay_t<decltype(l)>, std::monostate>)
          return DirectionResponse{};
        else
          return l.respond(motion, before);
      },
      law);
}

/// Response of direction k of a bearing. `axial_force`: present force of its axial law [N].
template <int D>
DirectionResponse respond(const Bearing<D>& b, const LawMotion<D>& now, int k, const DirectionMotion& motion,
                          const DirectionMemory& before, double axial_force) {
  if (now.on_dish && k < Directions<D>::axial && dish_radius(b.law[k]) > 0) {
    const double thrust = now.thrust(static_cast<std::size_t>(k), axial_force);
    return std::visit(
        [&](const auto& l) {
          if constexpr (HasDish<std::decay_t<decltype(l)>>)
            return l.respond_on_dish(motion, before, thrust);
          else
            return DirectionResponse{};
        },
        b.law[k]);
  }
  return respond(b.law[k], motion, before);
}

/// Response of the law of both horizontal directions. Its forces and dashpots are stored in the memories of the
/// directions along and across, like two separate laws. `begins`: the memory belongs to a law that becomes live in the
/// present position. `thrust`: thrust of a dish [N], or null.
DirectionResponse respond_horizontal(const Bearing<3>& b, const BearingMemory<3>& before, const HorizontalMotion& m,
                                     bool begins, const Vec2* thrust, BearingMemory<3>& after) {
  return std::visit(
      [&](const auto& l) {
        using L = std::decay_t<decltype(l)>;
        DirectionResponse out;
        if constexpr (HorizontalLaw<L>) {
          auto memory = horizontal_memory<L>(before.horizontal);
          if constexpr (requires { l.begin_horizontal_at(m.displacement); })
            if (begins) memory = l.begin_horizontal_at(m.displacement);
          const auto r = [&] {
            if constexpr (HasDish<L>)
              if (thrust != nullptr) return l.respond_horizontal_on_dish(m, memory, *thrust);
            return l.respond_horizontal(m, memory);
          }();
          keep_horizontal(r.memory, after.horizontal);
          for (const int k : {0, 1}) {
            DirectionMemory& own = after.direction[static_cast<std::size_t>(k)];
            const double last = before.direction[static_cast<std::size_t>(k)].damping;
            own.force = r.force[k], own.damping = l.damping * m.rate[k];
            out.lost_damping += 0.5 * (own.damping + last) * m.mean[k] * m.dt;
          }
          out.stored = r.stored, out.lost_inner = r.lost_inner, out.yielding = r.yielding;
        }
        return out;
      },
      b.horizontal);
}

HorizontalMotion horizontal_motion(const std::array<double, 6>& displacement, const std::array<double, 6>& rate,
                                   const std::array<double, 6>& mean, double dt, double compression) {
  return {{displacement[0], displacement[1]}, {rate[0], rate[1]}, dt, compression, {mean[0], mean[1]}};
}

/// The first direction beyond its limit, or -1.
template <int D>
int direction_beyond(const Bearing<D>& b, const std::array<double, Space<D>::dofs>& displacement) {
  for (std::size_t k = 0; k < displacement.size(); ++k)
    if (std::abs(displacement[k]) > b.limit[k]) return static_cast<int>(k);
  if constexpr (D == 3)
    if (portable::hypot(displacement[0], displacement[1]) > b.horizontal_limit) return Directions<3>::horizontal;
  return -1;
}

template <int D>
void take_up(const DirectionResponse& r, std::size_t i, BearingStatus& status, Work<D>& work) {
  if (r.yielding && status == BearingStatus::intact) status = BearingStatus::yielded;
  work.bearing_energy[i] += r.stored;
  work.given[EnergyTerm::bearing_inner] += r.lost_inner;
  work.given[EnergyTerm::bearing_damping] += r.lost_damping;
}

/// Computes force, energies and trial memory by the law of each direction; State is not modified.
template <int D>
void respond_live(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, double dt) {
  const Bearing<D>& b = model.bearings[i];
  const BearingMemory<D>& before = state.bearing[i];
  BearingMemory<D>& after = work.bearing[i];
  const BearingMotion<D> m = bearing_motion(model, state, i);
  const auto counted = m.counted(before);
  const LawMotion<D> now(b, counted, m.rate, mean_rates(model, state, b, m, dt), dt);
  std::array<double, Space<D>::dofs> force{};
  double compression = 0;
  for (const int k : direction_order<D>) {
    const DirectionMotion motion{now.displacement[k], now.rate[k], dt, compression, now.mean[k]};
    const DirectionResponse r = respond(b, now, k, motion, before.direction[k], force[Directions<D>::axial]);
    after.direction[k] = r.memory;
    force[k] = r.force();
    if (k == Directions<D>::axial) compression = std::max(0.0, -r.memory.force);
    take_up(r, i, after.status, work);
  }
  if constexpr (D == 3) {
    for (const std::size_t k : {0, 1, 2}) after.turned[k] = m.displacement[3 + k];
    if (b.has_horizontal()) {
      const HorizontalMotion level = horizontal_motion(now.displacement, now.rate, now.mean, dt, compression);
      const Vec2 thrust(now.thrust(0, force[2]), now.thrust(1, force[2]));
      take_up(respond_horizontal(b, before, level, false,
                                 now.on_dish && dish_radius(b.horizontal) > 0 ? &thrust : nullptr, after),
              i, after.status, work);
      for (const std::size_t k : {0, 1}) force[k] = after.direction[k].force + after.direction[k].damping;
    }
  }
  work.bearing_stored += work.bearing_energy[i];
  // The force resists the displacement of b. Body a receives the opposite force through b's point, so that no couple
  // acts on both together.
  work.bearing_force[i] = m.force(force);
  work.bearing_moment[i] = m.moment(force);
  for (int k = 0; k < D; ++k) work.bearing_displacement[i][k] = counted[static_cast<std::size_t>(k)];
  const int beyond = direction_beyond(b, now.displacement);
  if (beyond < 0) return;
  after.status = BearingStatus::failed;
  after.failed_direction = static_cast<std::uint32_t>(beyond);
}

/// Work over half of the last step by the bearing forces at its start [J].
template <int D>
double half_work(const Model<D>& model, const State<D>& state, std::size_t i, double dt) {
  const auto mean = mean_rates(model, state, model.bearings[i], bearing_motion(model, state, i), dt);
  double sum = 0;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    const DirectionMemory& last = state.bearing[i].direction[k];
    sum += 0.5 * dt * (last.force + last.damping) * mean[k];
  }
  return sum;
}

/// Accounts for a bearing that failed in the last step. Its last force works for half a step more, and no spring stores
/// this work. The first force of its successor has not worked yet, and its first half step has no source.
template <int D>
void let_go(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, double dt) {
  const BearingStatus status = state.bearing[i].status;
  if (status != BearingStatus::failed && status != BearingStatus::changed) return;
  const auto& last_of = state.bearing[i].direction;
  const bool held = std::any_of(last_of.begin(), last_of.end(),
                                [](const DirectionMemory& last) { return last.force != 0 || last.damping != 0; });
  if (!held) return;  // removed before
  double& dissipated = work.given[EnergyTerm::bearing_failure];
  dissipated += half_work(model, state, i, dt);
  for (DirectionMemory& last : work.bearing[i].direction) last.force = last.damping = 0;
  const int next = model.bearings[i].becomes_bearing;
  if (status == BearingStatus::changed && next >= 0 && is_live(state.bearing[next].status))
    dissipated -= half_work(model, state, static_cast<std::size_t>(next), dt);
}

/// Error of a live bearing: its laws are evaluated again for both parts of the path. Laws of both horizontal directions
/// are ignored.
template <int D>
double slip_reversal_error(const Model<D>& model, const State<D>& state, const Work<D>& work, std::size_t i,
                           double dt) {
  const Bearing<D>& b = model.bearings[i];
  const BearingMotion<D> m = bearing_motion(model, state, i);
  const LawMotion<D> at(b, m.counted(state.bearing[i]), m.rate, mean_rates(model, state, b, m, dt), dt);
  const DirectionMemory& pressed = work.bearing[i].direction[Directions<D>::axial];
  const double compression = std::max(0.0, -pressed.force), axial_force = pressed.force + pressed.damping;
  double sum = 0;
  for (const int k : direction_order<D>) {
    if (std::holds_alternative<std::monostate>(b.law[k])) continue;
    const Ways way(at.rate[k], at.mean[k], dt);
    if (way.back == 0) continue;
    const double time_on = dt - way.time_back;
    const DirectionMotion on{at.displacement[k] - way.back, 0, time_on, compression, way.on / time_on};
    const DirectionMotion back{at.displacement[k], at.rate[k], way.time_back, compression, way.back / way.time_back};
    const DirectionMemory turned = respond(b, at, k, on, state.bearing[i].direction[k], axial_force).memory;
    const DirectionResponse r = respond(b, at, k, back, turned, axial_force);
    const DirectionMemory& now = work.bearing[i].direction[k];
    sum += 0.5 * std::abs((now.force + now.damping - r.force()) * way.back);
  }
  return sum;
}

DirectionMemory memory_at(const DirectionLaw& law, double displacement) {
  return std::visit(
      [&](const auto& l) {
        if constexpr (requires { l.begin_at(displacement); })
          return l.begin_at(displacement);
        else
          return DirectionMemory{};
      },
      law);
}

}  // namespace

/// Sliders and dashpots start unstressed; springs start with the force of their displacement. If the displacement does
/// not count from here, their energy is new. A law that can start elsewhere than at 0 has a member begin_at; every
/// other law starts from an empty memory.
template <int D>
double start_bearing(const Model<D>& model, const State<D>& state, Work<D>& work, int i,
                     const std::array<double, Space<D>::dofs>& begun_at) {
  const Bearing<D>& b = model.bearings[i];
  BearingMemory<D>& begun = work.bearing[i];
  begun = {};
  begun.begun_at = begun_at;
  const BearingMotion<D> m = bearing_motion(model, state, static_cast<std::size_t>(i));
  const LawMotion<D> now(b, m.counted(begun), {}, {}, 0);
  double stored = 0, compression = 0, axial_force = 0;
  for (const int k : direction_order<D>) {
    const DirectionMotion at_rest{now.displacement[k], 0, 0, compression};
    const DirectionResponse r = respond(b, now, k, at_rest, memory_at(b.law[k], now.displacement[k]), axial_force);
    begun.direction[k] = r.memory;
    stored += r.stored;
    if (k == Directions<D>::axial) compression = std::max(0.0, -r.memory.force), axial_force = r.force();
  }
  if constexpr (D == 3) {
    for (const std::size_t k : {0, 1, 2}) begun.turned[k] = m.displacement[3 + k];
    const HorizontalMotion at_rest = horizontal_motion(now.displacement, {}, {}, 0, compression);
    const Vec2 thrust(now.thrust(0, axial_force), now.thrust(1, axial_force));
    stored += respond_horizontal(b, BearingMemory<3>{}, at_rest, true,
                                 now.on_dish && dish_radius(b.horizontal) > 0 ? &thrust : nullptr, begun)
                  .stored;
  }
  return stored;
}

/// Sizes the arrays for all bearings, with empty responses.
template <int D>
void start_bearings(const Model<D>& model, Work<D>& work) {
  const std::size_t count = model.bearings.size();
  work.bearing.resize(count);
  work.bearing_force.assign(count, Vec<D>::Zero());
  work.bearing_moment.assign(count, nothing<Moment<D>>());
  work.bearing_displacement.resize(count, Vec<D>::Zero());
  work.bearing_energy.assign(count, 0.0);
  work.bearing_stored = 0;
}

template <int D>
void bearing_force(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, double dt) {
  work.bearing[i] = state.bearing[i];
  if (is_live(state.bearing[i].status))
    respond_live(model, state, work, i, dt);
  else
    let_go(model, state, work, i, dt);
}

template <int D>
void bearing_forces(const Model<D>& model, const State<D>& state, Work<D>& work, double dt) {
  start_bearings(model, work);
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    bearing_force(model, state, work, i, dt);
    const bool stands = !work.stood_for.empty() && is_live(work.bearing[i].status);
    work.bearing[i].stood_for = stands ? work.stood_for[i] : 0;
  }
}

template <int D>
double bearing_reversal_error(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt) {
  double sum = 0;
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    if (is_live(state.bearing[i].status)) sum += slip_reversal_error(model, state, work, i, dt);
  return sum;
}

template double bearing_reversal_error(const Model<2>&, const State<2>&, const Work<2>&, double);
template double bearing_reversal_error(const Model<3>&, const State<3>&, const Work<3>&, double);
template double start_bearing(const Model<2>&, const State<2>&, Work<2>&, int, const std::array<double, 3>&);
template double start_bearing(const Model<3>&, const State<3>&, Work<3>&, int, const std::array<double, 6>&);
template void start_bearings(const Model<2>&, Work<2>&);
template void start_bearings(const Model<3>&, Work<3>&);
template void bearing_force(const Model<2>&, const State<2>&, Work<2>&, std::size_t, double);
template void bearing_force(const Model<3>&, const State<3>&, Work<3>&, std::size_t, double);
template void bearing_forces(const Model<2>&, const State<2>&, Work<2>&, double);
template void bearing_forces(const Model<3>&, const State<3>&, Work<3>&, double);

}  // namespace trilith
