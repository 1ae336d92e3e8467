// Named formats of ground motion files, and their recognition.
#pragma once

#include <string>
#include <string_view>

#include "load/motion.hpp"

namespace trilith {

/// A recognised format; false if there is none.
struct MotionFormat {
  std::string_view name;  ///< for messages: "a PEER AT2 file"
  std::string_view unit;  ///< of its samples: one of plain_units(); "" if the format is not read
  GroundMotion (*parse)(std::string_view text, const std::string& file) = nullptr;

  explicit operator bool() const { return parse != nullptr; }
};

/// Recognition by the content, or by the file extension if that belongs to one format alone. The formats are the
/// project's CSV ("# units:" and "# npts:"), PEER's AT2 ("NPTS" in the fourth line), ESM's ASCII
/// ("SAMPLING_INTERVAL_S:"), and K-NET ("Origin Time" first). Volumes of COSMOS, CSMIP, USGS and GeoNet (.V1, .V2) and
/// binary files are recognised and rejected by `parse`. They contain several blocks, and heads of bare numbers that
/// could be mistaken for samples.
MotionFormat named_format(std::string_view text, const std::string& file);

}  // namespace trilith
