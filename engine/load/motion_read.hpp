// Readers of ground motion files: the project's CSV and PEER's AT2.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// The largest peak [g] a record may have; recorded ground has stayed below 3 g, so above this the unit is wrong.
inline constexpr double largest_credible_peak = 5.0;

/// Reads a ground motion file. The form is told from the content ('#' first: CSV; "NPTS" in line 4: AT2).
///
/// CSV: lines "# key: value" (units: g; dt: 0.02 s; npts: 2688; optional title, component, source agency,
/// v0: -4.664 cm/s, u0: 2.159 cm, pga, note), then one line "time_s,acceleration_g" per sample.
/// AT2 (PEER): 4 header lines, the third saying UNITS OF G, the fourth "NPTS= 5372, DT= .0100 SEC" or
/// "5372 0.0100 NPTS, DT"; then the samples [g], any number to a line.
///
/// Throws InputError with file and line for: a missing, empty or foreign file; fewer or more samples than announced;
/// not a number, NaN or infinity; dt not above 0; a time column that is not uniform; all samples zero; a unit other
/// than g; a peak above largest_credible_peak, or other than the one the header announces.
GroundMotion read_motion(const std::filesystem::path& path);

/// The same from text in memory; `name` stands for the file in messages and in the motion's source.
GroundMotion parse_motion(std::string_view text, const std::string& name);

}  // namespace trilith
