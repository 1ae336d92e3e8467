#include "geometry/plane/convex_parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/plane/overlap.hpp"
#include "geometry/plane/polygon.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

Polygon corners_of(const Polygon& outline, const ConvexPiece& piece) {
  Polygon corners;
  for (int i : piece.corners) corners.push_back(outline[static_cast<std::size_t>(i)]);
  return corners;
}

int right_turns(const Polygon& outline) {
  const std::size_t n = outline.size();
  int count = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (turn_sine(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]) < -kStraightAngle) ++count;
  return count;
}

/// Checks all invariants of a decomposition and returns the number of pieces.
int checked_parts(const Polygon& outline) {
  const std::vector<ConvexPiece> pieces = convex_parts(outline);
  double area = 0;
  std::vector<int> seen(outline.size(), 0);
  std::vector<std::pair<int, int>> cuts;
  for (const ConvexPiece& piece : pieces) {
    const Polygon corners = corners_of(outline, piece);
    CHECK(is_convex(corners));
    CHECK(signed_area(corners) > 0);
    area += signed_area(corners);
    REQUIRE(piece.faces.size() == piece.corners.size());
    for (std::size_t k = 0; k < piece.faces.size(); ++k) {
      const int from = piece.corners[k], to = piece.corners[(k + 1) % piece.corners.size()];
      if (piece.faces[k] < 0) {
        cuts.emplace_back(from, to);
        continue;
      }
      CHECK(piece.faces[k] == from);
      CHECK(to == (from + 1) % static_cast<int>(outline.size()));
      ++seen[static_cast<std::size_t>(piece.faces[k])];
    }
  }
  CHECK(near(area, signed_area(outline), 1e-12));
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
  for (const auto& [from, to] : cuts) CHECK(std::count(cuts.begin(), cuts.end(), std::pair(to, from)) == 1);
  const int count = static_cast<int>(pieces.size()), right = right_turns(outline);
  CHECK(cuts.size() == 2 * (pieces.size() - 1));
  CHECK(count >= (right + 1) / 2 + 1);
  CHECK(count <= 2 * right + 1);
  return count;
}

Polygon stepped_valley(int steps) {
  Polygon outline{{0, -100}, {10.0 * steps, -100}};
  Polygon surface;
  for (int i = 0; i < steps; ++i) {
    const double level = -3.0 * std::min(i, steps - 1 - i);
    surface.emplace_back(10.0 * i, level);
    surface.emplace_back(10.0 * (i + 1), level);
  }
  if (steps % 2 == 0) {  // the two middle steps are level: otherwise their shared corner would occur twice
    surface.erase(surface.begin() + steps);
  }
  outline.insert(outline.end(), surface.rbegin(), surface.rend());
  return outline;
}

/// The least number of convex pieces, found by trying every cut from the first reflex corner; for few corners only.
class LeastPieces {
 public:
  explicit LeastPieces(Polygon outline) : outline_(std::move(outline)) {}

  int count() {
    std::vector<int> all(outline_.size());
    std::iota(all.begin(), all.end(), 0);
    return count(all);
  }

 private:
  const Vec2& at(int i) const { return outline_[static_cast<std::size_t>(i)]; }

  int count(const std::vector<int>& part) {
    if (const auto known = known_.find(part); known != known_.end()) return known->second;
    const std::size_t n = part.size();
    std::size_t v = 0;
    while (v < n && turn_sine(at(part[(v + n - 1) % n]), at(part[v]), at(part[(v + 1) % n])) >= -kStraightAngle) ++v;
    if (v == n) return known_[part] = 1;
    int least = 1000;
    std::vector<int> turned = part;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(v), turned.end());
    for (std::size_t w = 2; w + 1 < n; ++w) {
      if (!sees(turned, w)) continue;
      const auto middle = turned.begin() + static_cast<std::ptrdiff_t>(w);
      std::vector<int> right(middle, turned.end());
      right.push_back(turned[0]);
      least = std::min(least, count({turned.begin(), middle + 1}) + count(right));
    }
    return known_[part] = least;
  }

  /// True if the segment from the part's first corner to corner w is inside and meets no other corner.
  bool sees(const std::vector<int>& part, std::size_t w) const {
    const Vec2 &a = at(part[0]), &b = at(part[w]);
    Polygon corners;
    for (int i : part) corners.push_back(at(i));
    for (std::size_t k = 0; k < part.size(); ++k) {
      const std::size_t m = (k + 1) % part.size();
      if (k != 0 && k != w && boundary_point(std::vector<Vec2>{a, b}, corners[k]).distance < 1e-9) return false;
      if (k == 0 || k == w || m == 0 || m == w) continue;
      if (meeting_point(a, b, corners[k], corners[m], 1e-12)) return false;
    }
    return contains(corners, (a + b) / 2);
  }

  Polygon outline_;
  std::map<std::vector<int>, int> known_;
};

Polygon random_star(std::mt19937_64& bits, int corners) {
  Polygon star;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random_between(bits, 0.05, 0.95)) / corners;
    const double radius = random_between(bits, 0.05, 1);
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return star;
}

/// True if the points are a valid polygon (a star with a wide gap may be clockwise or cross itself).
bool is_simple(const Polygon& outline) {
  return !find_self_crossing(outline, 1e-12) && orientation(outline) > 0;
}

}  // namespace

TEST_CASE("a convex outline is one piece, with or without collinear corners") {
  const Polygon square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 0.5}};
  CHECK(checked_parts(square) == 1);
  CHECK(convex_parts(square)[0].corners == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(convex_parts(square)[0].faces == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
  std::mt19937_64 bits(1);
  for (int trial = 0; trial < 300; ++trial) CHECK(checked_parts(random_convex(bits, {.slenderest = 30})) == 1);
}

TEST_CASE("L, T, U, plus and notched outlines are divided into the least number of pieces") {
  CHECK(checked_parts({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}) == 2);
  CHECK(checked_parts({{0, 0}, {4, 0}, {4, 1}, {2.5, 1}, {2.5, 5}, {1.5, 5}, {1.5, 1}, {0, 1}}) == 2);
  CHECK(checked_parts({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}) == 3);
  CHECK(checked_parts(
            {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}) == 3);
  CHECK(checked_parts({{0, 0}, {4, 0}, {4, 4}, {2, 3}, {0, 4}}) == 2);
  // from this deeper notch a cut to either corner leaves a reflex corner
  CHECK(checked_parts({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}) == 3);
  // a pier with footing and cap: four reflex corners, two cuts resolve two each
  CHECK(
      checked_parts(
          {{0, 0}, {6, 0}, {6, 1}, {3.5, 1}, {3.5, 9}, {5, 9}, {5, 10}, {1, 10}, {1, 9}, {2.5, 9}, {2.5, 1}, {0, 1}}) ==
      3);
}

TEST_CASE("collinear corners on the sides of a concave outline do not change its pieces") {
  Polygon ell;
  const Polygon turns{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (int k = 0; k < 8; ++k) ell.push_back(turns[i] + k / 8.0 * (turns[(i + 1) % turns.size()] - turns[i]));
  CHECK(checked_parts(ell) == 2);
  // a collinear corner lies exactly at the end of the only straight cut
  CHECK(checked_parts({{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}, {0, 1}}) == 2);
  // both reflex corners and the corners between them lie on one line
  CHECK(checked_parts(
            {{0, 0}, {9, 0}, {9, 2}, {8, 2}, {8, 1}, {6, 1}, {6, 2}, {3, 2}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}) <= 6);
}

TEST_CASE("a ground stepped down and up 20 times has about one piece for each inner corner") {
  const Polygon valley = stepped_valley(20);
  const int right = right_turns(valley), count = checked_parts(valley);
  MESSAGE("stepped valley: ", right, " right turns, ", count, " pieces");
  CHECK(count <= right + 1);
  CHECK(checked_parts(stepped_valley(21)) <= right_turns(stepped_valley(21)) + 1);
}

TEST_CASE("combs with many teeth, straight and slanted, are divided exactly") {
  for (const double slant : {0.0, 0.3, -0.7}) {
    Polygon comb{{0, 0}, {40, 0}};
    for (int tooth = 19; tooth >= 0; --tooth) {
      const double x = 2.0 * tooth;
      comb.insert(comb.end(), {{x + 2, 1}, {x + 1.9 + slant, 9}, {x + 1.1 + slant, 9}, {x + 1, 1}});
    }
    const int count = checked_parts(comb);
    CHECK(count <= right_turns(comb) + 1);
  }
}

TEST_CASE("random star-shaped outlines are divided exactly, the same way in any pose") {
  std::mt19937_64 bits(2);
  long pieces = 0, turns = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Polygon star = random_star(bits, random_count(bits, 4, 60));
    if (!is_simple(star)) continue;
    const Polygon moved = placed(star, random_direction(bits), Vec2(random_between(bits, -50, 50), 3));
    pieces += checked_parts(moved);
    turns += right_turns(moved);
    const auto again = convex_parts(moved), first = convex_parts(moved);
    for (std::size_t i = 0; i < first.size(); ++i) CHECK(again[i].corners == first[i].corners);
  }
  MESSAGE("random stars: ", turns, " right turns, ", pieces, " pieces");
}

TEST_CASE("random outlines of up to 14 corners are divided into little more than the least number of pieces") {
  std::mt19937_64 bits(20);
  int outlines = 0, at_least = 0, ours = 0, least = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Polygon star = random_star(bits, random_count(bits, 4, 14));
    if (!is_simple(star)) continue;
    const int found = static_cast<int>(convex_parts(star).size()), possible = LeastPieces(star).count();
    CHECK(found >= possible);
    ++outlines;
    at_least += found == possible ? 1 : 0;
    ours += found;
    least += possible;
  }
  MESSAGE(outlines, " outlines: ", ours, " pieces, least ", least, "; the least in ", at_least);
  CHECK(ours < 1.03 * least);
  CHECK(at_least > 0.93 * outlines);
}

TEST_CASE("random rectilinear outlines on a coarse grid, full of collinear corners, are divided exactly") {
  std::mt19937_64 bits(3);
  for (int trial = 0; trial < 500; ++trial) {
    const int columns = random_count(bits, 2, 25);
    Polygon outline{{0, 0}}, top;
    for (int i = 0; i < columns; ++i) outline.emplace_back(i + 1, 0);
    for (int i = 0; i < columns; ++i) {
      const double height = random_count(bits, 1, 4);
      if (!top.empty() && top.back().y() == height) top.pop_back();
      top.emplace_back(i, height);
      top.emplace_back(i + 1, height);
    }
    outline.insert(outline.end(), top.rbegin(), top.rend());
    checked_parts(outline);
  }
}

TEST_CASE("the pieces of one outline share no area") {
  const Polygon valley = stepped_valley(20);
  const auto pieces = convex_parts(valley);
  OverlapBuffer buffer;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j)
      CHECK(convex_overlap(corners_of(valley, pieces[i]), corners_of(valley, pieces[j]), buffer).area < 1e-9);
}
