#include "step/static_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "step/commit.hpp"
#include "step/evaluate.hpp"
#include "step/implicit_step.hpp"

namespace trilith {
namespace {

/// Length of a static step: so long that rates are none [s].
constexpr double slow_step = 1e3;
/// Nodes are moved for the tangent by this share of how far the stiffest one is pressed in, or joints would open and
/// close under it; and by so much at least and at most [m].
constexpr double share_of_pressed = 1e-2, least_disturbance = 1e-12, most_disturbance = 1e-8;

void stop_moving(State<2>& state) {
  std::fill(state.velocity.begin(), state.velocity.end(), Vec2::Zero());
  std::fill(state.spin.begin(), state.spin.end(), 0.0);
  std::fill(state.acceleration.begin(), state.acceleration.end(), Vec2::Zero());
  std::fill(state.spin_rate.begin(), state.spin_rate.end(), 0.0);
}

/// By it moments compare with forces; 1 m where a node has no size.
double gyration_of(const Model<2>& model, int n) {
  const double radius = std::sqrt(model.inertia[n] / model.mass[n]);
  return radius > 0 ? radius : 1;
}

/// Size of the body that each node belongs to [m].
std::vector<double> reaches(const Model<2>& model) {
  std::vector<double> out(model.mass.size(), 0.0);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (int i = 0; i < model.bodies[b].nodes; ++i) out[model.bodies[b].first_node + i] = model.body_radius[b];
  return out;
}

}  // namespace

StaticTrial::StaticTrial(const Model<2>& model, const State<2>& state)
    : model_(model),
      state_(state),
      was_implicit_(state.implicit()),
      reach_(reaches(model)),
      disturbance_(most_disturbance) {
  if (!model.pushes.empty())
    throw InputError("statics: push '" + model.pushes.front().name +
                     "' controls a displacement in time; release it, or follow the path of its load instead");
  // Simulation holds a state that has been advanced and not committed: that is done first, under the scheme that took
  // the step, then velocities are brought to the instant, so that the balance of now is what statics has to keep.
  evaluate(model_, state_, work_, state_.last_dt);
  commit(model_, state_, work_);
  events_ = work_.events;
  begin_explicit(model_, state_, work_);
  begin_implicit(model_, state_, work_);
  evaluate(model_, state_, work_, 0);  // commit has taken the memories along that tell what is stored
  balance_ = implicit_energy(model_, state_, work_).balance();
  stop_moving(state_);
  // Laws take `position_before` and `last_dt` for mean rates: the way of the step over 1000 s.
  state_.last_dt = slow_step;
  begin_here();
}

/// Forces at the begin are kept: work is booked by the mean of them and those at the end.
void StaticTrial::begin_here() {
  state_.position_before = begin_position_ = state_.position;
  state_.rotation_before = begin_rotation_ = state_.rotation;
  evaluate_here();
  begin_force_ = all_forces();
}

std::vector<NodeForces<2>> StaticTrial::all_forces() const {
  const Outside outside(model_, state_, work_);
  std::vector<NodeForces<2>> out;
  out.reserve(model_.mass.size());
  for (int n = 0; n < model_.nodes(); ++n) out.push_back(node_forces(model_, state_, work_, n, {}, outside, {}));
  return out;
}

void StaticTrial::evaluate_here() {
  evaluate(model_, state_, work_, slow_step);
  tangent_.shape(model_, work_);
  if (rounding_.size() != coupling().size()) rounding_ = Eigen::VectorXd::Zero(coupling().size());
}

/// The largest force that a node takes up: of contacts and elements, or weight and loads; moments of beams and loads
/// too [N].
double StaticTrial::carried() const {
  double most = work_.carried;
  for (const auto* moments : {&work_.element_moment, &work_.load_moment})
    for (std::size_t n = 0; n < moments->size(); ++n)
      if (model_.support[n][2] == Support::free)
        most = std::max(most, std::abs((*moments)[n]) / gyration_of(model_, static_cast<int>(n)));
  return most;
}

double StaticTrial::mass_at(int unknown) const {
  const auto [n, k] = coupling().freedom[unknown];
  return mass_of(model_, n)[k];
}

Eigen::VectorXd StaticTrial::way() const {
  Eigen::VectorXd out(coupling().size());
  for (int i = 0; i < coupling().size(); ++i) {
    const auto [n, k] = coupling().freedom[i];
    out[i] = k == 2 ? state_.rotation[n] - begin_rotation_[n] : state_.position[n][k] - begin_position_[n][k];
  }
  return out;
}

/// left = F - inertia M d; its square, sum of left^2 / m, is what iterations are judged by; `share_` what ends them.
double StaticTrial::measure(double inertia) {
  // `inertia` is 1/h^2 in a step of pseudo-time and 0 on a path.
  left_ = inertia > 0 ? Eigen::VectorXd(-inertia * way()) : Eigen::VectorXd(Eigen::VectorXd::Zero(coupling().size()));
  double sum = 0, most = 0;
  worst_ = -1;
  for (int i = 0; i < coupling().size(); ++i) {
    const Freedom f = coupling().freedom[i];
    const double mass = mass_of(model_, f.node)[f.k];
    left_[i] = net_force(model_, state_, work_, f) + mass * left_[i];
    sum += left_[i] * left_[i] / mass;
    const double left = (std::abs(left_[i]) - rounding_[i]) / (f.k == 2 ? gyration_of(model_, f.node) : 1);
    if (left > most) most = left, worst_ = f.node;
  }
  const double size = std::max(least_carried_, carried());
  share_ = !std::isfinite(sum) ? std::numeric_limits<double>::infinity() : size > 0 ? most / size : most > 0 ? 1 : 0;
  return sum;
}

/// And what follows from it.
bool StaticTrial::find_tangent(double inertia, bool closes) {
  const bool regular = tangent_.find(model_, state_, work_, {slow_step, 0, 1, inertia, disturbance_, true, closes});
  if (rounding_.size() != coupling().size()) rounding_ = Eigen::VectorXd::Zero(coupling().size());
  find_rounding();
  find_stiffest(inertia);
  return regular;
}

void StaticTrial::find_stiffest(double inertia) {
  double stiffest = 0;
  highest_square_ = 0;
  for (int i = 0; i < coupling().size(); ++i) {
    const double mass = mass_at(i), stiffness = tangent_.matrix().coeff(i, i) - inertia * mass;
    // The diagonal less its inertia: K_ii / m_i.
    highest_square_ = std::max(highest_square_, stiffness / mass);
    if (coupling().freedom[i].k < 2) stiffest = std::max(stiffest, stiffness);
  }
  if (stiffest > 0 && work_.carried > 0)
    disturbance_ = std::clamp(share_of_pressed * work_.carried / stiffest, least_disturbance, most_disturbance);
}

/// What the last digit of every place makes of the forces: no iteration gets below it. A skin point has the digits of
/// its distance from the origin.
void StaticTrial::find_rounding() {
  constexpr double digit = std::numeric_limits<double>::epsilon();
  rounding_ = Eigen::VectorXd::Zero(coupling().size());
  for (int column = 0; column < coupling().size(); ++column) {
    const auto [n, k] = coupling().freedom[column];
    const Vec2& x = state_.position[n];
    const double size = k == 2 ? std::abs(state_.rotation[n]) : std::abs(x.x()) + std::abs(x.y()) + reach_[n];
    for (Eigen::SparseMatrix<double>::InnerIterator at(tangent_.matrix(), column); at; ++at)
      rounding_[at.row()] += digit * size * std::abs(at.value());
  }
}

void StaticTrial::move(const Eigen::VectorXd& by, double share) {
  for (int i = 0; i < coupling().size(); ++i) {
    const auto [n, k] = coupling().freedom[i];
    (k == 2 ? state_.rotation[n] : state_.position[n][k]) += share * by[i];
  }
}

void StaticTrial::go_back() {
  state_.position = begin_position_, state_.rotation = begin_rotation_;
  evaluate_here();
}

/// F (x' - x) with the mean of F at both ends, as half the way with either; `finish` books what the balance then lacks.
void StaticTrial::accept() {
  const std::vector<NodeForces<2>> force = all_forces();
  commit(model_, state_, work_);
  for (int n = 0; n < model_.nodes(); ++n) {
    const Vec2 half = 0.5 * (state_.position[n] - begin_position_[n]);
    const Dofs<2> path{half.x(), half.y(), 0.5 * (state_.rotation[n] - begin_rotation_[n])};
    add_work(begin_force_[n], path, state_.given);
    add_work(force[n], path, state_.given);
  }
  events_.insert(events_.end(), work_.events.begin(), work_.events.end());
  begin_here();
}

/// What statics cannot say where it went is `rest_damping`: the motion to rest that was left out.
State<2> StaticTrial::finish() {
  go_back();
  state_.given[EnergyTerm::rest_damping] += balance_ - implicit_energy(model_, state_, work_).balance();
  state_.last_dt = 0;
  state_.tangent.reset();
  if (!was_implicit_) begin_explicit(model_, state_, work_);
  state_.dt = state_.safety = 0;
  return std::move(state_);
}

}  // namespace trilith
