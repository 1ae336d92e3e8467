#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

constexpr double kFarthest = 1e12;  // [m]; beyond it fourth powers and tolerances lose their meaning

/// Points with their indices in the user's list, so that messages are correct after a repair.
struct NumberedPoints {
  Polygon at;
  std::vector<std::size_t> number;
};

std::string shown(const NumberedPoints& points, std::size_t i) {
  const std::size_t k = i % points.at.size();
  return fmt::format("point {} ({:g}, {:g})", points.number[k], points.at[k].x(), points.at[k].y());
}

void require_three(std::size_t count, std::string_view owner) {
  if (count < 3)
    throw InputError(
        fmt::format("{}: outline has {} different point{}, needs at least 3", owner, count, count == 1 ? "" : "s"));
}

void require_finite_points(const NumberedPoints& points, std::string_view owner) {
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    if (!points.at[i].allFinite())
      throw InputError(fmt::format("{}: {} is not finite; give two numbers in m", owner, shown(points, i)));
    if (points.at[i].cwiseAbs().maxCoeff() > kFarthest)
      throw InputError(
          fmt::format("{}: {} is farther out than {:g} m; check the unit", owner, shown(points, i), kFarthest));
  }
}

/// Removes each point that repeats its predecessor; the last point is compared with the first.
NumberedPoints without_repeats(const NumberedPoints& points, double tolerance, std::string_view owner,
                               std::vector<std::string>& notes) {
  NumberedPoints kept;
  const auto same = [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= tolerance; };
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    const bool repeats = !kept.at.empty() && same(points.at[i], kept.at.back());
    const bool closes = kept.at.size() > 1 && i + 1 == points.at.size() && same(points.at[i], kept.at.front());
    if (repeats || closes) {
      const std::size_t twin = closes ? kept.number.front() : kept.number.back();
      notes.push_back(fmt::format("{}: {} repeats point {}, left out", owner, shown(points, i), twin));
      continue;
    }
    kept.at.push_back(points.at[i]);
    kept.number.push_back(points.number[i]);
  }
  return kept;
}

/// Without area: all points are near the line from the first point to the point farthest from it.
void require_width(const NumberedPoints& points, double tolerance, std::string_view owner) {
  const Vec2 from = points.at[0];
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - from).squaredNorm() < (b - from).squaredNorm(); };
  const Vec2 along = (*std::max_element(points.at.begin(), points.at.end(), nearer) - from).normalized();
  for (const Vec2& p : points.at)
    if (std::abs(cross(along, p - from)) > tolerance) return;
  throw InputError(fmt::format("{}: outline has no area, all {} points lie on one line from {}", owner,
                               points.at.size(), shown(points, 0)));
}

/// A spike: the outline reverses its direction, within the angle that counts as straight.
void refuse_spikes(const NumberedPoints& points, std::string_view owner) {
  const std::size_t n = points.at.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = points.at[i] - points.at[(i + n - 1) % n], out = points.at[(i + 1) % n] - points.at[i];
    if (in.dot(out) < 0 && std::abs(cross(in, out)) <= kStraightAngle * in.norm() * out.norm())
      throw InputError(fmt::format("{}: outline turns back on itself at {}, a spike without width; leave the point out",
                                   owner, shown(points, i)));
  }
}

/// A self-crossing outline has no inside. The message names both edges by the user's numbers.
void refuse_crossing(const NumberedPoints& points, double tolerance, std::string_view owner) {
  const auto crossing = find_self_crossing(points.at, tolerance);
  if (!crossing) return;
  const auto i = static_cast<std::size_t>(crossing->first), j = static_cast<std::size_t>(crossing->second);
  throw InputError(
      fmt::format("{}: outline crosses or touches itself at ({:g}, {:g}): the edge from {} to {} meets the edge from "
                  "{} to {}; give "
                  "the points in order around the outline",
                  owner, crossing->point.x(), crossing->point.y(), shown(points, i), shown(points, i + 1),
                  shown(points, j), shown(points, j + 1)));
}

}  // namespace

/// Each check relies on the previous ones, so the order is: finite, no duplicates, some width, no spike, no crossing,
/// orientation. Tolerances are relative to the size of the polygon.
CheckedPolygon check_polygon(Polygon points, std::string_view owner) {
  require_three(points.size(), owner);
  NumberedPoints given{std::move(points), {}};
  given.number.resize(given.at.size());
  std::iota(given.number.begin(), given.number.end(), std::size_t{1});
  require_finite_points(given, owner);
  const Box2 box = bounding_box(given.at);
  // far from the origin the coordinates' resolution is coarser than the polygon's own tolerance
  const double coarse =
      4 * std::numeric_limits<double>::epsilon() * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  const double tolerance = std::max(kSamePoint * (box.high - box.low).norm(), coarse);

  CheckedPolygon checked;
  NumberedPoints kept = without_repeats(given, tolerance, owner, checked.notes);
  require_three(kept.at.size(), owner);
  require_width(kept, tolerance, owner);
  refuse_spikes(kept, owner);
  refuse_crossing(kept, tolerance, owner);
  if (orientation(kept.at) < 0) {
    std::reverse(kept.at.begin() + 1, kept.at.end());
    checked.notes.push_back(fmt::format("{}: outline was clockwise, reversed", owner));
  }
  checked.outline = std::move(kept.at);
  return checked;
}

}  // namespace trilith
