#include "statics/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "model/loads.hpp"
#include "statics/line_search.hpp"
#include "statics/static_trial.hpp"

namespace trilith {
namespace {

constexpr int most_shares = 1000;
/// Largest displacement of a body within a step as a share of its size, for a rigid body, whose contacts are then found
/// when they form, and for a deformable one.
constexpr double most_of_rigid = 0.1, most_of_soft = 0.5;
/// Largest rotation within a step, for a rigid and a deformable body [rad].
constexpr double most_turn = 0.3, most_turn_of_soft = 1;
/// Growth of the pseudo-time step: after a step with at most this number of iterations, and otherwise.
constexpr int easy_for_pseudo = 6;
constexpr double growth_if_easy = 10, growth_of_pseudo = 2;
/// Reduced growth for this number of steps after a step that was cut.
constexpr int wary_steps = 3;
constexpr double wary_growth = 1.5;
/// See Search::shorter [rad of the stiffest unknown].
constexpr double first_periods = 3;
/// Iterations stop if the residual is not halved within this number.
constexpr int patience = 5;
/// Factor of a failed step.
constexpr double cut_share = 0.2;
/// Below this pseudo-time results are dominated by rounding [s].
constexpr double shortest_pseudo = 1e-7;
/// A step ends at this share of its initial residual: the next step is as good as a further iteration.
constexpr double enough_of_step = 1e-2;
/// The tangent is updated after an iteration that leaves more than this share.
constexpr double slow_iteration = 0.5;

template <int D>
void scale_all(const Model<D>& whole, double share, Model<D>& model) {
  model.gravity.field = share * whole.gravity.field;
  for (std::size_t n = 0; n < whole.load.size(); ++n) model.load[n] = share * whole.load[n];
  model.loads = whole.loads;
  scale_loads(model, "", share);
}

/// One search for equilibrium.
template <int D>
class Search {
 public:
  Search(const Model<D>& model, const State<D>& state, const EquilibriumOptions& options)
      : model_(model),
        options_(options),
        trial_(model, state),
        given_(placement_of(state)),
        begin_(state.position),
        body_of_(model.mass.size(), 0) {
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      for (int i = 0; i < model.bodies[b].nodes; ++i) body_of_[model.bodies[b].first_node + i] = static_cast<int>(b);
  }

  /// Finds equilibrium under the present loads of the model.
  bool settle(Equilibrium& out);
  StaticTrial<D>& trial() { return trial_; }

 private:
  bool step(double h, double from, Equilibrium& out);
  bool improve(const Eigen::VectorXd& full, double inertia, double enough);
  double shorter(double h);
  double growth(int iterations);
  [[nodiscard]] bool too_long() const;
  [[nodiscard]] bool stopped() const { return options_.is_stopped && options_.is_stopped(); }
  [[nodiscard]] int gone() const;
  bool leaves(Equilibrium& out) const;

  const Model<D>& model_;
  const EquilibriumOptions& options_;
  StaticTrial<D> trial_;
  Placement<D> given_;         // at the start of the search
  std::vector<Vec<D>> begin_;  // [node] at the start of the present load share
  std::vector<int> body_of_;
  double merit_ = 0;
  bool has_failed_ = false;
  int since_cut_ = wary_steps;  // steps after the last cut one
};

/// True if some body has moved further within the step than its contacts permit.
template <int D>
bool Search<D>::too_long() const {
  const Eigen::VectorXd way = trial_.way();
  for (int i = 0; i < trial_.coupling().size(); ++i) {
    const auto [n, k] = trial_.coupling().freedom[i];
    const int b = body_of_[n];
    const bool rigid = model_.bodies[b].is_rigid();
    const double most = is_turn<D>({n, k}) ? (rigid ? most_turn : most_turn_of_soft)
                                           : (rigid ? most_of_rigid : most_of_soft) * model_.body_radius[b];
    if (!(std::abs(way[i]) <= most)) return true;
  }
  return false;
}

/// The node with the largest displacement beyond its limit, or -1.
template <int D>
int Search<D>::gone() const {
  int worst = -1;
  double most = options_.farthest;
  for (int n = 0; n < model_.nodes(); ++n) {
    const double way = (trial_.state().position[n] - begin_[n]).norm() / model_.body_radius[body_of_[n]];
    if (way > most) most = way, worst = n;
  }
  return worst;
}

/// True if a body has left its place, or moves away.
template <int D>
bool Search<D>::leaves(Equilibrium& out) const {
  out.travel = displaced_body(model_, trial_.state(), given_, options_.within);
  if (out.travel.body >= 0) {
    out.end = EquilibriumEnd::unstable, out.worst = model_.bodies[out.travel.body].first_node;
    return true;
  }
  const int n = gone();
  if (n >= 0) out.end = EquilibriumEnd::goes_off, out.worst = n;
  return n >= 0;
}

/// Line search along `full`, see statics/line_search.hpp.
template <int D>
bool Search<D>::improve(const Eigen::VectorXd& full, double inertia, double enough) {
  const auto move = [&](double share) {
    trial_.move(full, share);
    trial_.evaluate_here();
  };
  return search_along(trial_, full, inertia, enough, merit_, move);
}

/// A step of pseudo-time h [s]: M d / h^2 = F at its end, with the displacement d. `from`: initial residual as a share.
/// True if it has converged; then it is committed.
template <int D>
bool Search<D>::step(double h, double from, Equilibrium& out) {
  const double inertia = 1 / (h * h), enough = std::max(0.5 * options_.tolerance, enough_of_step * from);
  merit_ = trial_.measure(inertia);
  bool stale = true;
  double least = merit_;
  int since = 0;  // iterations after the last sufficient decrease
  for (int i = 0;
       i < options_.most_iterations && std::isfinite(merit_) && since <= patience && !too_long() && !stopped(); ++i) {
    if (i > 0 && trial_.share() <= enough) {
      trial_.accept();
      return true;
    }
    ++out.iterations;
    const double before = merit_;
    if (stale && !trial_.find_tangent(inertia, i == 0)) break;
    if (!improve(trial_.solve(trial_.left()), inertia, enough)) break;
    stale = merit_ > slow_iteration * slow_iteration * before;
    since = merit_ < 0.25 * least ? 0 : since + 1;
    least = since == 0 ? merit_ : least;
  }
  trial_.go_back();
  return false;
}

/// The step after a failed one of length h. After the first failure the stiffest contact has just enough time to take
/// up its load. So bodies that are not yet pressed together are held by friction.
template <int D>
double Search<D>::shorter(double h) {
  since_cut_ = 0;
  const double square = trial_.highest_square();
  if (std::exchange(has_failed_, true) || !(square > 0)) return cut_share * h;
  since_cut_ = wary_steps;
  return std::min(cut_share * h, first_periods / std::sqrt(square));
}

/// Growth factor of the step after one with this number of iterations.
template <int D>
double Search<D>::growth(int iterations) {
  ++since_cut_;
  if (since_cut_ <= wary_steps) return wary_growth;
  return iterations <= easy_for_pseudo ? growth_if_easy : growth_of_pseudo;
}

template <int D>
bool Search<D>::settle(Equilibrium& out) {
  double h = options_.first;
  begin_ = trial_.state().position;
  trial_.measure(0);
  for (int steps = 0;; ++steps) {
    out.left = trial_.share(), out.worst = trial_.worst();
    if (out.left <= options_.tolerance) out.end = EquilibriumEnd::rests;
    if (out.left <= options_.tolerance || steps == options_.most_steps) break;
    int before = out.iterations;
    // Fails until a shorter h succeeds; iterations of failed tries do not count for the growth.
    bool found = false;
    while (h > shortest_pseudo && !stopped() && !(found = step(h, out.left, out)))
      ++out.cuts, before = out.iterations, h = shorter(h);
    if (!found) {
      out.end = stopped() ? EquilibriumEnd::stopped : EquilibriumEnd::stuck;
      break;
    }
    ++out.steps;
    if (leaves(out)) break;
    trial_.measure(0);
    h *= growth(out.iterations - before);
  }
  return out.end == EquilibriumEnd::rests;
}

void check_rest(const EquilibriumOptions& o) {
  require_positive(o.tolerance, "equilibrium: tolerance", "");
  require_positive(o.first, "equilibrium: first step", "s");
  require_positive(o.within, "equilibrium: within", "");
  require_positive(o.farthest, "equilibrium: farthest", "");
  if (o.shares < 1 || o.shares > most_shares)
    throw InputError(fmt::format("equilibrium: {} shares, must be 1 to {}", o.shares, most_shares));
  if (o.most_steps < 1 || o.most_iterations < 1)
    throw InputError("equilibrium: most steps and most iterations must be at least 1");
}

}  // namespace

std::string_view name_of(EquilibriumEnd end) {
  constexpr std::array<std::string_view, 6> names{"at rest", "goes off", "stuck", "unsettled", "stopped", "unstable"};
  return names[static_cast<std::size_t>(end)];
}

template <int D>
Equilibrium find_equilibrium(const Model<D>& model, State<D>& state, const EquilibriumOptions& options) {
  check_rest(options);
  Model<D> loaded = model;
  Search<D> search(loaded, state, options);
  Equilibrium out;
  for (int i = 1; i <= options.shares; ++i) {
    out.end = EquilibriumEnd::unsettled;
    scale_all(model, static_cast<double>(i) / options.shares, loaded);
    search.trial().evaluate_here();
    // A body that expands freely carries nothing at the end; its residual is a share of the forces before it has moved.
    if (!model.fields.empty()) search.trial().keep_carried();
    if (!search.settle(out)) return out;
  }
  out.converged = true;
  out.events = search.trial().events();
  state = search.trial().finish();
  return out;
}

template Equilibrium find_equilibrium(const Model<2>&, State<2>&, const EquilibriumOptions&);
template Equilibrium find_equilibrium(const Model<3>&, State<3>&, const EquilibriumOptions&);

}  // namespace trilith
