// The tangent of a step: how the forces on free nodes answer to a change of the place the step ends at.
//
//   A = m (1 - alpha_m) / (b dt^2) - (1 - alpha_f) (dF/dx + c dF/dv),   c = g / (b dt)
//
// with b, g, alpha of step/alpha_scheme.hpp. dF is found term by term (step/term_tangent.hpp), each by central
// differences of what finds it in a step. So it is that of every law, branch and load there is, one that is added
// included; rounding leaves it exact to about 1e-6. Beams have theirs by hand (step/beam_tangent.hpp), which is of one
// side of a kink where a fibre or a hinge begins to yield.
#pragma once

#include <Eigen/SparseCore>

#include <memory>
#include <utility>
#include <vector>

#include "step/coupling.hpp"
#include "step/sparse_factors.hpp"
#include "step/step_times.hpp"
#include "world/state.hpp"

namespace trilith {

/// What the tangent is taken of.
struct TangentOptions {
  double dt = 0;        ///< of the step that the trial state ends [s]
  double rate = 0;      ///< change of velocity per change of place [1/s]
  double force = 1;     ///< share of the forces in the equation of motion
  double inertia = 0;   ///< coefficient of the mass [1/s2]
  double move = 0;      ///< how far nodes are moved [m]; 0: as suits the step
  bool bands = true;    ///< with what damping over a band adds to the stiffness
  bool closes = false;  ///< faces that just meet count as closed and sticking; else as they are
};

/// The force [N] or moment [N m] on an unknown at an evaluated state: weight, loads and all dampings with it.
double net_force(const Model<2>& model, const State<2>& state, const Work<2>& work, const Freedom& f);

class Tangent {
 public:
  /// Finds the pattern for the pairs that `work` holds, where it is not that already.
  void shape(const Model<2>& model, const Work<2>& work);
  /// The model has changed: the pattern is looked for anew.
  void forget() { shaped_ = false; }
  [[nodiscard]] const Coupling& coupling() const { return coupling_; }

  /// At a trial state that `work` is evaluated at. Both are as before afterwards.
  void assemble(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options);
  /// The same by differences of `evaluate`, many nodes at a time: what the other is checked against. `work` is then
  /// evaluated elsewhere.
  void assemble_by_differences(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options);
  /// The same, made ready to solve with and kept in the state. False where it is singular.
  bool find(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options,
            StepTimes* times = nullptr);
  /// Makes that of the state ready to solve with. False where it has none that was taken for the same step.
  bool take(const State<2>& state, const TangentOptions& options);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }
  [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  void disturbed(const Model<2>& model, State<2>& state, Work<2>& work, const std::vector<int>& nodes, int k,
                 double side, const TangentOptions& options, Eigen::VectorXd& force) const;

  Coupling coupling_;
  std::vector<std::pair<int, int>> pairs_;  // that it was found for
  bool shaped_ = false;
  void add_beams(const Model<2>& model, const State<2>& state, const TangentOptions& options);
  bool factorise(const std::shared_ptr<const KeptTangent>& kept);

  Eigen::SparseMatrix<double> matrix_;
  std::shared_ptr<const KeptTangent> ready_;  // what is solved with
  SparseFactors factors_;
};

}  // namespace trilith
