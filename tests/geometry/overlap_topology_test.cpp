#include <doctest/doctest.h>

#include <cstring>
#include <random>
#include <vector>

#include "geometry/plane/edge_overlap.hpp"
#include "geometry/space/random_convex_3d.hpp"
#include "geometry/space/separation_3d.hpp"

using namespace trilith;

namespace {

/// Whether two intersections agree to the last bit.
bool same(const EdgeOverlap& p, const EdgeOverlap& q) {
  if (p.points != q.points || p.origin != q.origin) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(p.points); ++i) {
    if (std::memcmp(&p.arm[i], &q.arm[i], sizeof p.arm[i]) != 0) return false;
    for (const std::size_t s : {0U, 1U})
      if (p.depth[s][i].below != q.depth[s][i].below) return false;
  }
  if (p.faces != q.faces) return false;
  for (std::size_t l = 0; l < p.loop.size(); ++l) {
    if (((p.faces >> l) & 1U) == 0) continue;
    if (p.loop[l].count != q.loop[l].count) return false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(p.loop[l].count); ++k)
      if (p.loop[l].point[k] != q.loop[l].point[k]) return false;
  }
  return true;
}

ConvexSolid few_faced(std::mt19937_64& bits) {
  switch (random_count(bits, 0, 2)) {
    case 0:
      return convex_solid(box_solid(Vec3(-0.5, -0.4, -0.3), Vec3(0.5, 0.4, 0.3)), "box");
    case 1:
      return convex_solid(random_convex_solid(bits, {.most_corners = 6, .slenderest = 3}), "solid");
    default:
      return convex_solid(random_prism(bits, 0.5, 1.5, {.most_corners = 4}), "prism");
  }
}

}  // namespace

TEST_CASE("the intersection by a known topology has the bits of a new one while two solids slide through each other") {
  std::mt19937_64 bits(510);
  int found = 0, kept = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ConvexSolid solid_a = few_faced(bits), solid_b = few_faced(bits);
    if (!has_few_faces(solid_a) || !has_few_faces(solid_b)) continue;
    PlacedSolid a, b;
    place(solid_a, Turn3(random_rotation(bits)), Vec3(3, -2, 1), a);
    const UnitQuaternion turn = random_rotation(bits);
    place(solid_b, Turn3(turn), Vec3(3, -2, 1), b);
    const Separation3 apart = separation(a, b);
    // From apart to deep and out on another side: all cases of corners, edges and faces, and their changes.
    const Vec3 start = Vec3(3, -2, 1) - 1.02 * apart.distance * apart.axis, way = 0.4 * random_in_ball(bits);
    OverlapTopology known;
    for (int step = 0; step < 200; ++step) {
      place(solid_b, Turn3(turn), start + (0.005 * step) * way + (step % 2) * 1e-5 * random_in_ball(bits), b);
      const bool was_known = known.a != nullptr;
      const std::size_t parts = known.parts;
      EdgeOverlap anew, by_known;
      const bool is_there = edge_overlap(a, b, anew);
      REQUIRE(edge_overlap(a, b, by_known, &known) == is_there);
      if (!is_there) continue;
      ++found;
      REQUIRE(same(anew, by_known));
      if (was_known && known.a != nullptr && parts == known.parts) ++kept;
    }
  }
  CHECK(found > 20000);
  CHECK(kept > 0.8 * found);
}

TEST_CASE("a topology of other solids at the same place in memory is not used") {
  const ConvexSolid box = convex_solid(box_solid(Vec3(-1, -1, -1), Vec3(1, 1, 1)), "box");
  std::mt19937_64 bits(511);
  int checked = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const ConvexSolid other = few_faced(bits);
    if (!has_few_faces(other)) continue;
    PlacedSolid a, b;
    OverlapTopology known;
    for (const ConvexSolid* solid : {&box, &other, &box}) {
      place(*solid, Turn3(random_rotation(bits)), Vec3::Zero(), a);
      place(*solid, Turn3(random_rotation(bits)), 0.6 * random_in_ball(bits), b);
      EdgeOverlap anew, by_known;
      const bool is_there = edge_overlap(a, b, anew);
      REQUIRE(edge_overlap(a, b, by_known, &known) == is_there);
      if (is_there) CHECK(same(anew, by_known));
      checked += is_there ? 1 : 0;
    }
  }
  CHECK(checked > 300);
}

TEST_CASE("a memory of topologies keeps the pairs in use, however many others there were") {
  std::vector<PlacedSolid> placed(3000);
  OverlapMemory memory;
  const auto use = [&](std::size_t first, std::size_t end) {
    int kept = 0;
    for (std::size_t i = first; i + 1 < end; ++i) {
      OverlapTopology& of = memory.of(placed[i], placed[i + 1]);
      kept += of.a == &placed[i] && of.b == &placed[i + 1] ? 1 : 0;
      of.a = &placed[i], of.b = &placed[i + 1];
    }
    return kept;
  };
  CHECK(use(0, 2000) == 0);
  // It was emptied while it grew.
  CHECK(use(0, 2000) > 0);
  use(0, 2000);
  CHECK(use(0, 2000) == 1999);
  for (std::size_t first = 0; first < 2900; ++first)
    for (int step = 0; step < 5; ++step) use(first, first + 100);
  CHECK(use(2899, 2999) == 99);
}
