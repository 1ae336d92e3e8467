#include "build/plane/flying_buttress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

void check(const FlyingButtress& f, const std::string& owner) {
  check_keys(f, owner);
  if (f.slope >= quarter_turn)
    throw InputError(fmt::format(
        "{}: slope of the coping is {:g} rad, must be below pi/2; give the angle from the horizontal, in radians",
        owner, f.slope));
}

/// The intrados: a circle through (0, 0) and (span, rise), and the angles of its ends from the vertical through its
/// centre, increasing to the right.
struct Circle {
  Vec2 centre;
  double radius, from, to;  ///< m [rad]
};

Circle intrados(const FlyingButtress& f, const std::string& owner) {
  const double chord2 = f.span * f.span + f.rise * f.rise, level = chord2 / (2 * f.rise);
  const double radius = f.radius > 0 ? f.radius : level;
  if (f.radius == 0 && f.rise > f.span)
    throw InputError(
        fmt::format("{}: rise is {:g} m, above the span of {:g} m, so no arc is level at the head and "
                    "springs outwards from the pier; give a smaller rise, or a radius",
                    owner, f.rise, f.span));
  const double least = chord2 / (2 * f.span);
  if (f.radius > 0 && (radius < level || radius < least))
    throw InputError(
        fmt::format("{}: radius is {:g} m, must be at least {:g} m; with less, the arc would fall towards the wall or "
                    "spring inwards from the pier",
                    owner, radius, std::max(level, least)));
  // Below and to the right of the middle of the chord.
  const Vec2 along = Vec2(f.span, f.rise) / std::sqrt(chord2);
  const double away = std::sqrt(std::max(0.0, radius * radius - chord2 / 4));
  const Vec2 centre = Vec2(f.span, f.rise) / 2 + away * Vec2(along.y(), -along.x());
  const auto angle_of = [&](const Vec2& p) {
    return portable::asin(std::clamp((p.x() - centre.x()) / radius, -1.0, 1.0));
  };
  return {centre, radius, angle_of(Vec2::Zero()), f.radius > 0 ? angle_of(Vec2(f.span, f.rise)) : 0};
}

/// Intersection of a ray from the circle's centre with the extrados.
class Extrados {
 public:
  Extrados(const FlyingButtress& f, const Circle& circle) : f_(f), circle_(circle) {}
  [[nodiscard]] Vec2 at(double angle) const {
    const Vec2 out(portable::sin(angle), portable::cos(angle));
    if (f_.slope == 0) return circle_.centre + (circle_.radius + f_.thickness) * out;
    // Height of the coping line above the centre, from its height above the head at the wall.
    const double rises = portable::tan(f_.slope), x = circle_.centre.x(), y = circle_.centre.y();
    const double over = f_.rise + f_.thickness - rises * (f_.span - x) - y;
    return circle_.centre + over / (out.y() - rises * out.x()) * out;
  }
  /// Vertically above the head.
  [[nodiscard]] Vec2 at_wall() const {
    if (f_.slope > 0) return {f_.span, f_.rise + f_.thickness};
    const double high = circle_.radius + f_.thickness, aside = f_.span - circle_.centre.x();
    return {f_.span, circle_.centre.y() + std::sqrt(high * high - aside * aside)};
  }

 private:
  const FlyingButtress& f_;
  const Circle& circle_;
};

/// Corners of the intrados, for each voussoir and its last joint, and of the extrados likewise.
struct Ring {
  std::vector<Vec2> low, high;
};

Ring ring_of(const FlyingButtress& f, const Circle& circle) {
  const Extrados extrados(f, circle);
  const int edges = f.voussoirs * f.sub_edges;
  Ring ring;
  for (int i = 0; i <= edges; ++i) {
    const double angle = circle.from + (circle.to - circle.from) * i / edges;
    ring.low.push_back(circle.centre + circle.radius * Vec2(portable::sin(angle), portable::cos(angle)));
    ring.high.push_back(extrados.at(angle));
  }
  ring.low.front() = Vec2::Zero(), ring.low.back() = Vec2(f.span, f.rise);
  ring.high.back() = extrados.at_wall();
  return ring;
}

/// Joints must have a length and must not cross.
void check(const FlyingButtress& f, const Circle& circle, const Ring& ring, const std::string& owner) {
  for (std::size_t i = 0; i < ring.low.size(); ++i) {
    const double length = (ring.high[i] - circle.centre).norm() - circle.radius;
    const bool beside = i == 0 || ring.high[i].x() > ring.high[i - 1].x();
    if (length > 0.01 * f.thickness && beside) continue;
    throw InputError(
        fmt::format("{}: a coping of slope {:g} rad meets the intrados {:.3g} m from the pier; give a smaller slope "
                    "(at most about {:.2g} rad), or a larger thickness",
                    owner, f.slope, ring.low[i].x(), portable::atan2(f.rise, f.span)));
  }
}

Part make_pier(const FlyingButtress& f, const Vec2& top, const std::string& owner) {
  const double width = f.pier_width > 0 ? f.pier_width : 1.5 * f.thickness;
  if (-top.x() > width)
    throw InputError(
        fmt::format("{}: pier_width is {:g} m, must be at least {:.4g} m for the joint that the ring springs "
                    "from",
                    owner, width, -top.x()));
  Polygon outline{{-width, -f.pier_height}, {0, -f.pier_height}, {0, 0}, top};
  if (-top.x() < width) outline.push_back({-width, top.y()});
  return {part_name(f.name, "pier"), std::move(outline), {"piers"}};
}

Part make_wall(const FlyingButtress& f, const Vec2& head) {
  const double over = std::max(f.wall_height > 0 ? f.rise + f.wall_height : 0.0, head.y());
  Polygon outline{{f.span, 0}, {f.span + f.wall_width, 0}, {f.span + f.wall_width, over}, {f.span, over}};
  return {part_name(f.name, "wall"), std::move(outline), {"walls"}};
}

}  // namespace

std::vector<Part> FlyingButtress::parts() const {
  return build_flying_buttress(*this);
}

std::vector<Part> build_flying_buttress(const FlyingButtress& f) {
  const std::string owner = builder_title("flying buttress", f.name);
  check(f, owner);
  const Circle circle = intrados(f, owner);
  const Ring ring = ring_of(f, circle);
  check(f, circle, ring, owner);
  std::vector<Part> parts;
  const auto k = static_cast<std::size_t>(f.sub_edges);
  for (std::size_t v = 0; v < static_cast<std::size_t>(f.voussoirs); ++v) {
    Part part{part_name(f.name, fmt::format("v{}", v + 1)), {}, {"voussoirs"}};
    for (std::size_t i = v * k; i <= (v + 1) * k; ++i) part.outline.push_back(ring.low[i]);
    for (std::size_t i = (v + 1) * k + 1; i-- > v * k;)
      // The coping line has corners at the joints only.
      if (f.slope == 0 || i % k == 0) part.outline.push_back(ring.high[i]);
    parts.push_back(std::move(part));
  }
  if (f.pier_height > 0) parts.push_back(make_pier(f, ring.high.front(), owner));
  if (f.wall_width > 0) parts.push_back(make_wall(f, ring.high.back()));
  for (Part& part : parts)
    for (Vec2& corner : part.outline) corner += f.springing;
  return parts;
}

}  // namespace trilith
