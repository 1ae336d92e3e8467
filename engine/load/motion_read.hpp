// Readers of ground motion files whose format has a name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// The largest peak [g] a record may have; recorded ground has stayed below 3 g, so above this the unit is wrong.
inline constexpr double largest_credible_peak = 5.0;
/// Limits of a record beyond which its step or its unit is wrong. Velocity and displacement are taken after the
/// parabola that fits the acceleration best is out of it, so that a raw record with an offset is read.
inline constexpr double least_credible_step = 1e-4;           // [s]
inline constexpr double largest_credible_step = 0.25;         // [s]
inline constexpr double largest_credible_duration = 7200;     // [s]
inline constexpr double largest_credible_velocity = 5;        // [m/s]; recorded ground has stayed below 4 m/s
inline constexpr double largest_credible_displacement = 100;  // [m]

/// Reads a ground motion file. The format is recognised by its content (motion_formats.hpp).
///
/// CSV: lines "# key: value" (units: g; dt: 0.02 s; npts: 2688; optional title, component, source agency,
/// v0: -4.664 cm/s, u0: 2.159 cm, pga, note), then one line "time_s,acceleration_g" per sample.
/// AT2 (PEER): 4 header lines, the third saying UNITS OF G, the fourth "NPTS= 5372, DT= .0100 SEC" or
/// "5372 0.0100 NPTS, DT", or the names in one line and the numbers in the next; then the samples [g], any number to a
/// line. ESM's ASCII form: lines "KEY: value" (SAMPLING_INTERVAL_S, NDATA, UNITS), then one sample [cm/s2] to a line.
/// K-NET's form: 17 lines of head (Sampling Freq(Hz), Scale Factor), then whole numbers, times the factor in gal.
///
/// Throws InputError with file and line for: a missing, empty or foreign file; fewer or more samples than announced;
/// not a number, NaN or infinity; dt not above 0; a time column that is not uniform; all samples zero; a unit other
/// than g; a peak above largest_credible_peak, or other than the one the header announces; a step, duration, velocity
/// or displacement beyond the other limits above.
GroundMotion read_motion(const std::filesystem::path& path);

/// The same from text in memory; `name` stands for the file in messages and in the motion's source.
GroundMotion parse_motion(std::string_view text, const std::string& name);

}  // namespace trilith
