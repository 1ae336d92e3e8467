#include "geometry/plane/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "geometry/space/unmerged_nodes.hpp"

namespace trilith {
namespace {

/// Sine of 2 degrees: smallest turn at a corner of an element.
constexpr double least_turn = 0.035;

struct MeshEdge {
  int element, side;
};
/// Keyed by the two nodes, in the direction in which the element runs.
using EdgeMap = std::map<std::pair<int, int>, MeshEdge>;

/// Coordinates must be finite, and elements must have distinct nodes with valid indices.
void check_indices(const Mesh& mesh, std::string_view owner) {
  if (mesh.element.empty()) throw InputError(fmt::format("{}: the mesh has no element; give at least one", owner));
  for (std::size_t n = 0; n < mesh.node.size(); ++n)
    if (!mesh.node[n].allFinite() || mesh.node[n].cwiseAbs().maxCoeff() > 1e12)
      throw InputError(fmt::format("{}: node {} of the mesh ({:g}, {:g}) is not finite or farther out than 1e12 m",
                                   owner, n + 1, mesh.node[n].x(), mesh.node[n].y()));
  const int nodes = static_cast<int>(mesh.node.size());
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const auto& element = mesh.element[e];
    for (int i = 0; i < corners_of(element); ++i) {
      if (element[i] < 0 || element[i] >= nodes)
        throw InputError(fmt::format("{}: element {} of the mesh names node {}, there are nodes 1 to {}", owner, e + 1,
                                     element[i] + 1, nodes));
      for (int j = 0; j < i; ++j)
        if (element[i] == element[j])
          throw InputError(fmt::format("{}: element {} of the mesh names node {} twice", owner, e + 1, element[i] + 1));
    }
  }
}

/// Elements may be given in either orientation and are stored counter-clockwise; the number of reversed ones is noted.
void turn_counter_clockwise(Mesh& mesh, std::string_view owner, std::vector<std::string>& notes) {
  int reversed = 0;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    auto& element = mesh.element[e];
    if (signed_area(corners_of(mesh, e)) >= 0) continue;
    std::reverse(element.begin() + 1, element.begin() + corners_of(element));
    ++reversed;
  }
  if (reversed > 0)
    notes.push_back(fmt::format("{}: {} clockwise elements of the mesh were reversed", owner, reversed));
}

/// At a corner of 180 degrees or more the Jacobian of the mapping from the square is 0 or negative.
void check_shapes(const Mesh& mesh, std::string_view owner) {
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const std::vector<Vec2> c = corners_of(mesh, e);
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (turn_sine(c[(i + c.size() - 1) % c.size()], c[i], c[(i + 1) % c.size()]) > least_turn) continue;
      throw InputError(fmt::format(
          "{}: element {} of the mesh is bent inwards or nearly straight at ({:g}, {:g}); every corner must be below "
          "178 degrees",
          owner, e + 1, c[i].x(), c[i].y()));
    }
  }
}

/// Edges keyed by their two nodes in the direction of the counter-clockwise element. A neighbour runs along the edge
/// the other way, so an edge without its reverse is boundary. The same directed edge twice means two elements on one
/// side.
EdgeMap edges_of(const Mesh& mesh, std::string_view owner) {
  EdgeMap edges;
  for (int e = 0; e < static_cast<int>(mesh.element.size()); ++e)
    for (int i = 0, count = corners_of(mesh.element[e]); i < count; ++i) {
      const int from = mesh.element[e][i], to = mesh.element[e][(i + 1) % count];
      const auto [other, fresh] = edges.try_emplace({from, to}, MeshEdge{e, i});
      if (!fresh)
        throw InputError(
            fmt::format("{}: elements {} and {} of the mesh lie on the same side of the edge of nodes {} and {}", owner,
                        other->second.element + 1, e + 1, from + 1, to + 1));
    }
  return edges;
}

/// Representative of the set, with path halving.
int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Elements with a common edge are in one set (union-find); in the end there must be one set.
void check_hangs_together(const Mesh& mesh, const EdgeMap& edges, std::string_view owner) {
  std::vector<int> parent(mesh.element.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [nodes, edge] : edges)
    if (const auto across = edges.find({nodes.second, nodes.first}); across != edges.end())
      parent[root_of(parent, edge.element)] = root_of(parent, across->second.element);
  for (int e = 1; e < static_cast<int>(mesh.element.size()); ++e)
    if (root_of(parent, e) != root_of(parent, 0))
      throw InputError(fmt::format("{}: element {} of the mesh shares no edge with the others; {}", owner, e + 1,
                                   unmerged_nodes(mesh.node)));
}

/// Loops of boundary nodes, the loop of the largest area (the outer one) first. A node where two loops meet separates
/// them. The outer loop runs counter-clockwise and loops of holes clockwise, so only the outer one has a positive area.
std::vector<std::vector<int>> boundary_loops(const Mesh& mesh, const EdgeMap& edges, std::string_view owner) {
  std::map<int, int> next;
  for (const auto& [nodes, edge] : edges) {
    if (edges.count({nodes.second, nodes.first}) != 0) continue;
    if (!next.emplace(nodes.first, nodes.second).second)
      throw InputError(
          fmt::format("{}: the mesh pinches to one node at node {} ({:g}, {:g}); let its parts share an edge there",
                      owner, nodes.first + 1, mesh.node[nodes.first].x(), mesh.node[nodes.first].y()));
  }
  std::vector<std::vector<int>> loops;
  // One loop after the other: from its lowest node along `next` until it closes.
  while (!next.empty()) {
    std::vector<int>& loop = loops.emplace_back();
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(at->first);
      const int to = at->second;
      next.erase(at);
      if (to == loop.front()) break;
      loop.push_back(to);
    }
  }
  const auto area = [&](const std::vector<int>& loop) {
    Polygon points;
    for (const int n : loop) points.push_back(mesh.node[n]);
    return signed_area(points);
  };
  std::stable_sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) { return area(a) > area(b); });
  return loops;
}

/// New node numbers: boundary nodes loop by loop, then the others in their order; -1 for unused ones. The first nodes
/// of a body are its skin points, so the boundary is numbered first.
std::vector<int> new_numbers(const Mesh& mesh, const std::vector<std::vector<int>>& loops) {
  std::vector<int> number(mesh.node.size(), -1);
  int count = 0;
  for (const auto& loop : loops)
    for (const int n : loop) number[n] = count++;
  std::vector<std::uint8_t> used(mesh.node.size(), 0);
  for (const auto& element : mesh.element)
    for (int i = 0; i < corners_of(element); ++i) used[element[i]] = 1;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (used[n] != 0 && number[n] < 0) number[n] = count++;
  return number;
}

}  // namespace

/// Cheap checks run first. The renumbered mesh begins with the boundary, which is the body's skin, and has no unused
/// node.
CheckedMesh check_mesh(Mesh mesh, std::string_view owner) {
  CheckedMesh out;
  check_indices(mesh, owner);
  turn_counter_clockwise(mesh, owner, out.notes);
  check_shapes(mesh, owner);
  const EdgeMap edges = edges_of(mesh, owner);
  check_hangs_together(mesh, edges, owner);
  const auto loops = boundary_loops(mesh, edges, owner);
  out.outline = static_cast<int>(loops[0].size());
  const std::vector<int> number = new_numbers(mesh, loops);
  const auto unused = std::count(number.begin(), number.end(), -1);
  if (unused > 0) out.notes.push_back(fmt::format("{}: {} nodes of the mesh are in no element", owner, unused));
  // An edge whose reverse no element has.
  out.boundary_edges.assign(mesh.element.size(), 0U);
  for (const auto& [nodes, edge] : edges)
    if (edges.count({nodes.second, nodes.first}) == 0)
      out.boundary_edges[edge.element] |= 1U << static_cast<unsigned>(edge.side);
  out.mesh.node.resize(mesh.node.size() - static_cast<std::size_t>(unused));
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] >= 0) out.mesh.node[number[n]] = mesh.node[n];
  out.mesh.element = mesh.element;
  for (auto& element : out.mesh.element)
    for (int i = 0; i < corners_of(element); ++i) element[i] = number[element[i]];
  return out;
}

/// Bilinear between the four corners:  3 --- 2
///                                     0 --- 1   x to the right, y up, nodes row by row from 0.
Mesh grid_mesh(const std::array<Vec2, 4>& corners, int nx, int ny) {
  Mesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = static_cast<double>(i) / nx, y = static_cast<double>(j) / ny;
      mesh.node.emplace_back((1 - y) * ((1 - x) * corners[0] + x * corners[1]) +
                             y * ((1 - x) * corners[3] + x * corners[2]));
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int at = j * (nx + 1) + i;
      mesh.element.push_back({at, at + 1, at + nx + 2, at + nx + 1});
    }
  return mesh;
}

std::vector<Vec2> corners_of(const Mesh& mesh, std::size_t e) {
  std::vector<Vec2> corners;
  for (int i = 0; i < corners_of(mesh.element[e]); ++i) corners.push_back(mesh.node[mesh.element[e][i]]);
  return corners;
}

}  // namespace trilith
