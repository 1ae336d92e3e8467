// Walls of masonry from one description: storeys of courses in a bond, openings with lintels, slabs, a base.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// One storey: courses, and the slab on top of them.
struct WallStorey {
  int courses = 0;          ///< 0: as many as the height contains
  double height = 0;        ///< from the top of the part below to the top of its slab [m]; 0: determined by the courses
  double slab_height = -1;  ///< [m]; 0: no slab; negative: the wall's slab_height

  static constexpr auto keys() {
    using K = KeysOf<WallStorey>;
    using S = WallStorey;
    return std::tuple(K::Count{&S::courses, "courses", "number of courses"},
                      K::Number{&S::height, "height", "m", "height with its slab", not_below_zero},
                      K::Number{&S::slab_height, "slab_height", "m", "height of its slab"});
  }
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

  static constexpr auto keys() {
    using K = KeysOf<WallOpening>;
    using O = WallOpening;
    return std::tuple(K::EachCount{&O::storey, "storey", "storey from below, or several"},
                      K::Number{&O::x, "x", "m", "left edge", any_number, must_be_given},
                      K::Number{&O::sill, "sill", "m", "lower edge above the storey's first course"},
                      K::Number{&O::width, "width", "m", "its width", any_number, must_be_given},
                      K::Number{&O::height, "height", "m", "its height", any_number, must_be_given},
                      K::Flag{&O::lintel, "lintel", "with a lintel"},
                      K::Number{&O::lintel_height, "lintel_height", "m", "height of its lintel"},
                      K::Number{&O::lintel_bearing, "lintel_bearing", "m", "bearing length of its lintel"},
                      K::Number{&O::sill_height, "sill_height", "m", "height of a block under the sill"},
                      K::Number{&O::sill_bearing, "sill_bearing", "m", "bearing length of that block"});
  }
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
  int courses = 0;    ///< of storeys that give neither courses nor height; see WallStorey
  double storey_height = 0;  ///< likewise [m]

  static constexpr std::string_view kind = "wall";
  static constexpr std::string_view sentence = "a masonry wall of storeys, with openings, lintels and slabs";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Wall>;
    return std::tuple(
        K::Point{&Wall::at, "at", "lower left corner of the first course; the base is below it"},
        K::Number{&Wall::length, "length", "m", "length of the wall; or units", any_number, {"from units"}},
        K::Count{&Wall::units, "units", "number of units in a course", -any_count, any_count, {"from length"}},
        K::Number{&Wall::unit_length, "unit_length", "m", "length of a stretcher, with half of its joints", above_zero},
        K::Number{&Wall::unit_height, "unit_height", "m", "height of a course", above_zero},
        K::Number{
            &Wall::header_length, "header_length", "m", "length of a header", not_below_zero, {"half a stretcher"}},
        K::Number{&Wall::head_joint, "head_joint", "m", "thickness of head joints, added to the length of units",
                  not_below_zero},
        K::Number{&Wall::bed_joint, "bed_joint", "m", "thickness of bed joints, added to the height of units",
                  not_below_zero},
        K::Text{&Wall::bond, "bond", "running, stack, english, flemish, header or english_garden"},
        K::Count{&Wall::first_row, "first_row", "first row of the bond pattern"},
        K::Number{&Wall::least_length,
                  "least_length",
                  "m",
                  "length of the shortest cut piece",
                  not_below_zero,
                  {"a quarter of a unit"}},
        K::Choice<ShortPieces, 2>{
            &Wall::short_pieces, "short_pieces", "treatment of shorter pieces", {"merge", "refuse"}},
        K::Number{&Wall::jitter, "jitter", "m", "largest random shift of head joints", not_below_zero},
        K::Count{&Wall::seed, "seed", "of the random numbers"},
        K::Count{&Wall::courses,
                 "courses",
                 "number of courses in a storey; or",
                 -any_count,
                 any_count,
                 {"from storey_height"}},
        K::Number{&Wall::storey_height, "storey_height", "m", "height of a storey", not_below_zero, {"from courses"}},
        K::CountOrList<WallStorey>{&Wall::storeys, "storeys", "storey",
                                   "number of storeys, or a list of { courses = , height = , slab_height = }", 1000},
        K::Number{&Wall::slab_height, "slab_height", "m", "height of the slab on each storey", not_below_zero},
        K::Number{&Wall::slab_overhang, "slab_overhang", "m", "length of slabs beyond the wall", not_below_zero},
        K::Number{&Wall::base_height, "base_height", "m", "height of the base", not_below_zero},
        K::Number{&Wall::base_margin, "base_margin", "m", "length of the base beyond the wall", not_below_zero},
        K::Number{&Wall::lintel_height, "lintel_height", "m", "height of lintels", not_below_zero, {"one course"}},
        K::Number{
            &Wall::lintel_bearing, "lintel_bearing", "m", "bearing length of lintels", not_below_zero, {"half a unit"}},
        K::Flag{&Wall::snap, "snap", "move openings to the nearest joints"},
        K::List<WallOpening>{&Wall::openings, "openings", "opening",
                             "{ storey = , x = , sill = , width = , height = , lintel = , sill_height = }, ..."});
  }
  /// build_wall.
  [[nodiscard]] BuiltParts parts() const;
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
/// range, for sizes out of range and heights that are not a whole number of courses. It also throws for openings
/// outside the storey, overlapping, or off the course lines, for lintels without masonry below their ends, and for
/// pieces that remain too short.
BuiltParts build_wall(const Wall& wall);

}  // namespace trilith
