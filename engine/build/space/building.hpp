// Masonry in space: a wall with a thickness, and buildings of walls with interlocking corners and junctions.
//
//        odd courses              even courses          Plan view. Where walls meet, the walls along x run through
//     ___________________       __ ________________     in odd courses and the walls along y in even ones; the
//    |____|____|____|____|     |  |____|____|____|  |   others stop at their faces. So corners are toothed over
//    |  |             |  |     |  |             |  |    the whole height, and so are T junctions.
//    |__|             |__|     |__|             |__|
//    |  |             |  |     |  |             |  |    A wall that runs through begins its bond with a whole
//    |__|             |__|     |__|             |__|    unit. A wall that stops has its joints over the middle
//                                                       of those units; with units half as thick as long it
//                                                       begins with a whole unit too.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// A bond with a thickness: the units of its two courses in letters, S a stretcher (along the wall; `leaves` of them
/// next to each other form the thickness), H a header (through the wall).
struct LeafBond {
  std::string_view name, sentence;
  std::string_view first, second;  ///< repeated from the start of the wall
  double shift_units;              ///< offset of the second course's first joint, in stretchers ...
  double shift_headers;            ///< ... and headers
  int leaves;
};

/// All bonds of walls with a thickness.
std::span<const LeafBond> leaf_bonds();

/// Common data of the walls of a structure. Joints have no thickness: each unit extends to the middle of its joints, as
/// in simplified micro-models of masonry (Lourenco 1996).
struct Masonry {
  double unit_length = 0.4;        ///< of a stretcher with its joint [m]
  double unit_height = 0.2;        ///< of a course [m]
  double header_length = 0;        ///< of a header along the wall [m]; 0: half a stretcher
  std::string bond = "stretcher";  ///< see leaf_bonds(): stretcher, header, english, flemish
  double lintel_height = 0;        ///< [m], whole courses; 0: one course
  double lintel_bearing = 0;       ///< [m]; 0: half a unit
  double least_length = 0;   ///< cut pieces shorter than this join the neighbouring unit, with a note [m]; 0: a fifth
                             ///< of a unit
  bool snap = false;         ///< sills and heads off the course lines are moved to the nearest one, with a note
  double slab_height = 0;    ///< default floor thickness of all storeys [m]; 0: none
  double slab_overhang = 0;  ///< by which floors extend beyond the walls [m]
  double base_height = 0;    ///< of the block below the walls [m]; 0: none
  double base_margin = 0;    ///< by which it extends beyond the walls [m]
};

/// A row of floor beams: parallel boxes that end in pockets of two walls across them, and pass through walls in
/// between. Their tops are level with the top of the storey's courses.
struct BeamRow {
  bool along_y = false;                    ///< they span along y, not x
  int count = 0;                           ///< 0: as many as the spacing allows
  double spacing = 0;                      ///< centre to centre [m]; 0: evenly distributed between the walls along them
  double width = 0;                        ///< [m], above 0
  double height = 0;                       ///< [m], whole courses; 0: one course
  std::optional<double> bearing = {};      ///< bearing length in the end walls [m]; none: through the walls
  std::optional<Vec2> from = {}, to = {};  ///< opposite corners of their part of the plan [m]; none: the whole plan
};

/// One storey: courses, and the floor on top of them or within them.
struct MasonryStorey {
  int courses = 0;                                 ///< 0: as many as the height contains
  double height = 0;                               ///< to the top of its floor [m]; used where courses is 0
  double slab_height = -1;                         ///< [m]; 0: no floor; negative: the slab height of the masonry
  std::optional<std::vector<BeamRow>> beams = {};  ///< empty: no beams; none: the beams of the building
};

/// A door or window: an empty box.
struct MasonryOpening {
  int storey = 1;              ///< from 1 at the bottom
  double from = 0;             ///< near edge, m from the start of the wall's line
  double sill = 0;             ///< lower edge, m above the bottom of the storey's first course; on a course line
  double width = 0;            ///< [m]
  double height = 0;           ///< [m]; the head, sill + height, lies on a course line too
  bool lintel = true;          ///< with a block over the head; none is made if the courses end at the head
  double lintel_height = -1;   ///< [m]; negative: the masonry's
  double lintel_bearing = -1;  ///< overlap of the lintel on each side [m]; negative: the masonry's
};

/// One wall of a plan: a line along x or y in the middle of its thickness. An end within the thickness of another wall
/// extends to the far face of that wall; a free end remains in place.
struct PlanWall {
  std::string name = {};                          ///< "": "w1", "w2", ... by its place in the list
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< [m]
  double thickness = 0;                           ///< [m]; 0: half a unit's length, or a unit's for bonds with headers
  std::string bond = {};                          ///< "": the masonry's
  std::vector<MasonryOpening> openings = {};
};

/// A plan of walls, repeated in each storey.
struct Building {
  std::string name = {};
  std::vector<PlanWall> walls = {};         ///< 1 to 1000
  std::vector<MasonryStorey> storeys = {};  ///< from the bottom up, at least one
  std::vector<BeamRow> beams = {};          ///< default floor beams of all storeys
  Masonry masonry = {};
  bool first_along_y = false;  ///< in odd courses the walls along y run through instead of the walls along x
  Polygon slab_outline = {};   ///< of floors, simple [m]; empty: the rectangle around all walls, with the overhang
  Vec3 at = Vec3::Zero();      ///< position of the plan's origin [m]
  double angle = 0;            ///< of the plan about z through its origin, counter-clockwise [rad]
};

/// Parts from the bottom up. Names and groups for wall "w1" in storey 2:
///   - "base": group "base".
///   - "w1.s2.c5.u3" (third unit of its fifth course, counted along x or y; for two leaves "u3a" and "u3b"):
///     groups "units", "storey 2", "course 5".
///   - "w1.s2.lintel1": "lintels".
///   - "s2.beam3": "beams", "floors", counted row by row along x or y.
///   - "s2.floor": "floors", one solid for each storey on all walls and beams.
/// Parts of a wall are in the group of its name, and all parts in the group of the building's name, if it has one.
/// Pockets have the width and height of their beams; the space behind a beam's end is filled, one unit for each course.
/// Units that meet share the coordinates of their faces to the bit.
///
/// Throws InputError, with place, value and allowed range, for:
///   - lines that are not along x or y, and parallel walls that overlap.
///   - sizes out of range, and heights that are not a whole number of courses.
///   - openings off the course lines, outside of their wall, in a junction, overlapping, or next to less masonry than
///     the least length.
///   - beams without two walls at their ends, within a wall along them, in a junction, overlapping, on openings or
///     lintels, over an opening without lintel, or with short pieces next to or behind them.
SolidParts build_building(const Building& building);

/// One wall with a thickness.
struct SolidWall {
  std::string name = {};
  double length = 0;     ///< along x [m], above 0
  double thickness = 0;  ///< along y [m]; 0: half a unit's length, or a unit's for bonds with headers
  std::vector<MasonryStorey> storeys = {};  ///< from the bottom up, at least one
  Masonry masonry = {};
  std::vector<MasonryOpening> openings = {};  ///< from the left end
  Vec3 at = Vec3::Zero();                     ///< lower left corner of its front [m]
  double angle = 0;                           ///< about z through that corner, counter-clockwise [rad]
};

/// A building of one wall, whose front is the plane y = 0; names do not contain the name of the wall in the middle:
/// "s1.c5.u3".
SolidParts build_solid_wall(const SolidWall& wall);

}  // namespace trilith
