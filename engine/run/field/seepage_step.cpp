#include "run/field/seepage_step.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "assembly/field/joint_water.hpp"
#include "events/body_events.hpp"
#include "field/field_step.hpp"
#include "model/field/seepage.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

constexpr int most_couplings = 200, most_cuts = 12;
constexpr std::size_t kept_couplings = 12;
/// Largest change of a pressure head in the last iteration, as a share of the
/// largest one, and in [m].
constexpr double coupled_share = 1e-7, coupled_head = 1e-9;

/// Anderson's acceleration of x = g(x).
class Anderson {
 public:
  /// The next x after g(x) was found.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
    const Eigen::VectorXd left = g - x;
    if (!g_.empty()) {
      steps_.push_back(g - g_.back()), changes_.push_back(left - left_.back());
      if (steps_.size() > kept_couplings) steps_.pop_front(), changes_.pop_front();
    }
    g_ = {g}, left_ = {left};
    if (steps_.empty()) return g;
    Eigen::MatrixXd a(x.size(), static_cast<Eigen::Index>(steps_.size()));
    for (std::size_t i = 0; i < steps_.size(); ++i) a.col(static_cast<Eigen::Index>(i)) = changes_[i];
    const Eigen::VectorXd share = a.colPivHouseholderQr().solve(left);
    Eigen::VectorXd out = g;
    for (std::size_t i = 0; i < steps_.size(); ++i) out -= share[static_cast<Eigen::Index>(i)] * steps_[i];
    return out;
  }

 private:
  std::vector<Eigen::VectorXd> g_, left_;
  std::deque<Eigen::VectorXd> steps_, changes_;
};

double fill_of(const Field& field, const FieldState* state, const FlowJoint& j, int i) {
  const auto at = static_cast<std::size_t>(field.flow->cells() + j.first_cell + i);
  const double volume = state != nullptr && at < state->value.size() ? state->value[at] : field.start[at];
  return volume / (j.width * j.cell_length() * j.aperture_at((i + 0.5) / j.cells));
}

}  // namespace

template <int D>
Equilibrium seepage_step(const SeepageStep<D>& step, FlowSolver& solver, State<D>& state) {
  Equilibrium found;
  found.converged = true, found.end = EquilibriumEnd::rests;
  const JointFlow& flow = *step.field.flow;
  const auto row = static_cast<std::size_t>(row_of(step.model.fields, FieldKind::seepage));
  extend_field(step.field, state.fields[row]);
  const FieldState before = state.fields[row];
  const std::vector<double> heads = seepage_heads(step.field, step.model, before.clock + step.dt, state.time);
  const bool coupled = step.mechanics && flow.has_bodies();
  if (!coupled) {
    const Apertures apertures = joint_apertures(flow, before, step.model, state);
    solver.advance(flow, apertures, heads, {}, step.dt, before, state.fields[row]);
    return step.mechanics ? find_equilibrium(step.model, state, step.how) : found;
  }
  const State<D> begun = state;
  const auto cells = static_cast<Eigen::Index>(flow.cells());
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(before.value.data(), cells);
  Anderson anderson;
  std::optional<Eigen::VectorXd> carried;  // the last pressures under which the bodies were in equilibrium
  for (int i = 0; i < most_couplings; ++i) {
    // Water in excess of the load lifts a plate for ever, because its pressure
    // is held here.
    for (int cut = 0;; ++cut) {
      state = begun;
      Eigen::Map<Eigen::VectorXd>(state.fields[row].value.data(), cells) = x;
      found = find_equilibrium(step.model, state, step.how);
      if (found.converged || !carried || cut == most_cuts) break;
      x = 0.5 * (x + *carried);
    }
    if (!found.converged) return found;
    carried = x;
    // Fissures keep the aperture of their pressure before the step.
    const Apertures apertures = joint_apertures(flow, before, step.model, state);
    FieldState after;
    solver.advance(flow, apertures, heads, {x.data(), static_cast<std::size_t>(cells)}, step.dt, before, after);
    const Eigen::VectorXd g = Eigen::Map<const Eigen::VectorXd>(after.value.data(), cells);
    state.fields[row] = after;
    if ((g - x).cwiseAbs().maxCoeff() <= coupled_share * g.maxCoeff() + coupled_head) return found;
    x = anderson.next(x, g).cwiseMax(0.0);
  }
  found.converged = false, found.end = EquilibriumEnd::unsettled;
  return found;
}

template <int D>
void flow_after_step(const Model<D>& model, double dt, FlowSolver& solver, State<D>& state,
                     std::vector<Event>& events) {
  const auto row = static_cast<std::size_t>(row_of(model.fields, FieldKind::seepage));
  const Field& field = *model.fields[row];
  state.fields.resize(model.fields.size());
  extend_field(field, state.fields[row]);
  const std::vector<bool> flooded = flooded_joints(model, state);
  const FieldState before = state.fields[row];
  const std::vector<double> heads = seepage_heads(field, model, before.clock + dt, state.time);
  const Apertures apertures = joint_apertures(*field.flow, before, model, state);
  solver.advance(*field.flow, apertures, heads, {}, dt, before, state.fields[row]);
  add_flow_events(model, state, flooded, events);
}

template <int D>
std::vector<bool> flooded_joints(const Model<D>& model, const State<D>& state) {
  std::vector<bool> out;
  const int row = row_of(model.fields, FieldKind::seepage);
  if (row < 0) return out;
  const auto at = static_cast<std::size_t>(row);
  const Field& field = *model.fields[at];
  const FieldState* values = at < state.fields.size() ? &state.fields[at] : nullptr;
  for (const FlowJoint& j : field.flow->joints) {
    bool full = true;
    for (int i = 0; i < j.cells; ++i) full = full && fill_of(field, values, j, i) > 0.5;
    out.push_back(full);
  }
  return out;
}

template <int D>
void add_flow_events(const Model<D>& model, const State<D>& state, const std::vector<bool>& before,
                     std::vector<Event>& events) {
  const std::vector<bool> after = flooded_joints(model, state);
  if (after == before) return;
  const Field& field = *field_of(model.fields, FieldKind::seepage);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const FlowJoint& j = field.flow->joints[i];
    if (before[i] == after[i] || !j.has_bodies()) continue;
    Event e = event_now(state, after[i] ? EventType::joint_flooded : EventType::joint_drained, j.upper.front().body,
                        j.lower.front().body);
    e.value = after[i] ? j.length : 0;
    e.text = j.name;
    if constexpr (D == 2)
      e.set_place(pose_at(model, state, j.toe).place);
    else
      e.set_place(ends_in_space(j, model, state)[1]);
    events.push_back(std::move(e));
  }
}

#define TRILITH_SEEPAGE_STEP(D)                                                                        \
  template Equilibrium seepage_step(const SeepageStep<D>&, FlowSolver&, State<D>&);                    \
  template void flow_after_step(const Model<D>&, double, FlowSolver&, State<D>&, std::vector<Event>&); \
  template std::vector<bool> flooded_joints(const Model<D>&, const State<D>&);                         \
  template void add_flow_events(const Model<D>&, const State<D>&, const std::vector<bool>&, std::vector<Event>&);
TRILITH_SEEPAGE_STEP(2)
TRILITH_SEEPAGE_STEP(3)
#undef TRILITH_SEEPAGE_STEP

}  // namespace trilith
