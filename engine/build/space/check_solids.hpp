// Looks through the solids of a structure for what a run would stumble over.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// What may be wrong with a solid, from what no run can take to what one should look at.
enum class SolidFault {
  degenerate,        ///< no volume, faces of no area, corners that are not there or not finite
  open,              ///< edges that belong to one face only
  inverted,          ///< faces that run the wrong way, all or some
  hollow,            ///< not convex
  overlapping,       ///< shares volume with another
  sliver,            ///< very thin for its size, or with an edge that is next to nothing
  touching_nothing,  ///< no other part is within reach
  unchecked          ///< two solids of so many faces that their overlap was not looked for
};

/// "open", "touching nothing", ...
const char* name_of(SolidFault fault);

/// One thing found.
struct SolidFinding {
  SolidFault fault;
  int part;          ///< index
  int piece;         ///< of the part
  int other = -1;    ///< part that it overlaps, or -1
  double value = 0;  ///< of an overlap the shared volume, m3; of a sliver the thickness or length, m; of an open solid
                     ///< the number of edges; of a hollow one the depth, m
  bool repaired = false;
  std::string text;  ///< one line: whose, what, how much
};

/// What counts as a finding.
struct SolidCheck {
  bool repair = true;       ///< turn faces round that run the wrong way, with a finding that says so
  double flat = kFlatFace;  ///< a solid is hollow beyond this share of its size
  double overlap = 1e-9;    ///< shared volume over that of the smaller piece, from which on two overlap
  double sliver = 1e-3;  ///< mean thickness (twice the volume over the surface) over the size, below which a solid is
                         ///< a sliver
  double edge = 1e-6;    ///< shortest edge over the size, likewise
  double reach = 1e-6;   ///< distance over the size of the smaller piece, within which parts touch
  bool touching = true;  ///< look for parts that touch nothing, where there is more than one
};

/// Findings in the order of parts; overlaps between pieces of one part are found too. Pieces that are degenerate, open
/// or hollow are not looked at further. Time goes with the number of faces (times its logarithm) and with the pairs of
/// pieces whose boxes meet: 1e5 faces of bricks take about a second. Throws InputError for numbers out of range.
std::vector<SolidFinding> check_solids(std::vector<SolidPart>& parts, const SolidCheck& check = {});

}  // namespace trilith
