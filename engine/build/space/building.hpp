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
  int courses = 0;           ///< of storeys that give neither courses nor height; see MasonryStorey
  double storey_height = 0;  ///< likewise [m]

  static constexpr auto keys() {
    using K = KeysOf<Masonry>;
    using M = Masonry;
    return std::tuple(
        K::Number{&M::unit_length, "unit_length", "m", "length of a stretcher with its joint", above_zero},
        K::Number{&M::unit_height, "unit_height", "m", "height of a course", above_zero},
        K::Number{&M::header_length,
                  "header_length",
                  "m",
                  "length of a header along the wall",
                  not_below_zero,
                  {"half a stretcher"}},
        K::Text{&M::bond, "bond", "stretcher, header, english or flemish"},
        K::Count{&M::courses,
                 "courses",
                 "number of courses in a storey; or storey_height",
                 0,
                 100000,
                 {"from storey_height"}},
        K::Number{&M::storey_height, "storey_height", "m", "height of a storey", not_below_zero, {"from courses"}},
        K::Number{&M::slab_height, "slab_height", "m", "height of the floor slab on each storey", not_below_zero},
        K::Number{&M::slab_overhang, "slab_overhang", "m", "length of slabs beyond the walls", not_below_zero},
        K::Number{&M::base_height, "base_height", "m", "height of the base", not_below_zero},
        K::Number{&M::base_margin, "base_margin", "m", "length of the base beyond the walls", not_below_zero},
        K::Number{&M::lintel_height, "lintel_height", "m", "height of lintels", not_below_zero, {"one course"}},
        K::Number{
            &M::lintel_bearing, "lintel_bearing", "m", "bearing length of lintels", not_below_zero, {"half a unit"}},
        K::Number{&M::least_length,
                  "least_length",
                  "m",
                  "length of the shortest cut piece",
                  not_below_zero,
                  {"a fifth of a unit"}},
        K::Flag{&M::snap, "snap", "move openings to the nearest course lines"});
  }
};

/// A row of floor beams: parallel boxes that end in pockets of two walls across them, and pass through walls in
/// between. Their tops are level with the top of the storey's courses.
struct BeamRow {
  bool along_y = false;                    ///< they span along y, not x
  std::optional<int> count = {};           ///< none: as many as the spacing allows
  double spacing = 0;                      ///< centre to centre [m]; 0: evenly distributed between the walls along them
  double width = 0;                        ///< [m], above 0
  double height = 0;                       ///< [m], whole courses; 0: one course
  std::optional<double> bearing = {};      ///< bearing length in the end walls [m]; none: through the walls
  std::optional<Vec2> from = {}, to = {};  ///< opposite corners of their part of the plan [m]; none: the whole plan

  static constexpr auto keys() {
    using K = KeysOf<BeamRow>;
    return std::tuple(
        K::Choice<bool, 2>{&BeamRow::along_y, "along", "direction of their span", {"x", "y"}, must_be_given},
        K::MaybeCount{&BeamRow::count, "count", "number of beams", 1, 10000},
        K::Number{&BeamRow::spacing, "spacing", "m", "from centre to centre", any_number, {"even"}},
        K::Number{&BeamRow::width, "width", "m", "width", any_number, must_be_given},
        K::Number{&BeamRow::height, "height", "m", "whole courses", any_number, {"one course"}},
        K::MaybeNumber{&BeamRow::bearing, "bearing", "m", "length in the walls; default: through them"},
        K::MaybePoint{&BeamRow::from, "from", "corner of their part of the plan"},
        K::MaybePoint{&BeamRow::to, "to", "opposite corner"});
  }
};
inline constexpr std::string_view beams_wanted = "{ along = , spacing = , width = }";

/// One storey: courses, and the floor on top of them or within them.
struct MasonryStorey {
  int courses = 0;                                 ///< 0: as many as the height contains
  double height = 0;                               ///< to the top of its floor [m]; used where courses is 0
  double slab_height = -1;                         ///< [m]; 0: no floor; negative: the slab height of the masonry
  std::optional<std::vector<BeamRow>> beams = {};  ///< empty: no beams; none: the beams of the building

  static constexpr auto keys() {
    using K = KeysOf<MasonryStorey>;
    return std::tuple(
        K::Count{&MasonryStorey::courses, "courses", "number of courses", 0, 100000, {"from height"}},
        K::Number{&MasonryStorey::height, "height", "m", "to the top of its floor", not_below_zero, {"from courses"}},
        K::Number{&MasonryStorey::slab_height, "slab_height", "m", "floor slab", any_number, {"as for all storeys"}},
        K::OneOrList<BeamRow>{&MasonryStorey::beams, "beams", "beams, row", beams_wanted, "beams of its floor"});
  }
};

/// Keys of a storey of a single wall, which has no beams.
struct WallStoreyKeys {
  static constexpr auto keys() {
    constexpr auto all = MasonryStorey::keys();
    return std::tuple(std::get<0>(all), std::get<1>(all), std::get<2>(all));
  }
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

  static constexpr auto keys() {
    using K = KeysOf<MasonryOpening>;
    constexpr Preset wall{"as for the wall"};
    return std::tuple(
        K::EachCount{&MasonryOpening::storey, "storey", "its storeys"},
        K::Number{&MasonryOpening::from, "from", "m", "near edge", any_number, must_be_given},
        K::Number{&MasonryOpening::sill, "sill", "m", "lower edge"},
        K::Number{&MasonryOpening::width, "width", "m", "width", any_number, must_be_given},
        K::Number{&MasonryOpening::height, "height", "m", "height", any_number, must_be_given},
        K::Flag{&MasonryOpening::lintel, "lintel", "with a lintel"},
        K::Number{&MasonryOpening::lintel_height, "lintel_height", "m", "height of the lintel", any_number, wall},
        K::Number{&MasonryOpening::lintel_bearing, "lintel_bearing", "m", "bearing length of the lintel", any_number,
                  wall});
  }
};

/// One wall of a plan: a line along x or y in the middle of its thickness. An end within the thickness of another wall
/// extends to the far face of that wall; a free end remains in place.
struct PlanWall {
  std::string name = {};                          ///< "": "w1", "w2", ... by its place in the list
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< [m]
  double thickness = 0;                           ///< [m]; 0: half a unit's length, or a unit's for bonds with headers
  std::string bond = {};                          ///< "": the masonry's
  std::vector<MasonryOpening> openings = {};

  static constexpr auto keys() {
    using K = KeysOf<PlanWall>;
    return std::tuple(K::Text{&PlanWall::name, "name", "name in the names of its parts"},
                      K::Point{&PlanWall::start, "from", "start of its line", must_be_given},
                      K::Point{&PlanWall::end, "to", "end of its line", must_be_given},
                      K::Number{&PlanWall::thickness, "thickness", "m", "thickness", any_number, {"from the bond"}},
                      K::Text{&PlanWall::bond, "bond", "instead of the bond of all walls"},
                      K::List<MasonryOpening>{&PlanWall::openings, "openings", "opening", "its openings"});
  }
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

  static constexpr std::string_view kind = "building";
  static constexpr std::string_view sentence =
      "walls of a plan in storeys, with interlocking corners and junctions. Floors are slabs, beams in pockets of two "
      "walls, or slabs on beams";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Building>;
    return std::tuple(
        K::List<PlanWall>{&Building::walls, "walls", "wall",
                          "{ name = , from = {x, y}, to = {x, y}, thickness = , bond = , openings = }, ...",
                          must_be_given},
        K::Within<Masonry>{&Building::masonry},
        K::CountOrList<MasonryStorey>{
            &Building::storeys, "storeys", "storey",
            "number of storeys, or a list of { courses = , height = , slab_height = , beams = }", 1000},
        K::OneOrList<BeamRow, std::vector<BeamRow>>{
            &Building::beams, "beams", "beams, row", beams_wanted,
            "beams of each floor, or a list of such rows: { along = \"x\" or \"y\", spacing = or count = , width = , "
            "height = whole courses (1), bearing = length in the walls (default: through them), from = {x, y}, to = "
            "{x, y} }. false in a storey: none"},
        K::Points{&Building::slab_outline, "slab_outline", "outline of the floors", {"around all walls"}},
        K::Flag{&Building::first_along_y, "first_along_y", "walls along y run through in odd courses"},
        K::Vector{&Building::at, "at", "position of the origin of the plan"},
        K::Number{&Building::angle, "angle", "rad", "rotation about z through that point"});
  }
  /// build_building.
  [[nodiscard]] SolidParts parts() const;
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

  static constexpr std::string_view kind = "wall";
  static constexpr std::string_view sentence = "a masonry wall with a thickness, along x";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<SolidWall>;
    return std::tuple(K::Number{&SolidWall::length, "length", "m", "length along x", above_zero, must_be_given},
                      K::Number{&SolidWall::thickness,
                                "thickness",
                                "m",
                                "thickness along y; with headers the length of a unit",
                                not_below_zero,
                                {"half a unit's length"}},
                      K::Within<Masonry>{&SolidWall::masonry},
                      K::CountOrList<MasonryStorey, WallStoreyKeys>{
                          &SolidWall::storeys, "storeys", "storey",
                          "number of storeys, or a list of { courses = , height = , slab_height = }", 1000},
                      K::List<MasonryOpening>{&SolidWall::openings, "openings", "opening",
                                              "{ storey = , from = , sill = , width = , height = , lintel = }, ..."},
                      K::Vector{&SolidWall::at, "at", "lower left corner of the front"},
                      K::Number{&SolidWall::angle, "angle", "rad", "rotation about z through that corner"});
  }
  /// build_solid_wall.
  [[nodiscard]] SolidParts parts() const;
};

/// A building of one wall, whose front is the plane y = 0; names do not contain the name of the wall in the middle:
/// "s1.c5.u3".
SolidParts build_solid_wall(const SolidWall& wall);

}  // namespace trilith
