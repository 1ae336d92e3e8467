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

/// A step is halved at most so often to converge, and to keep its energies.
constexpr int most_cuts = 14, most_cuts_for_energy = 7;
/// A step that misses less than this share of what it may can be longer.
constexpr double well_kept = 0.2;
/// Where a step halved so often misses more than this share of what it did before, it is no error of its length: a
/// contact has changed its form.
constexpr int cuts_that_tell = 4;
constexpr double no_better = 0.6;
/// Iterations within which a step is an easy one: the next may be longer, by `growth`.
constexpr int easy_iterations = 8;
constexpr double growth = 2;
/// Rounding of a place, as a share of it.
constexpr double digits = std::numeric_limits<double>::epsilon();
/// The tangent is found anew where an iteration has left more than this share of the forces, and more of them lie ahead
/// at that rate than it costs with its factors: in space, where all is evaluated for each colour, much more.
constexpr double slow_share = 0.1;
template <int D>
constexpr double tangent_cost = D == 2 ? 1 : 12;

/// Energies in a moving frame are differences of much larger ones: known to this share of them at best.
constexpr double rounding_share = 1e-9;

/// The velocity of the frame in which errors are measured: along each axis that of the support that comes nearest to
/// the mean of all that moves; without any support that mean itself [m/s].
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

/// What moves and what is stored [J].
double held(const Energy& e) {
  return e[EnergyTerm::kinetic] + e[EnergyTerm::contact_elastic] + e[EnergyTerm::bearing_elastic] +
         e[EnergyTerm::strain];
}

/// One step: the trial state, what it began with, and what is left of the equation of motion.
/// Order: predict the path, evaluate, measure what is left over, correct the path by A^-1 of it, and again; then the
/// energies of the whole step. `state_` is the trial's; `start_`, `forces_` and `energy_` are of the step's begin.
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

  /// Tries a step of length dt. False where it does not converge.
  bool attempt(double dt, ImplicitStep& out);
  /// What went by since the last mark is the step's own.
  void mark_advance() { clock_.mark(StepPart::advance); }
  void give_up();
  /// The step's work, where it has converged.
  [[nodiscard]] Energy booked() const;
  /// What it missed of its energies with that, as a share.
  [[nodiscard]] double missed(const Energy& booked);
  /// True where it took two pieces through each other, which forces at its end do not show.
  [[nodiscard]] bool tunnels(ImplicitStep& out) const;
  /// The most that has moved or been stored, as the step began, in the frame of the step [J].
  [[nodiscard]] double most_before() const {
    return in_frame() ? held(energy_) + kinetic_beside_ - energy_[EnergyTerm::kinetic] : held(energy_);
  }
  /// What its bonds missed of their work, see integrate/explicit/bond_step.hpp.
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
  /// The frame of the step moves.
  [[nodiscard]] bool in_frame() const { return frame_ != Vec<D>(Vec<D>::Zero()); }
  [[nodiscard]] double per_place() const { return scheme_.g / (scheme_.b * dt_); }

  const Model<D>& model_;
  State<D>& state_;
  Work<D>& work_;
  Tangent<D>& tangent_;
  const AlphaScheme scheme_;
  const ImplicitOptions& options_;
  const StepStart<D> start_;
  const Energy energy_;  // as the step begins
  const double time_;
  const std::shared_ptr<const KeptTangent> kept_;  // as the step begins
  std::vector<Vec<D>> position_before_;
  std::vector<Rotation<D>> rotation_before_;
  std::vector<NodeForces<D>> forces_;          // as the step begins
  std::vector<Dofs<D>> path_;                  // [node] along the step
  std::vector<Dofs<D>> added_before_, added_;  // [node] of consistent mass: as the step begins, and now; mostly empty
  std::vector<Dofs<D>> damped_;                // [node] of its damping, now; mostly empty
  Vec<D> frame_;                               // in which errors are measured [m/s]
  double kinetic_beside_ = 0;                  // in it, as the step begins [J]
  double carried_ = 0, dt_ = 0;
  double merit_ = 0, share_left_ = 0;
  int worst_ = -1;
  Eigen::VectorXd left_;      // of the equation of motion, by unknown
  Eigen::VectorXd rounding_;  // of the forces by that of the places, by unknown
  StepTimes* const times_;
  StepClock clock_;
};

/// Free nodes go on at their velocity; driven ones to where their motion has them.
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

/// Place, velocity and acceleration of a node at the end of the step from its path there. The path is kept apart from
/// the place: over a short step it has digits that the place has not.
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

/// What is left of the equation of motion at the evaluated trial state. Returns its square, each part over its inertia.
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

/// Forces know of a place no more than its digits: those times the last tangent. Moments on next to no inertia, on a
/// stiff member that has turned, get no nearer.
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

/// What of the equation of motion is rounding alone. The acceleration is a small difference of paths.
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

/// Goes along `full` as far as less is left over; where it gets no smaller, a little.
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

/// Whether the tangent is still good enough, by what the last iteration with it has left.
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
    // Found anew only where the last one does not serve: it costs as much as some iterations.
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

/// Back to where the step began. What led there is committed, so no step lies behind it any more: its half of the work
/// is booked here.
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

/// Work of the net forces along the step, by the mean of their values at both ends, seen from a frame that moves at
/// `frame` [J].
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

/// Kinetic energy in the frame of the step [J]. Velocities are put back to the last bit.
template <int D>
double Trial<D>::kinetic_beside() const {
  if (!in_frame()) return implicit_kinetic(model_, state_);
  const std::vector<Vec<D>> kept = state_.velocity;
  for (Vec<D>& v : state_.velocity) v -= frame_;
  const double kinetic = implicit_kinetic(model_, state_);
  state_.velocity = kept;
  return kinetic;
}

/// Work of the forces of the step's begin along half of the step behind and half of the one ahead. What the scheme
/// takes or brings is what the net force does, by the mean of its values at both ends, beyond the kinetic energy.
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

/// As a share of the most that has moved or been stored, so that what comes to rest needs no shorter steps. What
/// the scheme damps is meant to go; what it brings is not. Where friction turned back neither the ledger nor forces at
/// both ends tell: the work it was out by counts as energy of the error of velocities. Motion and the numerical term
/// count in the frame of the supports, so that an even motion of all changes nothing.
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
    // A bond that goes from held to gone without its work is not found by the equation of motion at both ends.
    if (trial.bonds_missed() > (out.cuts < most_cuts ? 1 : largest_bond_miss)) continue;
    const Energy booked = trial.booked();
    const double last = std::exchange(out.missed, options.accuracy > 0 ? trial.missed(booked) : 0);
    const bool gains = out.cuts < cuts_that_tell || out.missed <= no_better * last;
    const bool can_be_cut = out.cuts < most_cuts_for_energy && 0.5 * out.dt >= options.shortest;
    // Not the tangent's fault: the step is right but too long, and is tried from its begin at half the length.
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
