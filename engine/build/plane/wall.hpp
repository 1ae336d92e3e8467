// Walls of masonry from one description: storeys of courses in a bond, openings with lintels, slabs, a base.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// One storey: courses, and the slab on top of them.
struct WallStorey {
  int courses = 0;          ///< 0: as many as the height holds
  double height = 0;        ///< from the top of what is below to the top of its slab, m; 0: from the courses
  double slab_height = -1;  ///< m; 0: no slab; negative: the wall's slab_height
};

/// A door or window of one storey: a rectangle left empty.
struct WallOpening {
  int storey = 1;              ///< from 1 at the bottom
  double x = 0;                ///< left edge, m from the wall's left end
  double sill = 0;             ///< lower edge, m above the bottom of the storey's first course; on a course line
  double width = 0;            ///< m
  double height = 0;           ///< m; the head, sill + height, lies on a course line too
  bool lintel = true;          ///< with a block over the head; none is made where the courses end at the head
  double lintel_height = -1;   ///< m; negative: the wall's
  double lintel_bearing = -1;  ///< by which the lintel reaches over each side, m; negative: the wall's
  double sill_height = 0;      ///< of a block under the sill, m, whole courses; 0: none, units alone
  double sill_bearing = 0;     ///< by which that block reaches under each side, m
};

/// What is done with a unit that cutting leaves shorter than least_length.
enum class ShortPieces { merge, refuse };

/// A wall of rigid or deformable units. Joints have no thickness of their own: each unit reaches to the middle of its
/// joints, as in simplified micro-models of masonry (Lourenco 1996).
struct Wall {
  std::string name = {};
  Vec2 at = Vec2::Zero();                ///< lower left corner of the first course, m
  double length = 0;                     ///< m; 0: from `units`
  int units = 0;                         ///< whole units in a course of stretchers; used where length is 0
  double unit_length = 0.4;              ///< of a stretcher without joint, m
  double unit_height = 0.2;              ///< without joint, m
  double header_length = 0;              ///< of a header without joint, m; 0: as half a stretcher with joint
  double head_joint = 0;                 ///< thickness added to the units' length, m
  double bed_joint = 0;                  ///< thickness added to the units' height, m
  std::string bond = "running";          ///< see bond_patterns()
  int first_row = 1;                     ///< which course of the bond's pattern each storey begins with
  std::vector<WallStorey> storeys = {};  ///< from the bottom up, at least one
  double slab_height = 0;                ///< of every storey that says nothing else, m; 0: no slabs
  double slab_overhang = 0;              ///< by which slabs reach beyond both ends, m
  double base_height = 0;                ///< of the block under the wall, m; 0: no base
  double base_margin = 0;                ///< by which it reaches beyond both ends, m
  std::vector<WallOpening> openings = {};
  double lintel_height = 0;   ///< m, whole courses; 0: one course
  double lintel_bearing = 0;  ///< m; 0: half a unit
  double least_length = 0;    ///< shortest unit that cutting may leave, m; 0: a quarter of a unit or half a header
  ShortPieces short_pieces = ShortPieces::merge;
  bool snap = false;  ///< sills and heads off the course lines are moved to the nearest one, with a note
  double jitter = 0;  ///< every head joint is moved along its course by up to this much, m, below a quarter of
                      ///< least_length; neighbours keep sharing their face
  int seed = 1;       ///< of the jitter: the same number gives the same bits everywhere
};

/// Parts of a wall, and what was changed of the description, one line each.
struct WallParts {
  std::vector<Part> parts;
  std::vector<std::string> notes;
};

/// Parts from the bottom up, left to right. "base" (group "base"); for storey 2 "s2.c5.u3" (third unit of its fifth
/// course; groups "units", "storey 2", "course 5"), "s2.lintel1" and "s2.sill1" after the units of their lowest
/// course ("lintels" or "sills", "storey 2", their courses), "s2.slab" ("slabs", "storey 2"). Where a storey has
/// openings, its units, lintels and sills are also in "piers" and "pier k" (beside openings) or "spandrels" and
/// "spandrel k" (their middle above or below an opening), k counted from the left. All names begin with the wall's, and
/// all parts are in the group of the wall's name, where it has one.
///
/// Parts that meet share their corners' coordinates to the bit; there is no overlap and no gap. Units are cut at the
/// edges of openings, lintels and sills and at the right end of the wall. Throws InputError, with place, value and what
/// is allowed, for sizes out of range, heights that are no whole number of courses, openings outside the storey, on
/// each other, off the course lines or whose lintels do not lie on masonry, and pieces that stay too short.
WallParts build_wall(const Wall& wall);

}  // namespace trilith
