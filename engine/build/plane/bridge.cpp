#include "build/plane/bridge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace trilith {
namespace {

void check_pier(const Pier& pier, const std::string& owner) {
  require_finite(pier.x, owner + ": x");
  require_finite(pier.ground_level, owner + ": ground level");
  require_positive(pier.height, owner + ": height", "m");
  require_positive(pier.stem_width, owner + ": stem width", "m");
  require_not_negative(pier.top_width, owner + ": top width", "m");
  require_not_negative(pier.cap_thickness, owner + ": cap thickness", "m");
  require_not_negative(pier.footing_width, owner + ": footing width", "m");
  require_not_negative(pier.footing_thickness, owner + ": footing thickness", "m");
  if ((pier.footing_width > 0) != (pier.footing_thickness > 0))
    throw InputError(fmt::format("{}: footing is {:g} m wide and {:g} m thick; give both or neither", owner,
                                 pier.footing_width, pier.footing_thickness));
  if (pier.footing_width > 0 && pier.footing_width < pier.stem_width)
    throw InputError(fmt::format("{}: footing width is {:g} m, must not be below the stem width of {:g} m", owner,
                                 pier.footing_width, pier.stem_width));
  if (pier.cap_thickness > 0 && pier.top_width == 0)
    throw InputError(fmt::format("{}: cap is {:g} m thick; give its top width, too", owner, pier.cap_thickness));
  if (pier.footing_thickness + pier.cap_thickness >= pier.height)
    throw InputError(fmt::format("{}: height is {:g} m, must be above footing and cap together, {:g} m", owner,
                                 pier.height, pier.footing_thickness + pier.cap_thickness));
}

/// Checks seat and joint as given: both, or a joint alone.
void check_seat(double seat, const std::optional<double>& gap, const std::string& owner) {
  require_not_negative(seat, owner + ": seat", "m");
  if (gap) require_not_negative(*gap, owner + ": gap", "m");
  if (seat > 0 && !gap)
    throw InputError(
        fmt::format("{}: seat is {:g} m, but the width of its joint is missing; give gap too", owner, seat));
}

}  // namespace

Pier with_seats(const Pier& pier) {
  const std::string owner = builder_title("pier", pier.name);
  check_seat(pier.seat, pier.gap, owner);
  // Both widths are replaced below where they are 0, which means not given.
  require_not_negative(pier.stem_width, owner + ": stem width", "m");
  require_not_negative(pier.top_width, owner + ": top width", "m");
  Pier p = pier;
  if (p.seat > 0) {
    if (p.top_width > 0)
      throw InputError(
          fmt::format("{}: both top width, {:g} m, and seat, {:g} m, are given; keep one", owner, p.top_width, p.seat));
    // Top = seat + joint + seat; it is the stem's width too if that is not given.
    (p.stem_width > 0 ? p.top_width : p.stem_width) = 2 * p.seat + *p.gap;
  } else if (p.gap) {
    const double top = p.top_width > 0 ? p.top_width : p.stem_width;
    p.seat = (top - *p.gap) / 2;
    if (!(p.seat > 0))
      throw InputError(fmt::format("{}: a joint of {:g} m leaves no seat on a top {:g} m wide", owner, *p.gap, top));
  }
  return p;
}

Part build_pier(const Pier& given) {
  const Pier pier = with_seats(given);
  check_pier(pier, builder_title("pier", pier.name));
  const double stem = pier.stem_width / 2, top = pier.top_width > 0 ? pier.top_width / 2 : stem;
  const double seat = pier.ground_level + pier.height;
  //      +-----top------+  seat
  //      +--+        +--+          cap; without one the stem widens evenly to the top
  //         |  stem  |
  //      +--+        +--+          footing
  //      +--------------+  ground
  std::vector<Vec2> right;  // half width and level, from the ground to the seat
  if (pier.footing_width > pier.stem_width) {
    const double footing = pier.footing_width / 2, level = pier.ground_level + pier.footing_thickness;
    right.insert(right.end(), {{footing, pier.ground_level}, {footing, level}, {stem, level}});
  } else {
    right.emplace_back(stem, pier.ground_level);
  }
  if (pier.cap_thickness > 0 && top != stem)
    right.insert(right.end(), {{stem, seat - pier.cap_thickness}, {top, seat - pier.cap_thickness}});
  right.emplace_back(top, seat);

  Part part{pier.name, {{pier.x - right[0].x(), right[0].y()}}, {"piers"}};
  for (const Vec2& p : right) part.outline.emplace_back(pier.x + p.x(), p.y());
  for (std::size_t i = right.size() - 1; i > 0; --i) part.outline.emplace_back(pier.x - right[i].x(), right[i].y());
  return part;
}

Abutment with_seats(const Abutment& abutment) {
  const std::string owner = builder_title("abutment", abutment.name);
  check_seat(abutment.seat, abutment.gap, owner);
  require_positive(abutment.width, owner + ": width", "m");
  require_not_negative(abutment.back_wall_width, owner + ": back wall width", "m");
  Abutment a = abutment;
  if (a.axis && !(a.seat > 0))
    throw InputError(
        owner + ": the axis is the middle of the joint, so it needs seat and gap; give both, or x instead of axis");
  if (a.seat > 0) {
    if (a.back_wall_width > 0)
      throw InputError(fmt::format("{}: both back wall width, {:g} m, and seat, {:g} m, are given; keep one", owner,
                                   a.back_wall_width, a.seat));
    const double wall = a.width - a.seat - *a.gap;
    if (!(wall > 0))
      throw InputError(fmt::format("{}: width is {:g} m, must be above seat and joint together, {:g} m", owner, a.width,
                                   a.seat + *a.gap));
    if (a.back_wall_height > 0) a.back_wall_width = wall;
    // x is the edge of the seat: half of the joint plus the seat away from its axis, towards the span.
    if (a.axis) a.x = *a.axis + (a.side == AbutmentSide::left ? 1 : -1) * (*a.gap / 2 + a.seat);
  } else if (a.gap) {
    a.seat = a.width - a.back_wall_width - *a.gap;
    if (!(a.seat > 0))
      throw InputError(fmt::format("{}: a joint of {:g} m leaves no seat before the back wall; {:g} m are there", owner,
                                   *a.gap, a.width - a.back_wall_width));
  }
  return a;
}

Part build_abutment(const Abutment& given) {
  const Abutment abutment = with_seats(given);
  const std::string owner = builder_title("abutment", abutment.name);
  require_finite(abutment.x, owner + ": x");
  require_finite(abutment.ground_level, owner + ": ground level");
  require_positive(abutment.height, owner + ": height", "m");
  require_positive(abutment.width, owner + ": width", "m");
  require_not_negative(abutment.back_wall_height, owner + ": back wall height", "m");
  require_not_negative(abutment.back_wall_width, owner + ": back wall width", "m");
  if ((abutment.back_wall_height > 0) != (abutment.back_wall_width > 0))
    throw InputError(fmt::format("{}: back wall is {:g} m high and {:g} m wide; give both or neither", owner,
                                 abutment.back_wall_height, abutment.back_wall_width));
  if (abutment.back_wall_width >= abutment.width)
    throw InputError(
        fmt::format("{}: back wall width is {:g} m, must be below the width of {:g} m; otherwise no seat is left",
                    owner, abutment.back_wall_width, abutment.width));
  // for the right side: x increases away from the span
  //
  //             +----+ top
  //             |    |      back wall
  //   seat +----+    |
  //        |         |
  //        +---------+      x = 0 is the face towards the span, x = step the face of the back wall
  const double seat = abutment.ground_level + abutment.height, step = abutment.width - abutment.back_wall_width;
  Polygon outline{{0, abutment.ground_level}, {abutment.width, abutment.ground_level}};
  if (abutment.back_wall_height > 0) {
    const double top = seat + abutment.back_wall_height;
    outline.insert(outline.end(), {{abutment.width, top}, {step, top}, {step, seat}, {0, seat}});
  } else {
    outline.insert(outline.end(), {{abutment.width, seat}, {0, seat}});
  }
  const bool mirrored = abutment.side == AbutmentSide::left;
  for (Vec2& p : outline) p.x() = mirrored ? abutment.x - p.x() : abutment.x + p.x();
  if (mirrored) std::reverse(outline.begin(), outline.end());
  return {abutment.name, std::move(outline), {"abutments"}};
}

Part build_span(const Span& span) {
  const std::string owner = builder_title("span", span.name);
  require_not_negative(span.end_gap, owner + ": end gap", "m");
  require_positive(span.depth, owner + ": depth", "m");
  const double soffit = require_finite(span.soffit_level, owner + ": soffit level");
  const double left = require_finite(span.x0, owner + ": x0") + span.end_gap;
  const double right = require_finite(span.x1, owner + ": x1") - span.end_gap;
  if (!(right > left))
    throw InputError(fmt::format("{}: from {:g} m to {:g} m with a gap of {:g} m at each end leaves no length", owner,
                                 span.x0, span.x1, span.end_gap));
  return {span.name, rectangle({left, soffit}, {right, soffit + span.depth}), {"spans"}};
}

std::vector<Part> Pier::parts() const {
  return {build_pier(*this)};
}

std::vector<Part> Abutment::parts() const {
  return {build_abutment(*this)};
}

std::vector<Part> Span::parts() const {
  return {build_span(*this)};
}

}  // namespace trilith
