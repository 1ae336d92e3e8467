#include "step/load_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "step/equilibrium.hpp"
#include "step/evaluate.hpp"
#include "step/node_forces.hpp"
#include "step/static_trial.hpp"
#include "world/loads.hpp"

namespace trilith {
namespace {

/// A step that fails is cut to this share; from one to the next it changes by these factors at most.
constexpr double cut_of_path = 0.5, least_change = 0.5, most_change = 2;
/// The condition of a step is met to this share of it.
constexpr double condition_share = 1e-7;
/// Beside the stiffest frequency squared: keeps the tangent regular where something is free to move, and no more.
constexpr double hold_of_loose = 1e-13;

template <int D>
Model<D> scaled(const Model<D>& model, const std::string& name, double factor) {
  Model<D> out = model;
  scale_loads(out, name, factor);
  return out;
}

/// The loads that are scaled, alone and full.
template <int D>
Model<D> reference_of(const Model<D>& model, const std::string& name) {
  Model<D> out = model;
  std::fill(out.load.begin(), out.load.end(), Vec<D>::Zero());
  const auto is_other = [&](const auto& load) { return !name.empty() && load.name != name; };
  std::erase_if(out.point_loads, is_other);
  std::erase_if(out.face_loads, is_other);
  if (!out.loaded()) throw InputError("load path: no point or face load is called '" + name + "'");
  return out;
}

/// One path.
/// Unknowns x and factor; one step from the last equilibrium:
///
///     factor |        _.-o  correct: dx = dx_r + dfactor dx_q, until F = 0 and the condition hold at once
///            |     .'  /    predict: along the tangent, dx_q = A^-1 q
///            |   o'---x
///            +------------ x
///
/// All states on the way are the trial's; the factor is set by scaling the loads of `loaded_`, which it evaluates.
template <int D>
class Path {
 public:
  Path(const Model<D>& model, const State<D>& state, const LoadPathOptions<D>& options, LoadPath& out);

  void follow();
  State<D> finish() {
    out_.events.insert(out_.events.end(), trial_.events().begin(), trial_.events().end());
    return trial_.finish();
  }

 private:
  bool step(double size);
  bool predict(double size);
  bool correct(double size);
  void move(const Eigen::VectorXd& by, double factor);
  void set_factor(double factor);
  void find_loads();
  bool solve_loads();
  [[nodiscard]] double condition(double size) const;
  [[nodiscard]] double change(const Eigen::VectorXd& by) const;
  [[nodiscard]] double turned() const;
  [[nodiscard]] double inner(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return (a.array() * share_ * b.array()).sum();
  }
  bool add_point(int iterations);
  void look_for_limit();
  [[nodiscard]] double followed_place() const;
  [[nodiscard]] double size_to_go(double size) const;

  const LoadPathOptions<D>& options_;
  LoadPath& out_;
  Model<D> loaded_;           // as it is
  const Model<D> full_;       // ... with its loads at the factor 1
  const Model<D> reference_;  // with the scaled loads alone
  StaticTrial<D> trial_;
  double factor_, last_factor_;
  double origin_ = 0;
  int taken_ = 0;                       // iterations of the last step
  Eigen::ArrayXd share_;                // of the mass, by unknown
  Eigen::VectorXd followed_;            // weights, by unknown
  Eigen::VectorXd loads_, per_factor_;  // by unknown: of the factor 1; what they move at the present tangent
  Eigen::VectorXd last_way_;            // of the last step
};

template <int D>
Path<D>::Path(const Model<D>& model, const State<D>& state, const LoadPathOptions<D>& options, LoadPath& out)
    : options_(options),
      out_(out),
      loaded_(scaled(model, options.loads, options.begin)),
      full_(model),
      reference_(reference_of(model, options.loads)),
      trial_(loaded_, state),
      factor_(options.begin),
      last_factor_(options.begin) {
  const Coupling<D>& coupling = trial_.coupling();
  // S: masses and inertias over the sum of the masses along x and y.
  share_.resize(coupling.size());
  double sum = 0;
  for (int i = 0; i < coupling.size(); ++i) {
    share_[i] = trial_.mass_at(i);
    if (!is_turn<D>(coupling.freedom[i])) sum += share_[i];
  }
  share_ /= sum;
  // One row of weights: the followed displacement is their product with the way.
  followed_ = Eigen::VectorXd::Zero(coupling.size());
  for (const FollowedFreedom& f : options.followed) {
    const int i = coupling.unknown[f.freedom.node][f.freedom.k];
    if (i < 0) throw InputError("load path: a followed degree of freedom is not free");
    followed_[i] += f.weight;
  }
  origin_ = followed_place();
  trial_.find_tangent(1);  // tells how stiff it is
}

template <int D>
double Path<D>::followed_place() const {
  double sum = 0;
  const State<D>& s = trial_.state();
  for (const auto& [f, weight] : options_.followed) sum += weight * place_along(s, f.node, f.k);
  return sum - origin_;
}

template <int D>
void Path<D>::set_factor(double factor) {
  factor_ = factor;
  loaded_.point_loads = full_.point_loads, loaded_.face_loads = full_.face_loads;
  scale_loads(loaded_, options_.loads, factor);
}

template <int D>
void Path<D>::move(const Eigen::VectorXd& by, double factor) {
  trial_.move(by, 1);
  set_factor(factor_ + factor);
  trial_.evaluate_here();
}

/// The scaled loads at the factor 1 on the unknowns, where the bodies are now.
/// The loads of `reference_` are written to Work for this alone, and those of `loaded_` put back.
template <int D>
void Path<D>::find_loads() {
  Work<D>& work = trial_.work();
  apply_loads(reference_, trial_.state(), work);
  const Coupling<D>& coupling = trial_.coupling();
  loads_.resize(coupling.size());
  for (int i = 0; i < coupling.size(); ++i) {
    const auto [n, k] = coupling.freedom[i];
    loads_[i] = dofs_of(work.load[n], work.load_moment[n])[k];
  }
  apply_loads(loaded_, trial_.state(), work);
}

/// The tangent at the present place, and what the loads move by it.
template <int D>
bool Path<D>::solve_loads() {
  if (!trial_.find_tangent(hold_of_loose * trial_.highest_square())) return false;
  find_loads();
  per_factor_ = trial_.solve(loads_);
  return per_factor_.allFinite();
}

/// What the condition of a step of this size is off by: of the factor, the displacement, or the arc's square.
template <int D>
double Path<D>::condition(double size) const {
  const Eigen::VectorXd way = trial_.way();
  switch (options_.control) {
    case PathControl::load:
      return factor_ - last_factor_ - size;
    case PathControl::displacement:
      return followed_.dot(way) - size;
    case PathControl::arc:
      break;
  }
  return inner(way, way) - size * size;
}

/// How the condition changes with a move of all unknowns, the factor kept.
template <int D>
double Path<D>::change(const Eigen::VectorXd& by) const {
  switch (options_.control) {
    case PathControl::load:
      return 0;
    case PathControl::displacement:
      return followed_.dot(by);
    case PathControl::arc:
      break;
  }
  return 2 * inner(trial_.way(), by);
}

/// The first move of a step, along the tangent; an arc goes on the way the last one went.
template <int D>
bool Path<D>::predict(double size) {
  if (!solve_loads()) return false;
  double factor = size;
  if (options_.control == PathControl::displacement) factor = size / followed_.dot(per_factor_);
  if (options_.control == PathControl::arc) {
    factor = size / std::sqrt(inner(per_factor_, per_factor_));
    if (last_way_.size() > 0 && inner(last_way_, per_factor_) < 0)
      factor = -std::abs(factor);
    else if (last_way_.size() > 0)
      factor = std::abs(factor);
  }
  if (!std::isfinite(factor)) return false;
  move(factor * per_factor_, factor);
  return true;
}

/// Newton's iterations for equilibrium and condition at once: the tangent is solved for what is left over and for the
/// loads, and the factor is what the condition asks for (bordering).
template <int D>
bool Path<D>::correct(double size) {
  for (int i = 0;; ++i) {
    trial_.measure(0);
    out_.left = trial_.share(), out_.worst = trial_.worst();
    const double off = condition(size), unit = options_.control == PathControl::arc ? size * size : std::abs(size);
    if (!std::isfinite(out_.left) || !std::isfinite(off)) return false;
    if (out_.left <= options_.tolerance && std::abs(off) <= condition_share * unit) return true;
    if (i == options_.most_iterations) return false;
    ++out_.iterations;
    if (!solve_loads()) return false;
    const Eigen::VectorXd rest = trial_.solve(trial_.left());
    // g + g_x (dx_r + dfactor dx_q) + g_factor dfactor = 0, solved for dfactor.
    const double by_factor = change(per_factor_) + (options_.control == PathControl::load ? 1 : 0);
    const double factor = -(off + change(rest)) / by_factor;
    if (!std::isfinite(factor)) return false;
    move(rest + factor * per_factor_, factor);
  }
}

/// Cosine between this step and the last one; 1 where there is none.
template <int D>
double Path<D>::turned() const {
  if (last_way_.size() == 0 || options_.control != PathControl::arc) return 1;
  const Eigen::VectorXd way = trial_.way();
  return inner(way, last_way_) / std::sqrt(inner(way, way) * inner(last_way_, last_way_));
}

/// Tries a step of this size. Where it fails all is as it was.
template <int D>
bool Path<D>::step(double size) {
  const int before = out_.iterations;
  // An arc that has turned by more than a right angle would go back on the path it came by.
  if (predict(size) && correct(size) && turned() > 0) {
    last_way_ = trial_.way();
    last_factor_ = factor_;
    trial_.keep_carried();
    trial_.accept();
    taken_ = out_.iterations - before;
    return true;
  }
  set_factor(last_factor_);
  trial_.go_back();
  return false;
}

/// True where the path is to go on from it.
template <int D>
bool Path<D>::add_point(int iterations) {
  // Of the path by arcs, whatever it is controlled by: limit points are looked for over it.
  const double length = last_way_.size() == 0 ? 0 : std::sqrt(inner(last_way_, last_way_));
  const double before = out_.points.empty() ? 0 : out_.points.back().length;
  out_.points.push_back(
      {factor_, followed_place(), before + length, iterations, out_.events.size() + trial_.events().size()});
  look_for_limit();
  return !options_.goes_on || options_.goes_on(out_.points.back(), trial_.state());
}

/// A limit point lies about the last but one point where the factor rises before it and falls after it, or the other
/// way round: the end of the parabola over the length of the path.
template <int D>
void Path<D>::look_for_limit() {
  if (out_.points.size() < 3) return;
  const PathPoint* p = &out_.points[out_.points.size() - 3];
  const double before = p[1].factor - p[0].factor, after = p[2].factor - p[1].factor;
  if (!(before * after < 0)) return;
  const double s0 = p[0].length - p[1].length, s2 = p[2].length - p[1].length;
  const auto parabola = [&](double y0, double y1, double y2) {  // slope and half the bend at the middle point
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

/// The step is cut short where it would go beyond the end; 0 there.
template <int D>
double Path<D>::size_to_go(double size) const {
  if (options_.control == PathControl::arc) return size;
  const double now = options_.control == PathControl::load ? factor_ : followed_place(), left = options_.to - now;
  if (size * left <= 0 || std::abs(left) <= condition_share * std::abs(size)) return 0;
  return std::abs(left) < std::abs(size) ? left : size;
}

template <int D>
void Path<D>::follow() {
  const double first = std::abs(options_.first);
  const double longest = options_.longest > 0 ? options_.longest : 10 * first;
  const double shortest = options_.shortest > 0 ? options_.shortest : 1e-5 * first;
  double size = options_.first;
  bool on = add_point(0);
  while (on) {
    const double now = size_to_go(size);
    out_.end = now == 0                                                       ? PathEnd::arrived
               : static_cast<int>(out_.points.size()) >= options_.most_points ? PathEnd::most_points
                                                                              : PathEnd::stuck;
    if (out_.end != PathEnd::stuck || std::abs(size) < shortest) return;
    if (!step(now)) {
      size = cut_of_path * now, ++out_.cuts;
      continue;
    }
    on = add_point(taken_);
    // Few iterations: a longer step; the root keeps it from swinging.
    size *= std::clamp(std::sqrt(options_.wanted_iterations / std::max(1.0, 1.0 * taken_)), least_change, most_change);
    size = std::copysign(std::min(std::abs(size), longest), size);
  }
  out_.end = PathEnd::arrived;
}

template <int D>
void check_path(const LoadPathOptions<D>& o) {
  require_finite(o.begin, "load path: factor at the begin");
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
  State<D> resting = state;
  EquilibriumOptions rest;
  rest.tolerance = options.tolerance;
  Equilibrium e = find_equilibrium(scaled(model, options.loads, options.begin), resting, rest);
  out.left = e.left, out.worst = e.worst, out.iterations = e.iterations, out.events = std::move(e.events);
  if (!e.converged) return out;
  Path<D> path(model, resting, options, out);
  path.follow();
  state = path.finish();
  return out;
}

template LoadPath follow_loads(const Model<2>&, State<2>&, const LoadPathOptions<2>&);
template LoadPath follow_loads(const Model<3>&, State<3>&, const LoadPathOptions<3>&);

}  // namespace trilith
