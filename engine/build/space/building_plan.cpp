#include "build/space/building_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "build/space/beam_plan.hpp"
#include "geometry/plane/half_plane.hpp"

namespace trilith {
namespace {

// Headers of the second course lie over the middle of the unit below: a stretcher in English and Flemish bond.
constexpr std::array leaf_patterns{
    LeafBond{"stretcher", "stretchers as thick as the wall, each centred over a joint of the course below", "S", "S",
             0.5, 0, 1},
    LeafBond{"header", "headers through the wall, each centred over a joint of the course below", "H", "H", 0, 0.5, 1},
    LeafBond{"english", "courses of two leaves of stretchers alternate with courses of headers", "S", "H", 0, 0.5, 2},
    LeafBond{"flemish", "pairs of stretchers side by side alternate with headers", "SH", "SH", 0.5, 0.5, 2},
};

const LeafBond& find_leaf_bond(std::string_view name, std::string_view owner) {
  std::vector<std::string> known;
  for (const LeafBond& bond : leaf_patterns) {
    if (bond.name == name) return bond;
    known.emplace_back(bond.name);
  }
  throw InputError(fmt::format("{}: there is no bond '{}'{}", owner, name, name_hint(name, known)));
}

bool has_headers(const LeafBond& bond) {
  return bond.first.find('H') != std::string_view::npos || bond.second.find('H') != std::string_view::npos;
}

/// The area of an outline within a box [m2].
double area_within(const Polygon& outline, const Vec2& low, const Vec2& high) {
  std::vector<Polygon> left{outline};
  for (const HalfPlane& side : {HalfPlane{{-1, 0}, -low.x()}, HalfPlane{{1, 0}, high.x()}, HalfPlane{{0, -1}, -low.y()},
                                HalfPlane{{0, 1}, high.y()}}) {
    std::vector<Polygon> inside;
    for (const Polygon& part : left)
      for (Polygon& cut : cut_by(part, side, 0)) inside.push_back(std::move(cut));
    left = std::move(inside);
  }
  double area = 0;
  for (const Polygon& part : left) area += signed_area(part);
  return area;
}

class Planner {
 public:
  Planner(const Building& building, const std::string& owner) : b_(building) {
    plan_.owner = owner;
    check_sizes();
    storeys();
    footprints();
    extend_ends();
    refuse_too_many();
    refuse_overlaps();
    junctions();
    for (std::size_t w = 0; w < plan_.walls.size(); ++w) openings(w);
    outline();
  }

  BuildingPlan take() { return std::move(plan_); }

 private:
  [[nodiscard]] std::string wall_title(std::size_t w) const { return title_of(plan_, plan_.walls[w]); }

  void check_sizes() {
    const Masonry& m = b_.masonry;
    const std::string& owner = plan_.owner;
    plan_.unit = require_positive(m.unit_length, owner + ": unit length", "m");
    plan_.course = require_positive(m.unit_height, owner + ": unit height", "m");
    plan_.header = require_not_negative(m.header_length, owner + ": header length", "m");
    if (plan_.header == 0) plan_.header = plan_.unit / 2;
    plan_.least = require_not_negative(m.least_length, owner + ": least length", "m");
    if (plan_.least == 0) plan_.least = plan_.unit / 5;
    if (plan_.least > plan_.unit / 2)
      throw InputError(fmt::format("{}: least length is {:g} m, must be at most half a unit, {:g} m", owner,
                                   plan_.least, plan_.unit / 2));
    require_not_negative(m.lintel_height, owner + ": lintel height", "m");
    require_not_negative(m.lintel_bearing, owner + ": lintel bearing", "m");
    require_not_negative(m.slab_height, owner + ": slab height", "m");
    require_not_negative(m.slab_overhang, owner + ": slab overhang", "m");
    require_not_negative(m.base_height, owner + ": base height", "m");
    require_not_negative(m.base_margin, owner + ": base margin", "m");
    require_place(b_.at, owner);
    require_finite(b_.angle, owner + ": angle");
  }

  /// By number, by height, or by both if they agree.
  [[nodiscard]] int count_courses(const MasonryStorey& storey, double slab, const std::string& owner) const {
    require_not_negative(storey.height, owner + ": height", "m");
    if (storey.courses == 0) return courses_within(storey.height, slab, owner);
    const int courses = require_count(storey.courses, 1, 100000, owner + ": number of courses");
    if (const int held = storey.height > 0 ? courses_within(storey.height, slab, owner) : courses; held != courses)
      throw InputError(fmt::format("{}: {} courses are given, but its height of {:g} m holds {}; keep one of the two",
                                   owner, courses, storey.height, held));
    return courses;
  }

  /// Levels of all storeys above the foot of the first one.
  void storeys() {
    require_count(static_cast<int>(b_.storeys.size()), 1, 1000, plan_.owner + ": number of storeys");
    double foot = 0, all = 0;
    for (std::size_t s = 0; s < b_.storeys.size(); ++s) {
      MasonryStorey storey = b_.storeys[s];
      if (storey.courses == 0 && storey.height == 0)
        storey.courses = b_.masonry.courses, storey.height = b_.masonry.storey_height;
      const std::string owner = fmt::format("{}: storey {}", plan_.owner, s + 1);
      const double slab = storey.slab_height < 0
                              ? b_.masonry.slab_height
                              : require_not_negative(storey.slab_height, owner + ": slab height", "m");
      const int courses = count_courses(storey, slab, owner);
      all += courses;
      require_buildable(all, plan_.owner);
      PlannedStorey planned;
      for (int c = 0; c <= courses; ++c) planned.line.push_back(foot + plan_.course * c);
      planned.top = foot = planned.line.back() + slab;
      plan_.storeys.push_back(std::move(planned));
    }
  }

  /// Counts the units of all walls in all courses.
  void refuse_too_many() const {
    double courses = 0, leaves = 0;
    for (const PlannedStorey& storey : plan_.storeys) courses += storey.courses();
    for (const PlannedWall& wall : plan_.walls)
      leaves += (wall.along.high - wall.along.low) / std::min(plan_.unit, plan_.header);
    require_buildable(courses * leaves, plan_.owner);
  }

  [[nodiscard]] int courses_within(double height, double slab, const std::string& owner) const {
    require_positive(height, owner + ": height", "m");
    const double courses = (height - slab) / plan_.course, whole = std::round(courses);
    if (std::abs(courses - whole) > 1e-6 || whole < 1)
      throw InputError(
          fmt::format("{}: height is {:g} m, which is {:.4g} courses of {:g} m and a slab of {:g} m; with "
                      "{:.0f} courses it is {:g} m",
                      owner, height, courses, plan_.course, slab, std::max(1.0, whole),
                      std::max(1.0, whole) * plan_.course + slab));
    return require_count(static_cast<int>(std::min(whole, 1e6)), 1, 100000, owner + ": number of courses");
  }

  void footprints() {
    require_count(static_cast<int>(b_.walls.size()), 1, 1000, plan_.owner + ": number of walls");
    for (const PlanWall& wall : b_.walls) {
      PlannedWall planned;
      planned.name = wall.name;
      for (const PlannedWall& other : plan_.walls)
        if (other.name == wall.name)
          throw InputError(fmt::format("{}: there are two walls '{}'; give each its own name", plan_.owner, wall.name));
      plan_.walls.push_back(planned);
      lay_out(wall, plan_.walls.size() - 1);
    }
  }

  void lay_out(const PlanWall& wall, std::size_t w) {
    PlannedWall& p = plan_.walls[w];
    const std::string owner = wall_title(w);
    for (const Vec2* end : {&wall.start, &wall.end})
      require_finite(end->x(), owner + ": x of an end"), require_finite(end->y(), owner + ": y of an end");
    const Vec2 way = wall.end - wall.start;
    const double length = way.cwiseAbs().maxCoeff();
    if (length == 0) throw InputError(fmt::format("{}: its ends are the same point", owner));
    if (way.cwiseAbs().minCoeff() > 1e-9 * length)
      throw InputError(
          fmt::format("{}: runs from ({:g}, {:g}) to ({:g}, {:g}); walls of a plan run along x or y; rotate the whole "
                      "plan by its angle",
                      owner, wall.start.x(), wall.start.y(), wall.end.x(), wall.end.y()));
    p.axis = std::abs(way.x()) == length ? 0 : 1;
    p.forward = way[p.axis] > 0;
    p.along = {std::min(wall.start[p.axis], wall.end[p.axis]), std::max(wall.start[p.axis], wall.end[p.axis])};
    p.bond = &find_leaf_bond(wall.bond.empty() ? b_.masonry.bond : wall.bond, owner);
    double thickness = require_not_negative(wall.thickness, owner + ": thickness", "m");
    if (thickness == 0) thickness = has_headers(*p.bond) ? plan_.unit : plan_.unit / 2;
    const double middle = wall.start[1 - p.axis];
    p.across = {middle - thickness / 2, middle + thickness / 2};
  }

  /// True if the end of a wall's line at `end` lies in the thickness of another wall.
  [[nodiscard]] bool ends_in(const PlannedWall& wall, double end, const PlannedWall& other) const {
    const double same = 1e-6 * plan_.unit;
    return wall.axis != other.axis && end >= other.across.low - same && end <= other.across.high + same &&
           wall.across.high >= other.along.low - same && wall.across.low <= other.along.high + same;
  }

  /// Uses the lines as given, so that the order of walls does not matter.
  void extend_ends() {
    const std::vector<PlannedWall> given = plan_.walls;
    for (std::size_t w = 0; w < given.size(); ++w)
      for (const PlannedWall& other : given) {
        Stretch& along = plan_.walls[w].along;
        if (ends_in(given[w], given[w].along.low, other)) along.low = std::min(along.low, other.across.low);
        if (ends_in(given[w], given[w].along.high, other)) along.high = std::max(along.high, other.across.high);
      }
    // the same face may be given by two walls: an end close to a face is moved onto it
    for (PlannedWall& wall : plan_.walls)
      for (const PlannedWall& other : given)
        if (wall.axis != other.axis)
          for (double* end : {&wall.along.low, &wall.along.high})
            for (const double face : {other.across.low, other.across.high})
              if (std::abs(*end - face) <= 1e-9 * plan_.unit) *end = face;
  }

  [[nodiscard]] bool share_room(const PlannedWall& a, const PlannedWall& b) const {
    const double same = 1e-6 * plan_.unit;
    return a.axis == b.axis ? overlaps(a.along, b.along, same) && overlaps(a.across, b.across, same)
                            : overlaps(a.along, b.across, same) && overlaps(a.across, b.along, same);
  }

  void refuse_overlaps() const {
    for (std::size_t i = 0; i < plan_.walls.size(); ++i)
      for (std::size_t j = i + 1; j < plan_.walls.size(); ++j)
        if (plan_.walls[i].axis == plan_.walls[j].axis && share_room(plan_.walls[i], plan_.walls[j]))
          throw InputError(fmt::format(
              "{}: walls '{}' and '{}' overlap along their length; give walls in line as one wall, or move one of them",
              plan_.owner, plan_.walls[i].name, plan_.walls[j].name));
  }

  void junctions() {
    for (PlannedWall& wall : plan_.walls) {
      for (const PlannedWall& other : plan_.walls)
        if (wall.axis != other.axis && share_room(wall, other)) wall.junctions.push_back(other.across);
      std::sort(wall.junctions.begin(), wall.junctions.end(),
                [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
    }
  }

  /// The course line at a height above the storey's foot.
  int line_at(double height, const PlannedStorey& storey, const std::string& what) {
    const double courses = height / plan_.course, whole = std::round(courses);
    if (std::abs(courses - whole) > 1e-6) {
      const double nearest = whole * plan_.course;
      if (!b_.masonry.snap)
        throw InputError(
            fmt::format("{} is at {:g} m, which is not a course line; the nearest is at {:g} m; or set snap = true",
                        what, height, nearest));
      plan_.notes.push_back(
          fmt::format("{} was moved from {:g} m to the course line at {:g} m", what, height, nearest));
    }
    if (whole < 0 || whole > storey.courses())
      throw InputError(fmt::format("{} is at {:g} m, must be from 0 to {:g} m, where the courses end", what, height,
                                   storey.courses() * plan_.course));
    return static_cast<int>(whole);
  }

  void openings(std::size_t w) {
    PlannedWall& wall = plan_.walls[w];
    wall.voids.resize(plan_.storeys.size());
    const auto& given = b_.walls[w].openings;
    for (std::size_t o = 0; o < given.size(); ++o) {
      const std::string owner = fmt::format("{}, opening {}", wall_title(w), o + 1);
      const int storey = require_count(given[o].storey, 1, static_cast<int>(plan_.storeys.size()), owner + ": storey");
      require_finite(given[o].from, owner + ": from");
      require_positive(given[o].width, owner + ": width", "m");
      require_positive(given[o].height, owner + ": height", "m");
      require_finite(given[o].sill, owner + ": sill");
      open_wall(wall, given[o], b_.walls[w].start[wall.axis], static_cast<std::size_t>(storey) - 1, owner);
    }
  }

  void open_wall(PlannedWall& wall, const MasonryOpening& opening, double start, std::size_t s,
                 const std::string& owner) {
    const PlannedStorey& storey = plan_.storeys[s];
    const int sill = line_at(opening.sill, storey, owner + ": its sill");
    const int head = line_at(opening.sill + opening.height, storey, owner + ": its head");
    if (head <= sill) throw InputError(fmt::format("{}: its sill and head are on the same course line", owner));
    const double near_edge = wall.forward ? start + opening.from : start - opening.from - opening.width;
    const Stretch along{near_edge, near_edge + opening.width};
    add_void(wall, {along, sill, head, false}, s, owner);
    if (!opening.lintel || head == storey.courses()) return;
    const double height = opening.lintel_height >= 0 ? opening.lintel_height : b_.masonry.lintel_height;
    const double bearing = opening.lintel_bearing >= 0 ? opening.lintel_bearing : b_.masonry.lintel_bearing;
    const double reach = bearing == 0 ? plan_.unit / 2 : bearing;
    const int top =
        height == 0 ? head + 1 : line_at(opening.sill + opening.height + height, storey, owner + ": its lintel's top");
    add_void(wall, {{along.low - reach, along.high + reach}, head, std::max(top, head + 1), true}, s,
             owner + ": its lintel");
  }

  void add_void(PlannedWall& wall, WallVoid made, std::size_t storey, const std::string& owner) {
    const double same = 1e-6 * plan_.unit;
    if (made.along.low < wall.along.low - same || made.along.high > wall.along.high + same)
      throw InputError(fmt::format("{} reaches from {:g} to {:g} m in {}, outside of the wall from {:g} to {:g} m",
                                   owner, made.along.low, made.along.high, wall.axis == 0 ? "x" : "y", wall.along.low,
                                   wall.along.high));
    for (const Stretch& junction : wall.junctions)
      if (overlaps(made.along, junction, same))
        throw InputError(fmt::format(
            "{} reaches from {:g} to {:g} m in {}, into the wall across from {:g} to {:g} m; "
            "move or shorten it",
            owner, made.along.low, made.along.high, wall.axis == 0 ? "x" : "y", junction.low, junction.high));
    for (const WallVoid& other : wall.voids[storey])
      if (made.first < other.end && made.end > other.first && overlaps(made.along, other.along, same))
        throw InputError(fmt::format("{} lies on another opening or lintel of its storey, from {:g} to {:g} m", owner,
                                     other.along.low, other.along.high));
    wall.voids[storey].push_back(made);
  }

  void outline() {
    plan_.low = Vec2::Constant(INFINITY), plan_.high = -plan_.low;
    for (const PlannedWall& wall : plan_.walls) {
      const Stretch& x = wall.axis == 0 ? wall.along : wall.across;
      const Stretch& y = wall.axis == 0 ? wall.across : wall.along;
      plan_.low = plan_.low.cwiseMin(Vec2(x.low, y.low)), plan_.high = plan_.high.cwiseMax(Vec2(x.high, y.high));
    }
    if (b_.slab_outline.empty()) {
      const Vec2 more = Vec2::Constant(b_.masonry.slab_overhang);
      plan_.floor = rectangle(plan_.low - more, plan_.high + more);
      return;
    }
    CheckedPolygon checked = check_polygon(b_.slab_outline, plan_.owner + ": slab outline");
    plan_.floor = std::move(checked.outline);
    plan_.notes.insert(plan_.notes.end(), checked.notes.begin(), checked.notes.end());
    for (std::size_t s = 1; s < plan_.storeys.size(); ++s)
      if (plan_.storeys[s - 1].top > plan_.storeys[s - 1].line.back())
        for (std::size_t w = 0; w < plan_.walls.size(); ++w) check_foot(w, s);
  }

  /// A wall must stand on the slab below its storey: the thickness of the slab separates it from the wall below.
  void check_foot(std::size_t w, std::size_t s) {
    const PlannedWall& wall = plan_.walls[w];
    std::vector<Stretch> doors;
    for (const WallVoid& v : wall.voids[s])
      if (v.first == 0) doors.push_back(v.along);
    double foot = 0, carried = 0;
    for (const Stretch& run : between(wall.along, doors, 1e-9 * plan_.unit)) {
      const Stretch &x = wall.axis == 0 ? run : wall.across, &y = wall.axis == 0 ? wall.across : run;
      foot += (x.high - x.low) * (y.high - y.low);
      carried += area_within(plan_.floor, {x.low, y.low}, {x.high, y.high});
    }
    if (carried > (1 - 1e-6) * foot) return;
    const std::string what = fmt::format("{}, storey {}", wall_title(w), s + 1);
    const double gap = plan_.storeys[s - 1].top - plan_.storeys[s - 1].line.back();
    if (!(carried > 1e-6 * foot))
      throw InputError(
          fmt::format("{}: the slab below does not reach under it, so it hangs {:g} m above the wall below; extend "
                      "slab_outline under all walls, or leave it out",
                      what, gap));
    plan_.notes.push_back(
        fmt::format("{}: the slab below reaches under {:.3g} % of its foot; the rest hangs {:g} m above the wall below",
                    what, 100 * carried / foot, gap));
  }

  const Building& b_;
  BuildingPlan plan_;
};

}  // namespace

std::string title_of(const BuildingPlan& plan, const PlannedWall& wall) {
  // The wall of a single-wall structure has no name here.
  return wall.name.empty() ? plan.owner : fmt::format("{}: wall '{}'", plan.owner, wall.name);
}

std::span<const LeafBond> leaf_bonds() {
  return leaf_patterns;
}

std::vector<Stretch> between(const Stretch& whole, std::vector<Stretch> others, double same) {
  std::sort(others.begin(), others.end(), [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
  std::vector<Stretch> left;
  double at = whole.low;
  for (const Stretch& other : others) {
    if (other.low > at + same) left.push_back({at, other.low});
    at = std::max(at, other.high);
  }
  if (whole.high > at + same) left.push_back({at, whole.high});
  return left;
}

BuildingPlan plan_building(const Building& building, const std::string& owner) {
  BuildingPlan plan = Planner(building, owner).take();
  plan_beams(building, plan);
  return plan;
}

}  // namespace trilith
