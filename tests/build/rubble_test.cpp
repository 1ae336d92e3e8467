#include "build/plane/rubble.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "base/hash.hpp"
#include "build/plane/voronoi.hpp"
#include "build/sound_parts.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Polygon panel{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
const Polygon gate{{0, 0}, {1, 0}, {1, 2}, {2.5, 2}, {2.5, 0}, {4, 0}, {4, 3}, {0, 3}};

double shortest_edge(const std::vector<Part>& parts) {
  double least = 10;
  for (const Part& part : parts)
    for (std::size_t i = 0; i < part.outline.size(); ++i)
      least = std::min(least, (part.outline[(i + 1) % part.outline.size()] - part.outline[i]).norm());
  return least;
}

std::uint64_t digest(const std::vector<Part>& parts) {
  Hash hash;
  for (const Part& part : parts)
    for (const Vec2& p : part.outline) hash.add(p.x()), hash.add(p.y());
  return hash.value();
}

}  // namespace

TEST_CASE("rubble fills its outline without gap or overlap, convex or not, with any seed") {
  for (const Polygon& outline : {panel, gate})
    for (const int seed : {1, 2, 3, 4, 5, 6, 7, 8})
      for (const double aspect : {1.0, 2.0}) {
        CAPTURE(seed);
        CAPTURE(aspect);
        const Rubble rubble{.outline = outline, .stones = 60, .relaxations = seed % 4, .aspect = aspect, .seed = seed};
        const std::vector<Part> parts = build_rubble(rubble);
        check_sound(parts);
        CHECK(near(total_area(parts), signed_area(outline), 1e-12));
        CHECK(std::abs(static_cast<int>(parts.size()) - 60) <= 4);
      }
}

TEST_CASE("no face of rubble is shorter than the least edge where the outline leaves it free") {
  for (const int seed : {1, 2, 3, 4, 5, 6}) {
    const double size = std::sqrt(12. / 80);
    for (const double share : {0.0, 0.1, 0.25}) {
      const std::vector<Part> parts =
          build_rubble({.outline = panel, .stones = 80, .least_edge = share * size, .seed = seed});
      CHECK(shortest_edge(parts) >= share * size);
      CHECK(near(total_area(parts), 12, 1e-12));
      int concave = 0;
      for (const Part& part : parts) concave += !is_convex(part.outline);
      if (share <= 0.1) CHECK(concave <= 4);
    }
  }
}

TEST_CASE("stones share their corners to the bit") {
  const std::vector<Part> parts = build_rubble({.outline = panel, .stones = 100});
  std::vector<Vec2> corners;
  for (const Part& part : parts) corners.insert(corners.end(), part.outline.begin(), part.outline.end());
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      if ((corners[i] - corners[j]).norm() < 1e-6) CHECK(corners[i] == corners[j]);
}

TEST_CASE("the same seed gives the same bits, on every machine") {
  const Rubble rubble{.outline = panel, .stones = 50, .aspect = 1.5};
  Rubble other = rubble;
  other.seed = 2;
  CHECK(digest(build_rubble(rubble)) == digest(build_rubble(rubble)));
  CHECK(digest(build_rubble(rubble)) != digest(build_rubble(other)));
  CHECK(digest(build_rubble(rubble)) == 7165704911472208967ULL);
}

TEST_CASE("relaxation makes stones more even in size") {
  const auto spread = [](int relaxations) {
    const std::vector<Part> parts =
        build_rubble({.outline = panel, .stones = 100, .relaxations = relaxations, .least_edge = 0});
    double sum = 0, squares = 0;
    for (const Part& part : parts) sum += signed_area(part.outline), squares += std::pow(signed_area(part.outline), 2);
    return std::sqrt(squares * 100 / (sum * sum) - 1);
  };
  const double none = spread(0), three = spread(3), thirty = spread(30);
  // areas of the cells of random points vary by 0.53 of their mean (Gilbert 1962)
  CHECK(near(none, 0.53, 0.2));
  CHECK(three < 0.6 * none);
  CHECK(thirty < 0.6 * three);
}

TEST_CASE("a joint sets stones back from each other by its width, not from the outline") {
  const double joint = 0.03;
  const std::vector<Part> parts = build_rubble({.outline = panel, .stones = 60, .least_edge = 0, .joint = joint});
  check_sound(parts);
  double least = 10;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      for (const Vec2& p : parts[j].outline) least = std::min(least, boundary_point(parts[i].outline, p).distance);
  CHECK(near(least, joint, 1e-6));
  double low = 10;
  for (const Part& part : parts) low = std::min(low, bounding_box(part.outline).low.y());
  CHECK(low == 0);
  const std::vector<Part> rounded = build_rubble({.outline = panel, .stones = 60, .joint = joint});
  check_sound(rounded);
  for (std::size_t i = 0; i < parts.size(); ++i)
    CHECK(signed_area(rounded[i].outline) <= signed_area(parts[i].outline) + 1e-12);
}

TEST_CASE("rubble is named from the bottom up and stretched by the given factor") {
  const std::vector<Part> parts = build_rubble({.name = "w", .outline = panel, .stones = 200, .aspect = 3});
  CHECK(parts[0].name == "w.r1");
  CHECK(parts[0].groups == std::vector<std::string>{"stones", "w"});
  double along = 0, up = 0, before = -1;
  for (const Part& part : parts) {
    const Box2 box = bounding_box(part.outline);
    along += box.high.x() - box.low.x(), up += box.high.y() - box.low.y();
    const double y = polygon_moments(part.outline).centroid.y();
    CHECK(y >= before);
    before = y;
  }
  CHECK(near(along / up, 3, 0.15));
}

TEST_CASE("every place of the outline is in the cell of the point nearest to it") {
  const std::vector<Vec2> points{{0.5, 0.5}, {3, 1}, {2, 2.5}, {1.2, 2.2}, {3.6, 2.8}};
  const auto cells = voronoi_cells(panel, points, 0);
  for (double x = 0.05; x < 4; x += 0.1)
    for (double y = 0.05; y < 3; y += 0.1) {
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < points.size(); ++i)
        if ((points[i] - Vec2(x, y)).norm() < (points[nearest] - Vec2(x, y)).norm()) nearest = i;
      REQUIRE(cells[nearest].size() == 1);
      const Polygon spot{{x, y}, {x + 1e-9, y}, {x, y + 1e-9}};
      CHECK(penetration(spot, cells[nearest][0]).separation < 1e-8);
    }
}

TEST_CASE("impossible rubble in the plane is rejected") {
  const auto with = [](auto change) {
    Rubble rubble{.name = "r", .outline = panel};
    change(rubble);
    return refusal_of([&] { build_rubble(rubble); });
  };
  CHECK(mentions(with([](Rubble& r) { r.outline = {{0, 0}, {1, 1}}; }), "rubble 'r': outline has 2 different points"));
  CHECK(mentions(with([](Rubble& r) { r.stones = 0; }), "stones is 0"));
  CHECK(mentions(with([](Rubble& r) { r.aspect = 20; }), "aspect is 20, must be from 0.1 to 10"));
  CHECK(mentions(with([](Rubble& r) { r.least_edge = 1; }),
                 "least edge is 1 m, must be at most 0.3 of a stone's mean size"));
  CHECK(mentions(with([](Rubble& r) { r.joint = 1; }), "joint is 1 m, must be at most 0.5"));
  CHECK(mentions(with([](Rubble& r) { r.jitter = NAN; }), "jitter is nan"));
  CHECK(mentions(with([](Rubble& r) { r.relaxations = -1; }), "relaxations is -1"));
}
