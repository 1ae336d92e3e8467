#include "geometry/plane/mesh.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;

std::string message_of(const Mesh& mesh) {
  try {
    check_mesh(mesh, "body 'b'");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("a checked mesh has the outer boundary's nodes first, in order around it") {
  const CheckedMesh c = check_mesh(grid_mesh({Vec2(0, 0), Vec2(3, 0), Vec2(3, 2), Vec2(0, 2)}, 3, 2), "b");
  CHECK(c.outline == 10);
  CHECK(c.mesh.node.size() == 12);
  const Polygon outline(c.mesh.node.begin(), c.mesh.node.begin() + c.outline);
  CHECK(near(signed_area(outline), 6, 1e-12));
  int edges = 0;
  for (const unsigned bits : c.boundary_edges) edges += __builtin_popcount(bits);
  CHECK(edges == 10);
}

TEST_CASE("a mesh with a hole has the hole's loop after the outer one") {
  Mesh mesh = grid_mesh({Vec2(0, 0), Vec2(3, 0), Vec2(3, 3), Vec2(0, 3)}, 3, 3);
  mesh.element.erase(mesh.element.begin() + 4);
  const CheckedMesh c = check_mesh(mesh, "b");
  CHECK(c.outline == 12);
  CHECK(c.mesh.node.size() == 16);
}

TEST_CASE("clockwise elements are reversed and unused nodes dropped, with notes") {
  const Mesh mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}}, {{0, 3, 2, 1}}};
  const CheckedMesh c = check_mesh(mesh, "b");
  CHECK(c.notes.size() == 2);
  CHECK(c.mesh.node.size() == 4);
  CHECK(signed_area(corners_of(c.mesh, 0)) > 0);
}

TEST_CASE("meshes that cannot be used are rejected with the element or node") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {5, 5}, {6, 5}, {6, 6}};
  CHECK(message_of({square, {}}).find("no element") != std::string::npos);
  CHECK(message_of({square, {{0, 1, 2, 9}}}).find("element 1 of the mesh names node 10") != std::string::npos);
  CHECK(message_of({square, {{0, 1, 1, 3}}}).find("twice") != std::string::npos);
  CHECK(message_of({{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}, {{0, 1, 2, 3}}}).find("bent inwards") != std::string::npos);
  CHECK(message_of({square, {{0, 1, 2, 3}, {4, 5, 6, -1}}}).find("shares no edge with the others") !=
        std::string::npos);
  CHECK(message_of({square, {{0, 1, 2, 3}, {0, 1, 2, -1}}}).find("same side") != std::string::npos);
  CHECK(message_of({{{0, 0}, {NAN, 0}, {1, 1}}, {{0, 1, 2, -1}}}).find("not finite") != std::string::npos);
}

}  // namespace
}  // namespace trilith
