#include "build/space/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/error.hpp"
#include "base/whole_file.hpp"

namespace trilith {
namespace {

constexpr std::size_t largest_mesh = std::size_t{1} << 30;  // [bytes]

/// Reads a text line by line and word by word.
class Words {
 public:
  Words(std::string_view text, std::string_view owner) : text_(text), owner_(owner) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: line {}: {}", owner_, line_, what));
  }
  [[nodiscard]] bool at_end() {
    skip_blanks();
    return at_ >= text_.size();
  }
  std::string_view word(const char* what) {
    skip_blanks();
    const std::size_t from = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    if (from == at_) fail(fmt::format("the file ends before {}", what));
    return text_.substr(from, at_ - from);
  }
  std::int64_t whole(const char* what) {
    const std::string_view w = word(what);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (error != std::errc() || end != w.data() + w.size())
      fail(fmt::format("{} is '{}', must be a whole number", what, shown(w)));
    return value;
  }
  /// A count that cannot exceed the size of the file.
  std::int64_t count(const char* what) {
    const std::int64_t n = whole(what);
    if (n < 0 || n > static_cast<std::int64_t>(text_.size()))
      fail(fmt::format("{} is {}, more than the file could hold or below 0", what, n));
    return n;
  }
  double number(const char* what) {
    const std::string_view w = word(what);
    double value = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (error != std::errc() || end != w.data() + w.size() || !std::isfinite(value))
      fail(fmt::format("{} is '{}', must be a finite number", what, shown(w)));
    return value;
  }
  void expect(std::string_view tag) {
    const std::string_view w = word("a section's end");
    if (w != tag) fail(fmt::format("'{}' instead of {}", shown(w), tag));
  }
  void skip_section(std::string_view name) {
    const std::string end = fmt::format("$End{}", name);
    while (!at_end())
      if (word("a section's end") == end) return;
    fail(fmt::format("the file ends before {}", end));
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  static std::string shown(std::string_view w) {
    std::string out(w.substr(0, 40));
    for (char& c : out)
      if (c < ' ' || c > '~') c = '?';
    return out;
  }
  void skip_blanks() {
    for (; at_ < text_.size() && is_blank(text_[at_]); ++at_)
      if (text_[at_] == '\n') ++line_;
  }

  std::string_view text_, owner_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Element types by their number in Gmsh.
struct ElementType {
  std::int64_t type;
  int nodes;
  const char* name;
};
constexpr std::array<ElementType, 8> known_types{{{1, 2, "line"},
                                                  {2, 3, "triangle"},
                                                  {3, 4, "quadrilateral"},
                                                  {8, 3, "line of three nodes"},
                                                  {9, 6, "triangle of six nodes"},
                                                  {10, 9, "quadrilateral of nine nodes"},
                                                  {15, 1, "point"},
                                                  {16, 8, "quadrilateral of eight nodes"}}};

/// Element types of a mesh in space; for elements of its surface only the number of nodes is needed, to skip them.
constexpr std::array<ElementType, 10> types_in_space{{{4, 4, "tetrahedron"},
                                                      {5, 8, "hexahedron"},
                                                      {6, 6, "prism"},
                                                      {11, 10, "tetrahedron of ten nodes"},
                                                      {1, 2, "line"},
                                                      {2, 3, "triangle"},
                                                      {3, 4, "quadrilateral"},
                                                      {8, 3, "line of three nodes"},
                                                      {9, 6, "triangle of six nodes"},
                                                      {15, 1, "point"}}};

struct GmshNodes {
  std::map<std::int64_t, int> index;  ///< of tag
  std::vector<Vec2> place;
  std::vector<double> height;
};

enum class GmshVersion { v2_2, v4_1 };

GmshVersion read_format(Words& words) {
  const std::string_view version = words.word("the version");
  if (version != "4.1" && version != "2.2" && version != "2")
    words.fail(fmt::format("the format has version '{}', must be 4.1 or 2.2; save it as Version 4 ASCII",
                           version.substr(0, 20)));
  if (words.whole("the file type") != 0) words.fail("the file is binary, must be text; save it as Version 4 ASCII");
  words.whole("the data size");
  words.expect("$EndMeshFormat");
  return version == "4.1" ? GmshVersion::v4_1 : GmshVersion::v2_2;
}

/// Nodes of version 2.2: one list of tag, x, y, z.
void read_node_list(Words& words, GmshNodes& nodes) {
  const std::int64_t all = words.count("the number of nodes");
  for (std::int64_t i = 0; i < all; ++i) {
    const std::int64_t tag = words.whole("a node tag");
    if (!nodes.index.emplace(tag, static_cast<int>(i)).second) words.fail(fmt::format("node {} is given twice", tag));
    const double x = words.number("x of a node"), y = words.number("y of a node");
    nodes.place.emplace_back(x, y);
    nodes.height.push_back(words.number("z of a node"));
  }
  words.expect("$EndNodes");
}

/// Blocks of nodes: first all their tags, then all their positions x y z and, if the block has parameters, as many of
/// them as its dimension. Tags may be any numbers.
void read_nodes(Words& words, GmshNodes& nodes) {
  const std::int64_t blocks = words.count("the number of node blocks"), all = words.count("the number of nodes");
  words.whole("the smallest node tag"), words.whole("the largest node tag");
  for (std::int64_t b = 0; b < blocks; ++b) {
    const std::int64_t dim = words.whole("a block's dimension");
    words.whole("a block's tag");
    const bool parametric = words.whole("the parametric flag") != 0;
    const std::int64_t count = words.count("the number of nodes of a block");
    const std::size_t first = nodes.place.size();
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t tag = words.whole("a node tag");
      if (!nodes.index.emplace(tag, static_cast<int>(first + static_cast<std::size_t>(i))).second)
        words.fail(fmt::format("node {} is given twice", tag));
    }
    for (std::int64_t i = 0; i < count; ++i) {
      const double x = words.number("x of a node"), y = words.number("y of a node");
      nodes.place.emplace_back(x, y);
      nodes.height.push_back(words.number("z of a node"));
      for (std::int64_t k = 0; parametric && k < dim; ++k) words.number("a node's parameter");
    }
  }
  if (static_cast<std::int64_t>(nodes.place.size()) != all)
    words.fail(fmt::format("the header announces {} nodes, the file has {}", all, nodes.place.size()));
  words.expect("$EndNodes");
}

template <std::size_t N>
const ElementType& known_type(const Words& words, const std::array<ElementType, N>& types, const char* usable,
                              std::int64_t type) {
  for (const ElementType& t : types)
    if (t.type == type) return t;
  words.fail(fmt::format("elements of type {} cannot be used; use {}", type, usable));
}

/// Corners of an element in the plane; 0 for points and lines, which serve the construction of the mesh and are
/// skipped.
int corners_of_type(const ElementType& type) {
  switch (type.type) {
    case 2:
    case 9:
      return 3;
    case 3:
    case 10:
    case 16:
      return 4;
    default:
      return 0;
  }
}

/// Elements of the plane have straight sides. Of a second-order element the corners are used, if each node of a side is
/// its middle.
void require_straight(const Words& words, const ElementType& type, int corners,
                      const std::array<int, max_space_nodes>& node, const GmshNodes& nodes) {
  constexpr double slack = 0.01;  // of the length of a side
  if (type.nodes < 2 * corners) return;
  const auto place = [&](int k) { return nodes.place[static_cast<std::size_t>(node[static_cast<std::size_t>(k)])]; };
  for (int k = 0; k < corners; ++k) {
    const Vec2 a = place(k), b = place((k + 1) % corners), middle = place(corners + k);
    if ((middle - 0.5 * (a + b)).norm() > slack * (b - a).norm())
      words.fail(
          fmt::format("a {} has a curved side, or a node of a side that is not its middle; elements of the plane "
                      "have straight sides, so save the mesh with order 1 and more elements",
                      type.name));
  }
}

void add_element(const Words& words, const ElementType& type, const std::array<int, max_space_nodes>& node,
                 const GmshNodes& nodes, Mesh& mesh) {
  const int corners = corners_of_type(type);
  if (corners == 0) return;
  require_straight(words, type, corners, node, nodes);
  mesh.element.push_back({node[0], node[1], node[2], corners > 3 ? node[3] : -1});
}

/// In space surfaces are skipped too. Nodes are in Gmsh's order, which is the order of element/solid/space_element.hpp.
void add_element(const Words& /*words*/, const ElementType& type, const std::array<int, max_space_nodes>& node,
                 const GmshNodes& /*nodes*/, SpaceMesh& mesh) {
  constexpr std::array<std::pair<int, ElementShape>, 4> shapes{{{4, ElementShape::tetrahedron},
                                                                {5, ElementShape::brick},
                                                                {6, ElementShape::wedge},
                                                                {11, ElementShape::quadratic_tetrahedron}}};
  for (const auto& [known, shape] : shapes)
    if (type.type == known) mesh.cell.push_back({shape, node});
}

const ElementType& type_for(const Words& words, const Mesh& /*mesh*/, std::int64_t type) {
  return known_type(words, known_types, "triangles (2, 9) and quadrilaterals (3, 10, 16) in the plane", type);
}
const ElementType& type_for(const Words& words, const SpaceMesh& /*mesh*/, std::int64_t type) {
  return known_type(words, types_in_space,
                    "hexahedra of eight nodes (5), prisms of six (6) and tetrahedra of four (4) or ten nodes (11)",
                    type);
}

/// The nodes of an element, as indices; then the element is added.
template <class AnyMesh>
void read_element(Words& words, const GmshNodes& nodes, const ElementType& type, AnyMesh& mesh) {
  std::array<int, max_space_nodes> element{};
  for (int k = 0; k < type.nodes; ++k) {
    const std::int64_t tag = words.whole("a node of an element");
    const auto node = nodes.index.find(tag);
    if (node == nodes.index.end()) words.fail(fmt::format("a {} names node {}, which does not exist", type.name, tag));
    element[k] = node->second;
  }
  add_element(words, type, element, nodes, mesh);
}

/// Elements of version 2.2: one list of tag, type, number of further tags (physical group, entity, partitions), these
/// tags, nodes.
template <class AnyMesh>
void read_element_list(Words& words, const GmshNodes& nodes, AnyMesh& mesh) {
  const std::int64_t all = words.count("the number of elements");
  for (std::int64_t i = 0; i < all; ++i) {
    words.whole("an element tag");
    const ElementType& type = type_for(words, mesh, words.whole("an element type"));
    const std::int64_t tags = words.count("the number of tags of an element");
    for (std::int64_t k = 0; k < tags; ++k) words.whole("a tag of an element");
    read_element(words, nodes, type, mesh);
  }
  words.expect("$EndElements");
}

/// Elements of version 4.1, in blocks of one type.
template <class AnyMesh>
void read_elements(Words& words, const GmshNodes& nodes, AnyMesh& mesh) {
  const std::int64_t blocks = words.count("the number of element blocks"), all = words.count("the number of elements");
  words.whole("the smallest element tag"), words.whole("the largest element tag");
  std::int64_t found = 0;
  for (std::int64_t b = 0; b < blocks; ++b) {
    words.whole("a block's dimension"), words.whole("a block's tag");
    const ElementType& type = type_for(words, mesh, words.whole("an element type"));
    const std::int64_t count = words.count("the number of elements of a block");
    found += count;
    for (std::int64_t i = 0; i < count; ++i) {
      words.whole("an element tag");
      read_element(words, nodes, type, mesh);
    }
  }
  if (found != all) words.fail(fmt::format("the header announces {} elements, the file has {}", all, found));
  words.expect("$EndElements");
}

/// Removes nodes without elements, so that points outside the mesh do not count.
void keep_used(Mesh& mesh, const GmshNodes& nodes, std::string_view owner) {
  std::vector<int> number(nodes.place.size(), -1);
  double low = 0, high = 0;
  for (auto& element : mesh.element)
    for (int i = 0; i < corners_of(element); ++i) {
      const int n = element[i];
      if (number[n] < 0) {
        number[n] = static_cast<int>(mesh.node.size());
        const double z = nodes.height[n];
        low = mesh.node.empty() ? z : std::min(low, z), high = mesh.node.empty() ? z : std::max(high, z);
        mesh.node.push_back(nodes.place[n]);
      }
      element[i] = number[n];
    }
  if (mesh.node.empty())
    throw InputError(
        fmt::format("{}: there is no triangle or quadrilateral in it; mesh the surface (Mesh 2) before "
                    "saving",
                    owner));
  if (high - low > 1e-9 * polygon_size(mesh.node))
    throw InputError(fmt::format(
        "{}: its nodes reach from z = {:g} to {:g}; the mesh must lie in one plane of constant z", owner, low, high));
}

/// The nodes and the elements of a file.
template <class AnyMesh>
void read_file(std::string_view text, std::string_view owner, GmshNodes& nodes, AnyMesh& mesh) {
  Words words(text, owner);
  if (words.at_end() || words.word("$MeshFormat") != "$MeshFormat")
    words.fail("it does not begin with $MeshFormat, so it is not a Gmsh mesh");
  const bool in_blocks = read_format(words) == GmshVersion::v4_1;
  bool has_nodes = false, has_elements = false;
  while (!words.at_end()) {
    const std::string_view section = words.word("a section");
    if (section.size() < 2 || section[0] != '$') words.fail("a section should begin here, with '$' and its name");
    if (section == "$Nodes" && !has_nodes) {
      in_blocks ? read_nodes(words, nodes) : read_node_list(words, nodes);
      has_nodes = true;
    } else if (section == "$Elements" && has_nodes && !has_elements) {
      in_blocks ? read_elements(words, nodes, mesh) : read_element_list(words, nodes, mesh);
      has_elements = true;
    } else if (section == "$Nodes" || section == "$Elements") {
      words.fail(fmt::format("{} appears twice or before $Nodes", section));
    } else {
      words.skip_section(section.substr(1));
    }
  }
  if (!has_elements) words.fail("the file ends without $Nodes and $Elements");
}

}  // namespace

Mesh parse_gmsh(std::string_view text, std::string_view owner) {
  GmshNodes nodes;
  Mesh mesh;
  read_file(without_byte_order_mark(text), owner, nodes, mesh);
  keep_used(mesh, nodes, owner);
  return mesh;
}

SpaceMesh parse_gmsh_in_space(std::string_view text, std::string_view owner) {
  GmshNodes nodes;
  SpaceMesh mesh;
  read_file(without_byte_order_mark(text), owner, nodes, mesh);
  if (mesh.cell.empty())
    throw InputError(fmt::format(
        "{}: there is no tetrahedron, hexahedron or prism in it; mesh the volume (Mesh 3) before saving", owner));
  for (std::size_t n = 0; n < nodes.place.size(); ++n)
    mesh.node.emplace_back(nodes.place[n].x(), nodes.place[n].y(), nodes.height[n]);
  return mesh;
}

SpaceMesh read_gmsh_in_space(const std::filesystem::path& path) {
  const std::string owner = fmt::format("mesh '{}'", path.string());
  return parse_gmsh_in_space(text_of_file(path, "mesh", largest_mesh), owner);
}

Mesh read_gmsh(const std::filesystem::path& path) {
  const std::string owner = fmt::format("mesh '{}'", path.string());
  return parse_gmsh(text_of_file(path, "mesh", largest_mesh), owner);
}

}  // namespace trilith
