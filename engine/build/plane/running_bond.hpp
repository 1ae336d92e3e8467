// Wall panels in running bond: whole units, half units at the ends of every second course, openings and lintels.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// Which courses, counted from 1 at the bottom, begin and end with a half unit.
enum class HalfCourses { odd, even };

/// A rectangle of a panel, aligned with the grid of the bond.
struct PanelField {
  double from = 0;       ///< left edge, from the panel's left end [m]: a multiple of half of the unit's width
  double to = 0;         ///< right edge, likewise, right of `from`
  int first_course = 1;  ///< lowest course
  int last_course = 0;   ///< highest course, not below first_course; 0: first_course

  static constexpr auto keys() {
    using K = KeysOf<PanelField>;
    return std::tuple(K::Number{&PanelField::from, "from", "m", "left edge", any_number, must_be_given},
                      K::Number{&PanelField::to, "to", "m", "right edge", any_number, must_be_given},
                      K::Count{&PanelField::first_course, "first_course", "lowest course"},
                      K::Count{&PanelField::last_course, "last_course", "highest course"});
  }
};

/// A panel of rigid units laid in running bond without joint thickness.
struct RunningBond {
  std::string name = {};
  int columns = 5;  ///< whole units in a course without halves
  int courses = 6;
  double unit_width = 0.4;   ///< [m]
  double unit_height = 0.2;  ///< [m]
  HalfCourses half_courses = HalfCourses::even;
  Vec2 at = Vec2::Zero();                 ///< lower left corner of the first course [m]
  double base_height = 0;                 ///< of the block under the panel [m]; 0: no base
  double base_margin = 0;                 ///< by which the base extends beyond both ends [m]
  std::vector<PanelField> openings = {};  ///< left empty; units are cut at their edges
  std::vector<PanelField> lintels = {};   ///< each one block instead of the units there

  static constexpr std::string_view kind = "running_bond";
  static constexpr std::string_view sentence = "a plain panel on a grid of half units, for limit analysis";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<RunningBond>;
    using R = RunningBond;
    return std::tuple(
        K::Count{&R::columns, "columns", "number of units in a course", 1, 1'000'000},
        K::Count{&R::courses, "courses", "number of courses", 1, 1'000'000},
        K::Number{&R::unit_width, "unit_width", "m", "width of a unit", above_zero},
        K::Number{&R::unit_height, "unit_height", "m", "height of a unit", above_zero},
        K::Choice<HalfCourses, 2>{
            &R::half_courses, "half_courses", "courses that begin with a half unit", {"odd", "even"}},
        K::Point{&R::at, "at", "lower left corner of the first course; the base is below it"},
        K::Number{&R::base_height, "base_height", "m", "height of the base", not_below_zero},
        K::Number{&R::base_margin, "base_margin", "m", "length of the base beyond the panel", not_below_zero},
        K::List<PanelField>{&R::openings, "openings", "opening",
                            "{ from = , to = , first_course = , last_course = }, ..."},
        K::List<PanelField>{&R::lintels, "lintels", "lintel", "lintels in the same form"});
  }
  /// build_running_bond.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Parts from the bottom up, left to right. "base" is in group "base". Units "c1.u1", "c1.u2", ... are in groups
/// "units", "course 1"; units are counted from 1 in each course, including cut ones. Block "lintel1", after the units
/// of its lowest course, is in groups "lintels" and its courses. All corners lie on one grid of half units and courses,
/// computed once per grid line, so that neighbours share corners to the bit. Throws InputError for numbers out of range
/// (at most 1e6 units), and for fields off the grid (with the nearest lines), outside the panel or overlapping.
std::vector<Part> build_running_bond(const RunningBond& bond);

/// The panel of the benchmarks: units of 0.4 m x 0.2 m, odd courses of whole units, three columns to four courses, on a
/// base of equal length. 24 courses: 444 units and 1266 pairs of touching faces, including the base. 48 courses: 1752
/// units and 5124 pairs. The base is an additional part. Throws InputError unless 1 <= courses <= 1000.
std::vector<Part> build_bench_wall(int courses);

/// build_bench_wall as a builder of scripts.
struct BenchWall {
  std::string name = {};
  int courses = 24;

  static constexpr std::string_view kind = "bench_wall";
  static constexpr std::string_view sentence = "the wall of the benchmarks";
  static constexpr bool is_single = false, is_named = false;
  static constexpr auto keys() {
    return std::tuple(KeysOf<BenchWall>::Count{&BenchWall::courses, "courses", "number of courses", 1, 1000});
  }
  [[nodiscard]] std::vector<Part> parts() const { return build_bench_wall(courses); }
};

}  // namespace trilith
