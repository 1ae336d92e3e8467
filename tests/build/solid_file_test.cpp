#include "build/space/solid_file.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "base/rotation_3d.hpp"
#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "build/space/check_solids.hpp"
#include "build/space/dome.hpp"
#include "build/space/solid_rubble.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Faces divided into triangles from their first corner.
std::vector<std::array<int, 3>> triangles_of(const Polyhedron& solid) {
  std::vector<std::array<int, 3>> made;
  for (int f = 0; f < solid.faces.count(); ++f)
    for (std::size_t k = 2; k < solid.faces[f].size(); ++k)
      made.push_back({solid.faces[f][0], solid.faces[f][k - 1], solid.faces[f][k]});
  return made;
}

/// Text of an OBJ file: a header before each solid, and the solid in triangles.
std::string obj_of(const std::vector<std::pair<std::string, Polyhedron>>& solids) {
  std::string text;
  int points = 0;
  for (const auto& [head, solid] : solids) {
    text += head;
    for (const Vec3& p : solid.corners) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    for (const auto& t : triangles_of(solid))
      text += fmt::format("f {}/1/1 {}//2 {}\n", points + t[0] + 1, points + t[1] + 1, points + t[2] + 1);
    points += static_cast<int>(solid.corners.size());
  }
  return text;
}

std::string stl_of(const std::string& name, const Polyhedron& solid) {
  std::string text = fmt::format("solid {}\n", name);
  for (const auto& t : triangles_of(solid)) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const int i : t) {
      const Vec3& p = solid.corners[static_cast<std::size_t>(i)];
      text += fmt::format("  vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += " endloop\nendfacet\n";
  }
  return text + fmt::format("endsolid {}\n", name);
}

void put_word(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * k) & 255U);
}

std::string binary_stl_of(const std::vector<SolidPart>& parts) {
  std::string head = "solid that is binary all the same", body;
  head.resize(80, ' ');
  std::uint32_t count = 0;
  for (const SolidPart& part : parts)
    for (const auto& t : triangles_of(part.pieces[0])) {
      ++count;
      for (int k = 0; k < 3; ++k) put_word(body, 0);
      for (const int i : t)
        for (int k = 0; k < 3; ++k)
          put_word(body, std::bit_cast<std::uint32_t>(
                             static_cast<float>(part.pieces[0].corners[static_cast<std::size_t>(i)][k])));
      body += std::string(2, '\0');
    }
  put_word(head, count);
  return head + body;
}

const Polyhedron cube = box_solid({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("objects of an OBJ file become bodies whose triangles are joined to faces") {
  const Polyhedron other = box_solid({1, 0, 0}, {3, 1, 1});
  const std::string text = obj_of({{"# stones\no left stone\n", cube}, {"o right\ng upper lower\n", other}});
  const SolidParts read = parse_obj(text, {.name = "wall", .groups = {"old"}}, "file");
  CHECK(read.notes.empty());
  REQUIRE(read.parts.size() == 2);
  CHECK(read.parts[0].name == "wall.left stone");
  CHECK(read.parts[0].groups == std::vector<std::string>{"old", "wall"});
  CHECK(read.parts[1].groups == std::vector<std::string>{"upper", "lower", "old", "wall"});
  CHECK(read.parts[0].pieces[0].faces.count() == 6);
  CHECK(read.parts[0].pieces[0].corners.size() == 8);
  CHECK(volume_of(read.parts[0]) == 1);
  CHECK(volume_of(read.parts[1]) == 2);
  CHECK(check_sound(read.parts) == 1);
}

TEST_CASE("a group of several convex objects is one body of several pieces") {
  const std::string text = obj_of({{"g ell\no a\n", cube},
                                   {"o b\n", box_solid({1, 0, 0}, {2, 1, 3})},
                                   {"g alone\no c\n", box_solid({5, 0, 0}, {6, 1, 1})}});
  const SolidParts read = parse_obj(text, {}, "file");
  REQUIRE(read.parts.size() == 2);
  CHECK(read.parts[0].name == "ell");
  CHECK(read.parts[0].pieces.size() == 2);
  CHECK(volume_of(read.parts[0]) == 4);
  CHECK(read.parts[1].name == "alone");
}

TEST_CASE("files may have another unit, another upward axis, negative indices and faces of any size") {
  const std::string text =
      "v 0 0 0\nv +1000 0 0\nv 1e3 1000 0\nv 0 1000 0\nv 0 0 2000\nv 1000 0 2000\nv 1000 1000 2000 1 0.5 0\n"
      "v 0 1000 2000\nusemtl stone\nf 4 3 2 1\nf -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8 # last\n";
  const SolidParts read = parse_obj(text, {.name = "m", .scale = 0.001, .y_up = true}, "file");
  REQUIRE(read.parts.size() == 1);
  CHECK(read.parts[0].name == "m");
  CHECK(near(volume_of(read.parts[0]), 2, 1e-14));
  Vec3 low = Vec3::Constant(9), high = -low;
  for (const Vec3& p : read.parts[0].pieces[0].corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  CHECK((low - Vec3(0, -2, 0)).norm() < 1e-14);
  CHECK((high - Vec3(1, 0, 1)).norm() < 1e-14);
}

TEST_CASE("solids that are inside out or partly so are reversed with a note") {
  Polyhedron inverted;
  inverted.corners = cube.corners;
  Polyhedron partly = inverted;
  for (int f = 0; f < 6; ++f) {
    const std::vector<int> back(cube.faces[f].rbegin(), cube.faces[f].rend());
    inverted.faces.add(back);
    partly.faces.add(f == 0 || f == 3 ? std::span<const int>(back) : cube.faces[f]);
  }
  const SolidParts read = parse_obj(obj_of({{"o a\n", inverted}, {"o b\n", partly}}), {}, "file");
  CHECK(volume_of(read.parts[0]) == 1);
  CHECK(volume_of(read.parts[1]) == 1);
  REQUIRE(read.notes.size() == 2);
  CHECK(mentions(read.notes[0], "solid 'a' was inside out"));
  CHECK(mentions(read.notes[1], "solid 'b': 4 of 12 faces had the wrong orientation"));
}

TEST_CASE("STL as text gives a body for each solid, in exactly its places") {
  const SolidParts read = parse_stl(
      stl_of("a", cube) + stl_of("", box_solid({0, 0, 1}, {1, 1, 1.5})) + stl_of("a", box_solid({0, 0, 2}, {1, 1, 3})),
      {}, "file");
  REQUIRE(read.parts.size() == 3);
  CHECK(read.parts[0].name == "a");
  CHECK(read.parts[1].name == "solid");
  CHECK(read.parts[2].name == "a.2");
  REQUIRE(read.notes.size() == 1);
  CHECK(mentions(read.notes[0], "there is already a solid 'a'; the next one is named 'a.2'"));
  CHECK(near(volume_of(read.parts[1]), 0.5, 1e-15));
  CHECK(read.parts[1].pieces[0].faces.count() == 6);
}

TEST_CASE("a byte order mark at the start of a text is skipped") {
  const std::string mark = "\xEF\xBB\xBF";
  for (const auto& [bytes, parse] :
       {std::pair{obj_of({{"", cube}}), &parse_obj}, std::pair{stl_of("a", cube), &parse_stl}}) {
    const SolidParts plain = parse(bytes, {}, "file"), marked = parse(mark + bytes, {}, "file");
    REQUIRE(marked.parts.size() == 1);
    CHECK(volume_of(marked.parts[0]) == volume_of(plain.parts[0]));
  }
}

TEST_CASE("a dome in single precision, all stones in one binary STL, comes back with plane faces") {
  std::vector<SolidPart> dome = build_dome({.rings = 5, .sectors = 12, .phase = 0.123});
  for (SolidPart& part : dome) place_part(part, rotation_by(Vec3(0.3, 0.5, 0.1)), {0.1, 0.2, 0.3});
  const SolidParts read = parse_stl(binary_stl_of(dome), {.name = "dome", .shells_are_bodies = true}, "file");
  REQUIRE(read.parts.size() == dome.size());
  for (std::size_t i = 0; i < dome.size(); ++i) {
    CHECK(read.parts[i].name == fmt::format("dome.{}", i + 1));
    CHECK(near(volume_of(read.parts[i]), volume_of(dome[i]), 1e-5));
    CHECK(read.parts[i].pieces[0].faces.count() == dome[i].pieces[0].faces.count());
    check_convex(read.parts[i].pieces[0], "stone");
  }
  REQUIRE(read.notes.size() == 1);
  CHECK(mentions(read.notes[0], "solids were made plane, corners moved by up to"));
  const SolidParts one = parse_stl(binary_stl_of(dome), {.name = "dome"}, "file");
  CHECK(one.parts.size() == 1);
  CHECK(one.parts[0].pieces.size() == dome.size());
  CHECK(mentions(one.notes[0], "has 61 separate shells"));
}

TEST_CASE("a thousand stones of rubble pass all checks, also after single precision") {
  std::vector<SolidPart> rubble = build_solid_rubble({.high = {10, 1, 5}, .stones = 1000, .seed = 3});
  CHECK(near(total_volume(rubble), 50, 1e-12));
  CHECK(check_solids(rubble).empty());
  const SolidParts read = parse_stl(binary_stl_of(rubble), {.name = "R", .shells_are_bodies = true}, "file");
  REQUIRE(read.parts.size() == 1000);
  CHECK(near(total_volume(read.parts), 50, 1e-6));
  for (const SolidPart& part : read.parts) check_convex(part.pieces[0], part.name);
  REQUIRE(read.notes.size() == 2);
  CHECK(mentions(read.notes[1],
                 "solids with very narrow or non-planar faces were replaced by the hulls of their corners"));
}

TEST_CASE("files are read by their ending") {
  const auto folder = std::filesystem::temp_directory_path() / "trilith_solid_file_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.STL") << stl_of("a", cube);
  CHECK(read_solids(folder / "a.STL").parts.size() == 1);
  CHECK(mentions(refusal_of([&] { read_solids(folder / "a.ply"); }), "its extension is '.ply'"));
  CHECK(mentions(refusal_of([&] { read_solids(folder / "b.obj"); }), "cannot read solids"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a solid that is not closed and convex is rejected with name and place") {
  Polyhedron open = cube;
  open.faces.corner.resize(20), open.faces.start.pop_back();
  CHECK(mentions(refusal_of([&] {
                   parse_obj(obj_of({{"o a\n", open}}), {}, "file");
                 }),
                 "file: solid 'a' is open: 4 edges belong to one face only, such as the edge from ("));
  // all other corners are visible from the first and the last one, so that the fans of triangles are exact
  const Polyhedron ell = extrusion(
      std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {-0.1, 0.5, 0}}, {0, 0, 1});
  CHECK(
      mentions(refusal_of([&] { parse_stl(stl_of("L", ell), {}, "file"); }), "solid 'L' is not convex: a corner at ("));
  CHECK(mentions(refusal_of([&] { parse_stl(stl_of("L", ell), {}, "file"); }),
                 "give it as several convex objects in one group"));
  const auto obj = [](const char* text) { return refusal_of([&] { parse_obj(text, {}, "file"); }); };
  CHECK(mentions(obj(""), "file: there is no solid in the file"));
  CHECK(mentions(obj("v 0 0\n"), "file: line 1: z of a point is ''"));
  CHECK(mentions(obj("v 0 0 0\nf 1 2 3\n"), "line 2: a face names point 2, there are points 1 to 1"));
  CHECK(obj("f 1 2 3\n") == "file: line 1: a face names point 1, but no point precedes it");
  CHECK(mentions(obj("v 0 0 1e13\n"), "file: line 1: a point at (0, 0, 1e+13) m, must be within 1e12 m of the origin"));
  CHECK(mentions(obj("v 0 0 0\nf 1 1\n"), "line 2: a face has 2 corners"));
  CHECK(mentions(obj("v 0 0 0\nf a b c\n"), "a corner of a face is 'a'"));
  const auto stl = [](const std::string& text) { return refusal_of([&] { parse_stl(text, {}, "file"); }); };
  CHECK(mentions(stl("hello"), "is not an STL file"));
  CHECK(mentions(stl("solid a\nfacet"), "line 2: the file ends where 'normal' should be"));
  CHECK(mentions(stl("solid a\n facet normal 0 0 1\nouter loop\nvertex 0 0 x"), "line 4: a coordinate is 'x'"));
  CHECK(mentions(stl("solid a\nendsolid a\n"), "there is no solid in the file"));
  CHECK(mentions(refusal_of([&] { parse_stl("solid", {.scale = 0}, "file"); }), "file: scale is 0 m"));
  CHECK(mentions(refusal_of([&] { parse_stl(stl_of("a", cube), {.flat = 1}, "file"); }), "flat is 1, must be from"));
}

TEST_CASE("a self-intersecting solid is rejected with the place, not replaced by its hull") {
  // a prism over a bow tie, whose volume is 0, and one over a five-pointed star, which is convex at each edge
  const std::string attachment =
      "o tie\nv 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nv 1 0 1\nv 0 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  CHECK(refusal_of([&] { parse_obj(attachment, {}, "file"); }) ==
        "file: solid 'tie' intersects itself at (0.5, 0.5, 0) m, where two sides of one face cross; give each convex "
        "part of it as its own object");
  std::string star = "o star\n";
  for (const int z : {0, 1})
    for (int i = 0; i < 5; ++i) {
      const double angle = 0.8 * std::numbers::pi * i;
      star += fmt::format("v {} {} {}\n", std::cos(angle), std::sin(angle), z);
    }
  star += "f 5 4 3 2 1\nf 6 7 8 9 10\nf 1 2 7 6\nf 2 3 8 7\nf 3 4 9 8\nf 4 5 10 9\nf 5 1 6 10\n";
  CHECK(mentions(refusal_of([&] { parse_obj(star, {}, "file"); }),
                 "file: solid 'star' intersects itself at (-0.381966, "));
}

TEST_CASE("a duplicate face and a flat solid are reported") {
  Polyhedron twice = cube;
  twice.faces.add(std::vector<int>(cube.faces[0].begin(), cube.faces[0].end()));
  CHECK(mentions(refusal_of([&] {
                   parse_obj(obj_of({{"o a\n", twice}}), {}, "file");
                 }),
                 "file: solid 'a' has an edge with 3 faces, from ("));
  Polyhedron thin = cube;
  for (Vec3& p : thin.corners) p.z() *= 1e-6;
  CHECK(mentions(refusal_of([&] {
                   parse_obj(obj_of({{"o a\n", thin}}), {}, "file");
                 }),
                 "file: solid 'a' is flat: 1e-06 m thick and 1.41 m large, must be thicker than 5.66e-06 m"));
  CHECK(parse_obj(obj_of({{"o a\n", thin}}), {.flat = 1e-8}, "file").parts.size() == 1);
}

TEST_CASE("one note covers many solids of a file") {
  Polyhedron inverted = cube;
  for (int f = 0; f < inverted.faces.count(); ++f)
    std::reverse(inverted.faces.corner.begin() + inverted.faces.start[static_cast<std::size_t>(f)],
                 inverted.faces.corner.begin() + inverted.faces.start[static_cast<std::size_t>(f) + 1]);
  std::vector<std::pair<std::string, Polyhedron>> boxes;
  for (int i = 0; i < 1000; ++i) boxes.emplace_back(fmt::format("o box{}\n", i), inverted);
  const SolidParts read = parse_obj(obj_of(boxes), {}, "file");
  CHECK(read.parts.size() == 1000);
  REQUIRE(read.notes.size() == 1);
  CHECK(read.notes[0] ==
        "file: solid 'box0' was inside out; its faces were reversed (and 999 more of its solids likewise)");
}

TEST_CASE("a binary file with a wrong count or a truncated end is rejected with its capacity") {
  const std::string sound = binary_stl_of({SolidPart{"cube", {cube}, {}}});
  const auto stl = [](const std::string& bytes) { return refusal_of([&] { parse_stl(bytes, {}, "file"); }); };
  std::string more = sound, cut = sound.substr(0, sound.size() - 20);
  more[80] = 13;
  CHECK(stl(more) ==
        "file: is cut short or not an STL file: bytes 81 to 84 announce 13 triangles, which need 734 bytes, but it has "
        "684, room for 12; export it again");
  CHECK(mentions(stl(cut), "announce 12 triangles, which need 684 bytes, but it has 664, room for 11"));
  CHECK(mentions(stl("xy"), "is not an STL file: a text file begins with 'solid'"));
  CHECK(mentions(refusal_of([] { parse_obj(std::string("v 0 0\0 0\n", 9), {}, "file"); }),
                 "file: is not an OBJ file: its byte 6 is 0, but OBJ files are text"));
}

TEST_CASE("a file of 100,000 faces gives one line, whether it is closed, open or hollow") {
  const auto around = [](int of) { return 2 * std::numbers::pi * of / 224; };
  // a ball of 224 by 224 faces, each a triangle or a quad of two, with a bump at some corners
  const auto ball = [&](double bump, int left_out) {
    std::string text = "o ball\nv 0 0 -1\nv 0 0 1\n";
    for (int i = 1; i < 224; ++i)
      for (int j = 0; j < 224; ++j) {
        const double level = 0.5 * around(i) - 0.5 * std::numbers::pi, reach = 1 + bump * (i * j % 7 == 0 ? 1 : 0);
        text += fmt::format("v {} {} {}\n", reach * std::cos(level) * std::cos(around(j)),
                            reach * std::cos(level) * std::sin(around(j)), reach * std::sin(level));
      }
    const auto corner = [](int i, int j) { return 3 + (i - 1) * 224 + j % 224; };
    for (int j = left_out; j < 224; ++j) {
      text += fmt::format("f 1 {} {}\nf 2 {} {}\n", corner(1, j + 1), corner(1, j), corner(223, j), corner(223, j + 1));
      for (int i = 1; i < 223; ++i)
        text += fmt::format("f {0} {1} {2}\nf {0} {2} {3}\n", corner(i, j), corner(i, j + 1), corner(i + 1, j + 1),
                            corner(i + 1, j));
    }
    return refusal_of([&] { parse_obj(text, {}, "file"); });
  };
  CHECK(mentions(ball(0, 0), "faces, at most 5000 are allowed; make it coarser"));
  CHECK(mentions(ball(0, 1), "file: solid 'ball' is open: 448 edges belong to one face only, such as the edge from ("));
  CHECK(mentions(ball(0.1, 0), "file: solid 'ball' is not convex: a corner at ("));
}
