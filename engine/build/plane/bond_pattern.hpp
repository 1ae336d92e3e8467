// Bonds of masonry: in which order units of which length follow each other in the courses of a wall.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// One course in letters: S stretcher, B half a stretcher (a half bat), H header, C closer (half a header). `start` is
/// laid from the left end, `end` from the right end (its last letter lies outermost), `repeat` from the left between.
struct BondCourse {
  std::string_view start, repeat, end;
};

/// A bond: its courses from the bottom up, over and over again. A new bond is a new row of bond_patterns().
struct BondPattern {
  std::string_view name, sentence;
  std::array<BondCourse, 4> course;
  int courses;  ///< of `course` in use, 1 to 4
};

/// Every bond there is, seen in the plane of the wall.
std::span<const BondPattern> bond_patterns();

/// The bond of that name; throws InputError with the nearest name where there is none. `owner` begins the message.
const BondPattern& find_bond(std::string_view name, std::string_view owner);

/// Lengths along the wall of the letters' units, m, each with its share of the head joints.
struct BondUnits {
  double stretcher, header;
};

/// Positions of the head joints of a course from its left end, m, ascending, strictly between 0 and `length` (m, above
/// 0). Where the repeat does not come out even, its last unit is what is left over.
std::vector<double> head_joints(const BondCourse& course, const BondUnits& units, double length);

}  // namespace trilith
