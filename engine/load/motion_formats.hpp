// Formats of ground motion files that have a name, and how each is recognised.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A format that was recognised; false where none was.
struct MotionFormat {
  std::string_view name;  ///< for messages: "a PEER AT2 file"
  std::string_view unit;  ///< of its samples: one of plain_units(); "" where it is not read
  GroundMotion (*parse)(std::string_view text, const std::string& file) = nullptr;

  explicit operator bool() const { return parse != nullptr; }
};

/// By the content, or by the end of the file's name where that belongs to one format alone: the project's CSV ("#
/// units:" and "# npts:"), PEER's AT2 ("NPTS" in the fourth line), ESM's ASCII ("SAMPLING_INTERVAL_S:"), K-NET ("Origin
/// Time" first). Volumes of COSMOS, CSMIP, USGS and GeoNet (.V1, .V2) and binary files are recognised and refused by
/// `parse`: they hold several blocks, and heads of bare numbers that would pass for samples.
MotionFormat named_format(std::string_view text, const std::string& file);

}  // namespace trilith
