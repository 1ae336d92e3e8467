#include "geometry/space/surface.hpp"

#include <doctest/doctest.h>

#include <random>

#include "geometry/space/random_convex_3d.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Every face as triangles with their own corners, as in STL.
Polyhedron shattered(const Polyhedron& solid, std::mt19937_64& bits, double noise) {
  Polyhedron made;
  for (int f = 0; f < solid.faces.count(); ++f) {
    const auto loop = solid.faces[f];
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const int first = static_cast<int>(made.corners.size());
      for (const int i : {loop[0], loop[k - 1], loop[k]})
        made.corners.push_back(solid.corners[static_cast<std::size_t>(i)] + noise * random_in_ball(bits));
      made.faces.add(std::vector<int>{first, first + 1, first + 2});
    }
  }
  return made;
}

}  // namespace

TEST_CASE("joining a solid divided into triangles restores its numbers of corners, edges and faces") {
  std::mt19937_64 bits(11);
  for (int i = 0; i < 100; ++i) {
    const Polyhedron solid = random_prism(bits, 0.5, 1);
    const Polyhedron joined = with_joined_corners(shattered(solid, bits, 1e-9), 1e-7);
    CHECK(joined.corners.size() == solid.corners.size());
    const std::vector<int> across = edges_across(joined.faces);
    CHECK(std::count(across.begin(), across.end(), -1) == 0);
    const Shells shells = shells_of(joined, across);
    CHECK(shells.count == 1);
    CHECK(shells.whole[0] == 1);
    CHECK(std::count(shells.turn.begin(), shells.turn.end(), 1) == 0);
    const Polyhedron whole = with_joined_faces(solids_of(joined, shells)[0], 1e-7);
    CHECK(whole.faces.count() == solid.faces.count());
    CHECK(near(solid_moments(whole).volume, solid_moments(solid).volume, 1e-7));
    CHECK(hollow_edge(whole, edges_across(whole.faces)).by < 1e-7);
  }
}

TEST_CASE("faces with random order of corners are oriented outwards") {
  std::mt19937_64 bits(12);
  for (int i = 0; i < 100; ++i) {
    const Polyhedron solid = random_convex_solid(bits);
    Polyhedron mixed{solid.corners, {}};
    std::vector<char> turned;
    for (int f = 0; f < solid.faces.count(); ++f) {
      turned.push_back(static_cast<char>(random_count(bits, 0, 1)));
      std::vector<int> loop(solid.faces[f].begin(), solid.faces[f].end());
      if (turned.back() != 0) std::reverse(loop.begin(), loop.end());
      mixed.faces.add(loop);
    }
    const Shells shells = shells_of(mixed, edges_across(mixed.faces));
    CHECK(shells.turn == turned);
    check_convex(solids_of(mixed, shells)[0], "solid");
  }
}

TEST_CASE("two boxes that share corners and an edge are two shells") {
  Polyhedron both = box_solid({0, 0, 0}, {1, 1, 1});
  const Polyhedron other = box_solid({1, 1, 0}, {2, 2, 1});
  for (const Vec3& p : other.corners) both.corners.push_back(p);
  for (int f = 0; f < 6; ++f) {
    std::vector<int> loop(other.faces[f].begin(), other.faces[f].end());
    for (int& i : loop) i += 8;
    both.faces.add(loop);
  }
  const Polyhedron joined = with_joined_corners(both, 1e-9);
  CHECK(joined.corners.size() == 14);
  const Shells shells = shells_of(joined, edges_across(joined.faces));
  CHECK(shells.count == 2);
  for (const Polyhedron& solid : solids_of(joined, shells)) CHECK(solid_moments(solid).volume == 1);
}

TEST_CASE("an open surface is reported as open, a dent as a hollow edge with its depth") {
  Polyhedron box = box_solid({0, 0, 0}, {1, 1, 1});
  Polyhedron open{box.corners, {}};
  for (int f = 0; f < 5; ++f) open.faces.add(box.faces[f]);
  const std::vector<int> across = edges_across(open.faces);
  CHECK(std::count(across.begin(), across.end(), -1) == 4);
  CHECK(shells_of(open, across).whole[0] == 0);
  // the lid as four triangles around a point below it
  Polyhedron dented{box.corners, {}};
  dented.corners.emplace_back(0.5, 0.5, 0.9);
  for (int f = 0; f < 6; ++f) {
    const auto loop = box.faces[f];
    if (area_vector(box.corners, loop).z() < 0.5) {
      dented.faces.add(loop);
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) dented.faces.add(std::vector<int>{loop[k], loop[(k + 1) % 4], 8});
  }
  const HollowEdge hollow = hollow_edge(dented, edges_across(dented.faces));
  CHECK(hollow.by > 0.09);
  CHECK(near(hollow.at.z(), 1, 1e-15));
}
