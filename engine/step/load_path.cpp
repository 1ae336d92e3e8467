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
/// Failed arcs in a row before dissipation control is tried, and how that cuts its steps.
constexpr int arcs_before_detour = 2, most_detour_cuts = 10;
constexpr double cut_of_detour = 0.25, share_of_overshoot = 0.1;
/// A step without dissipation gives off less than this share of the last step's energy per length.
constexpr double idle_share = 1e-3;
/// Loads below this share of the largest one are carried by nothing but the hold of what is loose.
constexpr double nothing_carried = 1e-9;
/// Energy differences are taken over this share of the step.
constexpr double share_of_step = 1e-4;

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
  bool step(double size, bool reversed = false);
  bool arc(double size);
  bool dissipate(double size);
  bool jump();
  bool leap(double size);
  [[nodiscard]] double least_energy() const { return 1e-7 * std::abs(last_factor_ * followed_place()); }
  [[nodiscard]] bool resists() const;
  [[nodiscard]] bool fractures() const;
  bool predict(double size, bool reversed);
  bool predict_dissipation(double energy);
  double reach(const Eigen::VectorXd& direction, double factor, double energy);
  void try_at(const Eigen::VectorXd& direction, double factor, double share);
  double dissipation_along(const Eigen::VectorXd& by);
  bool correct(double size);
  void move(const Eigen::VectorXd& by, double factor);
  void set_factor(double factor);
  void find_loads();
  bool solve_loads();
  [[nodiscard]] double condition(double size) const;
  [[nodiscard]] double change(const Eigen::VectorXd& by);
  [[nodiscard]] double turned() const;
  [[nodiscard]] bool unloads() const;
  [[nodiscard]] double length_of(const Eigen::VectorXd& way) const { return std::sqrt(inner(way, way)); }
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
  PathControl control_;  // of the present step
  double origin_ = 0, longest_ = 0;
  double last_rise_ = 0, last_energy_ = 0;  // of the last step: change of the factor, dissipation [J]
  bool may_leap_ = false;                   // see fractures()
  double energy_ = 0;                       // next step under dissipation control [J]; 0: none yet
  int taken_ = 0;                           // iterations of the last step
  Eigen::ArrayXd share_;                    // of the mass, by unknown
  Eigen::VectorXd followed_;                // weights, by unknown
  Eigen::VectorXd loads_, per_factor_;      // by unknown: of the factor 1; what they move at the present tangent
  Eigen::VectorXd last_way_;                // of the last step
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
      last_factor_(options.begin),
      control_(options.control) {
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
  switch (control_) {
    case PathControl::load:
      return factor_ - last_factor_ - size;
    case PathControl::displacement:
      return followed_.dot(way) - size;
    case PathControl::dissipation:
      return trial_.dissipated() - size;
    case PathControl::arc:
      break;
  }
  return inner(way, way) - size * size;
}

/// How the condition changes with a move of all unknowns, the factor kept.
template <int D>
double Path<D>::change(const Eigen::VectorXd& by) {
  switch (control_) {
    case PathControl::load:
      return 0;
    case PathControl::displacement:
      return followed_.dot(by);
    case PathControl::dissipation:
      return dissipation_along(by);
    case PathControl::arc:
      break;
  }
  return 2 * inner(trial_.way(), by);
}

/// The directional derivative of the energy that the trial has given off, by central differences: so it holds for
/// every law. The trial ends where it was.
template <int D>
double Path<D>::dissipation_along(const Eigen::VectorXd& by) {
  const double size = length_of(by);
  if (!(size > 0)) return 0;
  const double share = share_of_step * length_of(trial_.way()) / size;
  const auto at = [&](double moved) {
    trial_.move(by, moved);
    trial_.evaluate_here();
    return trial_.dissipated();
  };
  const double more = at(share), less = at(-2 * share);
  at(share);
  return (more - less) / (2 * share);
}

/// The trial at a share of a move from the step's begin.
template <int D>
void Path<D>::try_at(const Eigen::VectorXd& direction, double factor, double share) {
  trial_.go_back();
  set_factor(last_factor_);
  move(share * direction, share * factor);
}

/// The share of a move at which the trial has given off this energy; unbounded where it does not within twice the
/// longest arc.
template <int D>
double Path<D>::reach(const Eigen::VectorXd& direction, double factor, double energy) {
  const double most = 2 * longest_ / length_of(direction);
  const auto given_off = [&](double share) {
    try_at(direction, factor, share);
    return trial_.dissipated();
  };
  double low = 0, high = 1e-6 * most;
  while (!(given_off(high) >= energy)) {
    low = high, high *= 4;
    if (high > most) return std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < 30 && high - low > 1e-6 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (given_off(middle) >= energy ? high : low) = middle;
  }
  return high;
}

/// A step under dissipation control begins on the loading branch of every softening point: on along the last step, or
/// along the tangent either way, whichever gives the energy off over the shortest way. At a sharp snap-back the tangent
/// at the last equilibrium is of neither branch, and Newton's method would change between the two.
template <int D>
bool Path<D>::predict_dissipation(double energy) {
  std::vector<std::pair<Eigen::VectorXd, double>> directions;
  if (last_way_.size() > 0) directions.emplace_back(last_way_, last_rise_);
  if (solve_loads()) {
    directions.emplace_back(per_factor_, 1.0);
    directions.emplace_back(-per_factor_, -1.0);
  }
  const std::pair<Eigen::VectorXd, double>* best = nullptr;
  double shortest = std::numeric_limits<double>::infinity(), best_share = 0;
  for (const auto& direction : directions) {
    const double share = reach(direction.first, direction.second, energy);
    const double length = share * length_of(direction.first);
    if (length < shortest) shortest = length, best_share = share, best = &direction;
  }
  if (best == nullptr) return false;
  try_at(best->first, best->second, best_share);
  return true;
}

/// The first move of a step, along the tangent; an arc goes on the way the last one went, or the other way.
template <int D>
bool Path<D>::predict(double size, bool reversed) {
  if (control_ == PathControl::dissipation) return predict_dissipation(size);
  if (!solve_loads()) return false;
  double factor = size;
  if (control_ == PathControl::displacement) factor = size / followed_.dot(per_factor_);
  if (control_ == PathControl::arc) {
    factor = size / std::sqrt(inner(per_factor_, per_factor_));
    if (last_way_.size() > 0 && inner(last_way_, per_factor_) < 0)
      factor = -std::abs(factor);
    else if (last_way_.size() > 0)
      factor = std::abs(factor);
    if (reversed) factor = -factor;
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
    const double off = condition(size), unit = control_ == PathControl::arc ? size * size
                                               : size != 0                  ? std::abs(size)
                                                                            : longest_;
    if (!std::isfinite(out_.left) || !std::isfinite(off)) return false;
    if (out_.left <= options_.tolerance && std::abs(off) <= condition_share * unit) return true;
    if (i == options_.most_iterations) return false;
    ++out_.iterations;
    if (!solve_loads()) return false;
    const Eigen::VectorXd rest = trial_.solve(trial_.left());
    // g + g_x (dx_r + dfactor dx_q) + g_factor dfactor = 0, solved for dfactor.
    const double by_factor = change(per_factor_) + (control_ == PathControl::load ? 1 : 0);
    const double factor = -(off + change(rest)) / by_factor;
    if (!std::isfinite(factor)) return false;
    move(rest + factor * per_factor_, factor);
  }
}

/// Cosine between this step and the last one; 1 where there is none.
template <int D>
double Path<D>::turned() const {
  if (last_way_.size() == 0 || control_ != PathControl::arc) return 1;
  const Eigen::VectorXd way = trial_.way();
  return inner(way, last_way_) / std::sqrt(inner(way, way) * inner(last_way_, last_way_));
}

/// An arc that follows a step with dissipation, gives off none and lowers the load: softening points unload, and it
/// goes back towards the unloaded structure.
template <int D>
bool Path<D>::unloads() const {
  if (control_ != PathControl::arc || last_way_.size() == 0 || !(last_energy_ > 0)) return false;
  const double expected = last_energy_ * length_of(trial_.way()) / length_of(last_way_);
  return trial_.dissipated() < idle_share * expected && std::abs(factor_) < std::abs(last_factor_);
}

/// An arc over fracture may leap from one branch to another, whatever that costs in energy: such a step is left to
/// dissipation control, as long as that finds one.
template <int D>
bool Path<D>::fractures() const {
  return control_ == PathControl::arc && !may_leap_ && last_way_.size() > 0 && trial_.fractured() > least_energy();
}

/// Tries a step of this size. Where it fails all is as it was.
template <int D>
bool Path<D>::step(double size, bool reversed) {
  const int before = out_.iterations;
  // An arc that has turned by more than a right angle would go back on the path it came by.
  if (predict(size, reversed) && correct(size) && (reversed || turned() > 0) && !unloads() && !fractures()) {
    last_way_ = trial_.way();
    last_rise_ = factor_ - last_factor_;
    last_factor_ = factor_;
    last_energy_ = trial_.dissipated() > least_energy() ? trial_.dissipated() : 0;
    trial_.keep_carried();
    trial_.accept();
    taken_ = out_.iterations - before;
    return true;
  }
  set_factor(last_factor_);
  trial_.go_back();
  return false;
}

/// A step under dissipation control: where softening turns the path sharply. The energy is that of the last such step,
/// or what going on by `size` would give off.
template <int D>
bool Path<D>::dissipate(double size) {
  if (last_way_.size() == 0) return false;
  if (!(energy_ > 0)) {
    const double length = length_of(last_way_);
    for (double share = size / length; share * length < 2 * longest_ && !(energy_ > 0); share *= 2) {
      try_at(last_way_, last_rise_, share);
      energy_ = share_of_overshoot * trial_.dissipated();
    }
    set_factor(last_factor_), trial_.go_back();
  }
  if (!(energy_ > least_energy())) {
    energy_ = 0;
    return false;
  }
  control_ = PathControl::dissipation;
  double energy = energy_;
  bool found = false;
  for (int i = 0; i < most_detour_cuts && !found && energy > least_energy(); ++i) {
    found = step(energy);
    if (!found) energy *= cut_of_detour, ++out_.cuts;
  }
  control_ = options_.control;
  if (!found) {
    energy_ = 0;
    return false;
  }
  const double faster = std::sqrt(options_.wanted_iterations / std::max(1.0, 1.0 * taken_));
  energy_ = energy * std::min(std::clamp(faster, least_change, most_change), longest_ / length_of(last_way_));
  return true;
}

/// Over the loss of a brittle bond, where the path itself jumps: the first bond to go along the path is broken alone,
/// and equilibrium is found again at the same displacement. More bonds go there only as that equilibrium asks for it.
template <int D>
bool Path<D>::jump() {
  if (last_way_.size() == 0 || options_.followed.empty()) return false;
  const Eigen::VectorXd way = last_way_;
  const double rise = last_rise_;
  if (!predict_dissipation(least_energy())) {
    set_factor(last_factor_), trial_.go_back();
    return false;
  }
  trial_.accept();
  last_factor_ = factor_;
  control_ = PathControl::displacement;
  const bool found = step(0);
  control_ = options_.control;
  // The path goes on as it went before the bond was lost.
  last_way_ = way, last_rise_ = rise, last_energy_ = 0;
  if (found) ++out_.jumps;
  return found;
}

/// The last resort: an arc that may go over fracture.
template <int D>
bool Path<D>::leap(double size) {
  may_leap_ = true;
  const bool found = step(size);
  may_leap_ = false;
  return found;
}

/// One step of an arc, and its other way where the first one unloads.
template <int D>
bool Path<D>::arc(double size) {
  may_leap_ = options_.control != PathControl::arc;
  if (step(size)) return true;
  return options_.control == PathControl::arc && last_energy_ > 0 && step(size, true);
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

/// False where the last point carries next to nothing of the largest load: the parts have come apart.
template <int D>
bool Path<D>::resists() const {
  if (last_way_.size() == 0 || out_.points.size() < 3 || options_.control != PathControl::arc) return true;
  double most = 0;
  for (const PathPoint& p : out_.points) most = std::max(most, std::abs(p.factor));
  const double limit = nothing_carried * most;
  return std::abs(out_.points.back().factor) > limit;
}

template <int D>
void Path<D>::follow() {
  const double first = std::abs(options_.first);
  const double longest = options_.longest > 0 ? options_.longest : 10 * first;
  const double shortest = options_.shortest > 0 ? options_.shortest : 1e-5 * first;
  double size = options_.first;
  longest_ = longest;
  int failed = 0;
  bool on = add_point(0);
  while (on) {
    const double now = size_to_go(size);
    out_.end = now == 0                                                       ? PathEnd::arrived
               : static_cast<int>(out_.points.size()) >= options_.most_points ? PathEnd::most_points
                                                                              : PathEnd::stuck;
    if (out_.end != PathEnd::stuck || std::abs(size) < shortest) return;
    const bool by_arc = options_.control == PathControl::arc;
    const bool goes_on_softening = by_arc && energy_ > 0 && dissipate(longest);
    if (!goes_on_softening && !arc(now)) {
      size = cut_of_path * now, ++out_.cuts;
      if (!by_arc || ++failed < arcs_before_detour || !(dissipate(now) || jump() || leap(now))) continue;
      size = std::min(first, std::max(length_of(last_way_), shortest));
    }
    failed = 0;
    on = add_point(taken_);
    if (on && !resists()) {
      out_.end = PathEnd::no_resistance;
      return;
    }
    if (energy_ > 0) continue;
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
