// Line search of Newton's method for rest, used by statics/equilibrium.hpp and statics/load_path.hpp.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "statics/static_trial.hpp"

namespace trilith {

/// The line search ends if the work of the residual along the iteration is below this share of its initial value; it
/// makes at most this number of tries.
inline constexpr double work_left = 0.5;
inline constexpr int most_tries = 12;

/// Line search along `full` to a point at which the residual does about no work along it, where a potential, if it
/// exists, has its minimum. A residual that increases for an iteration, as when joints open, is harmless (Matthies and
/// Strang, "The solution of nonlinear finite element equations", Int. J. Numer. Meth. Engng 14, 1979, sec. 3). A loose
/// part may meet another one on the way. The work is then 0 at the first contact, which is located between a point
/// before and one beyond it, so that the next tangent contains the contact. False if there is no such point ahead.
/// `move(share)` moves the trial along `full` and evaluates it; `merit` becomes the sum of StaticTrial::measure.
template <int D, class Move>
bool search_along(StaticTrial<D>& trial, const Eigen::VectorXd& full, double inertia, double enough, double& merit,
                  Move&& move) {
  const double begin = trial.left().dot(full), little = work_left * std::abs(begin);
  double share = 1, before = 0, beyond = 0, work_before = begin, work_beyond = 0;
  double by = 1;
  for (int tries = 0;; ++tries) {
    move(by);
    merit = trial.measure(inertia);
    const double work = trial.left().dot(full);
    if (trial.share() <= enough || std::abs(work) <= little || (work > 0 && beyond == 0)) return true;
    if (tries == most_tries) return work > 0 || before > 0;
    work > 0 ? void((before = share, work_before = work)) : void((beyond = share, work_beyond = work));
    // Zero of the line through the work at both points, within bounds. The last try is a point before.
    const double part = std::clamp(work_before / (work_before - work_beyond), 0.1, 0.9);
    const double next = tries + 1 == most_tries && before > 0 ? before : before + part * (beyond - before);
    by = next - share;
    share = next;
  }
}

}  // namespace trilith
