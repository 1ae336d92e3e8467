#include "statics/push_compliance.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/node_forces.hpp"
#include "statics/static_trial.hpp"

namespace trilith {
namespace {

/// Share of the stiffest frequency squared that keeps the tangent regular with free parts.
constexpr double held_by_little = 1e-13;

/// Adds a unit of the push's force on a node, and its moment about the node that rotates with it.
template <int D>
void add_row(const State<D>& state, const Push<D>& push, const PushRow<D>& row, const DofGraph<D>& coupling,
             Eigen::VectorXd& loads) {
  const Vec<D> force = row.weight * push.direction;
  const Vec<D> arm = turn_of(state.rotation[row.turn]).apply(row.place);
  const Dofs<D> along = dofs_of(force, nothing<Moment<D>>()),
                about = dofs_of(Vec<D>(Vec<D>::Zero()), Moment<D>(cross(arm, force)));
  for (int k = 0; k < Space<D>::dofs; ++k) {
    if (const int i = coupling.unknown[row.node][k]; i >= 0) loads[i] += along[k];
    if (const int i = coupling.unknown[row.turn][k]; i >= 0) loads[i] += about[k];
  }
}

}  // namespace

template <int D>
double push_compliance(const Model<D>& model, const State<D>& state, const Push<D>& push) {
  StaticTrial<D> trial(model, state);
  trial.find_tangent(1);  // determines the largest stiffness
  if (!trial.find_tangent(held_by_little * trial.highest_square())) return 0;
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(trial.coupling().size());
  for (const PushRow<D>& row : push.rows) add_row(trial.state(), push, row, trial.coupling(), loads);
  const double moved = loads.dot(trial.solve(loads));
  return std::isfinite(moved) && moved > 0 ? moved : 0;
}

template <int D>
double unsupported_force(const Model<D>& model, const Work<D>& work, const std::type_identity_t<Vec<D>>& direction) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n)
    for (int k = 0; k < Space<D>::translations; ++k)
      if (model.support[n][k] == Support::free) sum += direction[k] * work.force[n][k];
  return sum;
}

template <int D>
double force_on_supports(const Model<D>& model, const State<D>& state, const Work<D>& work,
                         const std::type_identity_t<Vec<D>>& direction) {
  const Outside<D> outside(model, state, work);
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    double pressed = 0;
    for (int k = 0; k < Space<D>::translations; ++k)
      if (model.support[n][k] != Support::free)
        pressed += direction[k] * (work.force[n][k] - model.mass[n] * outside.field[k] - outside.load[n][k]);
    sum += std::max(0.0, pressed);
  }
  return sum;
}

template <int D>
double unbalanced_power(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n) {
    const Dofs<D> force = dofs_of(work.force[n], work.moment[n]), speed = velocity_of(state, n);
    for (int k = 0; k < Space<D>::dofs; ++k)
      if (model.support[n][k] == Support::free) sum += force[k] * speed[k];
  }
  return sum;
}

template double unbalanced_power(const Model<2>&, const State<2>&, const Work<2>&);
template double unbalanced_power(const Model<3>&, const State<3>&, const Work<3>&);
template double push_compliance(const Model<2>&, const State<2>&, const Push<2>&);
template double push_compliance(const Model<3>&, const State<3>&, const Push<3>&);
template double force_on_supports(const Model<2>&, const State<2>&, const Work<2>&, const Vec<2>&);
template double force_on_supports(const Model<3>&, const State<3>&, const Work<3>&, const Vec<3>&);
template double unsupported_force(const Model<2>&, const Work<2>&, const Vec<2>&);
template double unsupported_force(const Model<3>&, const Work<3>&, const Vec<3>&);

}  // namespace trilith
