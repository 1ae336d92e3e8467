#include "build/space/building.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "build/space/building_plan.hpp"

namespace trilith {
namespace {

/// One unit along a course and its letter in the bond; C is a closer, cut from a header.
struct CourseUnit {
  Stretch along;
  char letter;
};

/// Units of a whole wall in one of its two kinds of courses, without regard to interruptions, from the wall's start
/// [m].
class CourseLayout {
 public:
  CourseLayout(const BuildingPlan& plan, const PlannedWall& wall) : plan_(plan), wall_(wall) {}

  [[nodiscard]] std::vector<CourseUnit> units(bool through) const {
    const LeafBond& bond = *wall_.bond;
    const std::string_view letters = through ? bond.first : bond.second;
    const double length = wall_.along.high - wall_.along.low;
    double period = 0;
    for (const char letter : letters) period += length_of_leaf(letter);
    double at = through ? 0 : bond.shift_units * plan_.unit + bond.shift_headers * plan_.header - period;
    std::vector<CourseUnit> units;
    for (std::size_t i = 0; at < length * (1 - 1e-9); ++i) {
      const char letter = letters[i % letters.size()];
      const double end = at + length_of_leaf(letter);
      if (end > 1e-9 * plan_.unit) units.push_back({{std::max(at, 0.0), std::min(end, length)}, letter});
      at = end;
    }
    if (!through && bond.leaves > 1) close_ends(units);  // over stretchers
    return units;
  }

 private:
  [[nodiscard]] double length_of_leaf(char letter) const { return letter == 'S' ? plan_.unit : plan_.header; }

  [[nodiscard]] bool is_free(bool at_start) const {
    if (wall_.junctions.empty()) return true;
    return at_start == wall_.forward ? wall_.junctions.front().low > wall_.along.low
                                     : wall_.junctions.back().high < wall_.along.high;
  }

  /// A shifted course would leave less than a header at a free end, next to a header. These are exchanged, so that a
  /// whole header ends the wall and a closer lies behind it, as in bricklaying practice.
  void close_ends(std::vector<CourseUnit>& units) const {
    const double h = plan_.header, least = h * (1 - 1e-6);
    if (units.size() < 2) return;
    const auto length = [](const CourseUnit& unit) { return unit.along.high - unit.along.low; };
    CourseUnit &first = units[0], &second = units[1];
    if (is_free(true) && length(first) < least && second.letter == 'H' && length(second) > least) {
      first = {{0, h}, 'H'};
      second = {{h, second.along.high}, 'C'};
    }
    CourseUnit &last = units.back(), &before = units[units.size() - 2];
    if (is_free(false) && length(last) < least && before.letter == 'H' && length(before) > least) {
      const double end = last.along.high;
      before = {{before.along.low, end - h}, 'C'};
      last = {{end - h, end}, 'H'};
    }
  }

  const BuildingPlan& plan_;
  const PlannedWall& wall_;
};

class BuildingCourses {
 public:
  BuildingCourses(const Building& building, BuildingPlan plan) : b_(building), plan_(std::move(plan)) {}

  SolidParts run() {
    out_.notes = std::move(plan_.notes);
    base();
    int course = 0;  // from the very bottom, because walls alternate from storey to storey too
    for (std::size_t s = 0; s < plan_.storeys.size(); ++s) {
      for (int c = 0; c < plan_.storeys[s].courses(); ++c, ++course)
        for (const PlannedWall& wall : plan_.walls)
          lay(wall, s, c, (wall.axis == 0) == ((course % 2 == 0) != b_.first_along_y));
      beams(s);
      floor(s);
    }
    if (joined_ > 0)
      out_.notes.push_back(fmt::format("{}: {} pieces shorter than {:g} m were merged with a neighbour", plan_.owner,
                                       joined_, plan_.least));
    const UnitQuaternion rotation = checked_turn({.axis = {0, 0, 1}, .angle = b_.angle}, plan_.owner);
    for (SolidPart& part : out_.parts) place_part(part, rotation, b_.at);
    return std::move(out_);
  }

 private:
  void add(const std::string& piece, std::vector<Polyhedron> pieces, std::vector<std::string> groups,
           const std::string& wall) {
    for (const std::string& group : {wall, b_.name})
      if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
    out_.parts.push_back({part_name(b_.name, part_name(wall, piece)), std::move(pieces), std::move(groups)});
  }

  void base() {
    const Masonry& m = b_.masonry;
    if (m.base_height == 0) return;
    const Vec2 low = plan_.low - Vec2::Constant(m.base_margin), high = plan_.high + Vec2::Constant(m.base_margin);
    add("base", {box_between({low.x(), low.y(), -m.base_height}, {high.x(), high.y(), 0})}, {"base"}, "");
  }

  void floor(std::size_t s) {
    const PlannedStorey& storey = plan_.storeys[s];
    if (!(storey.top > storey.line.back())) return;
    add(fmt::format("s{}.floor", s + 1),
        prisms_between(plan_.floor, OutlinePlane::level, storey.line.back(), storey.top),
        {"floors", fmt::format("storey {}", s + 1)}, "");
  }

  /// `axis` 0: `along` is along x, 1: along y.
  static Polyhedron box_of(int axis, const Stretch& along, const Stretch& across, double low, double high) {
    const Stretch &x = axis == 0 ? along : across, &y = axis == 0 ? across : along;
    return box_between({x.low, y.low, low}, {x.high, y.high, high});
  }

  /// Lays one course of a wall: its stretches between walls that run through, openings, lintels and pockets, the units
  /// of each, and the filling of pockets behind the ends of beams.
  void lay(const PlannedWall& wall, std::size_t s, int c, bool through) {
    const double same = 1e-9 * plan_.unit;
    std::vector<Stretch> taken;
    if (!through) taken = wall.junctions;
    for (const WallVoid& v : wall.voids[s])
      if (c >= v.first && c < v.end) taken.push_back(v.along);
    std::vector<const BeamPocket*> pockets;
    for (const BeamPocket& pocket : wall.pockets[s])
      if (c >= pocket.first && c < pocket.end) taken.push_back(pocket.along), pockets.push_back(&pocket);
    const std::vector<CourseUnit> whole = CourseLayout(plan_, wall).units(through);
    int number = 0;
    auto next = pockets.begin();
    const auto fill_before = [&](double place) {
      for (; next != pockets.end() && (*next)->along.low < place; ++next) fill(wall, **next, s, c, number);
    };
    for (const Stretch& run : between(wall.along, taken, same)) {
      fill_before(run.low);
      if (run.high - run.low < plan_.least * (1 - 1e-9)) refuse_short(wall, pockets, run, s, c);
      for (const CourseUnit& unit : without_short(units_in(wall, whole, run, same)))
        unit_of(wall, unit, s, c, ++number);
    }
    fill_before(wall.along.high);
    lintels(wall, s, c);
  }

  /// Fills the thickness that beams do not occupy.
  void fill(const PlannedWall& wall, const BeamPocket& pocket, std::size_t s, int c, int& number) {
    for (const Stretch& across : between(wall.across, pocket.beams, 1e-6 * plan_.unit))
      unit_box(wall, pocket.along, across, s, c, std::to_string(++number));
  }

  /// Handles a stretch of masonry that is too short: next to a pocket, an opening or a lintel it is rejected.
  void refuse_short(const PlannedWall& wall, const std::vector<const BeamPocket*>& pockets, const Stretch& run,
                    std::size_t s, int c) const {
    for (const BeamPocket* pocket : pockets)
      if (pocket->along.high == run.low || pocket->along.low == run.high)
        throw InputError(fmt::format(
            "{}: storey {}: beams: the pocket of beam {} leaves a piece of {:g} m in course {} of wall '{}', from {} = "
            "{:g} to {:g} m, shorter than the least length of {:g} m. Move the beams by spacing, count, from or to, or "
            "give a smaller least_length",
            plan_.owner, s + 1, pocket->beam, run.high - run.low, c + 1, wall.name, wall.axis == 0 ? "x" : "y", run.low,
            run.high, plan_.least));
    for (const WallVoid& v : wall.voids[s])
      if (c >= v.first && c < v.end && (v.along.high == run.low || v.along.low == run.high))
        throw InputError(fmt::format(
            "{}, storey {}, course {}: the masonry from {} = {:g} to {:g} m is {:g} m long, less than the least length "
            "of {:g} m; move the opening, {}or give a smaller least_length",
            title_of(plan_, wall), s + 1, c + 1, wall.axis == 0 ? "x" : "y", run.low, run.high, run.high - run.low,
            plan_.least, v.lintel ? "give its lintel another bearing, " : ""));
  }

  /// Units of the whole course cut to a run, in the direction of the axis, with its exact ends.
  [[nodiscard]] std::vector<CourseUnit> units_in(const PlannedWall& wall, const std::vector<CourseUnit>& whole,
                                                 const Stretch& run, double same) const {
    std::vector<CourseUnit> units;
    for (const CourseUnit& unit : whole) {
      const Stretch along = wall.forward ? Stretch{wall.along.low + unit.along.low, wall.along.low + unit.along.high}
                                         : Stretch{wall.along.high - unit.along.high, wall.along.high - unit.along.low};
      if (overlaps(along, run, same)) units.push_back({along, unit.letter});
    }
    if (!wall.forward) std::reverse(units.begin(), units.end());
    if (units.empty()) return units;
    units.front().along.low = run.low, units.back().along.high = run.high;
    for (std::size_t i = 1; i < units.size(); ++i) units[i].along.low = units[i - 1].along.high;
    return units;
  }

  /// A short piece becomes part of its shorter neighbour, with the letter of the longer of both.
  std::vector<CourseUnit> without_short(std::vector<CourseUnit> units) {
    const auto length = [&](std::size_t i) { return units[i].along.high - units[i].along.low; };
    for (std::size_t i = 0; i < units.size() && units.size() > 1;) {
      if (length(i) >= plan_.least * (1 - 1e-9)) {
        ++i;
        continue;
      }
      const bool to_next = i == 0 || (i + 1 < units.size() && length(i + 1) < length(i - 1));
      const std::size_t first = to_next ? i : i - 1;
      units[first] = {{units[first].along.low, units[first + 1].along.high}, units[to_next ? i + 1 : i - 1].letter};
      units.erase(units.begin() + static_cast<std::ptrdiff_t>(first) + 1);
      ++joined_;
      i = first;
    }
    return units;
  }

  void unit_of(const PlannedWall& wall, const CourseUnit& unit, std::size_t s, int c, int number) {
    const int leaves = unit.letter == 'S' ? wall.bond->leaves : 1;
    double from = wall.across.low;
    for (int leaf = 1; leaf <= leaves; ++leaf) {
      const double to =
          leaf == leaves ? wall.across.high : wall.across.low + (wall.across.high - wall.across.low) * leaf / leaves;
      const char mark = static_cast<char>('a' + leaf - 1);
      unit_box(wall, unit.along, {from, to}, s, c,
               fmt::format("{}{}", number, leaves > 1 ? std::string(1, mark) : std::string()));
      from = to;
    }
  }

  void unit_box(const PlannedWall& wall, const Stretch& along, const Stretch& across, std::size_t s, int c,
                const std::string& number) {
    const PlannedStorey& storey = plan_.storeys[s];
    const double low = storey.line[static_cast<std::size_t>(c)], high = storey.line[static_cast<std::size_t>(c) + 1];
    add(fmt::format("s{}.c{}.u{}", s + 1, c + 1, number), {box_of(wall.axis, along, across, low, high)},
        {"units", fmt::format("storey {}", s + 1), fmt::format("course {}", c + 1)}, wall.name);
  }

  void beams(std::size_t s) {
    const PlannedStorey& storey = plan_.storeys[s];
    int number = 0;
    for (const PlannedBeam& beam : storey.beams)
      add(fmt::format("s{}.beam{}", s + 1, ++number),
          {box_of(beam.axis, beam.along, beam.across, storey.line[static_cast<std::size_t>(beam.first)],
                  storey.line[static_cast<std::size_t>(beam.end)])},
          {"beams", "floors", fmt::format("storey {}", s + 1)}, "");
  }

  /// Lays the lintels that begin in this course.
  void lintels(const PlannedWall& wall, std::size_t s, int c) {
    const PlannedStorey& storey = plan_.storeys[s];
    int number = 0;
    for (const WallVoid& v : wall.voids[s]) {
      if (!v.lintel) continue;
      ++number;
      if (v.first != c) continue;
      add(fmt::format("s{}.lintel{}", s + 1, number),
          {box_of(wall.axis, v.along, wall.across, storey.line[static_cast<std::size_t>(v.first)],
                  storey.line[static_cast<std::size_t>(v.end)])},
          {"lintels", fmt::format("storey {}", s + 1)}, wall.name);
    }
  }

  const Building& b_;
  BuildingPlan plan_;
  SolidParts out_;
  int joined_ = 0;
};

}  // namespace

SolidParts build_building(const Building& building) {
  Building named = building;
  for (std::size_t w = 0; w < named.walls.size(); ++w)
    if (named.walls[w].name.empty()) named.walls[w].name = fmt::format("w{}", w + 1);
  const std::string owner = builder_title("building", building.name);
  return BuildingCourses(named, plan_building(named, owner)).run();
}

SolidParts build_solid_wall(const SolidWall& wall) {
  const std::string owner = builder_title("wall", wall.name);
  require_positive(wall.length, owner + ": length", "m");
  Building building{
      .name = wall.name, .storeys = wall.storeys, .masonry = wall.masonry, .at = wall.at, .angle = wall.angle};
  building.walls.push_back(
      {.name = {}, .start = {0, 0}, .end = {wall.length, 0}, .thickness = wall.thickness, .openings = wall.openings});
  BuildingPlan plan = plan_building(building, owner);
  // the line of a plan is the middle of the thickness; for a single wall it is its front
  PlannedWall& only = plan.walls[0];
  only.across = {0, only.across.high - only.across.low};
  plan.low.y() = 0, plan.high.y() = only.across.high;
  const Vec2 more = Vec2::Constant(wall.masonry.slab_overhang);
  plan.floor = rectangle(plan.low - more, plan.high + more);
  return BuildingCourses(building, std::move(plan)).run();
}

SolidParts Building::parts() const {
  check_keys(*this, builder_title(kind, name));
  return build_building(*this);
}

SolidParts SolidWall::parts() const {
  check_keys(*this, builder_title(kind, name));
  return build_solid_wall(*this);
}

}  // namespace trilith
