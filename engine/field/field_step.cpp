#include "field/field_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

const double first_share = 2 - std::sqrt(2.0);  // g: of the trapezoidal rule in a step

}  // namespace

void extend_field(const Field& field, FieldState& state) {
  for (std::size_t i = state.value.size(); i < field.start.size(); ++i) state.value.push_back(field.start[i]);
  state.supplied.resize(field.surroundings.size(), 0);
}

double content_of(const Field& field, const FieldState& state) {
  double sum = 0;
  for (std::size_t i = 0; i < field.capacity.size(); ++i)
    sum += field.capacity[i] * (i < state.value.size() ? state.value[i] : field.start[i]);
  return sum;
}

void FieldSolver::prepare(const std::shared_ptr<const Field>& field, std::span<const FieldLink> contacts, double dt) {
  if (field == field_ && dt == dt_ && std::ranges::equal(contacts, contacts_)) return;
  field_ = field, dt_ = dt, contacts_.assign(contacts.begin(), contacts.end());
  held_by_.assign(field->capacity.size(), -1), unknown_.assign(field->capacity.size(), -1);
  for (const FieldHeld& h : field->held) held_by_[static_cast<std::size_t>(h.cell)] = h.surrounding;
  int count = 0;
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (held_by_[i] < 0) unknown_[i] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  const double w = 0.5 * first_share * dt;
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (unknown_[i] >= 0) entries.emplace_back(unknown_[i], unknown_[i], field->capacity[i]);
  // `k`: w K_ij - C_ij.
  const auto add = [&](int cell, int other, double k) {
    const int row = unknown_[static_cast<std::size_t>(cell)];
    if (row < 0) return;
    entries.emplace_back(row, row, k);
    if (other >= 0 && unknown_[static_cast<std::size_t>(other)] >= 0)
      entries.emplace_back(row, unknown_[static_cast<std::size_t>(other)], -k);
  };
  for (const std::vector<FieldLink>* links : std::array<const std::vector<FieldLink>*, 2>{&field->links, &contacts_})
    for (const FieldLink& l : *links) {
      const double k = w * l.conductance - l.capacity;
      add(l.a, l.b, k), add(l.b, l.a, k);
    }
  for (const FieldExchange& e : field->exchange) add(e.cell, -1, w * e.conductance);
  Matrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
  if (count > 0 && factors_.info() != Eigen::Success) {
    field_.reset();
    throw InputError("the equations of the heat flow have no solution; check capacities and conductances");
  }
}

/// Sets the cells that have the value of a surrounding.
void FieldSolver::hold(Eigen::VectorXd& value, double clock) const {
  for (std::size_t i = 0; i < held_by_.size(); ++i)
    if (held_by_[i] >= 0)
      value[static_cast<Eigen::Index>(i)] =
          field_->surroundings[static_cast<std::size_t>(held_by_[i])].course.at(clock);
}

/// Heat that flows into each cell from its links and surroundings [W].
Eigen::VectorXd FieldSolver::inflow(const Eigen::VectorXd& value, double clock) const {
  Eigen::VectorXd flow = Eigen::VectorXd::Zero(value.size());
  for (const std::vector<FieldLink>* links : std::array<const std::vector<FieldLink>*, 2>{&field_->links, &contacts_})
    for (const FieldLink& l : *links) {
      const double q = l.conductance * (value[l.b] - value[l.a]);
      flow[l.a] += q, flow[l.b] -= q;
    }
  for (const FieldExchange& e : field_->exchange)
    flow[e.cell] += e.conductance *
                    (field_->surroundings[static_cast<std::size_t>(e.surrounding)].course.at(clock) - value[e.cell]);
  return flow;
}

/// C times the values [J].
Eigen::VectorXd FieldSolver::contents(const Eigen::VectorXd& value) const {
  Eigen::VectorXd out = Eigen::Map<const Eigen::VectorXd>(field_->capacity.data(), value.size()).cwiseProduct(value);
  for (const FieldLink& l : field_->links) {
    const double q = l.capacity * (value[l.b] - value[l.a]);
    out[l.a] += q, out[l.b] -= q;
  }
  return out;
}

/// Solves (C + w K) x = right + w (flow from surroundings at `clock`) in the free cells [J]; the others are held.
Eigen::VectorXd FieldSolver::solve(const Eigen::VectorXd& right, double clock) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
  hold(x, clock);
  const double w = 0.5 * first_share * dt_;
  // With the free cells at 0, the equations have this residual.
  const Eigen::VectorXd left = right + w * inflow(x, clock) - contents(x);
  Eigen::VectorXd b(static_cast<Eigen::Index>(std::ranges::count_if(unknown_, [](int u) { return u >= 0; })));
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (unknown_[i] >= 0) b[unknown_[i]] = left[static_cast<Eigen::Index>(i)];
  const Eigen::VectorXd found = b.size() > 0 ? Eigen::VectorXd(factors_.solve(b)) : b;
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    if (unknown_[i] >= 0) x[static_cast<Eigen::Index>(i)] = found[unknown_[i]];
  return x;
}

/// Adds the heat that surroundings supply by exchange over the share `share` of the step, at the flow of an instant. A
/// held cell supplies the flow out of it (`flow`: into each cell).
void FieldSolver::book(const Eigen::VectorXd& value, const Eigen::VectorXd& flow, double clock, double share,
                       FieldState& state) const {
  for (const FieldExchange& e : field_->exchange) {
    const auto o = static_cast<std::size_t>(e.surrounding);
    state.supplied[o] += share * dt_ * e.conductance * (field_->surroundings[o].course.at(clock) - value[e.cell]);
  }
  for (std::size_t i = 0; i < held_by_.size(); ++i)
    if (held_by_[i] >= 0)
      state.supplied[static_cast<std::size_t>(held_by_[i])] -= share * dt_ * flow[static_cast<Eigen::Index>(i)];
}

/// A held cell that jumps at the start of the step leaves the contents of the free cells as they are: their equations
/// contain the whole change from the values before the jump.
void FieldSolver::advance(const std::shared_ptr<const Field>& field, std::span<const FieldLink> contacts, double dt,
                          FieldState& state) {
  prepare(field, contacts, dt);
  extend_field(*field, state);
  const auto cells = static_cast<Eigen::Index>(state.value.size());
  const Eigen::VectorXd before = Eigen::Map<const Eigen::VectorXd>(state.value.data(), cells);
  const double g = first_share, t0 = state.clock, t1 = t0 + g * dt, t2 = t0 + dt;
  Eigen::VectorXd begun = before;  // after jumps of surroundings
  hold(begun, t0);
  const Eigen::VectorXd flow0 = inflow(begun, t0), content0 = contents(before);
  const Eigen::VectorXd middle = solve(content0 + 0.5 * g * dt * flow0, t1);
  const Eigen::VectorXd flow1 = inflow(middle, t1);
  const double a = 1 / (g * (2 - g));
  const Eigen::VectorXd after = solve(contents(a * middle) - (a - 1) * content0, t2);
  const Eigen::VectorXd flow2 = inflow(after, t2), gained = contents(after) - content0;
  const double outer = 0.5 * a * g, last = 0.5 * g;  // weights of the flows at both ends and in the middle
  book(begun, flow0, t0, outer, state), book(middle, flow1, t1, outer, state), book(after, flow2, t2, last, state);
  for (std::size_t i = 0; i < held_by_.size(); ++i)
    if (held_by_[i] >= 0) state.supplied[static_cast<std::size_t>(held_by_[i])] += gained[static_cast<Eigen::Index>(i)];
  Eigen::Map<Eigen::VectorXd>(state.value.data(), cells) = after;
  state.clock = t2;
}

}  // namespace trilith
