// Masonry bonds: sequences of units in the courses of a wall.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// One course in letters: S stretcher, B half a stretcher (a half bat), H header, C closer (half a header). `start` is
/// laid from the left end, `end` from the right end (its last letter is outermost), `repeat` from the left in between.
struct BondCourse {
  std::string_view start, repeat, end;
};

/// A bond: a repeated sequence of courses from the bottom up. A new bond is a new row of bond_patterns().
struct BondPattern {
  std::string_view name, sentence;
  std::array<BondCourse, 4> course;
  int courses;  ///< of `course` in use, 1 to 4
};

/// All bonds, as seen in the plane of the wall.
std::span<const BondPattern> bond_patterns();

/// The bond of that name; throws InputError with the nearest name if there is none. `owner` begins the message.
const BondPattern& find_bond(std::string_view name, std::string_view owner);

/// Lengths of the units along the wall [m], each with its share of the head joints.
struct BondUnits {
  double stretcher, header;
};

/// Positions of the head joints of a course from its left end [m], ascending, strictly between 0 and `length` [m],
/// above 0. If the repeat does not fit evenly, its last unit is cut.
std::vector<double> head_joints(const BondCourse& course, const BondUnits& units, double length);

}  // namespace trilith
