// The steps of a load path: by its control, and under dissipation and displacement control where joints break.
#include <algorithm>
#include <limits>

#include "statics/load_path_walk.hpp"

namespace trilith {
namespace {

/// Dissipation control: a failed step is cut by this factor, up to this number of times; it begins with this share of
/// the energy that the continued step would dissipate.
constexpr int most_detour_cuts = 10;
constexpr double cut_of_detour = 0.25, share_of_overshoot = 0.1;
/// A step under dissipation control is cut up to this number of times while it misses more than this share of its
/// energy, see missed_work().
constexpr int cuts_for_work = 4;
constexpr double most_missed = 0.01;
/// Work below this share of force times displacement may always be missed.
constexpr double missed_of_path = 2e-5;
/// A step counts as free of dissipation below this share of the last step's energy per length.
constexpr double idle_share = 1e-3;
/// Energy differences are taken over this share of the step.
constexpr double share_of_step = 1e-4;
/// A step towards the loss of a bond covers all but `share_before_loss` of the way to it. It is not taken if this way
/// is shorter than `near_loss` of the last step.
constexpr double share_before_loss = 0.02, near_loss = 0.05;

}  // namespace

/// Error of the condition for a step of this size: of the factor, the displacement, or the squared arc.
template <int D>
double LoadPathWalk<D>::condition(double size) const {
  const Eigen::VectorXd way = trial_.way();
  switch (control_) {
    case PathControl::load:
      return factor_ - last_factor_ - size;
    case PathControl::displacement:
      return followed_.dot(way) - size;
    case PathControl::dissipation:
      return trial_.softened() - size;
    case PathControl::arc:
      break;
  }
  return inner(way, way) - size * size;
}

/// Change of the condition by a move of all unknowns at constant factor.
template <int D>
double LoadPathWalk<D>::change(const Eigen::VectorXd& by) {
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

/// The directional derivative of the dissipated energy of the trial, by central differences, so that it is valid for
/// every law. The trial is restored.
template <int D>
double LoadPathWalk<D>::dissipation_along(const Eigen::VectorXd& by) {
  const double size = length_of(by);
  if (!(size > 0)) return 0;
  const double share = share_of_step * length_of(trial_.way()) / size;
  const auto at = [&](double moved) {
    trial_.move(by, moved);
    trial_.evaluate_here();
    return trial_.softened();
  };
  const double more = at(share), less = at(-2 * share);
  at(share);
  return (more - less) / (2 * share);
}

/// The trial at a share of a move from the start of the step.
template <int D>
void LoadPathWalk<D>::try_at(const Eigen::VectorXd& direction, double factor, double share) {
  trial_.go_back();
  set_factor(last_factor_);
  move(share * direction, share * factor);
}

/// The share of a move at which the trial has dissipated this energy; unbounded if it does not within twice the longest
/// arc.
template <int D>
double LoadPathWalk<D>::reach(const Eigen::VectorXd& direction, double factor, double energy) {
  const double most = 2 * longest_ / length_of(direction);
  const auto dissipated = [&](double share) {
    try_at(direction, factor, share);
    return trial_.softened();
  };
  double low = 0, high = 1e-6 * most;
  while (!(dissipated(high) >= energy)) {
    low = high, high *= 4;
    if (high > most || stopped()) return std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < 30 && high - low > 1e-6 * high && !stopped(); ++i) {
    const double middle = 0.5 * (low + high);
    (dissipated(middle) >= energy ? high : low) = middle;
  }
  return high;
}

/// A step under dissipation control begins on the loading branch of every softening point. It continues along the last
/// step, or along the tangent in either sense, whichever dissipates the energy over the shortest distance. At a sharp
/// snap-back the tangent at the last equilibrium belongs to neither branch, and Newton's method would alternate between
/// the two.
template <int D>
bool LoadPathWalk<D>::predict_dissipation(double energy) {
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

/// The predictor of a step, along the tangent; an arc continues in the sense of the last one, or in the opposite sense.
template <int D>
bool LoadPathWalk<D>::predict(double size, bool reversed) {
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

/// Error of a dissipated energy that remains where the last digit of positions moves it; 0 under another control [J].
/// The energy of a step only determines its length.
template <int D>
double LoadPathWalk<D>::energy_rounding() const {
  constexpr double share_of_least = 1e-4;
  return control_ == PathControl::dissipation ? share_of_least * least_energy() : 0;
}

/// Newton iterations for equilibrium and condition together: the tangent is solved for the residual and for the loads,
/// and the condition determines the factor (bordering).
template <int D>
bool LoadPathWalk<D>::correct(double size) {
  for (int i = 0;; ++i) {
    trial_.measure(0);
    out_.left = trial_.share(), out_.worst = trial_.worst();
    const double off = condition(size), unit = control_ == PathControl::arc ? size * size
                                               : size != 0                  ? std::abs(size)
                                                                            : longest_;
    if (!std::isfinite(out_.left) || !std::isfinite(off)) return false;
    if (out_.left <= options_.tolerance && std::abs(off) <= condition_share * unit) return true;
    if (i == options_.most_iterations) return out_.left <= options_.tolerance && std::abs(off) <= energy_rounding();
    if (stopped()) return false;
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

/// Cosine of the angle between this step and the last one; 1 if there is none.
template <int D>
double LoadPathWalk<D>::turned() const {
  if (last_way_.size() == 0 || control_ != PathControl::arc) return 1;
  const Eigen::VectorXd way = trial_.way();
  return inner(way, last_way_) / std::sqrt(inner(way, way) * inner(last_way_, last_way_));
}

/// True for an arc that follows a step with dissipation, dissipates nothing and reduces the load: softening points
/// unload, and the path returns towards the unloaded structure.
template <int D>
bool LoadPathWalk<D>::unloads() const {
  if (control_ != PathControl::arc || last_way_.size() == 0 || !(last_energy_ > 0)) return false;
  const double expected = last_energy_ * length_of(trial_.way()) / length_of(last_way_);
  return trial_.softened() < idle_share * expected && std::abs(factor_) < std::abs(last_factor_);
}

/// An arc across fracture may jump to another branch at any energy. Such a step is left to dissipation control, as long
/// as that finds one.
template <int D>
bool LoadPathWalk<D>::fractures() {
  const bool crosses =
      control_ == PathControl::arc && !may_leap_ && last_way_.size() > 0 && trial_.fractured() > least_energy();
  refused_ = refused_ || crosses;
  return crosses;
}

/// Work of the residual along the straight path of the step, which the energy balance misses, by Simpson's rule; the
/// residual is 0 at both ends [J]. It is large where a joint reaches its strength, or parts, within the step.
template <int D>
double LoadPathWalk<D>::missed_work() {
  const Eigen::VectorXd way = trial_.way();
  const double rise = factor_ - last_factor_;
  try_at(way, rise, 0.5);
  trial_.measure(0);
  const double middle = trial_.left().dot(way);
  try_at(way, rise, 1);
  return 2.0 / 3 * middle;
}

/// True for a step under dissipation control that is too long for its energy balance.
template <int D>
bool LoadPathWalk<D>::misses_work() {
  if (control_ != PathControl::dissipation || !strict_) return false;
  most_work_ = std::max(most_work_, std::abs(factor_ * followed_place()));
  const double enough = std::max(most_missed * trial_.softened(), missed_of_path * most_work_);
  missed_ = std::abs(missed_work()) > enough;
  return missed_;
}

/// Tries a step of this size. If it fails, everything is restored.
template <int D>
bool LoadPathWalk<D>::step(double size, bool reversed) {
  const int before = out_.iterations;
  // An arc that has turned by more than a right angle would return along its path.
  if (predict(size, reversed) && correct(size) && (reversed || turned() > 0) && !unloads() && !fractures() &&
      !misses_work() && !strays() && !overshoots()) {
    last_way_ = trial_.way();
    last_rise_ = factor_ - last_factor_;
    last_factor_ = factor_;
    last_energy_ = trial_.softened() > least_energy() ? trial_.softened() : 0;
    trial_.keep_carried();
    trial_.accept();
    taken_ = out_.iterations - before;
    return true;
  }
  set_factor(last_factor_);
  trial_.go_back();
  return false;
}

/// A step under dissipation control, where softening turns the path sharply. The energy is taken from the last such
/// step, or from the dissipation of a continued step of `size`.
template <int D>
bool LoadPathWalk<D>::dissipate(double size) {
  if (last_way_.size() == 0) return false;
  if (!(energy_ > 0)) {
    const double length = length_of(last_way_);
    for (double share = size / length; share * length < 2 * longest_ && !(energy_ > 0); share *= 2) {
      try_at(last_way_, last_rise_, share);
      energy_ = share_of_overshoot * trial_.softened();
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
    strict_ = i < cuts_for_work, missed_ = false;
    found = step(energy);
    if (missed_ && (i + 1 == cuts_for_work || cut_of_detour * energy <= least_energy())) {
      strict_ = false;
      found = step(energy);
    }
    if (!found) energy *= cut_of_detour, ++out_.cuts;
  }
  control_ = options_.control;
  if (!found) {
    energy_ = 0;
    return false;
  }
  const double faster = std::sqrt(options_.wanted_iterations / std::max(1.0, 1.0 * taken_));
  energy_ = energy * std::min(std::clamp(faster, least_path_change, most_path_change), longest_ / length_of(last_way_));
  return true;
}

/// Takes a step that ends just before the loss of a brittle bond. The largest load of a brittle joint lies there, and
/// not at the last arc before it.
template <int D>
bool LoadPathWalk<D>::approach() {
  if (last_way_.size() == 0) return false;
  const double last = length_of(last_way_), way = last * reach(last_way_, last_rise_, least_energy());
  set_factor(last_factor_), trial_.go_back();
  return std::isfinite(way) && way > near_loss * last && step((1 - share_before_loss) * way);
}

/// Crosses the loss of a brittle bond, where the path itself jumps. The first bond along the path is broken alone, and
/// equilibrium is found again at the same displacement. Further bonds break only if that equilibrium requires it.
template <int D>
bool LoadPathWalk<D>::jump() {
  if (last_way_.size() == 0 || options_.followed.empty()) return false;
  const Eigen::VectorXd way = last_way_;
  const double rise = last_rise_, factor = last_factor_, energy = last_energy_;
  typename StaticTrial<D>::Begin before_jump = trial_.begin();
  if (!predict_dissipation(least_energy())) {
    set_factor(last_factor_), trial_.go_back();
    return false;
  }
  trial_.accept();
  last_factor_ = factor_;
  control_ = PathControl::displacement;
  const bool found = step(0);
  control_ = options_.control;
  // The path continues in the direction it had before the loss of the bond. Without an equilibrium the bond is restored
  // and the state is the last point.
  last_way_ = way, last_rise_ = rise, last_energy_ = found ? 0 : energy;
  if (found) {
    ++out_.jumps;
    return true;
  }
  last_factor_ = factor;
  set_factor(factor);
  trial_.return_to(std::move(before_jump));
  return false;
}

/// Ways past a step that fails because joints break.
template <int D>
bool LoadPathWalk<D>::detour(double size) {
  const bool refused = refused_;
  return dissipate(size) || approach() || jump() || (refused && leap(size));
}

/// An arc that may cross fracture.
template <int D>
bool LoadPathWalk<D>::leap(double size) {
  may_leap_ = true;
  const bool found = step(size);
  may_leap_ = false;
  return found;
}

/// One step of an arc, and the opposite sense if the first one unloads.
template <int D>
bool LoadPathWalk<D>::arc(double size) {
  may_leap_ = options_.control != PathControl::arc;
  refused_ = false;
  if (step(size)) return true;
  return options_.control == PathControl::arc && last_energy_ > 0 && !overshot_ && step(size, true);
}

template bool LoadPathWalk<2>::step(double, bool);
template bool LoadPathWalk<3>::step(double, bool);
template bool LoadPathWalk<2>::arc(double);
template bool LoadPathWalk<3>::arc(double);
template bool LoadPathWalk<2>::dissipate(double);
template bool LoadPathWalk<3>::dissipate(double);
template bool LoadPathWalk<2>::detour(double);
template bool LoadPathWalk<3>::detour(double);

}  // namespace trilith
