// One attempt at an implicit step, and the energies by which it is accepted.
#pragma once

#include <memory>
#include <vector>

#include "assembly/node_forces.hpp"
#include "integrate/explicit/bond_step.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "integrate/implicit/step_error_estimate.hpp"

namespace trilith {

/// Kinetic plus stored energy [J].
inline double kinetic_and_stored(const Energy& e) {
  return e[EnergyTerm::kinetic] + e[EnergyTerm::contact_elastic] + e[EnergyTerm::bearing_elastic] +
         e[EnergyTerm::strain];
}

/// One implicit step: trial state, initial state, and residual of the equation of motion. Sequence: predict the path,
/// evaluate, compute the residual, correct the path by A^-1 times the residual, repeat; then check the energies of the
/// whole step. `state_` is the trial state; `start_`, `forces_` and `energy_` refer to the start of the step.
template <int D>
class ImplicitTrial {
 public:
  ImplicitTrial(const Model<D>& model, State<D>& state, Work<D>& work, const Energy& energy, Tangent<D>& tangent,
                const ImplicitOptions& options, StepTimes* times);

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
  /// Largest kinetic plus stored energy up to the start of the step, in the frame of the step [J].
  [[nodiscard]] double most_before() const {
    return in_frame() ? kinetic_and_stored(energy_) + kinetic_beside_ - energy_[EnergyTerm::kinetic]
                      : kinetic_and_stored(energy_);
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
  [[nodiscard]] double velocity_error() const;
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
  const Energy energy_;  // at the start of the step
  const double time_;
  const std::shared_ptr<const KeptTangent> kept_;  // at the start of the step
  std::vector<Vec<D>> position_before_;
  std::vector<Rotation<D>> rotation_before_;
  std::vector<NodeForces<D>> forces_;    // at the start of the step
  std::vector<Vec<D>> water_;            // [node] force of water at the start of the step [N]; empty without water
  std::vector<Moment<D>> water_moment_;  // [node] [N m]
  std::vector<Dofs<D>> path_;            // [node] along the step
  std::vector<Dofs<D>> added_before_, added_;  // [node] inertia forces of consistent mass at the start of the step, and
                                               // now; usually empty
  std::vector<Dofs<D>> damped_;                // [node] damping of the consistent mass, now; usually empty
  Vec<D> frame_;                               // frame in which errors are measured [m/s]
  double kinetic_beside_ = 0;                  // kinetic energy in this frame at the start of the step [J]
  double carried_ = 0, dt_ = 0;
  double merit_ = 0, share_left_ = 0;
  int worst_ = -1;
  bool factored_ = false;     // `tangent_` is factorised for a step of length dt_
  Eigen::VectorXd left_;      // residual of the equation of motion, by unknown
  Eigen::VectorXd rounding_;  // rounding error of the forces due to the rounding of positions, by unknown
  StepTimes* const times_;
  StepClock clock_;
};

}  // namespace trilith
