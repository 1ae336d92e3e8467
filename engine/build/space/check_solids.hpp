// Checks the solids of a structure for defects that would disturb a run.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Defects of a solid, from errors that no run accepts to warnings.
enum class SolidFault {
  degenerate,        ///< no volume, faces without area, corners that are missing or not finite
  open,              ///< edges that belong to only one face
  inverted,          ///< inverted faces, all or some
  hollow,            ///< not convex
  overlapping,       ///< volume shared with another solid
  sliver,            ///< very thin for its size, or with a very short edge
  touching_nothing,  ///< no other part within reach
  unchecked          ///< two solids with too many faces for the overlap check
};

/// "open", "touching nothing", ...
const char* name_of(SolidFault fault);

/// One thing found.
struct SolidFinding {
  SolidFault fault;
  int part;          ///< index
  int piece;         ///< of the part
  int other = -1;    ///< part that it overlaps, or -1
  double value = 0;  ///< of an overlap the shared volume [m3]; of a sliver the thickness or length [m]; of an open
                     ///< solid the number of edges; of a hollow one the depth [m]
  bool repaired = false;
  std::string text;  ///< one line: solid, defect, value
};

/// Options and limits of the check.
struct SolidCheck {
  bool repair = true;       ///< reverse inverted faces, with a finding
  double flat = kFlatFace;  ///< a solid is hollow beyond this share of its size
  double overlap = 1e-9;    ///< shared volume over the volume of the smaller piece, above which two overlap
  double sliver = 1e-3;  ///< mean thickness (twice the volume over the surface) over the size, below which a solid is a
                         ///< sliver
  double edge = 1e-6;    ///< shortest edge over the size, below which a solid is a sliver
  double reach = 1e-6;   ///< distance over the size of the smaller piece within which parts touch
  bool touching = true;  ///< search for parts without contact, if there is more than one part
};

/// Findings in the order of parts, including overlaps between pieces of one part. Pieces that are degenerate, open or
/// hollow are not checked further. The run time grows with the number of faces (times its logarithm) and of pairs of
/// pieces with overlapping AABBs: 1e5 faces of bricks take about 1 s. Throws InputError for numbers out of range.
std::vector<SolidFinding> check_solids(std::vector<SolidPart>& parts, const SolidCheck& check = {});

}  // namespace trilith
