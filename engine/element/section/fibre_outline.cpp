#include "element/section/fibre_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// Number of corners of a round outline.
constexpr int round_sides = 96;

Polygon box_between(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// Stacked rectangles from the bottom up, each centred in the width.
std::vector<SectionPart> stacked(std::initializer_list<SectionLayer> layers) {
  std::vector<SectionPart> out;
  double level = 0;
  for (const SectionLayer& l : layers) {
    out.push_back({box_between(-0.5 * l.width, 0.5 * l.width, level, level + l.depth)});
    level += l.depth;
  }
  return out;
}

/// A regular polygon of the same area as a circle about (0, up).
Polygon round_outline(double diameter, double up) {
  const double turn = 2 * M_PI / round_sides;
  const double radius = 0.5 * diameter * std::sqrt(turn / portable::sin(turn));
  Polygon out;
  for (int i = 0; i < round_sides; ++i) {
    const auto at = portable::sine_cosine((i + 0.5) * turn);
    out.emplace_back(radius * at.cosine, up + radius * at.sine);
  }
  return out;
}

std::vector<SectionPart> parts(const RectangleSection& s) {
  return stacked({{s.width, s.depth}});
}
std::vector<SectionPart> parts(const CircleSection& s) {
  std::vector<SectionPart> out{{round_outline(s.diameter, 0.5 * s.diameter)}};
  if (s.hollow > 0) out.push_back({round_outline(s.hollow, 0.5 * s.diameter), -1});
  return out;
}
std::vector<SectionPart> parts(const ISection& s) {
  return stacked({{s.bottom_width, s.bottom_thickness},
                  {s.web, s.depth - s.bottom_thickness - s.top_thickness},
                  {s.top_width, s.top_thickness}});
}
std::vector<SectionPart> parts(const TSection& s) {
  return stacked({{s.web, s.depth - s.thickness}, {s.width, s.thickness}});
}
/// Two slabs, and half of the web width at either side.
std::vector<SectionPart> parts(const BoxSection& s) {
  const double half = 0.5 * s.width, web = 0.5 * s.webs, from = s.bottom, to = s.depth - s.top;
  return {{box_between(-half, half, 0, s.bottom)},
          {box_between(-half, -half + web, from, to)},
          {box_between(half - web, half, from, to)},
          {box_between(-half, half, to, s.depth)}};
}
std::vector<SectionPart> parts(const SectionOutline& s) {
  const Vec2 from(polygon_moments(s.outline).centroid.x(), bounding_box(s.outline).low.y());
  Polygon out;
  for (const Vec2& p : s.outline) out.push_back(p - from);
  if (signed_area(out) < 0) std::reverse(out.begin(), out.end());
  return {{out}};
}

}  // namespace

std::vector<SectionPart> parts_of(const FibreShape& shape) {
  return std::visit([](const auto& s) { return parts(s); }, shape);
}

std::vector<double> borders_across(const std::vector<SectionPart>& parts) {
  std::vector<double> out;
  for (const SectionPart& part : parts) {
    const bool round = part.outline.size() == round_sides;
    const Box2 box = bounding_box(part.outline);
    out.push_back(box.low.x()), out.push_back(box.high.x());
    if (!round)
      for (const Vec2& p : part.outline) out.push_back(p.x());
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace trilith
