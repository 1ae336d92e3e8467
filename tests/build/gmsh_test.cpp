#include "build/space/gmsh.hpp"

#include <doctest/doctest.h>

#include <random>

#include "base/error.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;

const std::string two_elements = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "stone"
$EndPhysicalNames
$Nodes
2 6 1 9
0 1 0 1
9
-5 -5 0
2 1 0 5
1
2
3
4
5
0 0 0
1 0 0
1 1 0
0 1 0
2 0.5 0
$EndNodes
$Elements
3 3 1 3
1 1 1 1
1 1 2
2 1 3 1
2 1 2 3 4
2 1 2 1
3 2 5 3
$EndElements
)";

std::string message_of(const std::string& text) {
  try {
    parse_gmsh(text, "mesh 'x.msh'");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST_CASE("a Gmsh file gives its triangles and quadrilaterals and the nodes they have") {
  const Mesh mesh = parse_gmsh(two_elements, "mesh");
  REQUIRE(mesh.element.size() == 2);
  CHECK(mesh.node.size() == 5);
  CHECK(corners_of(mesh.element[0]) == 4);
  CHECK(corners_of(mesh.element[1]) == 3);
  CHECK(check_mesh(mesh, "body").outline == 5);
}

/// The mesh of `two_elements` in version 2.2, with physical groups as tags of elements.
const std::string two_elements_2_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "stone"
$EndPhysicalNames
$Nodes
6
9 -5 -5 0
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 2 0.5 0
$EndNodes
$Elements
3
1 1 2 7 1 1 2
2 3 2 1 1 1 2 3 4
3 2 3 1 1 4 2 5 3
$EndElements
)";

TEST_CASE("a Gmsh file of version 2.2 gives the same mesh as one of version 4.1") {
  const Mesh blocks = parse_gmsh(two_elements, "mesh"), list = parse_gmsh(two_elements_2_2, "mesh");
  CHECK(list.node == blocks.node);
  CHECK(list.element == blocks.element);
  CHECK(message_of(with(two_elements_2_2, "3 2 3 1 1 4 2 5 3", "3 2 3 1 1 4 2 5 8"))
            .find("line 21: a triangle names node 8") != std::string::npos);
  CHECK(message_of(with(two_elements_2_2, "5 2 0.5 0", "4 2 0.5 0")).find("node 4 is given twice") !=
        std::string::npos);
  CHECK(message_of(with(two_elements_2_2, "$Nodes\n6", "$Nodes\n7")) != "");
  CHECK(message_of(with(two_elements_2_2, "$Elements\n3", "$Elements\n2")).find("instead of $EndElements") !=
        std::string::npos);
}

/// A triangle of six nodes, with the node of its first side at (x, y).
std::string second_order(const std::string& middle) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 " + middle +
         " 0\n5 1 1 0\n6 0 1 0\n$EndNodes\n$Elements\n1\n1 9 2 1 1 1 2 3 4 5 6\n$EndElements\n";
}

TEST_CASE("second-order elements of a Gmsh file give their corners if their sides are straight") {
  const Mesh mesh = parse_gmsh(second_order("1 0"), "mesh");
  CHECK(mesh.node == std::vector<Vec2>{{0, 0}, {2, 0}, {0, 2}});
  CHECK(mesh.element == decltype(mesh.element){{0, 1, 2, -1}});
  CHECK(message_of(second_order("1 0.019")) == "");
  CHECK(message_of(second_order("1 0.021")).find("curved side") != std::string::npos);
  CHECK(message_of(second_order("1.5 0")).find("not its middle") != std::string::npos);
}

TEST_CASE("errors of a Gmsh file have their line") {
  CHECK(message_of("") == "mesh 'x.msh': line 1: it does not begin with $MeshFormat, so it is not a Gmsh mesh");
  CHECK(message_of(with(two_elements, "4.1 0 8", "3.0 0 8")).find("line 2: the format has version '3.0'") !=
        std::string::npos);
  CHECK(message_of(with(two_elements, "4.1 0 8", "4.1 1 8")).find("binary") != std::string::npos);
  CHECK(message_of(with(two_elements, "2 1 3 1\n2 1 2 3 4", "2 1 3 1\n2 1 2 3 7")).find("names node 7") !=
        std::string::npos);
  CHECK(message_of(with(two_elements, "2 1 2 1\n3", "2 1 21 1\n3")).find("type 21 cannot be used") !=
        std::string::npos);
  CHECK(message_of(with(two_elements, "1 1 0\n0 1", "1 1 0.5\n0 1")).find("z = 0 to 0.5") != std::string::npos);
  CHECK(message_of(with(two_elements, "2 0.5 0", "2 nan 0")).find("line 23: y of a node is 'nan'") !=
        std::string::npos);
  CHECK(message_of(with(two_elements, "2 6 1 9", "2 7 1 9")).find("announces 7 nodes, the file has 6") !=
        std::string::npos);
  CHECK(message_of(two_elements.substr(0, two_elements.find("$Elements"))).find("ends without") != std::string::npos);
  CHECK_THROWS_AS(read_gmsh("/no/such/file.msh"), InputError);
}

TEST_CASE("a truncated or corrupted Gmsh file is read or rejected without a crash") {
  std::mt19937 random(7);
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random() % below); };
  for (int round = 0; round < 20000; ++round) {
    std::string text = round % 2 == 0 ? two_elements : two_elements_2_2;
    for (std::size_t i = 0, edits = 1 + any(4); i < edits; ++i) {
      const std::size_t at = any(text.size());
      switch (any(4)) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.resize(at + 1);
          break;
        case 2:
          text.insert(at, static_cast<std::size_t>(1 + any(9)), static_cast<char>('0' + any(10)));
          break;
        default:
          text.erase(at, 1 + any(6));
      }
      if (text.empty()) text.push_back(' ');
    }
    try {
      check_mesh(parse_gmsh(text, "mesh"), "body");
    } catch (const InputError& e) {
      CHECK(std::string(e.what()).find("mesh") != std::string::npos);
    }
  }
}

}  // namespace
}  // namespace trilith

namespace trilith {
namespace {

/// Four nodes of a tetrahedron and one more, with an element line of `type` and its nodes.
std::string solid_file(const std::string& element) {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n" +
         element + "$EndElements\n";
}

TEST_CASE("a Gmsh mesh in space gives its volumes and skips elements of the surface") {
  const SpaceMesh mesh = parse_gmsh_in_space(solid_file("3 1 4 1\n2 1 2 3 4\n"), "mesh");
  CHECK(mesh.node.size() == 5);
  REQUIRE(mesh.cell.size() == 1);
  CHECK(mesh.cell[0].shape == ElementShape::tetrahedron);
  CHECK(mesh.cell[0].node[3] == 3);
  const CheckedSpaceMesh checked = check_space_mesh(mesh, "mesh");
  CHECK(checked.mesh.node.size() == 4);
  CHECK(checked.notes.size() == 1);
}

TEST_CASE("a prism of a Gmsh mesh is a wedge with its nodes in the same order") {
  const std::string file =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 6 1 6\n3 1 0 6\n1\n2\n3\n4\n5\n6\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 2\n1 0 2\n0 1 2\n$EndNodes\n$Elements\n1 1 1 1\n3 1 6 1\n"
      "1 1 2 3 4 5 6\n$EndElements\n";
  const SpaceMesh mesh = parse_gmsh_in_space(file, "mesh");
  REQUIRE(mesh.cell.size() == 1);
  CHECK(mesh.cell[0].shape == ElementShape::wedge);
  const CheckedSpaceMesh checked = check_space_mesh(mesh, "mesh");
  CHECK(checked.notes.empty());
  CHECK(near(node_shares(ElementShape::wedge, nodes_of(checked.mesh, 0)).volume, 1, 1e-12));
}

TEST_CASE("a Gmsh mesh in space without volumes or with unknown elements is rejected with the reason") {
  CHECK_THROWS_WITH_AS(
      (void)parse_gmsh_in_space(solid_file("2 2 2 1\n2 1 2 4\n"), "mesh 'x'"),
      "mesh 'x': there is no tetrahedron, hexahedron or prism in it; mesh the volume (Mesh 3) before saving",
      InputError);
  CHECK_THROWS_WITH_AS((void)parse_gmsh_in_space(solid_file("3 1 7 1\n2 1 2 3 4 5\n"), "mesh 'x'"),
                       "mesh 'x': line 22: elements of type 7 cannot be used; use hexahedra of eight nodes (5), "
                       "prisms of six (6) and tetrahedra of four (4) or ten nodes (11)",
                       InputError);
}

}  // namespace
}  // namespace trilith
