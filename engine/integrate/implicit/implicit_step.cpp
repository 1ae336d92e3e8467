#include "integrate/implicit/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/slip_reversal_error.hpp"
#include "base/portable.hpp"
#include "integrate/explicit/bond_step.hpp"
#include "integrate/explicit/tunnelling.hpp"
#include "integrate/implicit/step_error_estimate.hpp"

namespace trilith {
namespace {

/// Largest number of halvings of a step to converge, and to satisfy the energy limit.
constexpr int most_cuts = 14, most_cuts_for_energy = 7;
/// The next step may be longer if the error is below this share of the limit.
constexpr double well_kept = 0.2;
/// After this number of halvings, an error above `no_better` times the previous error does not depend on the step
/// length: a contact has changed its shape.
constexpr int cuts_that_tell = 4;
constexpr double no_better = 0.6;
/// A step is easy if it converges within this number of iterations; the next may then be longer by `growth`.
constexpr int easy_iterations = 8;
constexpr double growth = 2;
/// Rounding error of a position, as a share of it.
constexpr double digits = std::numeric_limits<double>::epsilon();
/// The tangent is updated if an iteration leaves more than slow_share of the residual and the expected number of
/// remaining iterations exceeds the cost of a new tangent with its factors. In space this cost is much higher, because
/// all forces are evaluated for each colour.
constexpr double slow_share = 0.1;
template <int D>
constexpr double tangent_cost = D == 2 ? 1 : 12;

/// Energies in a moving frame are small differences of large values, known to this share of them at best.
constexpr double rounding_share = 1e-9;

/// The velocity of the frame in which errors are measured [m/s]. Along each axis it is the velocity of the support
/// nearest to the mean velocity of all that moves. Without supports it is this mean.
template <int D>
Vec<D> frame_of(const Model<D>& model, const State<D>& state) {
  Vec<D> frame = Vec<D>::Zero();
  for (int k = 0; k < Space<D>::translations; ++k) {
    double mass = 0, momentum = 0;
    for (int n = 0; n < model.nodes(); ++n)
      if (model.support[n][k] == Support::free) mass += model.mass[n], momentum += model.mass[n] * state.velocity[n][k];
    const double mean = mass > 0 ? momentum / mass : 0;
    double nearest = std::numeric_limits<double>::infinity();
    frame[k] = mean;
    for (int n = 0; n < model.nodes(); ++n) {
      const double speed = state.velocity[n][k];
      if (model.support[n][k] == Support::free || !(std::abs(speed - mean) < nearest)) continue;
      nearest = std::abs(speed - mean), frame[k] = speed;
    }
  }
  return frame;
}

/// Kinetic plus stored energy [J].
double held(const Energy& e) {
  return e[EnergyTerm::kinetic] + e[EnergyTerm::contact_elastic] + e[EnergyTerm::bearing_elastic] +
         e[EnergyTerm::strain];
}

/// One implicit step: trial state, initial state, and residual of the equation of motion. Sequence: predict the path,
/// evaluate, compute the residual, correct the path by A^-1 times the residual, repeat; then check the energies of the
/// whole step. `state_` is the trial state; `start_`, `forces_` and `energy_` refer to the begin of the step.
template <int D>
class Trial {
 public:
  Trial(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy, Tangent<D>& tangent,
        const ImplicitOptions& options, StepTimes* times)
      : model_(model),
        state_(state),
        work_(work),
        tangent_(tangent),
        scheme_(options.scheme),
        options_(options),
        start_(state),
        energy_(energy),
        time_(state.time),
        kept_(state.tangent),
        position_before_(state.position_before),
        rotation_before_(state.rotation_before),
        times_(times),
        clock_(times) {
    forces_ = implicit_forces(model, state, work);
    path_.resize(forces_.size());
    carried_ = work.carried;
    added_inertia(model, state, true, added_before_);
    frame_ = frame_of(model, state);
    kinetic_beside_ = kinetic_beside();
  }

  /// Tries a step of length dt. False if it does not converge.
  bool attempt(double dt, ImplicitStep& out);
  /// The time since the last mark belongs to the step itself.
  void mark_advance() { clock_.mark(StepPart::advance); }
  void give_up();
  /// Work terms of the converged step.
  [[nodiscard]] Energy booked() const;
  /// Energy error of the step with these terms, as a share.
  [[nodiscard]] double missed(const Energy& booked);
  /// True if the step moved two pieces through each other; forces at its end do not show this.
  [[nodiscard]] bool tunnels(ImplicitStep& out) const;
  /// Largest kinetic plus stored energy up to the begin of the step, in the frame of the step [J].
  [[nodiscard]] double most_before() const {
    return in_frame() ? held(energy_) + kinetic_beside_ - energy_[EnergyTerm::kinetic] : held(energy_);
  }
  /// Work that the bonds missed, see integrate/explicit/bond_step.hpp.
  [[nodiscard]] double bonds_missed() const { return bond_miss(model_, state_, work_, dt_); }

 private:
  void predict();
  void correct(int n);
  void evaluate_trial();
  double residual();
  void find_rounding();
  [[nodiscard]] double rounding_of(int i, double mass) const;
  void improve(const Eigen::VectorXd& full);
  [[nodiscard]] bool serves_on(double merit_before) const;
  void move(const Eigen::VectorXd& by, double share);
  [[nodiscard]] double net_work(const std::vector<NodeForces<D>>& end, const Vec<D>& frame) const;
  [[nodiscard]] double kinetic_beside() const;
  /// True if the frame of the step moves.
  [[nodiscard]] bool in_frame() const { return frame_ != Vec<D>(Vec<D>::Zero()); }
  [[nodiscard]] double per_place() const { return scheme_.g / (scheme_.b * dt_); }

  const Model<D>& model_;
  State<D>& state_;
  Work<D>& work_;
  Tangent<D>& tangent_;
  const AlphaScheme scheme_;
  const ImplicitOptions& options_;
  const StepStart<D> start_;
  const Energy energy_;  // at the begin of the step
  const double time_;
  const std::shared_ptr<const KeptTangent> kept_;  // at the begin of the step
  std::vector<Vec<D>> position_before_;
  std::vector<Rotation<D>> rotation_before_;
  std::vector<NodeForces<D>> forces_;          // at the begin of the step
  std::vector<Dofs<D>> path_;                  // [node] along the step
  std::vector<Dofs<D>> added_before_, added_;  // [node] inertia forces of consistent mass at the begin of the step, and
                                               // now; usually empty
  std::vector<Dofs<D>> damped_;                // [node] damping of the consistent mass, now; usually empty
  Vec<D> frame_;                               // frame in which errors are measured [m/s]
  double kinetic_beside_ = 0;                  // kinetic energy in this frame at the begin of the step [J]
  double carried_ = 0, dt_ = 0;
  double merit_ = 0, share_left_ = 0;
  int worst_ = -1;
  Eigen::VectorXd left_;      // residual of the equation of motion, by unknown
  Eigen::VectorXd rounding_;  // rounding error of the forces due to the rounding of positions, by unknown
  StepTimes* const times_;
  StepClock clock_;
};

/// Predictor: free nodes keep their velocity; driven nodes follow their motion.
template <int D>
void Trial<D>::predict() {
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
void Trial<D>::correct(int n) {
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
void Trial<D>::evaluate_trial() {
  clock_.mark(StepPart::advance);
  evaluate(model_, state_, work_, dt_, times_);
  clock_.skip();
}

/// Residual of the equation of motion at the evaluated trial state. Returns the sum of its squares, each divided by its
/// inertia.
template <int D>
double Trial<D>::residual() {
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
void Trial<D>::find_rounding() {
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
double Trial<D>::rounding_of(int i, double mass) const {
  const auto [n, k] = tangent_.coupling().freedom[i];
  const double v0 = start_.velocity_of(n)[k], a0 = start_.acceleration_of(n)[k];
  return rounding_[i] + 1e-15 * mass * (std::abs(v0) / dt_ + std::abs(a0)) / scheme_.b;
}

template <int D>
void Trial<D>::move(const Eigen::VectorXd& by, double share) {
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
void Trial<D>::improve(const Eigen::VectorXd& full) {
  const double before = merit_;
  double share = 1;
  move(full, 1);
  evaluate_trial();
  merit_ = residual();
  for (int halvings = 0; !(merit_ < before) && halvings < 6; ++halvings) {
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
bool Trial<D>::serves_on(double merit_before) const {
  const double rate = std::sqrt(merit_ / merit_before);
  if (rate <= slow_share || share_left_ <= options_.tolerance) return true;
  if (!(rate < 1)) return false;
  const double ahead = portable::log(options_.tolerance / share_left_) / portable::log(rate);
  return ahead <= tangent_cost<D>;
}

template <int D>
bool Trial<D>::attempt(double dt, ImplicitStep& out) {
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
  clock_.mark(StepPart::factorise);
  for (int i = 0; i < options_.most_iterations; ++i) {
    out.left = share_left_, out.worst = worst_;
    if (share_left_ <= options_.tolerance) return true;
    if (!std::isfinite(merit_)) return false;
    ++out.iterations;
    const double before = merit_;
    // A new tangent costs as much as some iterations, so it is computed only if the last one is not sufficient.
    if (!serves) {
      clock_.mark(StepPart::advance);
      if (!tangent_.find(model_, state_, work_, wanted, times_)) return false;
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
bool Trial<D>::tunnels(ImplicitStep& out) const {
  const Tunnelling<D> t =
      find_tunnelling(model_, state_, work_, {start_.position, start_.velocity, start_.rotation, dt_});
  out.through_a = t.piece_a, out.through_b = t.piece_b;
  return t.piece_a >= 0;
}

/// Restores the begin of the step. The steps up to there are committed and no last step remains, so the outstanding
/// half of the work is booked here.
template <int D>
void Trial<D>::give_up() {
  state_.time = time_, state_.last_dt = 0;
  state_.tangent = kept_;
  state_.position = state_.position_before = start_.position;
  state_.rotation = state_.rotation_before = start_.rotation;
  state_.velocity = start_.velocity, state_.acceleration = start_.acceleration;
  state_.spin = start_.spin, state_.spin_rate = start_.spin_rate;
  for (int n = 0; n < model_.nodes(); ++n) {
    const Dofs<D> behind = dofs_of(Vec<D>(0.5 * (start_.position[n] - position_before_[n])),
                                   Spin<D>(0.5 * turn_between(rotation_before_[n], start_.rotation[n])));
    add_work(forces_[n], behind, state_.given);
    if (!added_before_.empty())
      state_.given[EnergyTerm::support] += work_on_support(model_, n, added_before_[n], behind);
  }
}

/// Work of the net forces along the step, by the mean of their values at both ends, in a frame that moves at `frame`
/// [J].
template <int D>
double Trial<D>::net_work(const std::vector<NodeForces<D>>& end, const Vec<D>& frame) const {
  double work = 0;
  for (int n = 0; n < model_.nodes(); ++n) {
    Dofs<D> ahead = half_way(start_, state_, n);
    for (int k = 0; k < Space<D>::translations; ++k) ahead[k] -= 0.5 * dt_ * frame[k];
    if (!added_before_.empty())
      work += work_on_support(model_, n, added_before_[n], ahead) + work_on_support(model_, n, added_[n], ahead);
    work += dot(forces_[n].force, ahead) + dot(end[n].force, ahead);
  }
  return work;
}

/// Kinetic energy in the frame of the step [J]. Velocities are restored bit for bit.
template <int D>
double Trial<D>::kinetic_beside() const {
  if (!in_frame()) return implicit_kinetic(model_, state_);
  const std::vector<Vec<D>> kept = state_.velocity;
  for (Vec<D>& v : state_.velocity) v -= frame_;
  const double kinetic = implicit_kinetic(model_, state_);
  state_.velocity = kept;
  return kinetic;
}

/// Work of the initial forces along half of the last step and half of this one. The numerical term is the work of the
/// net force, by the mean of its values at both ends, minus the change of the kinetic energy.
template <int D>
Energy Trial<D>::booked() const {
  Energy given;
  for (int n = 0; n < model_.nodes(); ++n) {
    const Dofs<D> path = half_of_both(position_before_[n], rotation_before_[n], start_, state_, n);
    add_work(forces_[n], path, given);
    if (!added_before_.empty()) given[EnergyTerm::support] += work_on_support(model_, n, added_before_[n], path);
  }
  const double work = net_work(implicit_forces(model_, state_, work_), Vec<D>::Zero());
  given[EnergyTerm::numerical] = work - (implicit_kinetic(model_, state_) - energy_[EnergyTerm::kinetic]);
  return given;
}

/// Error as a share of the largest kinetic plus stored energy, so that motion near rest needs no shorter steps. Energy
/// that the scheme dissipates is intended; energy that it adds is an error. If friction reverses, neither the ledger
/// nor the forces at both ends show the error. The work error of the reversal is then added to the energy of the
/// velocity error. Kinetic energy and the numerical term refer to the frame of the supports, so that a uniform motion
/// of the model changes nothing.
template <int D>
double Trial<D>::missed(const Energy& booked) {
  Energy end = implicit_energy(model_, state_, work_);
  for (std::size_t i = 0; i < end.value.size(); ++i) end.value[i] += booked.value[i];
  const double off_balance = std::abs(end.balance() - energy_.balance());
  double numerical = booked[EnergyTerm::numerical], begun = held(energy_), ended = held(end);
  if (in_frame()) {
    const double kinetic = kinetic_beside(), all = std::max(begun, ended);
    numerical = net_work(implicit_forces(model_, state_, work_), frame_) - (kinetic - kinetic_beside_);
    begun += kinetic_beside_ - energy_[EnergyTerm::kinetic], ended += kinetic - end[EnergyTerm::kinetic];
    begun = std::max(begun, rounding_share * all);
  }
  const double most = std::max({state_.most_energy, begun, ended});
  const double off = off_balance + std::max(0.0, -numerical);
  const double wrong =
      step_error_estimate(model_, state_, start_, dt_) + slip_reversal_error(model_, state_, work_, dt_);
  return most > 0 ? std::max(off / most, 2 * std::sqrt(wrong / most)) : 0;
}

}  // namespace

template <int D>
ImplicitStep advance_implicitly(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy,
                                Tangent<D>& tangent, const ImplicitOptions& options, StepTimes* times) {
  Trial<D> trial(model, state, work, energy, tangent, options, times);
  ImplicitStep out;
  out.dt = options.dt;
  for (; out.cuts <= most_cuts && (out.cuts == 0 || out.dt >= options.give_up); ++out.cuts, out.dt *= 0.5) {
    const int before = out.iterations;
    if (!trial.attempt(out.dt, out) || trial.tunnels(out)) continue;
    // The equation of motion at both ends does not detect a bond that breaks within the step without its work.
    if (trial.bonds_missed() > (out.cuts < most_cuts ? 1 : largest_bond_miss)) continue;
    const Energy booked = trial.booked();
    const double last = std::exchange(out.missed, options.accuracy > 0 ? trial.missed(booked) : 0);
    const bool gains = out.cuts < cuts_that_tell || out.missed <= no_better * last;
    const bool can_be_cut = out.cuts < most_cuts_for_energy && 0.5 * out.dt >= options.shortest;
    // The tangent is adequate: the step is correct but too long, and is repeated from its begin with half the length.
    if (out.missed > options.accuracy && gains && can_be_cut) continue;
    for (std::size_t i = 0; i < booked.value.size(); ++i) state.given.value[i] += booked.value[i];
    ++state.step;
    state.most_energy = std::max(state.most_energy, trial.most_before());
    out.converged = true;
    const bool easy =
        out.cuts == 0 && out.iterations - before <= easy_iterations && out.missed <= well_kept * options.accuracy;
    state.dt = easy ? growth * out.dt : out.dt;
    trial.mark_advance();
    return out;
  }
  trial.give_up();
  work.valid = false;
  return out;
}

template ImplicitStep advance_implicitly(const Model<2>&, State<2>&, Work<2>&, const Energy&, Tangent<2>&,
                                         const ImplicitOptions&, StepTimes*);
template ImplicitStep advance_implicitly(const Model<3>&, State<3>&, Work<3>&, const Energy&, Tangent<3>&,
                                         const ImplicitOptions&, StepTimes*);

}  // namespace trilith
