// What is done to a record before it shakes a model: baseline, filter, new step, rotation, and the scale that meets a
// spectrum. Each works on a motion as it was read: scale and delay it afterwards, or it is refused (InputError), so
// that factor and delay stay those of the record.
#pragma once

#include <span>
#include <utility>

#include "load/motion.hpp"

namespace trilith {

/// A pad or a step that would make more samples of a record than this is refused (InputError).
inline constexpr double most_samples = 1e7;

/// Takes the polynomial of `degree` (0 to 10) that fits the acceleration best (least squares over the samples) out of
/// it. Needs more than `degree` + 1 samples.
GroundMotion baseline_corrected(const GroundMotion& motion, int degree);

/// Corners of a Butterworth filter [Hz]; 0: none on that side.
struct FilterBand {
  double low = 0;   ///< what is slower is taken out (high-pass)
  double high = 0;  ///< what is faster is taken out (low-pass)
  int order = 4;    ///< of each side, 1 to 10
  double pad = 0;   ///< zeros that are set before and after the record and stay [s]
};

/// The record through a Butterworth filter forward and then backward in time, so that no phase is shifted. The
/// amplitude of both passes together is
///   1 / (1 + (sqrt(2) - 1) (w / w_c)^(2 n)),   w = tan(pi f dt),
/// (w_c / w for the low corner): 1/sqrt(2), which is -3 dB, at the corner itself. Beyond the ends of the record the
/// ground is taken to rest. Corners must lie above 0, below half the sampling rate, and low below high. A pad of 1.5 n
/// / low on each side lets the filter die out (D. M. Boore, BSSA 95, 2005); without it the result may end in motion.
GroundMotion filtered(const GroundMotion& motion, const FilterBand& band);

/// Samples at another step [s], linear between those of the record, as the motion itself is. Where the step becomes
/// longer, what the new one cannot hold is first taken out by a low-pass of order 8 at 80 % of half its rate.
GroundMotion resampled(const GroundMotion& motion, double step);

/// The two horizontal components of one record along axes that are turned by `angle` [rad], counter-clockwise where
/// `second` is a quarter of a turn that way from `first`:
///   first' = first cos + second sin,  second' = -first sin + second cos.
/// Both must have the same step and number of samples.
std::pair<GroundMotion, GroundMotion> rotated(const GroundMotion& first, const GroundMotion& second, double angle);

/// One point of a target spectrum.
struct SpectrumPoint {
  double period = 0;        ///< [s]
  double acceleration = 0;  ///< pseudo-acceleration [m/s2], above 0
};

/// Factor by which `motion` has pseudo-acceleration `target` [m/s2] at `period` [s].
double factor_to_spectrum(const GroundMotion& motion, SpectrumPoint target, double damping = 0.05);

/// Factor that brings the spectrum nearest to the target's points: the mean of ln(target / Sa) over them is 0, which
/// makes the sum of squared differences of the logarithms least. Nothing but the amplitude is changed.
double factor_to_spectrum(const GroundMotion& motion, std::span<const SpectrumPoint> target, double damping = 0.05);

}  // namespace trilith
