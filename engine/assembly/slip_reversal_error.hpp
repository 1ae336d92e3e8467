// Friction and yielding that turned back within an implicit step. A law is asked once for a step, by the whole way that
// was gone along it; where a contact or a bearing went on and then back, its force depends on both:
//
//       slip of the step                      force
//            . - ' - .   } back                    _______________   by the whole way
//         .            '                          /          . \     by both ways
//       '                                        /               \ .
#pragma once

#include "model/work.hpp"

namespace trilith {

/// The way of a slider along the step, in two parts [m] or [rad], and how long the second took [s]; both are 0 where it
/// did not turn.
struct Ways {
  double on = 0, back = 0, time_back = 0;
  /// By its rates at the end and in the mean, taken to be linear over the step.
  Ways(double rate, double mean, double dt) : on(mean * dt) {
    const double first = 2 * mean - rate;
    if (first * rate >= 0) return;
    time_back = dt * rate / (rate - first);
    back = 0.5 * rate * time_back;
    on -= back;
  }
};

/// Work that the forces of all contacts and bearings are out by on the ways back, over the step of length `dt` that was
/// evaluated last [J].
double slip_reversal_error(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt);
double slip_reversal_error(const Model<3>& model, const State<3>& state, const Work<3>& work, double dt);

/// The same of the bearings alone.
template <int D>
double bearing_reversal_error(const Model<D>& model, const State<D>& state, const Work<D>& work, double dt);

}  // namespace trilith
