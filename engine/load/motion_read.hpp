// Readers of ground motion files with a named format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// The largest peak [g] a record may have; recorded ground has stayed below 3 g, so above this the unit is wrong.
inline constexpr double largest_credible_peak = 5.0;
/// Limits of a record beyond which its step or its unit is wrong. Velocity and displacement are computed after
/// subtraction of the parabola that fits the acceleration best, so that a raw record with an offset is accepted.
inline constexpr double least_credible_step = 1e-4;           // [s]
inline constexpr double largest_credible_step = 0.25;         // [s]
inline constexpr double largest_credible_duration = 7200;     // [s]
inline constexpr double largest_credible_velocity = 5;        // [m/s]; recorded ground has stayed below 4 m/s
inline constexpr double largest_credible_displacement = 100;  // [m]

/// Reads a ground motion file. The format is recognised by its content (motion_formats.hpp).
///
/// CSV: lines "# key: value" (units: g; dt: 0.02 s; npts: 2688; optional title, component, source agency, v0: -4.664
/// cm/s, u0: 2.159 cm, pga, note), then one line "time_s,acceleration_g" per sample.
///
/// AT2 (PEER): 4 header lines, the third with UNITS OF G, the fourth `NPTS= 5372, DT= 0.0100 SEC` or `5372 0.0100 NPTS,
/// DT`, or the names in one line and the numbers in the next. Then the samples [g], any number per line.
///
/// ESM's ASCII form: lines "KEY: value" (SAMPLING_INTERVAL_S, NDATA, UNITS), then one sample [cm/s2] per line.
///
/// K-NET's form: 17 lines of head (Sampling Freq(Hz), Scale Factor), then integers, times the factor in gal.
///
/// Throws InputError with file and line for:
///   - a missing, empty or unknown file.
///   - fewer or more samples than announced, and text, NaN or infinity as a number.
///   - dt not above 0, and a time column that is not uniform.
///   - samples that are all zero, and a unit other than g.
///   - a peak above largest_credible_peak, or different from the peak in the header.
///   - a step, duration, velocity or displacement beyond the other limits above.
GroundMotion read_motion(const std::filesystem::path& path);

/// Reads text in memory; `name` is the file name in messages and in the motion's source.
GroundMotion parse_motion(std::string_view text, const std::string& name);

}  // namespace trilith
