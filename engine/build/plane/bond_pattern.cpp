#include "build/plane/bond_pattern.hpp"

#include <fmt/format.h>

#include <cassert>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith {
namespace {

// Quarter laps of English and Flemish bond result from a closer next to the corner header (the usual arrangement, as in
// BS 5606 and handbooks of bricklaying).
constexpr std::array patterns{
    BondPattern{
        "running", "stretchers, each centred over a joint of the course below", {{{"", "S", ""}, {"B", "S", ""}}}, 2},
    BondPattern{"stack", "stretchers, with aligned joints", {{{"", "S", ""}}}, 1},
    BondPattern{
        "english", "courses of stretchers alternate with courses of headers", {{{"", "S", ""}, {"HC", "H", "CH"}}}, 2},
    BondPattern{"flemish",
                "alternating stretchers and headers, each header centred over a stretcher",
                {{{"", "SH", ""}, {"HC", "SH", "CH"}}},
                2},
    BondPattern{
        "header", "headers only, each centred over a joint of the course below", {{{"", "H", ""}, {"C", "H", ""}}}, 2},
    BondPattern{"english_garden",
                "three courses of stretchers in running bond, then a course of headers",
                {{{"", "S", ""}, {"B", "S", ""}, {"", "S", ""}, {"HC", "H", "CH"}}},
                4},
};

double length_of(char letter, const BondUnits& units) {
  switch (letter) {
    case 'S':
      return units.stretcher;
    case 'B':
      return units.stretcher / 2;
    case 'H':
      return units.header;
    default:
      assert(letter == 'C');
      return units.header / 2;
  }
}

}  // namespace

std::span<const BondPattern> bond_patterns() {
  return patterns;
}

const BondPattern& find_bond(std::string_view name, std::string_view owner) {
  std::vector<std::string> known;
  for (const BondPattern& pattern : patterns) {
    if (pattern.name == name) return pattern;
    known.emplace_back(pattern.name);
  }
  throw InputError(fmt::format("{}: there is no bond '{}'{}", owner, name, name_hint(name, known)));
}

/// Lays the units of the start, then the repeat as often as it fits, then the units of the end, which are measured from
/// the right. The remaining length is filled by the last unit of the repeat, cut.
std::vector<double> head_joints(const BondCourse& course, const BondUnits& units, double length) {
  const double same = 1e-9 * length;
  double right = length;  // begin of the end units
  std::vector<double> last;
  for (auto letter = course.end.rbegin(); letter != course.end.rend(); ++letter)
    last.insert(last.begin(), right -= length_of(*letter, units));
  double x = 0;
  std::vector<double> joints;
  for (const char letter : course.start)
    if ((x += length_of(letter, units)) < right - same) joints.push_back(x);
  for (std::size_t i = 0; x < right - same; ++i)
    if ((x += length_of(course.repeat[i % course.repeat.size()], units)) < right - same) joints.push_back(x);
  const double taken = joints.empty() ? 0 : joints.back();
  for (const double joint : last)  // a wall shorter than start and end together keeps its start
    if (joint > taken + same) joints.push_back(joint);
  return joints;
}

}  // namespace trilith
