// Masonry in space: a wall with a thickness, and buildings of walls whose corners and junctions interlock.
//
//       odd courses              even courses          Seen from above. Where walls meet, the walls along x run through
//       in
//    ___________________       __ ________________     odd courses and those along y in even ones; the others stop at
//   |____|____|____|____|     |  |____|____|____|  |   their faces. So a corner is toothed from bottom to top, and so
//   is |  |             |  |     |  |             |  |    a wall that meets another in its middle. |  |             |
//   |     |__|             |__|
//   |__|             |__|     |  |             |  |    A wall that runs through begins its bond with a whole unit, one
//   |  |             |  |     |  |             |  |    that stops has its joints over the middle of those units: with
//   |__|             |__|     |__|             |__|    units half as thick as long it begins with a whole one too.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// A bond with a thickness: the units of its two courses in letters, S a stretcher (along the wall; `leaves` of them
/// side by side make the thickness), H a header (through the wall).
struct LeafBond {
  std::string_view name, sentence;
  std::string_view first, second;  ///< over and over again, from the start of the wall
  double shift_units;              ///< of the second course's first joint, in stretchers ...
  double shift_headers;            ///< ... and headers
  int leaves;
};

/// Every bond that walls with a thickness know.
std::span<const LeafBond> leaf_bonds();

/// What the walls of one structure have in common. Joints have no thickness of their own: each unit reaches to the
/// middle of its joints, as in simplified micro-models of masonry (Lourenco 1996).
struct Masonry {
  double unit_length = 0.4;        ///< of a stretcher with its joint, m
  double unit_height = 0.2;        ///< of a course, m
  double header_length = 0;        ///< of a header along the wall, m; 0: half a stretcher
  std::string bond = "stretcher";  ///< see leaf_bonds(): stretcher, header, english, flemish
  double lintel_height = 0;        ///< m, whole courses; 0: one course
  double lintel_bearing = 0;       ///< m; 0: half a unit
  double least_length = 0;   ///< pieces that cutting leaves shorter join the unit beside them, with a note, m; 0: a
                             ///< fifth of a unit
  bool snap = false;         ///< sills and heads off the course lines are moved to the nearest one, with a note
  double slab_height = 0;    ///< of floors of storeys that say nothing else, m; 0: none
  double slab_overhang = 0;  ///< by which floors reach beyond the walls, m
  double base_height = 0;    ///< of the block under the walls, m; 0: none
  double base_margin = 0;    ///< by which it reaches beyond them, m
};

/// A row of floor beams: boxes side by side that end in pockets of two walls across them, and go through what walls
/// stand between. Their tops are those of the storey's courses.
struct BeamRow {
  bool along_y = false;  ///< they span along y, not x
  int count = 0;         ///< 0: as many as the spacing holds
  double spacing = 0;    ///< centre to centre, m; 0: the room between the walls beside them, shared out evenly
  double width = 0;      ///< m, above 0
  double height = 0;     ///< m, whole courses; 0: one course
  std::optional<double> bearing = {};      ///< how far they reach into the walls they end in, m; none: through them
  std::optional<Vec2> from = {}, to = {};  ///< opposite corners of the part of the plan they lie in, m; none: its own
};

/// One storey: courses, and the floor on top of them or in them.
struct MasonryStorey {
  int courses = 0;                                 ///< 0: as many as the height holds
  double height = 0;                               ///< to the top of its floor, m; used where courses is 0
  double slab_height = -1;                         ///< m; 0: no floor; negative: that of the masonry
  std::optional<std::vector<BeamRow>> beams = {};  ///< empty: no beams; none: those of the building
};

/// A door or window: a box left empty.
struct MasonryOpening {
  int storey = 1;              ///< from 1 at the bottom
  double from = 0;             ///< near edge, m from the start of the wall's line
  double sill = 0;             ///< lower edge, m above the bottom of the storey's first course; on a course line
  double width = 0;            ///< m
  double height = 0;           ///< m; the head, sill + height, lies on a course line too
  bool lintel = true;          ///< with a block over the head; none is made where the courses end at the head
  double lintel_height = -1;   ///< m; negative: the masonry's
  double lintel_bearing = -1;  ///< by which the lintel reaches over each side, m; negative: the masonry's
};

/// One wall of a plan: a line along x or y, the middle of its thickness. An end that lies in another wall's thickness
/// reaches to the far face of that wall; a free end ends where it is.
struct PlanWall {
  std::string name = {};                          ///< "": "w1", "w2", ... by its place in the list
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< m
  double thickness = 0;                           ///< m; 0: half a unit's length, or a unit's for bonds with headers
  std::string bond = {};                          ///< "": the masonry's
  std::vector<MasonryOpening> openings = {};
};

/// A plan of walls, storey upon storey.
struct Building {
  std::string name = {};
  std::vector<PlanWall> walls = {};         ///< 1 to 1000
  std::vector<MasonryStorey> storeys = {};  ///< from the bottom up, at least one
  std::vector<BeamRow> beams = {};          ///< of floors of storeys that say nothing else
  Masonry masonry = {};
  bool first_along_y = false;  ///< in odd courses the walls along y run through, not those along x
  Polygon slab_outline = {};   ///< of floors, simple, m; empty: the rectangle around all walls, with the overhang
  Vec3 at = Vec3::Zero();      ///< where the plan's origin is, m
  double angle = 0;            ///< of the plan about z through its origin, counter-clockwise, rad
};

/// Parts from the bottom up: "base" (group "base"); for wall "w1" in storey 2 "w1.s2.c5.u3" (third unit of its fifth
/// course, counted in the direction of x or y; of two leaves "u3a" and "u3b"; groups "units", "storey 2", "course 5"),
/// "w1.s2.lintel1" ("lintels"); "s2.beam3" ("beams", "floors"), counted row by row towards x or y; "s2.floor"
/// ("floors"), one solid for each storey that lies on all walls and beams. Parts of a wall are in the group of its
/// name, all parts in that of the building's, where it has one. Pockets are as wide and high as their beams; what is
/// behind a beam's end is filled, a unit for each course. Units that meet share the coordinates of their faces to the
/// bit. Throws InputError, with place, value and what is allowed: lines that are not along x or y, walls along each
/// other that share room, sizes out of range, heights that are no whole number of courses, openings off the course
/// lines, outside of their wall, in a junction, on each other or next to less masonry than the least length; beams that
/// find no two walls to end in, lie in a wall along them, in a junction, on each other, on openings or lintels or over
/// an opening without one, or leave short pieces beside or behind them.
SolidParts build_building(const Building& building);

/// One wall with a thickness.
struct SolidWall {
  std::string name = {};
  double length = 0;                        ///< along x, m, above 0
  double thickness = 0;                     ///< along y, m; 0: half a unit's length, or a unit's for bonds with headers
  std::vector<MasonryStorey> storeys = {};  ///< from the bottom up, at least one
  Masonry masonry = {};
  std::vector<MasonryOpening> openings = {};  ///< from the left end
  Vec3 at = Vec3::Zero();                     ///< lower left corner of its front, m
  double angle = 0;                           ///< about z through that corner, counter-clockwise, rad
};

/// As a building of one wall, whose front is the plane y = 0; names without the wall's in the middle: "s1.c5.u3".
SolidParts build_solid_wall(const SolidWall& wall);

}  // namespace trilith
