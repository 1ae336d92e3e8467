// Class of a crack by its opening and slip.
#pragma once

#include <cmath>

#include "draw/scene/scene_picture.hpp"

namespace trilith::draw {

/// `opening`, `slip` in m, the slip of either sign.
inline CrackMark crack_mark(double opening, double slip) {
  if (opening < std::abs(slip)) return CrackMark::slid;
  if (opening <= fine_crack) return CrackMark::fine;
  return opening <= wide_crack ? CrackMark::opened : CrackMark::wide;
}

}  // namespace trilith::draw
