#include "integrate/explicit/drive_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/node_forces.hpp"

namespace trilith {
namespace {

/// Times at which the velocity of a drive may jump [s]: its start, and the first and last sample of its motion.
std::array<double, 3> jump_times(const Drive& d) {
  return {d.start, d.start + d.motion->start_time(), d.start + d.motion->end_time()};
}

/// Allowance for rounding of times, as a share of a step.
constexpr double time_rounding = 1e-6;

/// True for a time within the last step or the next one.
template <int D>
bool is_near(const State<D>& state, double time, double dt) {
  const double allowance = time_rounding * dt;
  return time >= state.time - state.last_dt - allowance && time <= state.time + dt + allowance;
}

/// Mean velocity of a drive over dt from `time` on [m/s] or [rad/s].
double mean_velocity(const Drive& d, double time, double dt) {
  return driven_turn(d, time, time + dt) / dt;
}

/// Jump of the velocity of a drive within the next step, 0 if there is none; `begins`: reduced to its time from now.
template <int D>
double jump_of(const State<D>& state, const Drive& d, double before, double dt, double& begins) {
  double jump = 0;
  for (const double at : jump_times(d)) {
    if (!is_near(state, at, dt)) continue;
    const double ahead = std::max(0.0, at - state.time);
    const double change = mean_velocity(d, state.time + ahead, dt) - before;
    if (change != 0) begins = std::min(begins, ahead);
    if (std::abs(change) > std::abs(jump)) jump = change;
  }
  return jump;
}

}  // namespace

template <int D>
bool motions_change(const Model<D>& model, const State<D>& state, double dt) {
  for (const Drive& d : model.drives)
    for (const double at : jump_times(d))
      if (is_near(state, at, dt)) return true;
  return false;
}

template <int D>
DriveJumps<D>::DriveJumps(const Model<D>& model, const State<D>& state, double dt) {
  if (!(dt > 0)) return;
  const auto nodes = static_cast<std::size_t>(model.nodes());
  std::vector<Vec<D>> along(nodes, Vec<D>(Vec<D>::Zero()));
  std::vector<double> about(nodes, 0.0);
  bool any = false;
  for (std::size_t n = 0; n < nodes; ++n) {
    const Dofs<D> before = velocity_of(state, static_cast<int>(n));
    double square = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      double jump = 0;
      const Support support = model.support[n][k];
      if (support == Support::driven)
        jump = jump_of(state, model.drives[static_cast<std::size_t>(model.drive_of[n][k])], before[k], dt, begins_);
      if (support == Support::fixed && before[k] != 0) jump = -before[k], begins_ = 0;
      any = any || jump != 0;
      if (k < static_cast<std::size_t>(D))
        along[n][static_cast<Eigen::Index>(k)] = jump;
      else
        square += jump * jump;
    }
    about[n] = std::sqrt(square);
  }
  if (any) gather(model, along, about);
}

template <int D>
void DriveJumps<D>::gather(const Model<D>& model, const std::vector<Vec<D>>& along, const std::vector<double>& about) {
  body_.resize(model.bodies.size());
  for (std::size_t b = 0; b < body_.size(); ++b) {
    const Body& of = model.bodies[b];
    BodyJump& jump = body_[b];
    if (of.nodes == 0) continue;
    jump.along = along[static_cast<std::size_t>(of.first_node)];
    for (int n = of.first_node; n < of.first_node + of.nodes; ++n) {
      const auto i = static_cast<std::size_t>(n);
      jump.spread = std::max(jump.spread, (along[i] - jump.along).norm() + about[i] * model.body_radius[b]);
    }
  }
}

template <int D>
double DriveJumps<D>::between(int body_a, int body_b) const {
  if (body_.empty()) return 0;
  const BodyJump &a = body_[static_cast<std::size_t>(body_a)], &b = body_[static_cast<std::size_t>(body_b)];
  return (b.along - a.along).norm() + a.spread + b.spread;
}

template bool motions_change(const Model<2>&, const State<2>&, double);
template bool motions_change(const Model<3>&, const State<3>&, double);
template class DriveJumps<2>;
template class DriveJumps<3>;

}  // namespace trilith
