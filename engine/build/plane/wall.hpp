// Walls of masonry from one description: storeys of courses in a bond, openings with lintels, slabs, a base.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// One storey: courses, and the slab on top of them.
struct WallStorey {
  int courses = 0;          ///< 0: as many as the height contains
  double height = 0;        ///< from the top of the part below to the top of its slab [m]; 0: determined by the courses
  double slab_height = -1;  ///< [m]; 0: no slab; negative: the wall's slab_height
};

/// A door or window of one storey: an empty rectangle.
struct WallOpening {
  int storey = 1;              ///< from 1 at the bottom
  double x = 0;                ///< left edge, m from the wall's left end
  double sill = 0;             ///< lower edge, m above the bottom of the storey's first course; on a course line
  double width = 0;            ///< [m]
  double height = 0;           ///< [m]; the head, sill + height, lies on a course line too
  bool lintel = true;          ///< with a block over the head; none is made if the courses end at the head
  double lintel_height = -1;   ///< [m]; negative: the wall's
  double lintel_bearing = -1;  ///< overlap of the lintel on each side [m]; negative: the wall's
  double sill_height = 0;      ///< of a block below the sill [m], whole courses; 0: none, units only
  double sill_bearing = 0;     ///< overlap of that block on each side [m]
};

/// Treatment of a cut unit that is shorter than least_length.
enum class ShortPieces { merge, refuse };

/// A wall of rigid or deformable units. Joints have no thickness: each unit extends to the middle of its joints, as in
/// simplified micro-models of masonry (Lourenco 1996).
struct Wall {
  std::string name = {};
  Vec2 at = Vec2::Zero();                ///< lower left corner of the first course [m]
  double length = 0;                     ///< [m]; 0: from `units`
  int units = 0;                         ///< whole units in a course of stretchers; used where length is 0
  double unit_length = 0.4;              ///< of a stretcher without joint [m]
  double unit_height = 0.2;              ///< without joint [m]
  double header_length = 0;              ///< of a header without joint [m]; 0: as half a stretcher with joint
  double head_joint = 0;                 ///< thickness added to the units' length [m]
  double bed_joint = 0;                  ///< thickness added to the units' height [m]
  std::string bond = "running";          ///< see bond_patterns()
  int first_row = 1;                     ///< course of the bond's pattern at which each storey begins
  std::vector<WallStorey> storeys = {};  ///< from the bottom up, at least one
  double slab_height = 0;                ///< default for all storeys [m]; 0: no slabs
  double slab_overhang = 0;              ///< by which slabs extend beyond both ends [m]
  double base_height = 0;                ///< of the block below the wall [m]; 0: no base
  double base_margin = 0;                ///< by which it extends beyond both ends [m]
  std::vector<WallOpening> openings = {};
  double lintel_height = 0;   ///< [m], whole courses; 0: one course
  double lintel_bearing = 0;  ///< [m]; 0: half a unit
  double least_length = 0;    ///< least length of a cut unit [m]; 0: a quarter of a unit or half of a header
  ShortPieces short_pieces = ShortPieces::merge;
  bool snap = false;  ///< sills and heads off the course lines are moved to the nearest one, with a note
  double jitter = 0;  ///< every head joint is moved along its course by up to this distance [m], below a quarter of
                      ///< least_length; neighbours still share their face
  int seed = 1;       ///< seed of the jitter: the same number gives the same bits everywhere
};

/// Parts of a wall, and the changes to its description, one line each.
struct WallParts {
  std::vector<Part> parts;
  std::vector<std::string> notes;
};

/// Parts from the bottom up, left to right. Names and groups in storey 2:
///   - "base": group "base".
///   - "s2.c5.u3" (third unit of its fifth course): groups "units", "storey 2", "course 5".
///   - "s2.lintel1" and "s2.sill1", after the units of their lowest course: "lintels" or "sills", "storey 2" and
///     their courses.
///   - "s2.slab": "slabs", "storey 2".
/// In a storey with openings, its units, lintels and sills are also in "piers" and "pier k" (next to openings) or
/// "spandrels" and "spandrel k" (with their middle above or below an opening), k counted from the left. All names begin
/// with the wall's name, and all parts are in the group of this name, if it has one.
///
/// Parts that meet share their corner coordinates to the bit, without overlap or gap. Units are cut at the edges of
/// openings, lintels and sills and at the right end of the wall. Throws InputError, with place, value and allowed
/// range, for sizes out of range and heights that are no whole number of courses. It also throws for openings outside
/// the storey, overlapping, or off the course lines, for lintels without masonry below their ends, and for pieces that
/// remain too short.
WallParts build_wall(const Wall& wall);

}  // namespace trilith
