// Error of friction and yielding that reverse within an implicit step. A law is evaluated once per step, with the whole
// relative displacement. If a contact or a bearing moves on and then back, its force depends on both parts.
//
//       slip of the step                      force
//            . - ' - .   } back                    _______________   by the whole path
//         .            '                          /          . \     by both parts
//       '                                        /               \ .
#pragma once

#include "model/work.hpp"

namespace trilith {

/// The path of a slider along the step, in two parts [m] or [rad], and the duration of the second [s]; `back` and
/// `time_back` are 0 without a reversal.
struct Ways {
  double on = 0, back = 0, time_back = 0;
  /// From the final and the mean rate, with a rate that is linear over the step.
  Ways(double rate, double mean, double dt) : on(mean * dt) {
    const double first = 2 * mean - rate;
    if (first * rate >= 0) return;
    time_back = dt * rate / (rate - first);
    back = 0.5 * rate * time_back;
    on -= back;
  }
};

/// Work error of the forces of all contacts and bearings on the reversed paths, over the step of length `dt` that was
/// evaluated last [J].
double slip_reversal_error(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt);
double slip_reversal_error(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt);

/// Work error of the bearings alone [J].
template <int D>
double bearing_reversal_error(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt);

}  // namespace trilith
