// Error control of load paths through contacts: how far a step leaves the path.
//
// A step is solved at its end only. Along the straight way to it the joints that open, close or slide within the step
// leave a residual, whose work is missing in the balance of the step:
//
//     error = 3/8 (|r(1/3) . d| + |r(2/3) . d|) / (largest load so far max(|d|, part of the first step))
//
// with the way d and the residual r at its thirds, where the factor is interpolated too (Simpson's second rule; the
// residual is 0 at both ends). It is the mean deviation of the force from the chord between both points, as a share of
// the largest force, and decreases with the square of the step. The slip of a joint depends on the way to it, so a step
// that passes too much of the path at once also ends at another point.
#include <algorithm>
#include <cmath>
#include <utility>

#include "statics/load_path_walk.hpp"

namespace trilith {
namespace {

/// The next step is this share of the step that the estimate permits; its change is limited.
constexpr double share_of_permitted = 0.9, least_accurate = 0.25, most_accurate = 4;
/// Steps are not shortened below this share of the first one. There the law itself jumps.
constexpr double least_for_accuracy = 1.0 / 64;
/// Steps shorter than this share of the first one may miss as much work as one of this length, as they add little to
/// the work of the path.
constexpr double share_of_first = 1.0 / 8;
/// A shorter step whose error is above this share of the longer one's crosses a jump of the path, which no step length
/// resolves. On a path with kinks the error is proportional to the step, on a smooth path to its square.
constexpr double share_at_jump = 0.7;

}  // namespace

/// Arcs and searches of structures of several bodies are judged, as contacts make a path depend on its steps.
template <int D>
bool LoadPathWalk<D>::is_judged() const {
  return options_.control == PathControl::arc && control_ == PathControl::arc && loaded_.bodies.size() > 1;
}

/// The error of the present step, see above. The trial is restored.
template <int D>
double LoadPathWalk<D>::mean_error() {
  const Eigen::VectorXd way = trial_.way();
  const double rise = factor_ - last_factor_, end = factor_;
  double sum = 0;
  for (const double share : {1.0 / 3, 2.0 / 3}) {
    try_at(way, rise, share);
    trial_.measure(0);
    sum += std::abs(trial_.left().dot(way));
  }
  try_at(way, rise, 1);
  double most = std::abs(end);
  for (const PathPoint& p : out_.points) most = std::max(most, std::abs(p.factor));
  const double way_length = std::max(std::abs(followed_.dot(way)), length_of(way));
  return 0.375 * sum / (most * std::max(way_length, share_of_first * std::abs(options_.first)));
}

/// True if the step is too long for its accuracy and can be shortened. `accurate_` becomes the permitted length. A step
/// that cannot adds to the missed work.
template <int D>
bool LoadPathWalk<D>::strays() {
  if (!is_judged()) return false;
  const double error = mean_error(), length = length_of(trial_.way());
  const double permitted = share_of_permitted * std::sqrt(most_path_error / std::max(error, 1e-300));
  if (!std::isfinite(error)) return false;
  const bool jumps = error > share_at_jump * std::exchange(last_error_, error);
  const double least = least_for_accuracy * std::abs(options_.first);
  accurate_ = std::max(least, length * std::clamp(permitted, least_accurate, most_accurate));
  strayed_ = error > most_path_error && length > least && !jumps && !lenient_;
  if (strayed_) return true;
  if (jumps) accurate_ = most_accurate * length;
  if (error > most_path_error) out_.missed += error * length;
  return false;
}

template bool LoadPathWalk<2>::strays();
template bool LoadPathWalk<3>::strays();

}  // namespace trilith
