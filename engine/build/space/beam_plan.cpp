#include "build/space/beam_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr const char* axis_names[] = {"x", "y"};

/// The beams of one row in one storey.
class BeamRowPlan {
 public:
  BeamRowPlan(BuildingPlan& plan, const BeamRow& row, std::size_t storey, std::string owner)
      : plan_(plan), row_(row), s_(storey), owner_(std::move(owner)), axis_(row.along_y ? 1 : 0) {}

  void run() {
    courses();
    part_of_plan();
    for (const Stretch& line : lines()) lay(line);
  }

 private:
  [[nodiscard]] const char* along() const { return axis_names[axis_]; }
  [[nodiscard]] const char* across() const { return axis_names[1 - axis_]; }
  [[nodiscard]] PlannedStorey& storey() const { return plan_.storeys[s_]; }

  [[nodiscard]] std::string title(int number, const Stretch& line) const {
    return fmt::format("{}: beam {} from {} = {:g} to {:g} m", owner_, number, across(), line.low, line.high);
  }

  void courses() {
    const double height = require_not_negative(row_.height, owner_ + ": height", "m");
    const double given = height == 0 ? 1 : height / plan_.course, whole = std::max(1.0, std::round(given));
    if (std::abs(given - whole) > 1e-6) {
      const double below = std::max(1.0, std::floor(given)) * plan_.course;
      throw InputError(
          fmt::format("{}: height is {:g} m, must be a whole number of courses of {:g} m; {:g} or {:g} m would fit",
                      owner_, height, plan_.course, below, below + plan_.course));
    }
    end_ = storey().courses();
    if (whole > end_)
      throw InputError(fmt::format("{}: height is {:g} m, must be at most the height of the storey's courses, {:g} m",
                                   owner_, height, end_ * plan_.course));
    first_ = end_ - static_cast<int>(whole);
  }

  void part_of_plan() {
    const Vec2 a = row_.from.value_or(plan_.low), b = row_.to.value_or(plan_.high);
    for (const Vec2* corner : {&a, &b})
      require_finite(corner->x(), owner_ + ": x of a corner"), require_finite(corner->y(), owner_ + ": y of a corner");
    const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
    if ((high - low).minCoeff() <= same_)
      throw InputError(
          fmt::format("{}: from ({:g}, {:g}) to ({:g}, {:g}) has no area; give opposite corners of a part "
                      "of the plan, on the lines of its walls",
                      owner_, a.x(), a.y(), b.x(), b.y()));
    span_ = {low[axis_], high[axis_]};
    room_ = {low[1 - axis_], high[1 - axis_]};
    clear_room();
  }

  /// Walls along the beams at which the part of the plan ends reduce it to the distance between their faces.
  void clear_room() {
    const Stretch all = room_;
    for (const PlannedWall& wall : plan_.walls) {
      if (wall.axis != axis_ || !overlaps(wall.along, span_, same_)) continue;
      const auto holds = [&](double at) { return wall.across.low <= at + same_ && wall.across.high >= at - same_; };
      if (holds(all.low)) room_.low = std::max(room_.low, wall.across.high);
      if (holds(all.high)) room_.high = std::min(room_.high, wall.across.low);
    }
    if (room_.high - room_.low <= same_)
      throw InputError(fmt::format("{}: there is no room between the walls along {} from {} = {:g} to {:g} m", owner_,
                                   along(), across(), all.low, all.high));
  }

  /// Positions of the beams across their span: centred, at half a spacing or more from the sides.
  [[nodiscard]] std::vector<Stretch> lines() const {
    const double room = room_.high - room_.low, width = require_positive(row_.width, owner_ + ": width", "m");
    const int count = beams_in(room);
    const double spacing = row_.spacing > 0 ? row_.spacing : room / count;
    if (const double all = (count - 1) * std::max(spacing, width) + width; all > room * (1 + 1e-9))
      throw InputError(
          fmt::format("{}: {} {} of {:g} m width {} {:g} m, but the room has {:g} m, from {} = {:g} to {:g} m; "
                      "give fewer, narrower or closer beams",
                      owner_, count, count == 1 ? "beam" : "beams", width, count == 1 ? "needs" : "need", all, room,
                      across(), room_.low, room_.high));
    std::vector<Stretch> lines;
    for (int i = 0; i < count; ++i) {
      const double middle = (room_.low + room_.high) / 2 + (i - (count - 1) / 2.0) * spacing;
      lines.push_back({middle - width / 2, middle + width / 2});
    }
    return lines;
  }

  [[nodiscard]] int beams_in(double room) const {
    require_not_negative(row_.spacing, owner_ + ": spacing", "m");
    if (row_.spacing > 0 && row_.spacing < row_.width * (1 - 1e-9) && row_.count != 1)
      throw InputError(
          fmt::format("{}: spacing is {:g} m, must be at least the width of a beam, {:g} m: it is measured "
                      "from centre to centre",
                      owner_, row_.spacing, row_.width));
    if (row_.count) return require_count(*row_.count, 1, 10'000, owner_ + ": count");
    if (row_.spacing == 0) throw InputError(owner_ + ": give their spacing in m from centre to centre, or their count");
    const double held = std::floor(room / row_.spacing + 1e-9);
    if (held < 1)
      throw InputError(
          fmt::format("{}: spacing is {:g} m, more than the room from {} = {:g} to {:g} m, {:g} m; give a smaller "
                      "spacing, or a count",
                      owner_, row_.spacing, across(), room_.low, room_.high, room));
    require_buildable(held, owner_);
    return static_cast<int>(held);
  }

  void lay(const Stretch& line) {
    const int number = static_cast<int>(storey().beams.size()) + 1;
    const std::string beam = title(number, line);
    const std::vector<PlannedWall*> walls = walls_across(line, beam);
    const PlannedWall &low = *walls.front(), &high = *walls.back();
    const PlannedBeam made{axis_, {end_in(low, true, beam), end_in(high, false, beam)}, line, first_, end_};
    refuse_walls_along(made, beam);
    refuse_beams(made, beam);
    for (PlannedWall* wall : walls) add_pocket(*wall, made, number, beam);
    storey().beams.push_back(made);
  }

  /// Walls that a line crosses within the part of the plan, sorted by coordinate; at least two.
  [[nodiscard]] std::vector<PlannedWall*> walls_across(const Stretch& line, const std::string& beam) const {
    std::vector<PlannedWall*> found;
    for (PlannedWall& wall : plan_.walls) {
      if (wall.axis == axis_ || !overlaps(wall.along, line, same_)) continue;
      if (wall.across.low > span_.high + same_ || wall.across.high < span_.low - same_) continue;
      if (wall.along.low > line.low + same_ || wall.along.high < line.high - same_)
        throw InputError(
            fmt::format("{} lies on wall '{}' with only a part of its width, because the wall reaches from {:g} to "
                        "{:g} m; move it by spacing, count, from or to",
                        beam, wall.name, wall.along.low, wall.along.high));
      found.push_back(&wall);
    }
    std::sort(found.begin(), found.end(),
              [](const PlannedWall* a, const PlannedWall* b) { return a->across.low < b->across.low; });
    if (found.size() < 2) refuse_end(found, beam);
    return found;
  }

  [[noreturn]] void refuse_end(const std::vector<PlannedWall*>& found, const std::string& beam) const {
    const std::string reach = fmt::format("{} = {:g} to {:g} m", along(), span_.low, span_.high);
    const char* const hint = "each end of a beam needs a wall across it; check along, from and to";
    if (found.empty()) throw InputError(fmt::format("{} has no wall at its ends from {}; {}", beam, reach, hint));
    const Stretch& face = found[0]->across;
    const bool above = face.low + face.high < span_.low + span_.high;
    throw InputError(fmt::format("{} has no wall at its end towards {}{}: from {} there is only '{}'; {}", beam,
                                 above ? "+" : "-", along(), reach, found[0]->name, hint));
  }

  /// Coordinate of a beam's end, in the wall at its low or its high end.
  [[nodiscard]] double end_in(const PlannedWall& wall, bool at_low, const std::string& beam) const {
    const double thickness = wall.across.high - wall.across.low;
    if (!row_.bearing) return at_low ? wall.across.low : wall.across.high;
    const double bearing = require_positive(*row_.bearing, owner_ + ": bearing", "m"), behind = thickness - bearing;
    if (std::abs(behind) <= same_) return at_low ? wall.across.low : wall.across.high;
    if (behind < 0)
      throw InputError(fmt::format("{} has a bearing of {:g} m, must be at most the thickness of wall '{}', {:g} m",
                                   beam, bearing, wall.name, thickness));
    return at_low ? wall.across.high - bearing : wall.across.low + bearing;
  }

  void refuse_walls_along(const PlannedBeam& made, const std::string& beam) const {
    for (const PlannedWall& wall : plan_.walls)
      if (wall.axis == axis_ && overlaps(wall.across, made.across, same_) && overlaps(wall.along, made.along, same_))
        throw InputError(
            fmt::format("{} lies in wall '{}', which runs along it from {} = {:g} to {:g} m; move it by spacing or "
                        "count, or give each room its own row, with from and to",
                        beam, wall.name, across(), wall.across.low, wall.across.high));
  }

  void refuse_beams(const PlannedBeam& made, const std::string& beam) const {
    int number = 0;
    for (const PlannedBeam& other : storey().beams) {
      ++number;
      const bool beside = other.axis == axis_;
      const Stretch &along = beside ? other.along : other.across, &across = beside ? other.across : other.along;
      if (made.first < other.end && other.first < made.end && overlaps(made.along, along, same_) &&
          overlaps(made.across, across, same_))
        throw InputError(
            fmt::format("{} runs into beam {}; give each row its own part of the plan, with from and to, and a "
                        "bearing of at most half the wall between them",
                        beam, number));
    }
  }

  void add_pocket(PlannedWall& wall, const PlannedBeam& made, int number, const std::string& beam) {
    for (const Stretch& junction : wall.junctions)
      if (overlaps(made.across, junction, same_))
        throw InputError(
            fmt::format("{} has its pocket in wall '{}' where another wall meets it, from {:g} to {:g} m; move "
                        "it by spacing, count, from or to",
                        beam, wall.name, junction.low, junction.high));
    refuse_voids(wall, made, beam);
    BeamPocket pocket{made.across, made.first, made.end, {}, number};
    pocket.beams = {{std::max(made.along.low, wall.across.low), std::min(made.along.high, wall.across.high)}};
    std::vector<BeamPocket>& pockets = wall.pockets[s_];
    const auto shared = std::find_if(pockets.begin(), pockets.end(), [&](const BeamPocket& other) {
      return overlaps(other.along, made.across, same_) && other.first < made.end;
    });
    if (shared != pockets.end()) {
      require_in_line(*shared, pocket, wall, beam);
      shared->beams.push_back(pocket.beams[0]);
      pocket = *shared;
    } else {
      pockets.push_back(pocket);
    }
    refuse_thin_filling(wall, pocket, beam);
  }

  /// Beams that end at opposite faces of a wall share a pocket.
  void require_in_line(const BeamPocket& other, const BeamPocket& made, const PlannedWall& wall,
                       const std::string& beam) const {
    if (std::abs(other.along.low - made.along.low) <= same_ && std::abs(other.along.high - made.along.high) <= same_ &&
        other.first == made.first)
      return;
    throw InputError(
        fmt::format("{} meets the pocket of beam {} in wall '{}', from {:g} to {:g} m. Two beams that end in a wall "
                    "from both sides must be in line with the same width and height, or side by side",
                    beam, other.beam, wall.name, other.along.low, other.along.high));
  }

  /// Rejects openings and lintels in the courses of a pocket, and openings that end directly below it.
  void refuse_voids(const PlannedWall& wall, const PlannedBeam& made, const std::string& beam) const {
    const std::vector<WallVoid>& voids = wall.voids[s_];
    const auto where = [&](const WallVoid& v) {
      return fmt::format("{} of wall '{}', from {:g} to {:g} m", v.lintel ? "a lintel" : "an opening", wall.name,
                         v.along.low, v.along.high);
    };
    const int courses = made.end - made.first;
    for (const WallVoid& v : voids)
      if (v.end > made.first && overlaps(v.along, made.across, same_))
        throw InputError(
            fmt::format("{} has its pocket on {}, which reaches into the top {} of the storey; move the "
                        "beam by spacing, count, from or to, or lower the opening",
                        beam, where(v), courses == 1 ? "course" : fmt::format("{} courses", courses)));
    for (const WallVoid& v : voids)
      if (!v.lintel && v.end == made.first && overlaps(v.along, made.across, same_)) refuse_hollow(where(v), beam);
    if (made.first > 0 || s_ == 0) return;
    const PlannedStorey& below = plan_.storeys[s_ - 1];
    if (below.top > below.line.back()) return;
    for (const WallVoid& v : wall.voids[s_ - 1])
      if (!v.lintel && v.end == below.courses() && overlaps(v.along, made.across, same_))
        refuse_hollow(where(v) + " in the storey below", beam);
  }

  [[noreturn]] void refuse_hollow(const std::string& where, const std::string& beam) const {
    throw InputError(
        fmt::format("{} lies over {}, without a lintel under it; give the opening a lintel, or move the beam by "
                    "spacing, count, from or to",
                    beam, where));
  }

  void refuse_thin_filling(const PlannedWall& wall, const BeamPocket& pocket, const std::string& beam) const {
    for (const Stretch& filling : between(wall.across, pocket.beams, same_))
      if (const double depth = filling.high - filling.low; depth < plan_.least * (1 - 1e-9))
        throw InputError(
            fmt::format("{} leaves {:g} m of wall '{}' behind its end, less than the least length of a piece, {:g} m; "
                        "give another bearing, none for the whole thickness, or a smaller least_length",
                        beam, depth, wall.name, plan_.least));
  }

  BuildingPlan& plan_;
  const BeamRow& row_;
  std::size_t s_;
  std::string owner_;
  int axis_;
  double same_ = 1e-6 * plan_.unit;
  int first_ = 0, end_ = 0;  // courses of the storey
  Stretch span_;             // of the part of the plan, along the beams
  Stretch room_;             // across the beams, between the walls
};

}  // namespace

void plan_beams(const Building& building, BuildingPlan& plan) {
  for (PlannedWall& wall : plan.walls) wall.pockets.resize(plan.storeys.size());
  for (std::size_t s = 0; s < plan.storeys.size(); ++s) {
    const std::optional<std::vector<BeamRow>>& own = building.storeys[s].beams;
    const std::vector<BeamRow>& rows = own ? *own : building.beams;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::string row = rows.size() > 1 ? fmt::format(", row {}", r + 1) : std::string();
      BeamRowPlan(plan, rows[r], s, fmt::format("{}: storey {}: beams{}", plan.owner, s + 1, row)).run();
    }
    for (PlannedWall& wall : plan.walls)
      std::sort(wall.pockets[s].begin(), wall.pockets[s].end(),
                [](const BeamPocket& a, const BeamPocket& b) { return a.along.low < b.along.low; });
  }
}

}  // namespace trilith
