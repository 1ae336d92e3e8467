// A state on its path to rest, which statics moves, evaluates and commits. Used by statics/equilibrium.hpp and
// statics/load_path.hpp.
#pragma once

#include <algorithm>
#include <vector>

#include "assembly/node_forces.hpp"
#include "assembly/tangent/tangent.hpp"
#include "model/event/event.hpp"

namespace trilith {

/// Bodies without velocities. Each step leads from a committed position to the next one. Sliding, yielding and breaking
/// follow the straight path between the two, independent of time; dampers do not act.
template <int D>
class StaticTrial {
 public:
  /// Starts from a state at a step border (advanced, not committed, as in Simulation). Both must outlive this; only the
  /// loads and the weight of `model` may change between evaluations.
  StaticTrial(const Model<D>& model, const State<D>& state);

  /// Evaluates the forces at the present position.
  void evaluate_here();
  /// Residual F - inertia M d at the last evaluated position, with the displacement d from the start of the step.
  /// Returns the sum of its squares, each over its mass. `inertia` [1/s2].
  double measure(double inertia);
  /// Finds and factorises A = inertia M - dF/dx at the present position. False if it is singular. `closes`: faces that
  /// just meet count as closed.
  bool find_tangent(double inertia, bool closes = false);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return tangent_.solve(right); }
  void move(const Eigen::VectorXd& by, double share);
  /// Displacement from the start of the step, by unknown [m] or [rad].
  [[nodiscard]] Eigen::VectorXd way() const;
  /// Displacement from another state, by unknown [m] or [rad].
  [[nodiscard]] Eigen::VectorXd way_from(const State<D>& from) const;
  /// Returns to the start of the step, and evaluates it.
  void go_back();
  /// The inertia of `measure` acts from here on against displacements from the present position, until the step is
  /// accepted or returned. These are steps of pseudo-time within one step, in which the laws keep their first memories.
  void hold_here() { held_position_ = state_.position, held_rotation_ = state_.rotation; }
  /// Returns to the held position, and evaluates it.
  void go_to_held();
  /// Displacement from the held position, by unknown [m] or [rad].
  [[nodiscard]] Eigen::VectorXd way_from_held() const;
  /// Makes the last evaluated position the start of the next step. Commits it, books the work of weight, loads and
  /// supports along the path with the mean of their forces at both ends, and evaluates it again.
  void accept();
  /// The start of a step, to return to after further steps.
  struct Begin {
    State<D> state;
    std::size_t events;
  };
  /// Begin of the present step, at which the trial must be (go_back).
  [[nodiscard]] Begin begin() const { return {state_, events_.size()}; }
  /// Undoes the steps accepted after `begin`.
  void return_to(Begin begin);
  /// The state at rest at the start of the step, from which explicit or implicit steps can continue. Dissipation along
  /// the path beyond the laws is booked as `rest_damping`. Must be the last call.
  State<D> finish();

  [[nodiscard]] const Eigen::VectorXd& left() const { return left_; }
  /// Largest residual force, as a share of the largest force carried; moments by the node's radius of gyration.
  /// Rounding errors do not count.
  [[nodiscard]] double share() const { return share_; }
  [[nodiscard]] int worst() const { return worst_; }  ///< the node with this residual, or -1
  /// From now on shares refer at least to the forces carried at the last evaluated position.
  void keep_carried() { least_carried_ = std::max(least_carried_, carried()); }
  /// Highest frequency squared of a single unknown, from the last tangent; 0 without stiffness [1/s2].
  [[nodiscard]] double highest_square() const { return highest_square_; }
  [[nodiscard]] const DofGraph<D>& coupling() const { return tangent_.coupling(); }
  [[nodiscard]] const State<D>& state() const { return state_; }
  [[nodiscard]] Work<D>& work() { return work_; }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }  ///< of all accepted steps
  /// Energy dissipated by friction, fracture and yielding within the step, at the last evaluated position [J].
  [[nodiscard]] double dissipated() const {
    double sum = 0;
    for (std::size_t i = 0; i < energy_term_info.size(); ++i)
      if (energy_term_info[i].dissipated) sum += work_.given.value[i] - state_.given.value[i];
    return sum;
  }
  /// Part of it that weakens the structure: fracture, crushing and yielding, without friction [J].
  [[nodiscard]] double softened() const {
    const EnergyTerm friction = EnergyTerm::contact_friction;
    return dissipated() - (work_.given[friction] - state_.given[friction]);
  }
  /// Part of it due to broken bonds and crushing [J].
  [[nodiscard]] double fractured() const {
    return work_.given[EnergyTerm::contact_fracture] - state_.given[EnergyTerm::contact_fracture];
  }
  /// Size of the body of a node [m].
  [[nodiscard]] double reach_of(int node) const { return reach_[static_cast<std::size_t>(node)]; }
  /// The mass or inertia of an unknown.
  [[nodiscard]] double mass_at(int unknown) const;

 private:
  void begin_here();
  [[nodiscard]] std::vector<NodeForces<D>> all_forces() const;
  void find_rounding();
  void find_stiffest(double inertia);
  [[nodiscard]] double carried() const;
  [[nodiscard]] double farthest() const;

  const Model<D>& model_;
  State<D> state_;
  Work<D> work_;
  Tangent<D> tangent_;
  bool was_implicit_;
  double balance_ = 0;                  // of the ledger at the start [J]
  std::vector<Vec<D>> begin_position_;  // of the step
  std::vector<Rotation<D>> begin_rotation_;
  std::vector<Vec<D>> held_position_;  // where pseudo-time stands; the start of the step unless hold_here() is used
  std::vector<Rotation<D>> held_rotation_;
  std::vector<NodeForces<D>> begin_force_;
  std::vector<double> reach_;        // [node] of its body [m]
  double disturbance_;               // perturbation of nodes for the tangent [m]
  Eigen::VectorXd left_, rounding_;  // by unknown
  double least_carried_ = 0;         // [N]
  double share_ = 0, highest_square_ = 0;
  int worst_ = -1;
  std::vector<Event> events_;

  [[nodiscard]] Dofs<D> way_of(int node) const;
  [[nodiscard]] Dofs<D> held_way_of(int node) const;
};

}  // namespace trilith
