#include "build/plane/running_bond.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

/// A field on the grid: half units from the left end, courses counted from 1.
struct GridField {
  int from, to, first, last;
  int number;  ///< index among the lintels, from 1; 0 for an opening
};

class Panel {
 public:
  explicit Panel(const RunningBond& bond) : bond_(bond), owner_(builder_title("running bond", bond.name)) {
    check_sizes();
    for (const PanelField& opening : bond.openings) add_field(opening, "opening", 0);
    for (std::size_t i = 0; i < bond.lintels.size(); ++i) add_field(bond.lintels[i], "lintel", static_cast<int>(i) + 1);
    // each grid line is computed once, so that all parts that meet there have the same bits
    for (int i = 0; i <= 2 * bond.columns; ++i) x_.push_back(bond.at.x() + i * (bond.unit_width / 2));
    for (int i = 0; i <= bond.courses; ++i) y_.push_back(bond.at.y() + i * bond.unit_height);
  }

  std::vector<Part> run() {
    if (bond_.base_height > 0) lay_base();
    for (int course = 1; course <= bond_.courses; ++course) {
      lay_units(course);
      for (const GridField& field : fields_)
        if (field.number > 0 && field.first == course) lay_lintel(field);
    }
    return std::move(parts_);
  }

 private:
  void check_sizes() const {
    check_keys(bond_, owner_);
    if (static_cast<double>(bond_.columns) * bond_.courses > 1e6)
      throw InputError(fmt::format("{}: {} columns in {} courses are more than 1000000 units", owner_, bond_.columns,
                                   bond_.courses));
  }

  /// Index of the grid line at x; a field off the grid is rejected, not moved.
  int grid_line(double x, const std::string& what) const {
    const double half = bond_.unit_width / 2, lines = require_finite(x, what) / half, nearest = std::round(lines);
    if (std::abs(lines - nearest) > 1e-6)
      throw InputError(fmt::format("{} is {:g} m, must be a multiple of half a unit: {:g} or {:g} m are nearest", what,
                                   x, std::floor(lines) * half, std::ceil(lines) * half));
    if (nearest < 0 || nearest > 2 * bond_.columns)
      throw InputError(
          fmt::format("{} is {:g} m, must lie within the panel's 0 to {:g} m", what, x, 2 * bond_.columns * half));
    return static_cast<int>(nearest);
  }

  void add_field(const PanelField& given, std::string_view kind, int number) {
    const std::string what = number > 0 ? fmt::format("{}, lintel {}", owner_, number)
                                        : fmt::format("{}, opening {}", owner_, fields_.size() + 1);
    const int last_course = given.last_course == 0 ? given.first_course : given.last_course;
    const GridField field{grid_line(given.from, what + ": left edge"), grid_line(given.to, what + ": right edge"),
                          require_count(given.first_course, 1, bond_.courses, what + ": first course"),
                          require_count(last_course, given.first_course, bond_.courses, what + ": last course"),
                          number};
    if (field.from >= field.to)
      throw InputError(
          fmt::format("{}: right edge {:g} m must lie right of left edge {:g} m", what, given.to, given.from));
    for (const GridField& other : fields_)
      if (field.from < other.to && other.from < field.to && field.first <= other.last && other.first <= field.last)
        throw InputError(
            fmt::format("{}: overlaps an earlier opening or lintel; a {} can only replace units", what, kind));
    fields_.push_back(field);
  }

  void lay_base() {
    const Vec2 low(x_.front() - bond_.base_margin, y_.front() - bond_.base_height);
    parts_.push_back(
        {part_name(bond_.name, "base"), rectangle(low, {x_.back() + bond_.base_margin, y_.front()}), {"base"}});
  }

  Polygon field_outline(int from, int to, int first, int last) const {
    const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
    const auto low = static_cast<std::size_t>(first - 1), high = static_cast<std::size_t>(last);
    return rectangle({x_[i], y_[low]}, {x_[j], y_[high]});
  }

  void lay_lintel(const GridField& lintel) {
    Part part{part_name(bond_.name, fmt::format("lintel{}", lintel.number)),
              field_outline(lintel.from, lintel.to, lintel.first, lintel.last),
              {"lintels"}};
    for (int course = lintel.first; course <= lintel.last; ++course)
      part.groups.push_back(fmt::format("course {}", course));
    parts_.push_back(std::move(part));
  }

  /// Lays the units of a course along its half units; a unit ends at its joint and at the edge of a field. Grid lines
  /// are half units; courses with halves have their joints at odd lines, the others at even ones.
  ///
  ///     line 0   1   2   3   4   5   6        joint_parity 1:  |half|  unit  |  unit  |half|
  ///                                           joint_parity 0:  |  unit  |  unit  |  unit   |
  // Grid lines are half units; courses with halves have their joints at odd lines, the others at even ones.
  //
  //     line 0   1   2   3   4   5   6        joint_parity 1:  |half|  unit  |  unit  |half|
  //                                           joint_parity 0:  |  unit  |  unit  |  unit   |
  void lay_units(int course) {
    const int end = 2 * bond_.columns;
    const int joint_parity = (course % 2 == 1) == (bond_.half_courses == HalfCourses::odd) ? 1 : 0;
    std::vector<char> filled(static_cast<std::size_t>(end), 1);
    for (const GridField& field : fields_)
      if (field.first <= course && course <= field.last)
        std::fill(filled.begin() + field.from, filled.begin() + field.to, char{0});
    int unit = 0;
    for (int from = 0; from < end;) {
      int to = from + 1;
      const bool laid = filled[static_cast<std::size_t>(from)] != 0;
      if (laid && to % 2 != joint_parity && to < end && filled[static_cast<std::size_t>(to)] != 0) ++to;
      if (laid)
        parts_.push_back({part_name(bond_.name, fmt::format("c{}.u{}", course, ++unit)),
                          field_outline(from, to, course, course),
                          {"units", fmt::format("course {}", course)}});
      from = to;
    }
  }

  const RunningBond& bond_;
  std::string owner_;
  std::vector<GridField> fields_;
  std::vector<double> x_, y_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<Part> RunningBond::parts() const {
  return build_running_bond(*this);
}

std::vector<Part> build_running_bond(const RunningBond& bond) {
  return Panel(bond).run();
}

std::vector<Part> build_bench_wall(int courses) {
  require_count(courses, 1, 1000, "bench wall: number of courses");
  return build_running_bond({.columns = std::max(1, 3 * courses / 4),
                             .courses = courses,
                             .half_courses = HalfCourses::even,
                             .base_height = 0.4});
}

}  // namespace trilith
