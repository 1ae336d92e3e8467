#include "build/plane/wall_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

constexpr double whole_within = 1e-6;  ///< a height counts as whole courses within this share of a course

double wall_length(const Wall& wall, const WallPlan& plan) {
  if (wall.length == 0 && wall.units == 0)
    throw InputError(plan.owner + ": give its length in m, or the number of whole units in a course");
  if (wall.length != 0 && wall.units != 0) throw InputError(plan.owner + ": both length and units are given; keep one");
  if (wall.length != 0) return require_positive(wall.length, plan.owner + ": length", "m");
  return require_count(wall.units, 1, 100'000, plan.owner + ": number of units in a course") * plan.units.stretcher;
}

/// Number of courses in `height`, or -1 if it is not a whole number of them.
int whole_courses(double height, double course_height) {
  const double courses = height / course_height, nearest = std::round(courses);
  return std::abs(courses - nearest) <= whole_within && nearest < 1e6 ? static_cast<int>(nearest) : -1;
}

/// Height or number of courses; if both are given they must agree.
int count_courses(const WallStorey& storey, double slab, double course_height, const std::string& what) {
  if (storey.height == 0) return require_count(storey.courses, 1, 100'000, what + ": number of courses");
  const double clear = storey.height - slab;
  const int courses = whole_courses(clear, course_height);
  if (courses < 1) {
    const double below = std::max(1.0, std::floor(clear / course_height));
    throw InputError(fmt::format(
        "{}: {:g} m high with a slab of {:g} m leaves {:.4g} courses of {:g} m, must be a whole number; {:g} or {:g} m "
        "would fit",
        what, storey.height, slab, clear / course_height, course_height, slab + below * course_height,
        slab + (below + 1) * course_height));
  }
  if (storey.courses != 0 && storey.courses != courses)
    throw InputError(fmt::format("{}: {} courses are given, but its height of {:g} m holds {}; keep one of the two",
                                 what, storey.courses, storey.height, courses));
  return courses;
}

void plan_storeys(const Wall& wall, WallPlan& plan) {
  if (wall.storeys.empty()) throw InputError(plan.owner + ": has no storey, needs at least 1");
  double bottom = 0, units = 0;
  for (WallStorey storey : wall.storeys) {
    if (storey.courses == 0 && storey.height == 0) storey.courses = wall.courses, storey.height = wall.storey_height;
    const std::string what = fmt::format("{}, storey {}", plan.owner, plan.storeys.size() + 1);
    const double slab = storey.slab_height < 0 ? wall.slab_height : storey.slab_height;
    StoreyPlan made;
    const int courses = count_courses(storey, slab, plan.course_height, what);
    // Each line is computed once, so that all parts that meet there have the same bits.
    for (int i = 0; i <= courses; ++i) made.line.push_back(bottom + i * plan.course_height);
    bottom = made.top = slab > 0 ? made.line.back() + slab : made.line.back();
    units += courses * (plan.length / std::min(plan.units.header, plan.units.stretcher));
    plan.storeys.push_back(std::move(made));
  }
  if (units > 1e6)
    throw InputError(fmt::format("{}: has about {:g} units, at most 1000000 are built", plan.owner, units));
}

/// The course line (0: the lowest) at `height` above the storey's first course, snapped if requested.
int course_line(const Wall& wall, WallPlan& plan, double height, const std::string& what) {
  require_finite(height, what);
  const double step = plan.course_height, low = std::floor(height / step) * step;
  const int line = whole_courses(height, step);
  if (line >= 0) return line;
  if (!wall.snap)
    throw InputError(fmt::format(
        "{} is {:g} m, must lie on a course line: {:g} or {:g} m are nearest, and snap takes the nearer one", what,
        height, low, low + step));
  const double nearest = std::round(height / step);
  plan.notes.push_back(fmt::format("{} is moved from {:g} to {:g} m, a course line", what, height, nearest * step));
  return static_cast<int>(nearest);
}

/// True if two fields share an area; lengths below `same` do not count.
bool meet(const WallField& a, const WallField& b, double same) {
  return a.from < b.to - same && b.from < a.to - same && a.first <= b.last && b.first <= a.last;
}

WallField plan_opening(const Wall& wall, WallPlan& plan, const WallOpening& given, const std::string& what) {
  const StoreyPlan& storey = plan.storeys[static_cast<std::size_t>(given.storey - 1)];
  require_positive(given.width, what + ": width", "m");
  require_positive(given.height, what + ": height", "m");
  require_not_negative(given.sill, what + ": sill", "m");
  const double right = require_finite(given.x, what + ": x") + given.width;
  const double same = 1e-9 * plan.length, room = storey.line.back() - storey.line.front();
  if (given.x < -same || right > plan.length + same)
    throw InputError(fmt::format("{}: lies from x = {:g} to {:g} m, must lie within the wall's 0 to {:g} m", what,
                                 given.x, right, plan.length));
  const int sill = course_line(wall, plan, given.sill, what + ": sill");
  const int head = course_line(wall, plan, given.sill + given.height, what + ": head (sill + height)");
  if (head > storey.courses())
    throw InputError(fmt::format("{}: head is at {:g} m, must not be above the storey's courses of {:g} m", what,
                                 head * plan.course_height, room));
  if (head == sill) throw InputError(fmt::format("{}: is less than a course high", what));
  const WallField field{std::max(given.x, 0.0), std::min(right, plan.length), sill + 1, head, FieldKind::opening, 0};
  for (const WallField& other : storey.fields)
    if (meet(field, other, same))
      throw InputError(fmt::format("{}: overlaps the opening from x = {:g} to {:g} m in the same storey", what,
                                   other.from, other.to));
  return field;
}

/// True if masonry of course `course` fills the stretch from `from` to `to`, without an opening: the ends of a block
/// need a support.
bool is_masonry(const StoreyPlan& storey, double from, double to, int course) {
  const WallField stretch{from, to, course, course, FieldKind::opening, 0};
  return std::none_of(storey.fields.begin(), storey.fields.end(), [&](const WallField& f) {
    return f.kind == FieldKind::opening && meet(stretch, f, 1e-9 * (to - from));
  });
}

/// The block above (lintel) or below (sill) an opening, extending by `bearing` beyond its sides; `what` begins
/// messages.
WallField plan_block(const WallPlan& plan, const StoreyPlan& storey, const WallField& opening, FieldKind kind,
                     int courses, double bearing, const std::string& what) {
  const int number = 1 + static_cast<int>(std::count_if(storey.fields.begin(), storey.fields.end(),
                                                        [&](const WallField& f) { return f.kind == kind; }));
  //      +--------------+   lintel: courses above the head, `bearing` over either side
  //      +--+        +--+
  //         | opening|
  //      +--+        +--+
  //      +--------------+   sill: courses below
  const bool above = kind == FieldKind::lintel;
  const int first = above ? opening.last + 1 : opening.first - courses;
  WallField block{opening.from - bearing, opening.to + bearing, first, first + courses - 1, kind, number};
  const double same = 1e-9 * plan.length;
  if (block.from < -same || block.to > plan.length + same)
    throw InputError(fmt::format(
        "{} lies from x = {:g} to {:g} m, must lie within the wall's 0 to {:g} m; a bearing of up to {:g} m fits{}",
        what, block.from, block.to, plan.length, std::min(opening.from, plan.length - opening.to),
        above ? ", or give lintel = false" : ""));
  block.from = std::max(block.from, 0.0), block.to = std::min(block.to, plan.length);
  if (block.first < 1 || block.last > storey.courses())
    throw InputError(fmt::format("{} needs {} courses {}, but {} are left in the storey", what, courses,
                                 above ? "over the head" : "under the sill",
                                 above ? storey.courses() - opening.last : opening.first - 1));
  for (const WallField& other : storey.fields)
    if (meet(block, other, same))
      throw InputError(fmt::format("{} from x = {:g} to {:g} m runs into the {} from x = {:g} to {:g} m", what,
                                   block.from, block.to, name_of(other.kind), other.from, other.to));
  return block;
}

void plan_lintel(const Wall& wall, WallPlan& plan, const WallOpening& given, const WallField& opening,
                 const std::string& opening_name) {
  StoreyPlan& storey = plan.storeys[static_cast<std::size_t>(given.storey - 1)];
  const std::string what = opening_name + ": lintel";
  double height = given.lintel_height < 0 ? wall.lintel_height : given.lintel_height;
  double bearing = given.lintel_bearing < 0 ? wall.lintel_bearing : given.lintel_bearing;
  height = height == 0 ? plan.course_height : require_finite(height, what + " height");
  bearing = bearing == 0 ? plan.units.stretcher / 2 : require_finite(bearing, what + " bearing");
  // At least one course after snapping.
  const int courses = std::max(1, course_line(wall, plan, height, what + " height"));
  const WallField block = plan_block(plan, storey, opening, FieldKind::lintel, courses, bearing, what);
  if (!is_masonry(storey, block.from, opening.from, opening.last) ||
      !is_masonry(storey, opening.to, block.to, opening.last))
    throw InputError(fmt::format(
        "{} reaches {:g} m beyond each side and so over the next opening; give a shorter bearing", what, bearing));
  storey.fields.push_back(block);
}

void plan_sill(const Wall& wall, WallPlan& plan, const WallOpening& given, const WallField& opening,
               const std::string& opening_name) {
  StoreyPlan& storey = plan.storeys[static_cast<std::size_t>(given.storey - 1)];
  const std::string what = opening_name + ": sill block";
  require_not_negative(given.sill_height, what + " height", "m");
  require_not_negative(given.sill_bearing, what + " bearing", "m");
  if (given.sill_height == 0) return;
  const int courses = std::max(1, course_line(wall, plan, given.sill_height, what + " height"));
  storey.fields.push_back(plan_block(plan, storey, opening, FieldKind::sill, courses, given.sill_bearing, what));
}

/// Openings first: lintels and sills must not intersect any of them.
void plan_openings(const Wall& wall, WallPlan& plan) {
  std::vector<WallField> made;
  std::vector<std::string> names;
  for (const WallOpening& given : wall.openings) {
    const std::string what = fmt::format("{}, opening {}", plan.owner, made.size() + 1);
    require_count(given.storey, 1, static_cast<int>(plan.storeys.size()), what + ": storey");
    names.push_back(fmt::format("{} (storey {})", what, given.storey));
    made.push_back(plan_opening(wall, plan, given, names.back()));
    plan.storeys[static_cast<std::size_t>(given.storey - 1)].fields.push_back(made.back());
  }
  for (std::size_t i = 0; i < made.size(); ++i) {
    const WallOpening& given = wall.openings[i];
    const StoreyPlan& storey = plan.storeys[static_cast<std::size_t>(given.storey - 1)];
    if (given.lintel && made[i].last < storey.courses()) plan_lintel(wall, plan, given, made[i], names[i]);
    plan_sill(wall, plan, given, made[i], names[i]);
  }
}

/// Openings above each other, or with overlapping x ranges, form one strip: piers are next to it, spandrels within it.
std::vector<WallStrip> strips_of(const std::vector<WallField>& fields) {
  std::vector<WallStrip> all, strips;
  for (const WallField& field : fields)
    if (field.kind == FieldKind::opening) all.push_back({field.from, field.to});
  std::sort(all.begin(), all.end(), [](const WallStrip& a, const WallStrip& b) { return a.from < b.from; });
  for (const WallStrip& strip : all) {
    if (strips.empty() || strip.from >= strips.back().to)
      strips.push_back(strip);
    else
      strips.back().to = std::max(strips.back().to, strip.to);
  }
  return strips;
}

}  // namespace

WallPlan plan_wall(const Wall& wall) {
  WallPlan plan{};
  plan.owner = builder_title("wall", wall.name);
  check_keys(wall, plan.owner);
  plan.course_height = wall.unit_height + wall.bed_joint;
  plan.units.stretcher = wall.unit_length + wall.head_joint;
  plan.units.header = wall.header_length == 0 ? plan.units.stretcher / 2 : wall.header_length + wall.head_joint;
  plan.bond = &find_bond(wall.bond, plan.owner);
  require_count(wall.first_row, 1, plan.bond->courses, plan.owner + ": first row of the bond");
  plan.length = wall_length(wall, plan);
  const double shortest = std::min(plan.units.stretcher / 4, plan.units.header / 2);
  plan.least_length = wall.least_length == 0 ? shortest : wall.least_length;
  if (plan.least_length > plan.length)
    throw InputError(fmt::format("{}: least length of a unit is {:g} m, must not be above the wall's length of {:g} m",
                                 plan.owner, plan.least_length, plan.length));
  if (wall.jitter > plan.least_length / 4)
    throw InputError(
        fmt::format("{}: jitter is {:g} m, must be at most a quarter of the least length of a unit, {:g} m", plan.owner,
                    wall.jitter, plan.least_length / 4));
  plan_storeys(wall, plan);
  plan_openings(wall, plan);
  for (StoreyPlan& storey : plan.storeys) storey.strips = strips_of(storey.fields);
  return plan;
}

}  // namespace trilith
