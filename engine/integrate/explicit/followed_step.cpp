#include "integrate/explicit/followed_step.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "integrate/explicit/stable_step.hpp"
#include "law/bearing/clearance.hpp"

namespace trilith {
namespace {

/// Largest step as a share of: a sample interval, 1 / w of a spring, 1 / w of elements, a smooth part of a load curve,
/// and the time constant of mass damping.
constexpr double of_samples = 0.5, of_spring = 0.25, of_elements = 0.5, of_smooth = 0.05, of_mass_damping = 0.1;
/// Largest rotation of gravity in a step [rad].
constexpr double longest_tilt = 0.02;

/// A time window from now, to select motions and loads that act in it.
struct Window {
  double now, until;  ///< [s]
  [[nodiscard]] bool meets(double begin, double end) const { return begin < until && end > now; }
};

double sampled(const GroundMotion& motion, double start, const Window& window) {
  const bool acts = window.meets(start + motion.start_time(), start + motion.end_time());
  return acts ? of_samples * motion.step() : unbounded;
}

double sampled(const LoadCurve& curve, const Window& window) {
  double least = unbounded;
  for (std::size_t i = 0; i + 1 < curve.time.size(); ++i)
    if (window.meets(curve.time[i], curve.time[i + 1]))
      least = std::min(least, (curve.smooth ? of_smooth : of_samples) * (curve.time[i + 1] - curve.time[i]));
  return least;
}

template <int D>
double sampled(const Gravity<D>& g, const Window& window) {
  double least = unbounded;
  if (window.meets(g.grow_start, g.grow_end)) least = of_smooth * (g.grow_end - g.grow_start);
  double rate = 0;
  if constexpr (D == 2)
    rate = std::abs(g.tilt_rate);
  else
    rate = g.tilt_rate.norm();
  if (rate > 0 && window.meets(g.tilt_start, g.tilt_end)) least = std::min(least, longest_tilt / rate);
  return least;
}

/// Mass of a body that moves; unbounded if it does not move [kg].
template <int D>
double moving_mass(const Model<D>& model, int body) {
  if (!model.body_moves(body)) return unbounded;
  double sum = 0;
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) sum += model.mass[n];
  return sum;
}

/// Least moment of inertia of a moving rigid body about its node; unbounded for others [kg m2].
template <int D>
double moving_inertia(const Model<D>& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  if (!b.is_rigid() || !model.body_moves(body)) return unbounded;
  if constexpr (D == 2)
    return model.inertia[b.first_node];
  else
    return model.inertia[b.first_node].minCoeff();
}

/// Longest step that follows a spring and a dashpot between two bodies with the summed inverse mass `yielding` [s].
double following(double stiffness, double dashpot, double yielding) {
  const double rate = std::max(std::sqrt(std::max(0.0, stiffness * yielding)), dashpot * yielding);
  return rate > 0 ? of_spring / rate : unbounded;
}

/// Laws whose closing impact_step handles are not counted here.
double following(const DirectionLaw& law, double yielding) {
  return std::visit(
      [&](const auto& l) {
        using L = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<L, std::monostate> || ClosesAndOpens<L>)
          return unbounded;
        else
          return following(l.tangent(), l.dashpot(), yielding);
      },
      law);
}

template <int D>
double following(const Model<D>& model, const Bearing<D>& b) {
  const double along = 1 / moving_mass(model, b.body_a) + 1 / moving_mass(model, b.body_b),
               turning = 1 / moving_inertia(model, b.body_a) + 1 / moving_inertia(model, b.body_b);
  double least = unbounded;
  for (std::size_t k = 0; k < b.law.size(); ++k)
    least = std::min(least, following(b.law[k], static_cast<int>(k) < Directions<D>::first_turning ? along : turning));
  bool limited = std::any_of(b.limit.begin(), b.limit.end(), [](double l) { return std::isfinite(l); });
  if constexpr (D == 3) {
    least = std::min(least, following(b.horizontal, along));
    limited = limited || std::isfinite(b.horizontal_limit);
  }
  return limited ? std::min(least, shortest_followed_step) : least;
}

/// The shortest step for the load curves.
template <int D>
double sampled_loads(const Model<D>& model, const Window& window) {
  double least = unbounded;
  model.loads.for_each([&](const auto& load) { least = std::min(least, sampled(load.curve, window)); });
  return least;
}

template <int D>
bool may_act(const State<D>& state, std::size_t bearing) {
  const BearingStatus status = state.bearing[bearing].status;
  return status != BearingStatus::failed && status != BearingStatus::removed;
}

}  // namespace

template <int D>
double followed_step(const Model<D>& model, const State<D>& state, double dt, double ahead) {
  if (!(dt > shortest_followed_step)) return dt;
  const Window window{state.time, state.time + ahead};
  double least = sampled(model.gravity, window);
  if (!model.pushes.empty()) least = shortest_followed_step;
  for (const Drive& d : model.drives) least = std::min(least, sampled(*d.motion, d.start, window));
  least = std::min(least, sampled_loads(model, window));
  for (std::size_t i = 0; i < model.bearings.size(); ++i)
    if (may_act(state, i)) least = std::min(least, following(model, model.bearings[i]));
  for (const RateBound& own : model.element_bound) {
    const double rate = std::max(std::sqrt(own.stiffness), own.damping);
    if (rate > 0) least = std::min(least, of_elements / rate);
  }
  if (model.mass_damping > 0) least = std::min(least, of_mass_damping / model.mass_damping);
  return least < dt ? std::max(shortest_followed_step, settled_step(least, 1)) : dt;
}

template double followed_step(const Model<2>&, const State<2>&, double, double);
template double followed_step(const Model<3>&, const State<3>&, double, double);

}  // namespace trilith
