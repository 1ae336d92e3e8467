#include "statics/static_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "base/error.hpp"
#include "events/commit.hpp"
#include "integrate/implicit/implicit_step.hpp"

namespace trilith {
namespace {

/// Length of a static step, for which rates are negligible [s].
constexpr double slow_step = 1e3;
/// Perturbation of nodes for the tangent, as a share of the penetration of the stiffest one, because joints would open
/// and close otherwise; with its limits [m].
constexpr double share_of_pressed = 1e-2, least_disturbance = 1e-12, most_disturbance = 1e-8;
/// Upper limit as a share of the path of the step: with a larger one, slightly sliding contacts would appear to stick
/// on one side.
constexpr double share_of_way = 0.1;

template <int D>
void stop_moving(State<D>& state) {
  std::fill(state.velocity.begin(), state.velocity.end(), Vec<D>::Zero());
  std::fill(state.spin.begin(), state.spin.end(), nothing<Spin<D>>());
  std::fill(state.acceleration.begin(), state.acceleration.end(), Vec<D>::Zero());
  std::fill(state.spin_rate.begin(), state.spin_rate.end(), nothing<Spin<D>>());
}

/// Length that relates moments to forces; 1 m for a node without size.
template <int D>
double lever_of(const Model<D>& model, int n) {
  const double radius = gyration_of(model, n);
  return radius > 0 ? radius : 1;
}

/// Size of the body of each node [m].
template <int D>
std::vector<double> reaches(const Model<D>& model) {
  std::vector<double> out(model.mass.size(), 0.0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (int i = 0; i < model.bodies[b].nodes; ++i) out[model.bodies[b].first_node + i] = model.body_radius[b];
  return out;
}

/// Inertia force of a node after the displacement `way` [N], [N m].
Dofs<2> held_by_mass(const Model<2>& model, const State<2>& state, int n, double inertia, const Dofs<2>& way) {
  const Dofs<2> mass = mass_of(model, state, n);
  return {mass[0] * (inertia * way[0]), mass[1] * (inertia * way[1]), mass[2] * (inertia * way[2])};
}
Dofs<3> held_by_mass(const Model<3>& model, const State<3>& state, int n, double inertia, const Dofs<3>& way) {
  return dofs_of(Vec3(model.mass[n] * inertia * along_of(way)),
                 Vec3(inertia * momentum_of(model.inertia[n], state.rotation[n], about_of(way))));
}

/// Magnitude that determines the rounding of a rotation [rad].
double size_of_turn(double rotation) {
  return std::abs(rotation);
}
double size_of_turn(const UnitQuaternion& /*rotation*/) {
  return 1;
}

}  // namespace

template <int D>
StaticTrial<D>::StaticTrial(const Model<D>& model, const State<D>& state)
    : model_(model),
      state_(state),
      was_implicit_(state.implicit()),
      reach_(reaches(model)),
      disturbance_(most_disturbance) {
  if (!model.pushes.empty())
    throw InputError("statics: push '" + model.pushes.front().name +
                     "' controls a displacement in time; release it, or follow the path of its load instead");
  // The state of a simulation has been advanced and not committed. It is committed first, under the scheme that took
  // the step. Then velocities are brought to the instant, so that statics conserves the present energy balance.
  evaluate(model_, state_, work_, state_.last_dt);
  commit(model_, state_, work_);
  events_ = work_.events;
  begin_explicit(model_, state_, work_);
  begin_implicit(model_, state_, work_);
  evaluate(model_, state_, work_, 0);  // commit has swapped the memories that determine the stored energy
  balance_ = implicit_energy(model_, state_, work_).balance();
  stop_moving(state_);
  // Laws use `position_before` and `last_dt` for mean rates: the path of the step over 1000 s.
  state_.last_dt = slow_step;
  begin_here();
}

/// The forces at the start are stored: work is booked by the mean of them and the forces at the end.
template <int D>
void StaticTrial<D>::begin_here() {
  state_.position_before = begin_position_ = state_.position;
  state_.rotation_before = begin_rotation_ = state_.rotation;
  hold_here();
  evaluate_here();
  begin_force_ = all_forces();
}

template <int D>
std::vector<NodeForces<D>> StaticTrial<D>::all_forces() const {
  const Outside outside(model_, state_, work_);
  std::vector<NodeForces<D>> out;
  out.reserve(model_.mass.size());
  for (int n = 0; n < model_.nodes(); ++n) out.push_back(node_forces(model_, state_, work_, n, {}, outside, {}));
  return out;
}

template <int D>
void StaticTrial<D>::evaluate_here() {
  evaluate(model_, state_, work_, slow_step);
  tangent_.shape(model_, work_);
  if (rounding_.size() != coupling().size()) rounding_ = Eigen::VectorXd::Zero(coupling().size());
}

/// The largest force that a node carries: of contacts and elements, or weight and loads; including moments of beams and
/// loads [N].
template <int D>
double StaticTrial<D>::carried() const {
  double most = work_.carried;
  for (const auto* moments : {&work_.element_moment, &work_.load_moment})
    for (std::size_t n = 0; n < moments->size(); ++n)
      for (int k = Space<D>::translations; k < Space<D>::dofs; ++k)
        if (model_.support[n][k] == Support::free)
          most = std::max(most, std::abs(dofs_of(Vec<D>(Vec<D>::Zero()), (*moments)[n])[k]) /
                                    lever_of(model_, static_cast<int>(n)));
  return most;
}

template <int D>
double StaticTrial<D>::mass_at(int unknown) const {
  const auto [n, k] = coupling().freedom[unknown];
  return mass_of(model_, state_, n)[k];
}

template <int D>
Dofs<D> StaticTrial<D>::way_of(int node) const {
  return dofs_of(Vec<D>(state_.position[node] - begin_position_[node]),
                 turn_between(begin_rotation_[node], state_.rotation[node]));
}

template <int D>
Dofs<D> StaticTrial<D>::held_way_of(int node) const {
  return dofs_of(Vec<D>(state_.position[node] - held_position_[node]),
                 turn_between(held_rotation_[node], state_.rotation[node]));
}

template <int D>
Eigen::VectorXd StaticTrial<D>::way_from_held() const {
  Eigen::VectorXd out(coupling().size());
  Dofs<D> of{};
  for (int i = 0, node = -1; i < coupling().size(); ++i) {
    const auto [n, k] = coupling().freedom[i];
    if (n != node) of = held_way_of(n), node = n;
    out[i] = of[k];
  }
  return out;
}

template <int D>
Eigen::VectorXd StaticTrial<D>::way() const {
  Eigen::VectorXd out(coupling().size());
  Dofs<D> of{};
  for (int i = 0, node = -1; i < coupling().size(); ++i) {
    const auto [n, k] = coupling().freedom[i];
    if (n != node) of = way_of(n), node = n;
    out[i] = of[k];
  }
  return out;
}

template <int D>
Eigen::VectorXd StaticTrial<D>::way_from(const State<D>& from) const {
  Eigen::VectorXd out(coupling().size());
  Dofs<D> of{};
  for (int i = 0, node = -1; i < coupling().size(); ++i) {
    const auto [n, k] = coupling().freedom[i];
    if (n != node)
      of = dofs_of(Vec<D>(state_.position[n] - from.position[n]), turn_between(from.rotation[n], state_.rotation[n]));
    node = n, out[i] = of[k];
  }
  return out;
}

/// left = F - inertia M d. Returns the sum of left^2 / m, by which iterations are judged; `share_` ends them. In space
/// M d of a rotation is the present tensor of inertia times the rotation vector.
template <int D>
double StaticTrial<D>::measure(double inertia) {
  // `inertia` is 1/h^2 in a step of pseudo-time and 0 on a path.
  left_ = Eigen::VectorXd::Zero(coupling().size());
  double sum = 0, most = 0;
  worst_ = -1;
  Dofs<D> masses{}, held{};
  for (int i = 0, node = -1; i < coupling().size(); ++i) {
    const Freedom f = coupling().freedom[i];
    if (f.node != node) {
      node = f.node, masses = mass_of(model_, state_, node);
      held = inertia > 0 ? held_by_mass(model_, state_, node, inertia, held_way_of(node)) : Dofs<D>{};
    }
    const double mass = masses[f.k];
    left_[i] = net_force(model_, state_, work_, f) - held[f.k];
    sum += left_[i] * left_[i] / mass;
    const double left = (std::abs(left_[i]) - rounding_[i]) / (is_turn<D>(f) ? lever_of(model_, f.node) : 1);
    if (left > most) most = left, worst_ = f.node;
  }
  const double size = std::max(least_carried_, carried());
  share_ = !std::isfinite(sum) ? std::numeric_limits<double>::infinity() : size > 0 ? most / size : most > 0 ? 1 : 0;
  return sum;
}

/// The largest displacement of a node within the step [m].
template <int D>
double StaticTrial<D>::farthest() const {
  double most = 0;
  for (std::size_t n = 0; n < begin_position_.size(); ++n)
    most = std::max(most, (state_.position[n] - begin_position_[n]).norm());
  return most;
}

/// The tangent, and derived quantities.
template <int D>
bool StaticTrial<D>::find_tangent(double inertia, bool closes) {
  const double gone = farthest();
  const double move = gone > 0 ? std::clamp(share_of_way * gone, least_disturbance, disturbance_) : disturbance_;
  const bool regular = tangent_.find(model_, state_, work_, {slow_step, 0, 1, inertia, move, true, closes});
  if (rounding_.size() != coupling().size()) rounding_ = Eigen::VectorXd::Zero(coupling().size());
  find_rounding();
  find_stiffest(inertia);
  return regular;
}

template <int D>
void StaticTrial<D>::find_stiffest(double inertia) {
  double stiffest = 0;
  highest_square_ = 0;
  for (int i = 0; i < coupling().size(); ++i) {
    const double mass = mass_at(i), stiffness = tangent_.matrix().coeff(i, i) - inertia * mass;
    // The diagonal minus its inertia: K_ii / m_i.
    highest_square_ = std::max(highest_square_, stiffness / mass);
    if (!is_turn<D>(coupling().freedom[i])) stiffest = std::max(stiffest, stiffness);
  }
  if (stiffest > 0 && work_.carried > 0)
    disturbance_ = std::clamp(share_of_pressed * work_.carried / stiffest, least_disturbance, most_disturbance);
}

/// Rounding error of the forces due to the last digit of the positions, below which no iteration converges. A skin
/// point has the digits of its distance from the origin.
template <int D>
void StaticTrial<D>::find_rounding() {
  constexpr double digit = std::numeric_limits<double>::epsilon();
  rounding_ = Eigen::VectorXd::Zero(coupling().size());
  for (int column = 0; column < coupling().size(); ++column) {
    const auto [n, k] = coupling().freedom[column];
    const double size =
        is_turn<D>({n, k}) ? size_of_turn(state_.rotation[n]) : state_.position[n].cwiseAbs().sum() + reach_[n];
    for (Eigen::SparseMatrix<double>::InnerIterator at(tangent_.matrix(), column); at; ++at)
      rounding_[at.row()] += digit * size * std::abs(at.value());
  }
}

template <int D>
void StaticTrial<D>::move(const Eigen::VectorXd& by, double share) {
  for (int n = 0; n < model_.nodes(); ++n) {
    Dofs<D> way{};
    bool turns = false;
    for (int k = 0; k < Space<D>::dofs; ++k) {
      const int i = coupling().unknown[n][k];
      if (i < 0) continue;
      way[k] = share * by[i];
      if (is_turn<D>({n, k}))
        turns = true;
      else
        state_.position[n][k] += way[k];
    }
    if (turns) state_.rotation[n] = turned_by(about_of(way), state_.rotation[n]);
  }
}

template <int D>
void StaticTrial<D>::go_back() {
  state_.position = begin_position_, state_.rotation = begin_rotation_;
  hold_here();
  evaluate_here();
}

template <int D>
void StaticTrial<D>::go_to_held() {
  state_.position = held_position_, state_.rotation = held_rotation_;
  evaluate_here();
}

/// Work F (x' - x) with the mean of F at both ends; `finish` books the remaining difference of the balance.
template <int D>
void StaticTrial<D>::accept() {
  const std::vector<NodeForces<D>> force = all_forces();
  commit(model_, state_, work_);
  for (int n = 0; n < model_.nodes(); ++n) {
    Dofs<D> path = way_of(n);
    for (double& p : path) p *= 0.5;
    add_work(begin_force_[n], path, state_.given);
    add_work(force[n], path, state_.given);
  }
  events_.insert(events_.end(), work_.events.begin(), work_.events.end());
  begin_here();
}

template <int D>
void StaticTrial<D>::return_to(Begin begin) {
  state_ = std::move(begin.state);
  events_.resize(begin.events);
  work_.valid = false;
  begin_here();
}

/// Energy that statics cannot assign is booked as `rest_damping`: the omitted motion to rest.
template <int D>
State<D> StaticTrial<D>::finish() {
  go_back();
  state_.given[EnergyTerm::rest_damping] += balance_ - implicit_energy(model_, state_, work_).balance();
  state_.last_dt = 0;
  state_.tangent.reset();
  if (!was_implicit_) begin_explicit(model_, state_, work_);
  state_.dt = state_.safety = 0;
  return std::move(state_);
}

template class StaticTrial<2>;
template class StaticTrial<3>;

}  // namespace trilith
