// Wall panels in running bond: whole units, half units at the ends of every second course, openings and lintels.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// Which courses, counted from 1 at the bottom, begin and end with a half unit.
enum class HalfCourses { odd, even };

/// A rectangle of a panel, aligned with the grid of the bond.
struct PanelField {
  double from = 0;       ///< left edge, from the panel's left end [m]: a multiple of half of the unit's width
  double to = 0;         ///< right edge, likewise, right of `from`
  int first_course = 1;  ///< lowest course
  int last_course = 1;   ///< highest course, not below first_course
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
};

/// Parts from the bottom up, left to right. "base" is in group "base". Units "c1.u1", "c1.u2", ... are in groups
/// "units", "course 1"; units are counted from 1 in each course, including cut ones. Block "lintel1", after the units
/// of its lowest course, is in groups "lintels" and its courses. All corners lie on one grid of half units and courses,
/// computed once per grid line, so that neighbours share corners to the bit. Throws InputError for numbers out of range
/// (at most 1e6 units), and for fields off the grid (with the nearest lines), outside the panel or overlapping.
std::vector<Part> build_running_bond(const RunningBond& bond);

/// The panel of the benchmarks: units of 0.4 m x 0.2 m, odd courses of whole units, three columns to four courses, on a
/// base of equal length. 24 courses: 444 units and 1266 pairs of touching faces, including the base. 48 courses: 1752
/// units and 5124 pairs. The base is a further part. Throws InputError unless 1 <= courses <= 1000.
std::vector<Part> build_bench_wall(int courses);

}  // namespace trilith
