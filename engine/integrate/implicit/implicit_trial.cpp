#include "integrate/implicit/implicit_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/evaluate.hpp"
#include "base/portable.hpp"
#include "integrate/explicit/tunnelling.hpp"

namespace trilith {
namespace {

/// Rounding error of a position, as a share of it.
constexpr double digits = std::numeric_limits<double>::epsilon();
/// The tangent is updated if an iteration leaves more than slow_share of the residual and the expected number of
/// remaining iterations exceeds the cost of a new tangent with its factors. In space this cost is much higher, because
/// all forces are evaluated for each colour.
constexpr double slow_share = 0.1;
template <int D>
constexpr double tangent_cost = D == 2 ? 1 : 12;

}  // namespace

/// Predictor: free nodes keep their velocity; driven nodes follow their motion.
template <int D>
void ImplicitTrial<D>::predict() {
  state_.time = time_ + dt_, state_.last_dt = dt_;
  state_.position_before = start_.position;
  state_.rotation_before = start_.rotation;
  for (int n = 0; n < model_.nodes(); ++n) {
    path_[n] = {};
    const Dofs<D> speed = start_.velocity_of(n);
    for (int k = 0; k < Space<D>::dofs; ++k) {
      const int axis = k - Space<D>::translations;
      double& rate = axis >= 0 ? number_at(axis, state_.spin[n]) : state_.velocity[n][k];
      double& rise = axis >= 0 ? number_at(axis, state_.spin_rate[n]) : state_.acceleration[n][k];
      if (model_.support[n][k] == Support::free) {
        path_[n][k] = dt_ * speed[k];
      } else if (model_.support[n][k] == Support::driven) {
        const Drive& drive = model_.drives[model_.drive_of[n][k]];
        const MotionAt motion = drive.motion->at(state_.time - drive.start);
        const bool turns = D == 3 && axis >= 0;
        path_[n][k] = turns ? driven_turn(drive, time_, state_.time)
                            : drive.origin + motion.displacement - place_along(start_, n, k);
        rate = motion.velocity, rise = motion.acceleration;
      } else {
        rate = rise = 0;
      }
    }
    correct(n);
  }
}

/// Position, velocity and acceleration of a node at the end of the step, from its path there. The path is stored
/// separately from the position: over a short step it has digits that the position has not.
template <int D>
void ImplicitTrial<D>::correct(int n) {
  state_.position[n] = start_.position[n] + along_of(path_[n]);
  const double per = 1 / (scheme_.b * dt_ * dt_), half = 0.5 - scheme_.b;
  for (int k = 0; k < Space<D>::translations; ++k) {
    if (model_.support[n][k] != Support::free) continue;
    const double v0 = start_.velocity[n][k], a0 = start_.acceleration[n][k];
    const double a = per * (path_[n][k] - dt_ * v0 - half * dt_ * dt_ * a0);
    state_.acceleration[n][k] = a;
    state_.velocity[n][k] = v0 + dt_ * ((1 - scheme_.g) * a0 + scheme_.g * a);
  }
  const TurnMotion<D> end = turned(model_, n, scheme_, dt_, start_.turn(n), about_of(path_[n]),
                                   {state_.rotation[n], state_.spin[n], state_.spin_rate[n]});
  state_.rotation[n] = end.rotation, state_.spin[n] = end.spin, state_.spin_rate[n] = end.rate;
}

template <int D>
void ImplicitTrial<D>::evaluate_trial() {
  clock_.mark(StepPart::advance);
  evaluate(model_, state_, work_, dt_, times_);
  clock_.skip();
}

/// Residual of the equation of motion at the evaluated trial state. Returns the sum of its squares, each divided by its
/// inertia.
template <int D>
double ImplicitTrial<D>::residual() {
  const DofGraph<D>& coupling = tangent_.coupling();
  left_.resize(coupling.size());
  double sum = 0, most = 0, carried = std::max(carried_, work_.carried);
  const double m = scheme_.alpha_m, f = scheme_.alpha_f;
  added_inertia(model_, state_, true, added_);
  added_damping(model_, state_, damped_);
  Dofs<D> mass{}, inertia{}, largest{};
  for (int i = 0, node = -1; i < coupling.size(); ++i) {
    const auto [n, k] = coupling.freedom[i];
    if (n != node)
      mass = mass_of(model_, state_, n), inertia = inertia_of(model_, state_, start_, m, n, largest), node = n;
    const double now = net_force(model_, state_, work_, coupling.freedom[i]) + (damped_.empty() ? 0 : damped_[n][k]);
    double taken = inertia[k];
    if (!added_.empty()) taken += (1 - m) * added_[n][k] + m * added_before_[n][k];
    // r = (1 - alpha_f) F' + alpha_f F - M ((1 - alpha_m) a' + alpha_m a), [N] or [N m].
    left_[i] = (1 - f) * now + f * forces_[n].force[k] - taken;
    sum += left_[i] * left_[i] / mass[k];
    const double radius = is_turn<D>({n, k}) ? gyration_of(model_, n) : 1;
    const double left = std::abs(left_[i]) - rounding_of(i, mass[k]);
    if (left / radius > most) most = left / radius, worst_ = n;
    carried = std::max(carried, std::max(std::abs(taken), std::abs(largest[k])) / radius);
  }
  share_left_ = carried > 0 ? most / carried : most > 0 ? 1 : 0;
  return sum;
}

/// Rounding error of the forces: the last tangent times the rounding error of the positions. Moments on very small
/// inertia, at a stiff member that has turned, converge no further than this.
template <int D>
void ImplicitTrial<D>::find_rounding() {
  rounding_.setZero(tangent_.coupling().size());
  const KeptTangent* const kept = state_.tangent.get();
  if (kept == nullptr || kept->size() != rounding_.size()) return;
  for (int column = 0; column < kept->size(); ++column) {
    const auto [n, k] = tangent_.coupling().freedom[column];
    const double place = digits_along(state_, n, k);
    const Dofs<D> own = inertia_column(model_, state_, {n, k}, kept->inertia, kept->rate);
    for (int at = kept->column[column]; at < kept->column[column + 1]; ++at) {
      const int row = kept->row[at];
      const Freedom& of = tangent_.coupling().freedom[row];
      const double inertia = of.node == n ? own[of.k] : 0;
      rounding_[row] += digits * place * std::abs(kept->value[at] - inertia);
    }
  }
}

/// Rounding error of one component of the residual. The acceleration is a small difference of paths.
template <int D>
double ImplicitTrial<D>::rounding_of(int i, double mass) const {
  const auto [n, k] = tangent_.coupling().freedom[i];
  const double v0 = start_.velocity_of(n)[k], a0 = start_.acceleration_of(n)[k];
  return rounding_[i] + 1e-15 * mass * (std::abs(v0) / dt_ + std::abs(a0)) / scheme_.b;
}

template <int D>
void ImplicitTrial<D>::move(const Eigen::VectorXd& by, double share) {
  const DofGraph<D>& coupling = tangent_.coupling();
  for (int n = 0; n < model_.nodes(); ++n) {
    Dofs<D> way{};
    for (int k = 0; k < Space<D>::dofs; ++k)
      if (const int i = coupling.unknown[n][k]; i >= 0) way[k] = share * by[i];
    Dofs<D> path = path_[n];
    for (int k = 0; k < Space<D>::translations; ++k) path[k] += way[k];
    path_[n] = dofs_of(along_of(path), corrected_turn(model_, n, about_of(path), about_of(way)));
    correct(n);
  }
}

/// Line search along `full` as far as the residual decreases; if it does not decrease, a small step.
template <int D>
void ImplicitTrial<D>::improve(const Eigen::VectorXd& full) {
  const double before = merit_;
  double share = 1;
  move(full, 1);
  evaluate_trial();
  merit_ = residual();
  for (int halvings = 0; !(merit_ < before) && halvings < 6 && !options_.stopped(); ++halvings) {
    clock_.mark(StepPart::advance);
    move(full, -0.5 * share);
    share *= 0.5;
    evaluate(model_, state_, work_, dt_);
    merit_ = residual();
    clock_.mark(StepPart::search);
  }
}

/// True if the tangent can be reused, judged by the residual that the last iteration has left.
template <int D>
bool ImplicitTrial<D>::serves_on(double merit_before) const {
  const double rate = std::sqrt(merit_ / merit_before);
  if (rate <= slow_share || share_left_ <= options_.tolerance) return true;
  if (!(rate < 1)) return false;
  const double ahead = portable::log(options_.tolerance / share_left_) / portable::log(rate);
  return ahead <= tangent_cost<D>;
}

template <int D>
bool ImplicitTrial<D>::attempt(double dt, ImplicitStep& out) {
  dt_ = dt;
  out.through_a = out.through_b = -1;
  predict();
  evaluate_trial();
  tangent_.shape(model_, work_);
  find_rounding();
  merit_ = residual();
  const TangentOptions wanted{dt_, per_place(), 1 - scheme_.alpha_f, (1 - scheme_.alpha_m) / (scheme_.b * dt_ * dt_)};
  clock_.mark(StepPart::advance);
  bool serves = tangent_.take(state_, wanted);
  factored_ = serves;
  clock_.mark(StepPart::factorise);
  for (int i = 0; i < options_.most_iterations; ++i) {
    out.left = share_left_, out.worst = worst_;
    if (share_left_ <= options_.tolerance) return true;
    if (!std::isfinite(merit_)) return false;
    if (options_.stopped()) {
      out.stopped = true;
      return false;
    }
    ++out.iterations;
    const double before = merit_;
    // A new tangent costs as much as some iterations, so it is computed only if the last one is not sufficient.
    if (!serves) {
      clock_.mark(StepPart::advance);
      if (!tangent_.find(model_, state_, work_, wanted, times_)) return false;
      factored_ = true;
      clock_.skip();
      find_rounding();
    }
    clock_.mark(StepPart::advance);
    const Eigen::VectorXd way = tangent_.solve(left_);
    clock_.mark(StepPart::solve);
    improve(way);
    serves = serves_on(before);
  }
  return false;
}

template <int D>
bool ImplicitTrial<D>::tunnels(ImplicitStep& out) const {
  const Tunnelling<D> t =
      find_tunnelling(model_, state_, work_, {start_.position, start_.velocity, start_.rotation, dt_});
  out.through_a = t.piece_a, out.through_b = t.piece_b;
  return t.piece_a >= 0;
}

template bool ImplicitTrial<2>::attempt(double, ImplicitStep&);
template bool ImplicitTrial<3>::attempt(double, ImplicitStep&);
template bool ImplicitTrial<2>::tunnels(ImplicitStep&) const;
template bool ImplicitTrial<3>::tunnels(ImplicitStep&) const;

}  // namespace trilith
