// Bodies that crack on a load path. A step ends before a section exceeds its strength, so that the body is divided
// while the joint of its parts is still elastic. The path then goes on from the same displacement.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "statics/load_path_walk.hpp"

namespace trilith {
namespace {

/// Steps aim at this share of the strength, the middle of the shares at which bodies are divided.
constexpr double aimed_share = 0.5 * (1 + share_at_crack);
/// Steps below this share of the first one are not shortened: there the use of the strength itself jumps.
constexpr double least_to_strength = 1e-4;
/// Length of the first step after a crack, as a share of the first one: far below the rest of the strength.
constexpr double elastic_step = 1e-3;
/// Limits of the length of a shortened step, as a share of it.
constexpr double least_shortened = 0.05, most_shortened = 0.95;

}  // namespace

/// Stores the use of strengths at the last evaluated position.
template <int D>
void LoadPathWalk<D>::take_strength() {
  if (options_.strength_used) used_ = options_.strength_used(loaded_, trial_.state(), trial_.work());
}

/// True if the step ends beyond the strength of a section and can be shortened. `to_strength_` becomes the length at
/// which the strength is reached if its use is linear over the step: of this step, or of the next one.
template <int D>
bool LoadPathWalk<D>::overshoots() {
  if (!options_.strength_used) return false;
  const double before = used_, length = length_of(trial_.way()), least = least_to_strength * std::abs(options_.first);
  take_strength();
  const double rise = used_ - before;
  overshot_ = used_ > 1 && length > least;
  if (overshot_) {
    to_strength_ = length * std::clamp((aimed_share - before) / rise, least_shortened, most_shortened);
    used_ = before;
    return true;
  }
  const bool nears = length > least && rise > 0 && used_ < aimed_share;
  to_strength_ =
      nears ? std::max(least, length * (aimed_share - used_) / rise) : std::numeric_limits<double>::infinity();
  return false;
}

template <int D>
bool LoadPathWalk<D>::find_again() {
  if (options_.followed.empty()) return false;
  const Eigen::VectorXd way = last_way_;
  const double rise = last_rise_;
  control_ = PathControl::displacement;
  bool found = step(0);
  control_ = options_.control;
  found = found || search_rest(0, false) || search_rest(0, true);
  last_way_ = way, last_rise_ = rise, last_energy_ = 0;
  // The given displacement does not open the new joints. A short elastic step has the direction that does.
  if (found && way.size() > 0) step(elastic_step * options_.first);
  return found;
}

template bool LoadPathWalk<2>::overshoots();
template bool LoadPathWalk<3>::overshoots();
template void LoadPathWalk<2>::take_strength();
template void LoadPathWalk<3>::take_strength();
template bool LoadPathWalk<2>::find_again();
template bool LoadPathWalk<3>::find_again();

}  // namespace trilith
