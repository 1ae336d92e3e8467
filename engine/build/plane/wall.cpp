#include "build/plane/wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "base/error.hpp"
#include "build/plane/wall_plan.hpp"
#include "geometry/plane/random_convex.hpp"

namespace trilith {
namespace {

/// Vertical lines of the wall: positions that differ only by rounding form one line with the same bits.
class Lines {
 public:
  explicit Lines(double same) : same_(same) {}
  double at(double x) {
    const auto found = lines_.lower_bound(x - same_);
    if (found != lines_.end() && *found <= x + same_) return *found;
    lines_.insert(found, x);
    return x;
  }

 private:
  double same_;
  std::set<double> lines_;  // a wall with jittered joints has as many lines as joints
};

class Laying {
 public:
  Laying(const Wall& wall, WallPlan plan)
      : wall_(wall), plan_(std::move(plan)), same_(1e-9 * plan_.length), lines_(same_), bits_(seed_of(wall)) {
    lines_.at(0), lines_.at(plan_.length);
    for (const StoreyPlan& storey : plan_.storeys)
      for (const WallField& field : storey.fields) lines_.at(field.from), lines_.at(field.to);
  }

  BuiltParts run() {
    if (wall_.base_height > 0) {
      add("base", -wall_.base_margin, plan_.length + wall_.base_margin, -wall_.base_height, 0, {"base"});
    }
    for (std::size_t i = 0; i < plan_.storeys.size(); ++i) lay_storey(static_cast<int>(i) + 1, plan_.storeys[i]);
    if (merged_ > 0)
      plan_.notes.push_back(fmt::format("{}: pieces shorter than {:g} m were merged with a neighbour, {} in all",
                                        plan_.owner, plan_.least_length, merged_));
    return {std::move(parts_), std::move(plan_.notes)};
  }

 private:
  static std::uint64_t seed_of(const Wall& wall) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(wall.seed));
  }

  void add(const std::string& name, double from, double to, double low, double high, std::vector<std::string> groups) {
    if (!wall_.name.empty()) groups.push_back(wall_.name);
    const double left = wall_.at.x(), foot = wall_.at.y();
    parts_.push_back({part_name(wall_.name, name),
                      rectangle({left + lines_.at(from), foot + low}, {left + lines_.at(to), foot + high}),
                      std::move(groups)});
  }

  void lay_storey(int number, const StoreyPlan& storey) {
    for (int course = 1; course <= storey.courses(); ++course) {
      lay_course(number, storey, course);
      for (const WallField& field : storey.fields)
        if (field.kind != FieldKind::opening && field.first == course) lay_block(number, storey, field);
    }
    if (storey.has_slab())
      add(fmt::format("s{}.slab", number), -wall_.slab_overhang, plan_.length + wall_.slab_overhang, storey.line.back(),
          storey.top, {"slabs", fmt::format("storey {}", number)});
  }

  /// Lays a lintel or a sill.
  void lay_block(int number, const StoreyPlan& storey, const WallField& field) {
    std::vector<std::string> groups{fmt::format("{}s", name_of(field.kind)), fmt::format("storey {}", number)};
    for (int course = field.first; course <= field.last; ++course) groups.push_back(fmt::format("course {}", course));
    add_place(storey, (field.from + field.to) / 2, groups);
    add(fmt::format("s{}.{}{}", number, name_of(field.kind), field.number), field.from, field.to,
        storey.line[static_cast<std::size_t>(field.first - 1)], storey.line[static_cast<std::size_t>(field.last)],
        std::move(groups));
  }

  /// Adds the groups of the pier or spandrel that contains `x`, if the storey has openings.
  void add_place(const StoreyPlan& storey, double x, std::vector<std::string>& groups) const {
    if (storey.strips.empty()) return;
    int spandrel = 0, pier = storey.strips.front().from > same_ ? 1 : 0;
    for (const WallStrip& strip : storey.strips) {
      if (x < strip.from) break;
      ++spandrel;
      if (x <= strip.to) {
        groups.insert(groups.end(), {"spandrels", fmt::format("spandrel {}", spandrel)});
        return;
      }
      ++pier;
    }
    groups.insert(groups.end(), {"piers", fmt::format("pier {}", pier)});
  }

  /// Lays a course. The bond's head joints over the whole length are interrupted by openings, lintels and sills. Each
  /// stretch of masonry between two of them is laid separately, with the joints within it.
  ///
  ///     |  unit  |  unit  |un|  opening  |it |  unit  |
  void lay_course(int number, const StoreyPlan& storey, int course) {
    const auto row = static_cast<std::size_t>((course - 1 + wall_.first_row - 1) % plan_.bond->courses);
    const std::vector<double> joints = head_joints(plan_.bond->course[row], plan_.units, plan_.length);
    std::vector<WallStrip> gaps;  // stretches without units
    for (const WallField& field : storey.fields)
      if (field.first <= course && course <= field.last) gaps.push_back({field.from, field.to});
    std::sort(gaps.begin(), gaps.end(), [](const WallStrip& a, const WallStrip& b) { return a.from < b.from; });
    gaps.push_back({plan_.length, plan_.length});
    double from = 0;
    int unit = 0;
    for (const WallStrip& gap : gaps) {
      if (gap.from - from > same_) {
        const std::string what = fmt::format("{}, storey {}, course {}", plan_.owner, number, course);
        const std::vector<double> cuts = cut_stretch(from, gap.from, joints, what);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
          lay_unit(number, storey, course, ++unit, cuts[i], cuts[i + 1]);
      }
      from = gap.to;
    }
  }

  void lay_unit(int number, const StoreyPlan& storey, int course, int unit, double from, double to) {
    std::vector<std::string> groups{"units", fmt::format("storey {}", number), fmt::format("course {}", course)};
    add_place(storey, (from + to) / 2, groups);
    add(fmt::format("s{}.c{}.u{}", number, course, unit), from, to, storey.line[static_cast<std::size_t>(course - 1)],
        storey.line[static_cast<std::size_t>(course)], std::move(groups));
  }

  /// Ends of the units between two edges, including both; none is shorter than the least length.
  std::vector<double> cut_stretch(double from, double to, const std::vector<double>& joints, const std::string& what) {
    std::vector<double> cuts{from};
    for (const double joint : joints)
      if (joint > from + same_ && joint < to - same_) cuts.push_back(joint);
    cuts.push_back(to);
    const double least = plan_.least_length - same_;
    if (to - from < least)
      throw InputError(
          fmt::format("{}: the masonry from x = {:g} to {:g} m is {:g} m long, less than the least length of a unit, "
                      "{:g} m; move the opening, or give a smaller least_length",
                      what, from, to, to - from, plan_.least_length));
    // A short piece is merged with its shorter neighbour, and the stretch is checked again from its start.
    for (std::size_t i = 0; i + 1 < cuts.size();) {
      if (cuts[i + 1] - cuts[i] >= least) {
        ++i;
        continue;
      }
      if (wall_.short_pieces == ShortPieces::refuse)
        throw InputError(
            fmt::format("{}: cutting leaves a piece of {:g} m from x = {:g} to {:g} m, less than the least length of a "
                        "unit, {:g} m; move the opening, give a smaller least_length, or let short pieces be merged",
                        what, cuts[i + 1] - cuts[i], cuts[i], cuts[i + 1], plan_.least_length));
      drop_joint_of(cuts, i);
      ++merged_;
      i = 0;
    }
    for (std::size_t i = 1; i + 1 < cuts.size() && wall_.jitter > 0; ++i)
      cuts[i] += random_between(bits_, -wall_.jitter, wall_.jitter);
    return cuts;
  }

  /// Removes the joint between piece i and its shorter neighbour.
  static void drop_joint_of(std::vector<double>& cuts, std::size_t i) {
    const bool first = i == 0, last = i + 2 == cuts.size();
    const bool left = last || (!first && cuts[i] - cuts[i - 1] < cuts[i + 2] - cuts[i + 1]);
    cuts.erase(cuts.begin() + static_cast<std::ptrdiff_t>(left ? i : i + 1));
  }

  const Wall& wall_;
  WallPlan plan_;
  double same_;  ///< positions within this distance are equal [m]
  Lines lines_;
  std::mt19937_64 bits_;
  std::vector<Part> parts_;
  int merged_ = 0;
};

}  // namespace

BuiltParts Wall::parts() const {
  return build_wall(*this);
}

BuiltParts build_wall(const Wall& wall) {
  return Laying(wall, plan_wall(wall)).run();
}

}  // namespace trilith
