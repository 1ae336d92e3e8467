// A state on its way to rest: what statics moves, evaluates and commits. Shared by statics/equilibrium.hpp and
// statics/load_path.hpp.
#pragma once

#include <algorithm>
#include <vector>

#include "assembly/node_forces.hpp"
#include "assembly/tangent/tangent.hpp"
#include "model/event.hpp"

namespace trilith {

/// Bodies without velocities. Each step leads from a committed place to the next: what slides, yields or breaks does so
/// along the straight way between the two, however long that takes; dampers do not act.
template <int D>
class StaticTrial {
 public:
  /// Of a state at a step border (advanced, not committed, as Simulation holds it). Both must outlive this; `model` may
  /// be changed between evaluations in its loads and weight, and in nothing else.
  StaticTrial(const Model<D>& model, const State<D>& state);

  /// Forces at the present place.
  void evaluate_here();
  /// What is left of F - inertia M d, where d is the way from the step's begin, at the place last evaluated. Returns
  /// its square, each part over its mass. `inertia` [1/s2]
  double measure(double inertia);
  /// A = inertia M - dF/dx at the present place, ready to solve with. False where it is singular. `closes`: faces that
  /// just meet count as closed, as they are about to.
  bool find_tangent(double inertia, bool closes = false);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return tangent_.solve(right); }
  void move(const Eigen::VectorXd& by, double share);
  /// The way from the step's begin, by unknown [m] or [rad].
  [[nodiscard]] Eigen::VectorXd way() const;
  /// Back to the step's begin, evaluated.
  void go_back();
  /// Makes the place last evaluated the begin of the next step: commits it, books the work of weight, loads and
  /// supports along the way with the mean of their forces at both ends, and evaluates it anew.
  void accept();
  /// The begin of a step, to return to after later steps have been accepted.
  struct Begin {
    State<D> state;
    std::size_t events;
  };
  /// Of the present step; the trial is there (go_back).
  [[nodiscard]] Begin begin() const { return {state_, events_.size()}; }
  /// Undoes the steps accepted since.
  void return_to(Begin begin);
  /// The state at rest at the step's begin, as one that either kind of step goes on from. What the way gave off beyond
  /// what the laws book is the ledger's `rest_damping`. The last call.
  State<D> finish();

  [[nodiscard]] const Eigen::VectorXd& left() const { return left_; }
  /// Largest force left over, as a share of the largest one carried; moments by the node's radius of gyration.
  /// What the digits of places cannot tell is not counted.
  [[nodiscard]] double share() const { return share_; }
  [[nodiscard]] int worst() const { return worst_; }  ///< the node where that is, or -1
  /// From now on shares are of no less than what is carried at the place last evaluated.
  void keep_carried() { least_carried_ = std::max(least_carried_, carried()); }
  /// Of the stiffest unknown by itself, as the last tangent has it; 0 where nothing is stiff [1/s2].
  [[nodiscard]] double highest_square() const { return highest_square_; }
  [[nodiscard]] const DofGraph<D>& coupling() const { return tangent_.coupling(); }
  [[nodiscard]] const State<D>& state() const { return state_; }
  [[nodiscard]] Work<D>& work() { return work_; }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }  ///< of all accepted steps
  /// What friction, fracture and yielding have given off within the step, at the place last evaluated [J].
  [[nodiscard]] double dissipated() const {
    double sum = 0;
    for (std::size_t i = 0; i < energy_term_info.size(); ++i)
      if (energy_term_info[i].dissipated) sum += work_.given.value[i] - state_.given.value[i];
    return sum;
  }
  /// The part of it that bonds at their loss and crushing took [J].
  [[nodiscard]] double fractured() const {
    return work_.given[EnergyTerm::contact_fracture] - state_.given[EnergyTerm::contact_fracture];
  }
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
  double balance_ = 0;                  // of the ledger as statics began [J]
  std::vector<Vec<D>> begin_position_;  // of the step
  std::vector<Rotation<D>> begin_rotation_;
  std::vector<NodeForces<D>> begin_force_;
  std::vector<double> reach_;        // [node] of its body [m]
  double disturbance_;               // how far nodes are moved for the tangent [m]
  Eigen::VectorXd left_, rounding_;  // by unknown
  double least_carried_ = 0;         // [N]
  double share_ = 0, highest_square_ = 0;
  int worst_ = -1;
  std::vector<Event> events_;

  [[nodiscard]] Dofs<D> way_of(int node) const;
};

}  // namespace trilith
