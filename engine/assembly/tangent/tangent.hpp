// The tangent of a step: how the forces on free nodes answer to a change of the place the step ends at.
//
//   A = m (1 - alpha_m) / (b dt^2) - (1 - alpha_f) (dF/dx + c dF/dv),   c = g / (b dt)
//
// with b, g, alpha of assembly/alpha_scheme.hpp. dF is found by central differences of single terms
// (assembly/tangent/fd_tangent.hpp). So it is that of every law, branch and load there is, one that is added included;
// rounding leaves it exact to about 1e-6. Beams have theirs by themselves (assembly/tangent/beam_tangent.hpp), which
// costs less; in the plane by hand, of one side of a kink where a fibre or a hinge begins to yield.
//
// In space a rotation is changed by a turn about an axis of the world, after those it has made (from the left): the
// unknown of a rotation is that rotation vector, and m is the block that assembly/implicit_turn.hpp gives.
#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "assembly/step_times.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "assembly/tangent/sparse_factors.hpp"
#include "model/state.hpp"

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
template <int D>
double net_force(const Model<D>& model, const State<D>& state, const Work<D>& work, const Freedom& f);

template <int D>
class Tangent {
 public:
  /// Finds the pattern for the pairs that `work` holds, where it is not that already.
  void shape(const Model<D>& model, const Work<D>& work);
  /// The model has changed: the pattern is looked for anew.
  void forget() { shaped_ = false; }
  [[nodiscard]] const DofGraph<D>& coupling() const { return coupling_; }

  /// At a trial state that `work` is evaluated at. Both are as before afterwards.
  void assemble(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options);
  /// The same by differences of `evaluate`, many nodes at a time, where nodes that act on no common node move together
  /// (Curtis, Powell and Reid 1974): what the other is checked against. `work` is then evaluated elsewhere.
  void assemble_by_differences(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options);
  /// The same, made ready to solve with and kept in the state. False where it is singular.
  bool find(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options,
            StepTimes* times = nullptr);
  /// Makes that of the state ready to solve with. False where it has none that was taken for the same step.
  bool take(const State<D>& state, const TangentOptions& options);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }
  [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  void disturbed(const Model<D>& model, State<D>& state, Work<D>& work, const std::vector<int>& nodes, int k,
                 double side, const TangentOptions& options, Eigen::VectorXd& force) const;

  DofGraph<D> coupling_;
  std::vector<std::pair<int, int>> pairs_;  // that it was found for
  bool shaped_ = false;
  void add_beams(const Model<D>& model, const State<D>& state, const TangentOptions& options);
  template <class Block>
  void add_block(const std::array<int, 2>& node, const Block& block);
  bool factorise(const std::shared_ptr<const KeptTangent>& kept);

  Eigen::SparseMatrix<double> matrix_;
  std::shared_ptr<const KeptTangent> ready_;  // what is solved with
  SparseFactors factors_;
};

template <>
void Tangent<2>::add_beams(const Model<2>& model, const State<2>& state, const TangentOptions& options);
template <>
void Tangent<3>::add_beams(const Model<3>& model, const State<3>& state, const TangentOptions& options);
template <>
void Tangent<2>::assemble(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options);
template <>
void Tangent<3>::assemble(const Model<3>& model, State<3>& state, Work<3>& work, const TangentOptions& options);

}  // namespace trilith
