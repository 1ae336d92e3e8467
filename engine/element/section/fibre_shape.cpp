#include "element/section/fibre_shape.hpp"

#include <algorithm>

#include "base/portable.hpp"

namespace trilith {

namespace {

/// Stacked rectangles from the bottom up.
using LayerStack = std::array<SectionLayer, 3>;

LayerStack stack_of(const RectangleSection& s) {
  return {{{s.width, s.depth}, {0, 0}, {0, 0}}};
}
LayerStack stack_of(const ISection& s) {
  return {{{s.bottom_width, s.bottom_thickness},
           {s.web, s.depth - s.bottom_thickness - s.top_thickness},
           {s.top_width, s.top_thickness}}};
}
LayerStack stack_of(const TSection& s) {
  return {{{s.web, s.depth - s.thickness}, {s.width, s.thickness}, {0, 0}}};
}
LayerStack stack_of(const BoxSection& s) {
  return {{{s.width, s.bottom}, {s.webs, s.depth - s.bottom - s.top}, {s.width, s.top}}};
}

StripMoments strip_of_stack(const LayerStack& stack, double low, double high) {
  StripMoments out;
  double level = 0;
  for (const SectionLayer& l : stack) {
    const double from = std::max(low, level), to = std::min(high, level + l.depth);
    level += l.depth;
    if (to <= from) continue;
    const double area = l.width * (to - from), middle = 0.5 * (from + to);
    out += {area, area * middle, area * (middle * middle + (to - from) * (to - from) / 12)};
  }
  return out;
}

/// Part of a disc of radius r below the level y, about its centre: integrals of 2 sqrt(r^2 - y^2), times y, times y^2.
StripMoments disc_below(double r, double y) {
  const double at = std::clamp(y, -r, r), half = std::sqrt(std::max(0.0, r * r - at * at));
  // y = r sin(angle - pi/2): from 0 at the bottom to pi at the top.
  const double angle = portable::asin(std::clamp(at / r, -1.0, 1.0)) + M_PI / 2;
  return {at * half + r * r * angle, -2.0 / 3 * half * half * half,
          at * half * (2 * at * at - r * r) / 4 + r * r * r * r * angle / 4};
}

/// The same moments about a level lower by `up`.
StripMoments lifted(const StripMoments& m, double up) {
  return {m.area, m.first + up * m.area, m.second + up * (2 * m.first + up * m.area)};
}

/// Levels from the centre.
StripMoments strip_of_disc(double diameter, double low, double high) {
  StripMoments out = disc_below(diameter / 2, high);
  return out -= disc_below(diameter / 2, low);
}

/// Clips a polygon by a level; keeps the part above it where `sign` is 1. Sutherland and Hodgman; parts connected by
/// edges along the level do not affect integrals.
Polygon cut_at(const Polygon& in, double level, double sign) {
  Polygon out;
  for (std::size_t i = 0; i < in.size(); ++i) {
    const Vec2 &p = in[i], &q = in[(i + 1) % in.size()];
    const double dp = sign * (p.y() - level), dq = sign * (q.y() - level);
    if (dp >= 0) out.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) out.emplace_back(p + dp / (dp - dq) * (q - p));
  }
  return out;
}

double bottom_of(const Polygon& outline) {
  double low = unbounded;
  for (const Vec2& p : outline) low = std::min(low, p.y());
  return low;
}

/// Triangles from a point on the bottom to each edge of the strip: moments about the bottom.
StripMoments strip_of_outline(const Polygon& outline, double low, double high) {
  const double bottom = bottom_of(outline);
  const Polygon strip = cut_at(cut_at(outline, bottom + low, 1), bottom + high, -1);
  StripMoments out;
  const double sign = signed_area(outline) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const Vec2 base(strip[0].x(), bottom), p = strip[i] - base, q = strip[(i + 1) % strip.size()] - base;
    const double turn = sign * cross(p, q);
    out += {turn / 2, turn * (p.y() + q.y()) / 6, turn * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 12};
  }
  return out;
}

RectangleSection core(const RectangleSection& s, double c) {
  return {s.width - 2 * c, s.depth - 2 * c};
}
CircleSection core(const CircleSection& s, double c) {
  return {s.diameter - 2 * c, s.hollow > 0 ? s.hollow + 2 * c : 0};
}
/// All dimensions shrink by 2 c, of webs and flanges too, because both of their sides are covered.
ISection core(const ISection& s, double c) {
  return {s.depth - 2 * c,         s.web - 2 * c,          s.top_width - 2 * c,
          s.top_thickness - 2 * c, s.bottom_width - 2 * c, s.bottom_thickness - 2 * c};
}
TSection core(const TSection& s, double c) {
  return {s.depth - 2 * c, s.web - 2 * c, s.width - 2 * c, s.thickness - 2 * c};
}
/// `webs` is the sum of two.
BoxSection core(const BoxSection& s, double c) {
  return {s.width - 2 * c, s.depth - 2 * c, s.webs - 4 * c, s.top - 2 * c, s.bottom - 2 * c};
}

}  // namespace

Section section_of(const FibreShape& shape) {
  if (const auto* s = std::get_if<SectionOutline>(&shape)) return polygon_section(s->outline);
  return std::visit(
      [](const auto& s) -> Section {
        if constexpr (requires { s.numbers(); }) return s.numbers();
        return {};
      },
      shape);
}

StripMoments strip_of(const FibreShape& shape, double low, double high) {
  if (const auto* s = std::get_if<SectionOutline>(&shape)) return strip_of_outline(s->outline, low, high);
  if (const auto* s = std::get_if<CircleSection>(&shape)) {
    const double r = s->diameter / 2;
    StripMoments out = strip_of_disc(s->diameter, low - r, high - r);
    if (s->hollow > 0) out -= strip_of_disc(s->hollow, low - r, high - r);
    // From the centre to the bottom.
    return lifted(out, r);
  }
  return std::visit(
      [&](const auto& s) -> StripMoments {
        if constexpr (requires { stack_of(s); }) return strip_of_stack(stack_of(s), low, high);
        return {};
      },
      shape);
}

/// For an outline the levels of its corners, for a stack the boundaries of rectangles, for a pipe the levels of its
/// hole.
std::vector<double> borders_of(const FibreShape& shape) {
  std::vector<double> out{0, section_of(shape).depth()};
  std::visit(
      [&](const auto& s) {
        if constexpr (requires { stack_of(s); }) {
          double level = 0;
          for (const SectionLayer& l : stack_of(s)) out.push_back(level += l.depth);
        } else if constexpr (requires { s.outline; }) {
          for (const Vec2& p : s.outline) out.push_back(p.y() - bottom_of(s.outline));
        } else {
          if (s.hollow > 0) out.push_back((s.diameter - s.hollow) / 2), out.push_back((s.diameter + s.hollow) / 2);
        }
      },
      shape);
  return out;
}

FibreShape core_of(const FibreShape& shape, double cover) {
  return std::visit(
      [&](const auto& s) -> FibreShape {
        if constexpr (requires { core(s, cover); }) {
          const auto left = core(s, cover);
          try {
            check_parameters(left);
            if constexpr (requires { left.check(); }) left.check();
          } catch (const InputError& e) {
            throw InputError(fmt::format("a cover of {:g} m leaves no core: {}", cover, e.what()));
          }
          return left;
        } else {
          throw InputError("a cover on an outline: give the outline of its core, or only bars");
        }
      },
      shape);
}

}  // namespace trilith
