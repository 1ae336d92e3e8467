// The tangent of a step: derivative of the forces on free nodes with respect to the position at the end of the step.
//
//   A = m (1 - alpha_m) / (b dt^2) - (1 - alpha_f) (dF/dx + c dF/dv),   c = g / (b dt)
//
// with b, g, alpha of assembly/alpha_scheme.hpp. dF is the central difference of single terms
// (assembly/tangent/fd_tangent.hpp). So it contains every law, branch and load, also new ones; rounding limits its
// accuracy to about 1e-6. Beams have analytic or separate blocks (assembly/tangent/beam_tangent.hpp), which cost less.
// In the plane these are taken on one side of a kink where a fibre or a hinge begins to yield.
//
// In space a rotation is changed by a further rotation about a world axis (from the left). The unknown of a rotation is
// this rotation vector, and m is the block in assembly/implicit_turn.hpp.
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

/// Options of the tangent.
struct TangentOptions {
  double dt = 0;        ///< length of the step that the trial state ends [s]
  double rate = 0;      ///< change of velocity per change of position [1/s]
  double force = 1;     ///< share of the forces in the equation of motion
  double inertia = 0;   ///< coefficient of the mass [1/s2]
  double move = 0;      ///< perturbation of nodes [m]; 0: chosen by the step
  bool bands = true;    ///< include the stiffness of band damping
  bool closes = false;  ///< faces that just meet count as closed and sticking; otherwise their present state counts
};

/// The force [N] or moment [N m] on an unknown at an evaluated state, including weight, loads and all dampings.
template <int D>
double net_force(const Model<D>& model, const State<D>& state, const Work<D>& work, const Freedom& f);

template <int D>
class Tangent {
 public:
  /// Finds the pattern for the pairs in `work`, unless it is known already.
  void shape(const Model<D>& model, const Work<D>& work);
  /// Resets the pattern after a change of the model.
  void forget() { shaped_ = false; }
  [[nodiscard]] const DofGraph<D>& coupling() const { return coupling_; }

  /// Assembles at a trial state at which `work` is evaluated. Both are restored afterwards.
  void assemble(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options);
  /// As above by differences of `evaluate`, many nodes at a time: nodes that act on no common node move together
  /// (Curtis, Powell and Reid 1974). It is used to check the other tangent. `work` is evaluated elsewhere afterwards.
  void assemble_by_differences(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options);
  /// Assembles and factorises the tangent, and stores it in the state. False if it is singular.
  bool find(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options,
            StepTimes* times = nullptr);
  /// Factorises the tangent of the state. False if the state has none for an equal step.
  bool take(const State<D>& state, const TangentOptions& options);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }
  [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

 private:
  void disturbed(const Model<D>& model, State<D>& state, Work<D>& work, const std::vector<int>& nodes, int k,
                 double side, const TangentOptions& options, Eigen::VectorXd& force) const;

  DofGraph<D> coupling_;
  std::vector<std::pair<int, int>> pairs_;  // pairs of the pattern
  bool shaped_ = false;
  void add_beams(const Model<D>& model, const State<D>& state, const TangentOptions& options,
                 const std::vector<double>* trial);
  template <class Block>
  void add_block(const std::array<int, 2>& node, const Block& block);
  bool factorise(const std::shared_ptr<const KeptTangent>& kept);

  Eigen::SparseMatrix<double> matrix_;
  std::shared_ptr<const KeptTangent> ready_;  // the factorised tangent
  SparseFactors factors_;
};

template <>
void Tangent<2>::add_beams(const Model<2>& model, const State<2>& state, const TangentOptions& options,
                           const std::vector<double>* trial);
template <>
void Tangent<3>::add_beams(const Model<3>& model, const State<3>& state, const TangentOptions& options,
                           const std::vector<double>* trial);
template <>
void Tangent<2>::assemble(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options);
template <>
void Tangent<3>::assemble(const Model<3>& model, State<3>& state, Work<3>& work, const TangentOptions& options);

}  // namespace trilith
