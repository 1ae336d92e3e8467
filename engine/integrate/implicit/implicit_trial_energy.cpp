// Begin and end of an implicit step: its frame, its work, and its energy error.
#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/slip_reversal_error.hpp"
#include "assembly/water/water_work.hpp"
#include "integrate/implicit/fibre_error.hpp"
#include "integrate/implicit/implicit_trial.hpp"

namespace trilith {
namespace {

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

}  // namespace

template <int D>
ImplicitTrial<D>::ImplicitTrial(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy,
                                Tangent<D>& tangent, const ImplicitOptions& options, StepTimes* times)
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
  water_ = work.water, water_moment_ = work.water_moment;
  path_.resize(forces_.size());
  carried_ = work.carried;
  added_inertia(model, state, true, added_before_);
  frame_ = frame_of(model, state);
  kinetic_beside_ = kinetic_beside();
}

/// Restores the start of the step. The steps up to there are committed and no last step remains, so the outstanding
/// half of the work is booked here.
template <int D>
void ImplicitTrial<D>::give_up() {
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
  book_water<D>(model_, {water_, water_moment_}, state_.given, [&](int n) {
    return dofs_of(Vec<D>(0.5 * (start_.position[n] - position_before_[n])),
                   Spin<D>(0.5 * turn_between(rotation_before_[n], start_.rotation[n])));
  });
}

/// Work of the net forces along the step, by the mean of their values at both ends, in a frame that moves at `frame`
/// [J].
template <int D>
double ImplicitTrial<D>::net_work(const std::vector<NodeForces<D>>& end, const Vec<D>& frame) const {
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
double ImplicitTrial<D>::kinetic_beside() const {
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
Energy ImplicitTrial<D>::booked() const {
  Energy given;
  for (int n = 0; n < model_.nodes(); ++n) {
    const Dofs<D> path = half_of_both(position_before_[n], rotation_before_[n], start_, state_, n);
    add_work(forces_[n], path, given);
    if (!added_before_.empty()) given[EnergyTerm::support] += work_on_support(model_, n, added_before_[n], path);
  }
  book_water<D>(model_, {water_, water_moment_}, given,
                [&](int n) { return half_of_both(position_before_[n], rotation_before_[n], start_, state_, n); });
  const double work = net_work(implicit_forces(model_, state_, work_), Vec<D>::Zero());
  given[EnergyTerm::numerical] = work - (implicit_kinetic(model_, state_) - energy_[EnergyTerm::kinetic]);
  return given;
}

/// Energy of the velocity error of the step [J]. Vibrations of frames of fibres that the step does not resolve are left
/// out where the step has a tangent.
template <int D>
double ImplicitTrial<D>::velocity_error() const {
  std::vector<Dofs<D>> jump = acceleration_change(model_, state_, start_);
  if (factored_ && has_fibres(model_))
    filter_fibre_error(model_, state_, work_, tangent_, (1 - scheme_.alpha_m) / (scheme_.b * dt_ * dt_), jump);
  return step_error_estimate(model_, state_, jump, dt_);
}

/// Error as a share of the largest kinetic plus stored energy, so that motion near rest needs no shorter steps. Energy
/// that the scheme dissipates is intended; energy that it adds is an error. If friction reverses, neither the ledger
/// nor the forces at both ends show the error. The work error of the reversal is then added to the energy of the
/// velocity error. Kinetic energy and the numerical term refer to the frame of the supports, so that a uniform motion
/// of the model changes nothing.
template <int D>
double ImplicitTrial<D>::missed(const Energy& booked) {
  Energy end = implicit_energy(model_, state_, work_);
  for (std::size_t i = 0; i < end.value.size(); ++i) end.value[i] += booked.value[i];
  const double off_balance = std::abs(end.balance() - energy_.balance());
  double numerical = booked[EnergyTerm::numerical], begun = kinetic_and_stored(energy_),
         ended = kinetic_and_stored(end);
  if (in_frame()) {
    const double kinetic = kinetic_beside(), all = std::max(begun, ended);
    numerical = net_work(implicit_forces(model_, state_, work_), frame_) - (kinetic - kinetic_beside_);
    begun += kinetic_beside_ - energy_[EnergyTerm::kinetic], ended += kinetic - end[EnergyTerm::kinetic];
    begun = std::max(begun, rounding_share * all);
  }
  const double most = std::max({state_.most_energy, begun, ended});
  const double off = off_balance + std::max(0.0, -numerical);
  const double wrong = velocity_error() + slip_reversal_error(model_, state_, work_, dt_);
  return most > 0 ? std::max(off / most, 2 * std::sqrt(wrong / most)) : 0;
}

#define TRILITH_TRIAL(D)                                                                                     \
  template ImplicitTrial<D>::ImplicitTrial(const Model<D>&, State<D>&, Work<D>&, const Energy&, Tangent<D>&, \
                                           const ImplicitOptions&, StepTimes*);                              \
  template void ImplicitTrial<D>::give_up();                                                                 \
  template Energy ImplicitTrial<D>::booked() const;                                                          \
  template double ImplicitTrial<D>::missed(const Energy&);
TRILITH_TRIAL(2)
TRILITH_TRIAL(3)
#undef TRILITH_TRIAL

}  // namespace trilith
