// Processing of a record before a run: baseline, filter, new step, rotation, and the scale factor for a spectrum. Each
// works on a motion as read. A scaled or delayed motion is rejected (InputError), so that its factor and delay remain
// valid for the record.
#pragma once

#include <span>
#include <utility>

#include "load/motion.hpp"

namespace trilith {

/// A pad or a step that would make more samples of a record than this is rejected (InputError).
inline constexpr double most_samples = 1e7;

/// Subtracts the polynomial of `degree` (0 to 10) that fits the acceleration best (least squares over the samples).
/// Needs more than `degree` + 1 samples.
GroundMotion baseline_corrected(const GroundMotion& motion, int degree);

/// Corners of a Butterworth filter [Hz]; 0: none on that side.
struct FilterBand {
  double low = 0;   ///< lower frequencies are removed (high-pass)
  double high = 0;  ///< higher frequencies are removed (low-pass)
  int order = 4;    ///< of each side, 1 to 10
  double pad = 0;   ///< zeros before and after the record, which remain [s]
};

/// Filters the record with a Butterworth filter forward and then backward in time, so that there is no phase shift. The
/// amplitude of both passes together is
///     1 / (1 + (sqrt(2) - 1) (w / w_c)^(2 n)),   w = tan(pi f dt),
/// (w_c / w for the low corner): 1/sqrt(2), or -3 dB, at the corner itself. Beyond the ends of the record the ground is
/// at rest. Corners must lie above 0, below half of the sampling rate, and low below high. A pad of 1.5 n / low on each
/// side lets the filter decay (D. M. Boore, BSSA 95, 2005); without it the result may end in motion.
GroundMotion filtered(const GroundMotion& motion, const FilterBand& band);

/// Samples at another step [s], linear between the samples of the record, as in the motion itself. For a longer step,
/// frequencies that it cannot represent are first removed by a low-pass of order 8 at 80 % of half its rate.
GroundMotion resampled(const GroundMotion& motion, double step);

/// The two horizontal components of one record along axes rotated by `angle` [rad]. The rotation is counter-clockwise
/// if `second` is a quarter turn counter-clockwise from `first`:
///     first' = first cos + second sin,  second' = -first sin + second cos.
/// Both must have the same step and number of samples.
std::pair<GroundMotion, GroundMotion> rotated(const GroundMotion& first, const GroundMotion& second, double angle);

/// One point of a target spectrum.
struct SpectrumPoint {
  double period = 0;        ///< [s]
  double acceleration = 0;  ///< pseudo-acceleration [m/s2], above 0
};

/// Factor for which `motion` has the pseudo-acceleration `target` [m/s2] at `period` [s].
double factor_to_spectrum(const GroundMotion& motion, SpectrumPoint target, double damping = 0.05);

/// Factor that fits the spectrum to the target's points: the mean of ln(target / Sa) over them is 0, which minimises
/// the sum of squared differences of the logarithms. Only the amplitude changes.
double factor_to_spectrum(const GroundMotion& motion, std::span<const SpectrumPoint> target, double damping = 0.05);

}  // namespace trilith
