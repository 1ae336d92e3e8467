// The next point of a load path where no arc converges: rest at a given displacement, by steps of pseudo-time.
//
// Dry joints open, close, stick and slip within a step, and Newton's method on an arc may alternate between two such
// states however short the arc is. The followed displacement is then moved by a given amount, and rest is searched as
// in statics/equilibrium.hpp, with the factor of the loads as the unknown force that keeps the displacement:
//
//     M d / h^2 = F(x, factor),     followed displacement = given,     h increases as the residual decreases
#include <algorithm>
#include <cmath>
#include <utility>

#include "statics/line_search.hpp"
#include "statics/load_path_walk.hpp"

namespace trilith {
namespace {

/// Limits of the search: steps of pseudo-time, and fewer where the laws keep the memories of the last point; iterations
/// of each, and those without halving the residual.
constexpr int most_pseudo_steps = 100, most_held_steps = 30, most_pseudo_iterations = 20, pseudo_patience = 5;
/// Pseudo-time of the first step and of the last try [s], factor of a failed step, and growth after an easy step and
/// otherwise.
constexpr double first_pseudo = 1, least_pseudo = 1e-7, pseudo_cut = 0.2, easy_growth = 10, usual_growth = 2;
constexpr int easy_pseudo_iterations = 6;
/// After a failed step the stiffest contact has this share of its period [rad].
constexpr double pseudo_periods = 3;
/// A step ends at this share of its largest residual.
constexpr double share_of_pseudo = 1e-2;
/// Largest displacement and rotation [rad] within a step, as a share of the size of a body.
constexpr double most_share = 0.1, most_rotation = 0.3;
/// A search fails if a body moves farther than this share of its size, or rotates by more [rad].
constexpr double most_of_search = 0.25, most_rotation_of_search = 0.5;
/// Cuts of the displacement by a quarter each, where there is no rest; where the step is too long for its accuracy, it
/// is halved instead. The last try is accepted at any accuracy.
constexpr int most_search_cuts = 3;
constexpr double search_cut = 0.25, accuracy_cut_of_search = 0.5;
/// After this number of failed searches in a row the wait for the next one grows no more.
constexpr int most_waits = 5;
/// Growth of the displacement from one snap to the next one, and tries of such a one, each with a cut.
constexpr double growth_of_snap = 2;
constexpr int most_slides = 3;

}  // namespace

/// True if a node moves by more than this share of the size of its body, or rotates by more than `rotation` [rad].
template <int D>
bool LoadPathWalk<D>::goes_far(const Eigen::VectorXd& way, double share, double rotation) const {
  for (int i = 0; i < way.size(); ++i) {
    const Freedom f = trial_.coupling().freedom[i];
    const double most = is_turn<D>(f) ? rotation : share * trial_.reach_of(f.node);
    if (!(std::abs(way[i]) <= most)) return true;
  }
  return false;
}

/// A step of pseudo-time h [s] at whose end the followed displacement has moved by `push` since the start of the step
/// of the path. True if it has converged.
template <int D>
bool LoadPathWalk<D>::pseudo_step(double h, double push) {
  const double inertia = 1 / (h * h), begun = factor_;
  double merit = trial_.measure(inertia), most = trial_.share(), least = merit;
  bool good = true;
  for (int i = 0, since = 0; good && i < most_pseudo_iterations && since <= pseudo_patience && !stopped(); ++i) {
    const double enough = std::max(0.5 * options_.tolerance, share_of_pseudo * most);
    if (i > 0 && trial_.share() <= enough) return true;
    ++out_.iterations;
    good = trial_.find_tangent(inertia, i == 0);
    if (!good) break;
    find_loads();
    per_factor_ = trial_.solve(loads_);
    const Eigen::VectorXd rest = trial_.solve(trial_.left());
    const double missing = push - followed_.dot(trial_.way());
    const double rise = (missing - followed_.dot(rest)) / followed_.dot(per_factor_);
    const Eigen::VectorXd full = rest + rise * per_factor_;
    good = std::isfinite(rise) && full.allFinite();
    if (!good) break;
    const auto go = [&](double share) { move(share * full, share * rise); };
    if (i == 0 && std::abs(missing) > 1e-9 * std::abs(push))  // moved, so that there is no residual to reduce yet
      go(1), merit = trial_.measure(inertia), least = merit, most = std::max(most, trial_.share());
    else
      good = search_along(trial_, full, inertia, enough, merit, go);
    good = good && std::isfinite(merit) && !goes_far(trial_.way_from_held(), most_share, most_rotation);
    since = merit < 0.25 * least || i == 0 ? 0 : since + 1;
    least = std::min(least, merit);
  }
  set_factor(begun);
  trial_.go_to_held();
  return false;
}

/// Rest after the followed displacement has moved by `push`. If there is none, or if it is too far to be accurate,
/// everything is restored. The laws keep the memories of the last point, so a joint slides as on the
/// straight way between both, whatever the search does in between. Where a part snaps, there is no such rest nearby:
/// `snaps` commits each step of pseudo-time, as a motion that a large inertia slows down.
template <int D>
bool LoadPathWalk<D>::search_rest(double push, bool snaps) {
  const double before = last_factor_;
  typename StaticTrial<D>::Begin begin = trial_.begin();
  double h = first_pseudo, left = push;
  bool cut = false, found = false;
  for (int steps = 0; steps < (snaps ? most_pseudo_steps : most_held_steps) && h > least_pseudo && !stopped() && !found;
       ++steps) {
    const int taken = out_.iterations;
    if (!pseudo_step(h, left)) {
      const double square = trial_.highest_square();
      h *= pseudo_cut, ++out_.cuts;
      if (!std::exchange(cut, true) && square > 0) h = std::min(h, pseudo_periods / std::sqrt(square));
      continue;
    }
    trial_.measure(0);
    if (goes_far(trial_.way_from(begin.state), most_of_search, most_rotation_of_search)) break;
    found = trial_.share() <= options_.tolerance;
    snaps ? trial_.accept() : trial_.hold_here();
    if (snaps) left = 0;
    h *= out_.iterations - taken <= easy_pseudo_iterations ? easy_growth : usual_growth;
  }
  out_.left = trial_.share(), out_.worst = trial_.worst();
  const bool good = found && (snaps ? !even_only_ || is_even() : !strays());
  if (good) return end_search(begin.state, snaps);
  set_factor(before);
  trial_.return_to(std::move(begin));
  return false;
}

/// True if the factor has changed by less than a step may miss: parts slide on at the same load.
template <int D>
bool LoadPathWalk<D>::is_even() const {
  return std::abs(factor_ - last_factor_) <= most_path_error * std::abs(last_factor_);
}

/// After a snap parts may slide on at the same load, where no search within one step converges. Then snaps of
/// increasing length follow each other, as long as the factor remains.
template <int D>
bool LoadPathWalk<D>::slide_on() {
  bool found = false;
  even_only_ = true;
  for (int i = 0; i < most_slides && snap_ != 0 && !found && !stopped(); ++i) {
    found = search_rest(snap_, true);
    if (!found) snap_ *= search_cut;
    if (found && i == 0) snap_ = std::copysign(std::min(growth_of_snap * std::abs(snap_), longest_), snap_);
  }
  even_only_ = false;
  if (!found) snap_ = 0;
  return found;
}

/// Makes the rest that a search has found the next point.
template <int D>
bool LoadPathWalk<D>::end_search(const State<D>& begin, bool snaps) {
  last_way_ = trial_.way_from(begin);
  last_rise_ = factor_ - last_factor_, last_factor_ = factor_, last_energy_ = 0;
  trial_.keep_carried();
  if (!snaps) trial_.accept();
  take_strength();
  ++(snaps ? out_.snaps : out_.searched);
  failed_searches_ = 0;
  return true;
}

/// The next point by a search for rest, if no arc of this size converges. The displacement continues in the sense of
/// the path's first step. Where no rest is found across any part of the step, the shortest one that ends at rest is
/// crossed as a snap.
template <int D>
bool LoadPathWalk<D>::search(double size) {
  if (options_.followed.empty()) return false;
  const int before = out_.iterations;
  double push = size;
  if (last_way_.size() > 0)
    push = std::copysign(std::abs(size) / length_of(last_way_) * followed_.dot(last_way_), options_.first);
  bool found = slide_on();
  for (int i = 0; i <= most_search_cuts && push != 0 && !found && !stopped(); ++i) {
    strayed_ = false, lenient_ = i == most_search_cuts;
    found = search_rest(push, false);
    if (!found && i < most_search_cuts) push *= strayed_ ? accuracy_cut_of_search : search_cut;
  }
  lenient_ = false;
  for (int i = 0; i <= most_search_cuts && push != 0 && !found && !stopped(); ++i) {
    found = search_rest(push, true);
    if (found) snap_ = growth_of_snap * push;
    push /= search_cut;
  }
  if (found) {
    taken_ = out_.iterations - before;
    return true;
  }
  failed_searches_ = std::min(failed_searches_ + 1, most_waits);
  next_search_ = static_cast<int>(out_.points.size()) + (1 << failed_searches_);
  return false;
}

template bool LoadPathWalk<2>::search_rest(double, bool);
template bool LoadPathWalk<3>::search_rest(double, bool);
template bool LoadPathWalk<2>::search(double);
template bool LoadPathWalk<3>::search(double);

}  // namespace trilith
