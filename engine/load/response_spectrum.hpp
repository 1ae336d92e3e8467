// Elastic response of single oscillators on moving ground: the response spectrum.
#pragma once

#include <span>
#include <vector>

#include "load/motion.hpp"

namespace trilith {

/// The largest response of one damped oscillator to one ground motion.
struct OscillatorPeak {
  double period = 0;               ///< undamped natural period T [s]
  double damping = 0;              ///< ratio of critical, zeta
  double displacement = 0;         ///< largest displacement relative to the ground [m], above 0
  double time = 0;                 ///< time of the peak [s]
  double pseudo_velocity = 0;      ///< displacement times 2 pi / T [m/s]
  double pseudo_acceleration = 0;  ///< displacement times (2 pi / T)^2 [m/s2]
};

/// Response of x'' + 2 zeta w x' + w^2 x = -a(t), w = 2 pi / T, from x = x' = 0 at the first sample, by the exact
/// recurrence for piecewise linear excitation (Nigam and Jennings, BSSA 59, 1969). Sample intervals longer than T/20
/// are subdivided. The extreme inside a subinterval is the extreme of the cubic through displacement and velocity at
/// both ends (error below 1e-4 of the peak). The free vibration after the last sample (ground acceleration 0) is
/// computed for one period. T = 0 is the rigid oscillator: its pseudo-acceleration is the peak ground acceleration.
/// `period`: 0, or 0.001 s to 100 s; `damping`: 0 to below 1; otherwise InputError.
OscillatorPeak oscillator_peak(const GroundMotion& motion, double period, double damping);

/// The peaks for every period [s], in the order given.
std::vector<OscillatorPeak> response_spectrum(const GroundMotion& motion, std::span<const double> periods,
                                              double damping = 0.05);

/// `count` (2 or more) periods from `from` to `to` [s], evenly spaced in the logarithm.
std::vector<double> spectrum_periods(double from = 0.02, double to = 10, int count = 120);

}  // namespace trilith
