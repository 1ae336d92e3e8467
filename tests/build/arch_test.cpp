#include "build/plane/arch.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double kHalfCircle = std::numbers::pi / 2;

double voussoir_area(const std::vector<Part>& parts) {
  double area = 0;
  for (const Part& part : parts)
    if (part.groups[0] == "voussoirs") area += signed_area(part.outline);
  return area;
}

}  // namespace

TEST_CASE("an arch's voussoirs have the closed-form area of their straight or finely curved sides") {
  for (const double half : {kHalfCircle, 1.0, 0.4})
    for (const int n : {2, 7, 15, 21})
      for (const int k : {1, 2, 8, 64}) {
        const Arch arch{.voussoirs = n, .radius = 2, .thickness = 0.22, .half_angle = half, .sub_edges = k};
        const std::vector<Part> parts = build_arch(arch);
        REQUIRE(static_cast<int>(parts.size()) == n + 2);
        const double d = 2 * half / (n * k), area = voussoir_area(parts), curved = 2 * half * 2 * 0.22;
        CHECK(near(area, curved * std::sin(d) / d, 1e-12));
        CHECK(std::abs(area / curved - 1) < d * d / 6);
      }
}

TEST_CASE("with 40 sub-edges an arch of 11 has the curved weight to 1e-5 and each voussoir its curved centroid") {
  const std::vector<Part> parts = build_arch({.voussoirs = 11, .radius = 1, .thickness = 0.1, .sub_edges = 40});
  CHECK(near(voussoir_area(parts), std::numbers::pi * 0.1, 1e-5));
  const double b = kHalfCircle / 11, ro = 1.05, ri = 0.95;
  const double r = 2 * std::sin(b) / (3 * b) * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri);
  for (std::size_t i = 0; i < 11; ++i) CHECK(near(polygon_moments(parts[i].outline).centroid.norm(), r, 1e-5));
}

TEST_CASE("neighbouring voussoirs share their joint's corners to the bit and overlap nowhere") {
  for (const int k : {1, 5}) {
    const std::vector<Part> parts = build_arch(
        {.name = "A", .voussoirs = 15, .radius = 3, .thickness = 0.4, .sub_edges = k, .centre = {0.7, -0.2}});
    check_sound(parts);
    const auto s = static_cast<std::size_t>(k);
    for (std::size_t i = 0; i + 1 < 15; ++i) {
      const Polygon &left = parts[i].outline, &right = parts[i + 1].outline;
      CHECK(left[s] == right[0]);
      CHECK(left[s + 1] == right[2 * s + 1]);
    }
  }
}

TEST_CASE("an arch about x = 0 is its own mirror image to the bit") {
  const std::vector<Part> parts = build_arch({.voussoirs = 8, .half_angle = 1.1, .sub_edges = 3});
  for (std::size_t i = 0; i < 8; ++i) {
    const Polygon &left = parts[i].outline, &right = parts[7 - i].outline;
    for (const Vec2& p : left) CHECK(std::count(right.begin(), right.end(), Vec2(-p.x(), p.y())) == 1);
  }
}

TEST_CASE("abutments meet the springings: to the bit without a margin, in one straight face with one") {
  for (const double half : {kHalfCircle, 0.8}) {
    const std::vector<Part> flush = build_arch({.voussoirs = 9, .half_angle = half, .abutment_margin = 0});
    check_sound(flush);
    const Polygon &first = flush[0].outline, &last = flush[8].outline;
    const Polygon &left = named(flush, "left").outline, &right = named(flush, "right").outline;
    CHECK(left[3] == first[0]);
    CHECK(left[0] == first[3]);
    CHECK(right[0] == last[1]);
    CHECK(right[3] == last[2]);

    const std::vector<Part> wide = build_arch({.voussoirs = 9, .half_angle = half});
    check_sound(wide);
    for (const auto& [voussoir, side] : {std::pair("v1", "left"), std::pair("v9", "right")}) {
      const Polygon &stone = named(wide, voussoir).outline, &block = named(wide, side).outline;
      CHECK(std::abs(penetration(stone, block).separation) < 1e-15);
      const auto corners = side == std::string("left") ? std::pair(stone[0], stone[3]) : std::pair(stone[1], stone[2]);
      CHECK(boundary_point(block, corners.first).distance < 1e-15);
      CHECK(boundary_point(block, corners.second).distance < 1e-15);
      CHECK(near(signed_area(block), 0.3 * 0.15, 1e-13));
    }
  }
}

TEST_CASE("a voussoir with curved sides parts into few convex pieces") {
  const std::vector<Part> parts = build_arch({.voussoirs = 7, .thickness = 0.1, .sub_edges = 8, .abutments = false});
  CHECK(parts.size() == 7);
  for (const Part& part : parts) CHECK(convex_parts(part.outline).size() <= 8);
  for (const Part& part : build_arch({.voussoirs = 7, .abutments = false}))
    CHECK(convex_parts(part.outline).size() == 1);
}

TEST_CASE("span and rise give a segmental, semicircular or pointed intrados through springings and crown") {
  for (const double rise : {0.3, 1.0, 1.9999, 2.0, 2.0001, 3.0, 4.0})
    for (const int n : {12, 13}) {
      CAPTURE(rise);
      CAPTURE(n);
      Arch arch{.voussoirs = n, .thickness = 0.4, .sub_edges = 2, .centre = {0.5, 1}};
      set_span_and_rise(arch, 4, rise);
      const std::vector<Part> parts = build_arch(arch);
      check_sound(parts);
      CHECK((arch.offset > 0) == (rise > 2));
      const Vec2 left = parts[0].outline[0], right = parts[static_cast<std::size_t>(n) - 1].outline[2];
      CHECK(near(right.x() - left.x(), 4, 1e-12));
      CHECK(near(left.y(), right.y(), 1e-12));
      double crown = -10;
      const auto& middle = parts[static_cast<std::size_t>(n) / 2].outline;  // the keystone, or the first stone right of
                                                                            // the crown
      for (const Vec2& p : middle)
        if (std::abs(p.x() - 0.5) < 1e-12 && (crown == -10 || p.y() < crown)) crown = p.y();
      CHECK(near(crown - left.y(), rise, 1e-9));
    }
}

TEST_CASE("a pointed arch has the area between its two pairs of circles") {
  // One side, from the vertical through the crown: the sector of radius r from angle asin(e/r) to the springing, minus
  // the triangle between its centre and the middle line.
  const auto under = [](double r, double e) {
    const double phi = std::asin(e / r);
    return r * r / 2 * (kHalfCircle - phi) - e * std::sqrt(r * r - e * e) / 2;
  };
  for (const int n : {9, 14}) {
    const Arch arch{.voussoirs = n, .radius = 3, .thickness = 0.5, .offset = 1.2, .sub_edges = 200};
    const double curved = 2 * (under(3.25, 1.2) - under(2.75, 1.2));
    CHECK(near(voussoir_area(build_arch(arch)), curved, 1e-5));
  }
}

TEST_CASE("a pointed arch is its own mirror image to the bit, its crown a vertical joint or within the key") {
  for (const int n : {10, 11})
    for (const int k : {1, 3}) {
      const std::vector<Part> parts =
          build_arch({.voussoirs = n, .radius = 2, .thickness = 0.3, .offset = 0.7, .sub_edges = k});
      check_sound(parts);
      const auto count = static_cast<std::size_t>(n);
      for (std::size_t i = 0; i < count; ++i) {
        const Polygon &left = parts[i].outline, &right = parts[count - 1 - i].outline;
        for (const Vec2& p : left) CHECK(std::count(right.begin(), right.end(), Vec2(-p.x(), p.y())) == 1);
      }
      int on_middle = 0;
      for (const Part& part : parts)
        for (const Vec2& p : part.outline) on_middle += p.x() == 0;
      CHECK(on_middle == (n == 10 ? 4 : 2));
      CHECK(count_in_group(parts, "key") == n % 2);
    }
}

TEST_CASE("a key is wider than the other voussoirs by the requested factor") {
  for (const double key : {0.5, 1.0, 2.0}) {
    const std::vector<Part> parts = build_arch({.voussoirs = 9, .radius = 2, .thickness = 0.3, .key = key});
    check_sound(parts);
    const auto angle = [&](std::size_t i) {
      const Polygon& p = parts[i].outline;
      return std::atan2(p[0].y(), p[0].x()) - std::atan2(p[1].y(), p[1].x());
    };
    CHECK(near(angle(4), key * angle(0), 1e-12));
    CHECK(near(8 * angle(0) + angle(4), std::numbers::pi, 1e-12));
  }
}

TEST_CASE("an arch's jitter moves the joints between voussoirs along the mid line, the same for the same seed") {
  Arch arch{.name = "A", .voussoirs = 11, .radius = 2, .thickness = 0.3};
  const std::vector<Part> straight = build_arch(arch);
  arch.jitter = 1e-6;
  const std::vector<Part> moved = build_arch(arch), again = build_arch(arch);
  arch.seed = 2;
  const std::vector<Part> other = build_arch(arch);
  check_sound(moved);
  double most = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    CHECK(moved[i].outline == again[i].outline);
    CHECK((moved[i].outline == other[i].outline) == (i >= 11));
    for (std::size_t k = 0; k < moved[i].outline.size(); ++k)
      most = std::max(most, (moved[i].outline[k] - straight[i].outline[k]).norm());
    if (i < 10) CHECK(moved[i].outline[1] == moved[i + 1].outline[0]);
  }
  CHECK(most > 0.5e-6);
  CHECK(most < 1.1e-6);
}

TEST_CASE("arches that cannot be built are rejected") {
  CHECK(mentions(refusal_of([] { build_arch({.offset = 0.95}); }),
                 "offset of the centres is 0.95 m, must be below the inner"));
  CHECK(mentions(refusal_of([] { build_arch({.half_angle = 0.4, .offset = 0.5}); }), "must be above 0.571"));
  CHECK(mentions(refusal_of([] { build_arch({.voussoirs = 100, .thickness = 0.6, .offset = 0.5}); }),
                 "the joints next to the crown meet within the arch"));
  CHECK(mentions(refusal_of([] { build_arch({.voussoirs = 8, .key = 2}); }), "8 voussoirs have no middle one"));
  CHECK(mentions(refusal_of([] { build_arch({.key = 0}); }), "key is 0"));
  CHECK(mentions(refusal_of([] { build_arch({.jitter = 0.1}); }),
                 "jitter is 0.1 m, must be at most a quarter of a voussoir"));
  CHECK(mentions(refusal_of([] {
                   Arch arch;
                   set_span_and_rise(arch, 4, 0);
                 }),
                 "rise is 0 m"));
  CHECK(mentions(refusal_of([] { build_arch({.name = "A", .voussoirs = 0}); }), "arch 'A': voussoirs is 0"));
  CHECK(mentions(refusal_of([] { build_arch({.thickness = 2}); }),
                 "thickness is 2 m, must be below twice the mid radius"));
  CHECK(mentions(refusal_of([] { build_arch({.half_angle = 90}); }), "half opening angle is 90 rad"));
  CHECK(mentions(refusal_of([] { build_arch({.half_angle = 0}); }), "half angle is 0 rad"));
  CHECK(mentions(refusal_of([] { build_arch({.voussoirs = 1}); }), "one straight edge spans 3.14159 rad"));
  CHECK(mentions(refusal_of([] { build_arch({.sub_edges = 2000}); }), "sub edges is 2000"));
  CHECK(mentions(refusal_of([] { build_arch({.abutment_depth = -1}); }), "abutment depth is -1 m"));
  CHECK(mentions(refusal_of([] { build_arch({.abutment_margin = 1}); }), "abutment margin is 1 m"));
  CHECK(mentions(refusal_of([] { build_arch({.abutment_margin = -0.1}); }), "abutment margin is -0.1 m"));
  CHECK(
      mentions(refusal_of([] { build_arch({.radius = std::numeric_limits<double>::infinity()}); }), "radius is inf m"));
}
