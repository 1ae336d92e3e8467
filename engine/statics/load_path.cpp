#include "statics/load_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assembly/evaluate.hpp"
#include "assembly/node_forces.hpp"
#include "base/error.hpp"
#include "model/loads.hpp"
#include "statics/equilibrium.hpp"
#include "statics/load_path_walk.hpp"

namespace trilith {
namespace {

/// Factor of a failed step.
constexpr double cut_of_path = 0.5;
/// Share of the stiffest frequency squared that keeps the tangent regular with free parts, and is otherwise negligible.
constexpr double hold_of_loose = 1e-13;
/// Number of consecutive failed arcs before dissipation control is tried.
constexpr int arcs_before_detour = 2;
/// Number of consecutive failed arcs before rest is searched at a given displacement.
constexpr int arcs_before_search = 5;
/// Arcs below this share of the first one are short.
constexpr double short_arc = 0.1;
/// Growth of a step that takes more iterations than wanted, up to this multiple, at any length.
constexpr double growth_of_contact = 1.25;
constexpr int most_growing = 3;
/// Loads below this share of the largest one are carried only by the regularisation of loose parts.
constexpr double nothing_carried = 1e-9;
template <int D>
Model<D> scaled(const Model<D>& model, const std::string& name, double factor) {
  Model<D> out = model;
  scale_loads(out, name, factor);
  return out;
}

/// A model with the scaled loads alone, at factor 1.
template <int D>
Model<D> reference_of(const Model<D>& model, const std::string& name) {
  Model<D> out = model;
  std::fill(out.load.begin(), out.load.end(), Vec<D>::Zero());
  const auto is_other = [&](const auto& load) { return !name.empty() && load.name != name; };
  out.loads.erase_if(is_other);
  if (!out.loaded()) throw InputError("load path: no point or face load is called '" + name + "'");
  return out;
}

}  // namespace

template <int D>
LoadPathWalk<D>::LoadPathWalk(const Model<D>& model, const State<D>& state, const LoadPathOptions<D>& options,
                              LoadPath& out)
    : options_(options),
      out_(out),
      loaded_(scaled(model, options.loads, options.begin)),
      full_(model),
      reference_(reference_of(model, options.loads)),
      trial_(loaded_, state),
      factor_(options.begin),
      last_factor_(options.begin),
      control_(options.control) {
  const DofGraph<D>& coupling = trial_.coupling();
  // S: masses and inertias over the sum of the masses along x and y.
  share_.resize(coupling.size());
  double sum = 0;
  for (int i = 0; i < coupling.size(); ++i) {
    share_[i] = trial_.mass_at(i);
    if (!is_turn<D>(coupling.freedom[i])) sum += share_[i];
  }
  share_ /= sum;
  // One row of weights: the followed displacement is their product with the path.
  followed_ = Eigen::VectorXd::Zero(coupling.size());
  for (const FollowedFreedom& f : options.followed) {
    const int i = coupling.unknown[f.freedom.node][f.freedom.k];
    if (i < 0) throw InputError("load path: a followed degree of freedom is not free");
    followed_[i] += f.weight;
  }
  origin_ = followed_place() - options.displacement;
  longest_ = options.longest > 0 ? options.longest : 10 * std::abs(options.first);
  trial_.find_tangent(1);  // determines the largest stiffness
  if (options.last_step.empty()) return;
  last_way_.resize(coupling.size()), last_rise_ = options.rise;
  for (int i = 0; i < coupling.size(); ++i)
    last_way_[i] = options.last_step[static_cast<std::size_t>(coupling.freedom[i].node)]
                                    [static_cast<std::size_t>(coupling.freedom[i].k)];
}

template <int D>
double LoadPathWalk<D>::followed_place() const {
  double sum = 0;
  const State<D>& s = trial_.state();
  for (const auto& [f, weight] : options_.followed) sum += weight * place_along(s, f.node, f.k);
  return sum - origin_;
}

template <int D>
void LoadPathWalk<D>::set_factor(double factor) {
  factor_ = factor;
  loaded_.loads = full_.loads;
  scale_loads(loaded_, options_.loads, factor);
}

template <int D>
void LoadPathWalk<D>::move(const Eigen::VectorXd& by, double factor) {
  trial_.move(by, 1);
  set_factor(factor_ + factor);
  trial_.evaluate_here();
}

/// The scaled loads at factor 1 on the unknowns, in the present position of the bodies. Only for this the loads of
/// `reference_` are written to Work; the loads of `loaded_` are restored.
template <int D>
void LoadPathWalk<D>::find_loads() {
  Work<D>& work = trial_.work();
  apply_loads(reference_, trial_.state(), work);
  const DofGraph<D>& coupling = trial_.coupling();
  loads_.resize(coupling.size());
  for (int i = 0; i < coupling.size(); ++i) {
    const auto [n, k] = coupling.freedom[i];
    loads_[i] = dofs_of(work.load[n], work.load_moment[n])[k];
  }
  apply_loads(loaded_, trial_.state(), work);
}

/// The tangent at the present position, and the displacement by the scaled loads.
template <int D>
bool LoadPathWalk<D>::solve_loads() {
  if (!trial_.find_tangent(hold_of_loose * trial_.highest_square())) return false;
  find_loads();
  per_factor_ = trial_.solve(loads_);
  return per_factor_.allFinite();
}

/// Adds a point; true if the path continues.
template <int D>
bool LoadPathWalk<D>::add_point(int iterations) {
  // Arc length for any control: limit points are searched over it.
  const double length = last_way_.size() == 0 ? 0 : std::sqrt(inner(last_way_, last_way_));
  const double before = out_.points.empty() ? 0 : out_.points.back().length;
  out_.points.push_back(
      {factor_, followed_place(), before + length, iterations, out_.events.size() + trial_.events().size()});
  look_for_limit();
  return !options_.goes_on || options_.goes_on(out_.points.back(), trial_.state());
}

/// A limit point lies near the last but one point if the factor increases before it and decreases after it, or the
/// reverse: the vertex of the parabola over the path length.
template <int D>
void LoadPathWalk<D>::look_for_limit() {
  if (out_.points.size() < 3) return;
  const PathPoint* p = &out_.points[out_.points.size() - 3];
  const double before = p[1].factor - p[0].factor, after = p[2].factor - p[1].factor;
  if (!(before * after < 0)) return;
  const double s0 = p[0].length - p[1].length, s2 = p[2].length - p[1].length;
  const auto parabola = [&](double y0, double y1, double y2) {  // slope and half of the curvature at the middle point
    const double to0 = (y0 - y1) / s0, to2 = (y2 - y1) / s2;
    const double bend = (to2 - to0) / (s2 - s0);
    return std::pair(to2 - bend * s2, bend);
  };
  const auto [slope, bend] = parabola(p[0].factor, p[1].factor, p[2].factor);
  const auto [rate, turn] = parabola(p[0].displacement, p[1].displacement, p[2].displacement);
  const double at = -0.5 * slope / bend;
  out_.limits.push_back(
      {p[1].factor + at * (slope + bend * at), p[1].displacement + at * (rate + turn * at), before > 0});
}

/// Limits the step to the end of the path; 0 at the end.
template <int D>
double LoadPathWalk<D>::size_to_go(double size) const {
  if (options_.control == PathControl::arc) return size;
  const double now = options_.control == PathControl::load ? factor_ : followed_place(), left = options_.to - now;
  if (size * left <= 0 || std::abs(left) <= condition_share * std::abs(size)) return 0;
  return std::abs(left) < std::abs(size) ? left : size;
}

/// False if the last point carries a negligible share of the largest load: the parts have separated.
template <int D>
bool LoadPathWalk<D>::resists() const {
  if (last_way_.size() == 0 || out_.points.size() < 3 || options_.control != PathControl::arc) return true;
  double most = 0;
  for (const PathPoint& p : out_.points) most = std::max(most, std::abs(p.factor));
  const double limit = nothing_carried * most;
  return std::abs(out_.points.back().factor) > limit;
}

/// Change of the step length. Few iterations permit a longer step; the square root prevents oscillation. Contacts that
/// open, close or slide cost iterations at any length: where a shorter step has not saved any, the next one is longer.
template <int D>
double LoadPathWalk<D>::growth() {
  const int before = std::exchange(last_taken_, taken_), wanted = options_.wanted_iterations;
  const bool no_better = taken_ > wanted && taken_ <= most_growing * wanted && taken_ >= before;
  if (no_better && options_.control == PathControl::arc && loaded_.bodies.size() > 1) return growth_of_contact;
  return std::clamp(std::sqrt(wanted / std::max(1.0, 1.0 * taken_)), least_path_change, most_path_change);
}

/// True if rest is searched after this number of failed arcs, of which the last had this size: after several ones, and
/// at once after a search and where steps have become short without fracture. After a search that failed some points
/// are awaited.
template <int D>
bool LoadPathWalk<D>::is_search_due(int failed, double size) const {
  const bool is_short = std::abs(size) < short_arc * std::abs(options_.first) && !refused_ && !(last_energy_ > 0);
  const bool due = failed == (searched_ || is_short ? 1 : arcs_before_search);
  return due && static_cast<int>(out_.points.size()) >= next_search_;
}

template <int D>
void LoadPathWalk<D>::follow() {
  const double first = std::abs(options_.first);
  const double longest = longest_;
  const double shortest = options_.shortest > 0 ? options_.shortest : 1e-5 * first;
  double size = options_.first, asked = size;  // asked: before cuts
  int failed = 0;
  trial_.evaluate_here(), take_strength();
  bool on = add_point(0);
  while (on && !is_cracking()) {
    if (stopped()) {
      out_.end = PathEnd::stopped;
      return;
    }
    const double now = size_to_go(size);
    out_.end = now == 0                              ? PathEnd::arrived
               : budget_ + 1 >= options_.most_points ? PathEnd::most_points
                                                     : PathEnd::stuck;
    if (out_.end != PathEnd::stuck || std::abs(size) < shortest) return;
    const bool by_arc = options_.control == PathControl::arc;
    const bool goes_on_softening = by_arc && energy_ > 0 && dissipate(longest);
    bool searched = false;
    strayed_ = overshot_ = false;
    if (!goes_on_softening && !arc(now)) {
      if (overshot_) {
        size = std::copysign(to_strength_, now), ++out_.cuts;
        continue;
      }
      if (strayed_) {
        size = std::copysign(std::min(accurate_, 0.5 * std::abs(now)), now), ++out_.cuts;
        continue;
      }
      if (failed++ == 0) asked = now;
      size = cut_of_path * now, ++out_.cuts;
      if (!by_arc) continue;
      const bool found = failed >= arcs_before_detour && detour(now);
      searched = !found && (is_search_due(failed, now) || std::abs(size) < shortest) &&
                 search(std::copysign(std::min(std::max(std::abs(asked), first), accurate_), asked));
      if (!found && !searched) continue;
      size = std::min(searched ? longest : first, std::max(length_of(last_way_), shortest));
    }
    searched_ = searched;
    last_error_ = std::numeric_limits<double>::infinity();
    failed = 0;
    on = add_point(taken_);
    if (on && !resists()) {
      out_.end = PathEnd::no_resistance;
      return;
    }
    budget_ += accurate_ < longest && last_way_.size() > 0 ? std::min(1.0, length_of(last_way_) / first) : 1;
    if (!(energy_ > 0 || searched)) size *= growth();
    size = std::copysign(std::min({std::abs(size), longest, accurate_, to_strength_}), size);
  }
  out_.end = on ? PathEnd::cracks : PathEnd::arrived;
}

namespace {

template <int D>
void check_path(const LoadPathOptions<D>& o) {
  require_finite(o.begin, "load path: factor at the beginning");
  require_finite(o.first, "load path: first step");
  require_positive(std::abs(o.first), "load path: size of the first step", "");
  require_positive(o.tolerance, "load path: tolerance", "");
  require_not_negative(o.longest, "load path: longest step", "");
  require_not_negative(o.shortest, "load path: shortest step", "");
  if (o.most_points < 1 || o.most_iterations < 1 || o.wanted_iterations < 1)
    throw InputError("load path: most points, most iterations and wanted iterations must be at least 1");
  if (o.control == PathControl::displacement && o.followed.empty())
    throw InputError("load path: displacement control needs a degree of freedom to follow");
}

}  // namespace

template <int D>
LoadPath follow_loads(const Model<D>& model, State<D>& state, const LoadPathOptions<D>& options) {
  check_path(options);
  LoadPath out;
  if (options.finds_again) {
    LoadPathWalk<D> path(model, state, options, out);
    out.end = PathEnd::stuck;
    if (path.find_again()) path.follow();
    state = path.finish();
    return out;
  }
  State<D> resting = state;
  EquilibriumOptions rest;
  rest.tolerance = options.tolerance, rest.is_stopped = options.is_stopped;
  Equilibrium e = find_equilibrium(scaled(model, options.loads, options.begin), resting, rest);
  out.left = e.left, out.worst = e.worst, out.iterations = e.iterations, out.events = std::move(e.events);
  if (e.end == EquilibriumEnd::stopped) out.end = PathEnd::stopped;
  if (!e.converged) return out;
  LoadPathWalk<D> path(model, resting, options, out);
  path.follow();
  state = path.finish();
  return out;
}

template void LoadPathWalk<2>::set_factor(double);
template void LoadPathWalk<3>::set_factor(double);
template void LoadPathWalk<2>::move(const Eigen::VectorXd&, double);
template void LoadPathWalk<3>::move(const Eigen::VectorXd&, double);
template void LoadPathWalk<2>::find_loads();
template void LoadPathWalk<3>::find_loads();
template bool LoadPathWalk<2>::solve_loads();
template bool LoadPathWalk<3>::solve_loads();
template double LoadPathWalk<2>::followed_place() const;
template double LoadPathWalk<3>::followed_place() const;
template LoadPath follow_loads(const Model<2>&, State<2>&, const LoadPathOptions<2>&);
template LoadPath follow_loads(const Model<3>&, State<3>&, const LoadPathOptions<3>&);

}  // namespace trilith
