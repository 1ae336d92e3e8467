#include "element/section/section_3d.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "geometry/plane/convex_parts.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

double cube(double x) {
  return x * x * x;
}

/// Uses the exponential of base/portable.hpp, so that a section has the same bits on every processor.
double tanh_of(double x) {
  return 1 - 2 / (portable::exp(2 * x) + 1);
}

std::vector<Vec2> rectangle(double width, double low, double high) {
  return {{-0.5 * width, low}, {0.5 * width, low}, {0.5 * width, high}, {-0.5 * width, high}};
}

// A section seen along its beam, y to its top and z across.
//
//         y |  ___          second_moment[1], about z: bends up and down, as in the plane
//           | |___| flange  second_moment[0], about y: bends across
//           |  | |  web     torsion: J of the twist, M = G J theta'
//           +------ z

/// Area, vertical bending and its shear as in the plane; `across`: second moment about y.
Section3 with_numbers(const Section& plane, double across, double shear_across, double torsion) {
  Section3 s;
  s.area = plane.area;
  s.second_moment = {across, plane.second_moment}, s.shear_area = {shear_across, plane.shear_area};
  s.torsion = torsion;
  return s;
}

/// A regular polygon of the same area as a circle [m].
std::vector<Vec2> round_profile(double diameter) {
  constexpr int sides = 12;
  const double turn = 2 * M_PI / sides;
  const double radius = 0.5 * diameter * std::sqrt(M_PI / (0.5 * sides * portable::sin(turn)));
  std::vector<Vec2> out;
  for (int i = 0; i < sides; ++i) {
    const auto at = portable::sine_cosine((i + 0.5) * turn);
    out.emplace_back(radius * at.cosine, radius * at.sine);
  }
  return out;
}

/// Stacked rectangles from the bottom of the section up.
std::vector<std::vector<Vec2>> layered_profile(std::span<const SectionLayer> layers, double below) {
  std::vector<std::vector<Vec2>> out;
  double level = -below;
  for (const SectionLayer& l : layers) {
    out.push_back(rectangle(l.width, level, level + l.depth));
    level += l.depth;
  }
  return out;
}

/// For open walls: flanges bend across individually; they carry shear across on 5/6 of their area.
Section3 open_section(std::span<const SectionLayer> layers, std::span<const double> flange_areas,
                      const Section& plane) {
  double across = 0, torsion = 0, shear = 0;
  for (const SectionLayer& l : layers) {
    across += l.depth * cube(l.width) / 12;
    torsion += std::max(l.width, l.depth) * cube(std::min(l.width, l.depth)) / 3;
  }
  for (const double area : flange_areas) shear += area * 5 / 6;
  Section3 s = with_numbers(plane, across, shear, torsion);
  s.profile = layered_profile(layers, plane.below);
  return s;
}

}  // namespace

/// Saint-Venant's constant of a rectangle a x b, a >= b (Timoshenko and Goodier, Theory of Elasticity, art. 109):
///   J = a b^3 (1/3 - 64/pi^5 b/a sum over odd n of tanh(n pi a / 2b) / n^5).
double rectangle_torsion(double width, double depth) {
  const double a = std::max(width, depth), b = std::min(width, depth);
  double sum = 0;
  // Terms decrease with the fifth power: after 40 terms the remainder is below 1e-9 of the sum.
  for (int n = 79; n >= 1; n -= 2) sum += tanh_of(std::min(n * M_PI * a / (2 * b), 40.0)) / (cube(n) * n * n);
  return a * cube(b) * (1.0 / 3 - 64 / (cube(M_PI) * M_PI * M_PI) * b / a * sum);
}

Section3 section_in_space(const RectangleSection& s) {
  const Section plane = s.numbers();
  Section3 out =
      with_numbers(plane, plane.area * s.width * s.width / 12, plane.shear_area, rectangle_torsion(s.width, s.depth));
  out.profile = {rectangle(s.width, -plane.below, plane.above)};
  return out;
}

/// Circles and pipes do not warp: their torsion constant is the polar second moment.
Section3 section_in_space(const CircleSection& s) {
  const Section plane = s.numbers();
  Section3 out = with_numbers(plane, plane.second_moment, plane.shear_area, 2 * plane.second_moment);
  out.profile = {round_profile(s.diameter)};
  return out;
}

/// An open thin-walled section twists as its walls do, J = sum of b t^3 / 3; restrained warping is not modelled.
Section3 section_in_space(const ISection& s) {
  const std::array layers{SectionLayer{s.bottom_width, s.bottom_thickness},
                          SectionLayer{s.web, s.depth - s.top_thickness - s.bottom_thickness},
                          SectionLayer{s.top_width, s.top_thickness}};
  return open_section(layers, std::array{s.bottom_width * s.bottom_thickness, s.top_width * s.top_thickness},
                      s.numbers());
}

Section3 section_in_space(const TSection& s) {
  const std::array layers{SectionLayer{s.web, s.depth - s.thickness}, SectionLayer{s.width, s.thickness}};
  return open_section(layers, std::array{s.width * s.thickness}, s.numbers());
}

/// Two webs of half of `webs` each, and two slabs.
Section3 section_in_space(const BoxSection& s) {
  const Section plane = s.numbers();
  const double web = 0.5 * s.webs, clear = s.depth - s.top - s.bottom, arm = 0.5 * (s.width - web);
  const double across =
      (s.top + s.bottom) * cube(s.width) / 12 + 2 * (clear * cube(web) / 12 + clear * web * arm * arm);
  // Bredt's second formula along the middle lines of the walls: J = 4 A^2 / sum of (length / thickness).
  const double width = s.width - web, depth = s.depth - 0.5 * (s.top + s.bottom), enclosed = width * depth;
  const double torsion = 4 * enclosed * enclosed / (2 * depth / web + width / s.top + width / s.bottom);
  Section3 out = with_numbers(plane, across, s.width * (s.top + s.bottom), torsion);
  out.profile = {rectangle(s.width, -plane.below, plane.above)};
  return out;
}

Section3 section_in_space(const GivenSection& s) {
  const Section plane = s.numbers();
  const double shear = s.shear_area_across > 0 ? s.shear_area_across : s.area * 5 / 6;
  Section3 out = with_numbers(plane, s.inertia_across, shear, s.torsion);
  if (s.width > 0) out.profile = {rectangle(s.width, -plane.below, plane.above)};
  return out;
}

Section3 polygon_section_in_space(std::span<const Vec2> outline) {
  const Section plane = polygon_section(outline);
  const PolygonMoments moments = polygon_moments(outline);
  const double sign = moments.area < 0 ? -1 : 1;
  double across = 0, mixed = 0;
  std::vector<Vec2> own;
  for (const Vec2& p : outline) own.emplace_back(p - moments.centroid);
  // Green's theorem for each side: moments of the triangle between the centroid and the side.
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Vec2 &p = own[i], &q = own[(i + 1) % own.size()];
    const double twice = sign * cross(p, q);
    across += twice * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 12;
    mixed += twice * (p.x() * (2 * p.y() + q.y()) + q.x() * (2 * q.y() + p.y())) / 24;
  }
  if (std::abs(mixed) > 1e-6 * (across + plane.second_moment))
    throw InputError(
        fmt::format("polygon_section: up and across are not its principal axes, which a beam in space bends about; "
                    "rotate its outline by {:.4g} rad, and the orientation of its members by the opposite angle",
                    0.5 * portable::atan2(2 * mixed, plane.second_moment - across)));
  // Saint-Venant's estimate for a solid section, J = A^4 / (40 Ip). Exact for an ellipse, within a few per cent for
  // similar shapes.
  const double polar = across + plane.second_moment;
  Section3 out =
      with_numbers(plane, across, plane.shear_area, plane.area * plane.area * plane.area * plane.area / (40 * polar));
  for (const ConvexPiece& piece : convex_parts(own)) {
    std::vector<Vec2>& part = out.profile.emplace_back();
    for (const int corner : piece.corners) part.push_back(own[static_cast<std::size_t>(corner)]);
  }
  return out;
}

}  // namespace trilith
