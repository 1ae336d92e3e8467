// Implicit steps of a field, of second order and stable for any length.
//
// TR-BDF2: the trapezoidal rule over the share g = 2 - sqrt(2) of the step, then the backward formula of second order.
// Both parts have the same matrix C + (g/2) dt K. A jump of a surrounding decays, as with backward Euler, where
// Crank-Nicolson would oscillate. Bank, Coughran, Fichtner, Grosse, Rose and Smith, "Transient simulation of silicon
// devices and circuits", IEEE Trans. Electron Devices 32, 1985; Hosea and Shampine, Appl. Numer. Math. 20, 1996.
#pragma once

#include <Eigen/SparseCholesky>

#include <memory>
#include <span>
#include <vector>

#include "field/field.hpp"
#include "field/joint_flow.hpp"

namespace trilith {

/// Advances a field, and keeps the factors of its matrix while field, contacts and step remain the same.
class FieldSolver {
 public:
  /// One step of `dt` [s] above 0. `contacts`: links across contacts during the step, merged. A step extends the state
  /// to all cells. Throws InputError if the matrix is not positive definite.
  void advance(const std::shared_ptr<const Field>& field, std::span<const FieldLink> contacts, double dt,
               FieldState& state);
  /// The solver of a field of water in joints.
  [[nodiscard]] FlowSolver& flow() { return flow_; }

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  void prepare(const std::shared_ptr<const Field>& field, std::span<const FieldLink> contacts, double dt);
  [[nodiscard]] Eigen::VectorXd contents(const Eigen::VectorXd& value) const;
  [[nodiscard]] Eigen::VectorXd inflow(const Eigen::VectorXd& value, double clock) const;
  void book(const Eigen::VectorXd& value, const Eigen::VectorXd& flow, double clock, double share,
            FieldState& state) const;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right, double clock) const;
  void hold(Eigen::VectorXd& value, double clock) const;

  std::shared_ptr<const Field> field_;
  std::vector<FieldLink> contacts_;
  double dt_ = 0;
  std::vector<int> unknown_;  // [cell] -1: held
  std::vector<int> held_by_;  // [cell] surrounding, -1: free
  Eigen::SimplicialLDLT<Matrix> factors_;
  FlowSolver flow_;
};

/// Extends a state to all cells and surroundings of a field.
void extend_field(const Field& field, FieldState& state);

/// Heat content of a field relative to 0 degC: the sum of capacity times value [J].
double content_of(const Field& field, const FieldState& state);

}  // namespace trilith
