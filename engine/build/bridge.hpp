// The rigid pieces of a simple-span bridge seen from the side: piers, abutments and spans.
#pragma once

#include <string>
#include <vector>

#include "build/part.hpp"

namespace trilith {

/// A pier of footing, stem and head, one rigid body symmetric about its middle line.
struct Pier {
  std::string name = "pier";
  double x = 0;                  ///< middle line, m
  double ground_level = 0;       ///< y of the footing's underside, m
  double height = 0;             ///< from there to the seat, m
  double stem_width = 0;         ///< m
  double top_width = 0;          ///< of the seat, m; 0: the stem's
  double cap_thickness = 0;      ///< height of the cap, m; 0: no cap, the stem tapers evenly to the top width
  double footing_width = 0;      ///< m; 0: no footing
  double footing_thickness = 0;  ///< m, above 0 where there is a footing
};

/// One part, group "piers". The outline begins at the lower left corner of the footing (of the stem where there is
/// none). Throws InputError for sizes not above 0, a footing narrower than the stem, or a height that leaves no stem.
Part build_pier(const Pier& pier);

/// Side of the bridge an abutment stands at.
enum class AbutmentSide { left, right };

/// A stub abutment: a block whose seat carries the end of a span, with or without a back wall behind the deck's end.
struct Abutment {
  std::string name = "abutment";
  AbutmentSide side = AbutmentSide::left;
  double x = 0;                 ///< of the front face, towards the span, m
  double ground_level = 0;      ///< y of the underside, m
  double height = 0;            ///< from there to the seat, m
  double width = 0;             ///< from the front face away from the bridge, m
  double back_wall_height = 0;  ///< above the seat, m; 0: no back wall
  double back_wall_width = 0;   ///< m, below `width`: the seat is as long as the rest
};

/// One part, group "abutments": a rectangle or an L whose seat lies at the front. Left and right are mirror images.
/// Throws InputError for sizes not above 0 or a back wall that leaves no seat.
Part build_abutment(const Abutment& abutment);

/// A deck between two supports.
struct Span {
  std::string name = "span";
  double x0 = 0, x1 = 0;    ///< left and right end of the opening it fills, m
  double end_gap = 0;       ///< kept free at each of the two ends, m: half the joint between two decks
  double soffit_level = 0;  ///< y of the underside, m
  double depth = 0;         ///< m
};

/// One rectangle, group "spans", from x0 + end_gap to x1 - end_gap. Throws InputError where no length is left or the
/// depth is not above 0.
Part build_span(const Span& span);

}  // namespace trilith
