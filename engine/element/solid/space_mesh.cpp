#include "element/solid/space_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/error.hpp"

namespace trilith {
namespace {

/// An element counts as inverted below this share of its Jacobian at the centre.
constexpr double least_share = 1e-3;

int count_of(const SpaceCell& cell) {
  return info_of(cell.shape).nodes;
}

void check_cells(const SpaceMesh& mesh, std::string_view owner) {
  if (mesh.cell.empty()) throw InputError(fmt::format("{}: the mesh has no element; give at least one", owner));
  for (std::size_t n = 0; n < mesh.node.size(); ++n)
    if (!mesh.node[n].allFinite() || mesh.node[n].cwiseAbs().maxCoeff() > 1e12)
      throw InputError(
          fmt::format("{}: node {} of the mesh ({:g}, {:g}, {:g}) is not finite or farther out than 1e12 m", owner,
                      n + 1, mesh.node[n].x(), mesh.node[n].y(), mesh.node[n].z()));
  const int nodes = static_cast<int>(mesh.node.size());
  for (std::size_t e = 0; e < mesh.cell.size(); ++e)
    for (int i = 0; i < count_of(mesh.cell[e]); ++i) {
      const auto& node = mesh.cell[e].node;
      const int n = node[static_cast<std::size_t>(i)];
      if (n < 0 || n >= nodes)
        throw InputError(fmt::format("{}: element {} of the mesh names node {}, there are nodes 1 to {}", owner, e + 1,
                                     n + 1, nodes));
      if (std::find(node.begin(), node.begin() + i, n) != node.begin() + i)
        throw InputError(fmt::format("{}: element {} of the mesh names node {} twice", owner, e + 1, n + 1));
    }
}

/// Mirrors an element: exchanges top and bottom of a brick or a wedge, or nodes 1 and 2 of a tetrahedron.
void turn_round(SpaceCell& cell) {
  auto& n = cell.node;
  if (cell.shape == ElementShape::brick || cell.shape == ElementShape::wedge) {
    const auto above = static_cast<std::size_t>(count_of(cell) / 2);
    for (std::size_t i = 0; i < above; ++i) std::swap(n[i], n[i + above]);
    return;
  }
  std::swap(n[1], n[2]);
  if (cell.shape == ElementShape::quadratic_tetrahedron) std::swap(n[4], n[6]), std::swap(n[8], n[9]);
}

void check_shapes(SpaceMesh& mesh, std::string_view owner, std::vector<std::string>& notes) {
  int turned = 0;
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    SpaceCell& cell = mesh.cell[e];
    if (node_shares(cell.shape, nodes_of(mesh, e)).volume < 0) turn_round(cell), ++turned;
    const std::vector<Vec3> nodes = nodes_of(mesh, e);
    const double size = solid_size(nodes), volume = node_shares(cell.shape, nodes).volume;
    if (!(volume > 1e-9 * size * size * size))
      throw InputError(fmt::format("{}: element {} of the mesh ({}) is flat: its volume is {:g} m3", owner, e + 1,
                                   info_of(cell.shape).name, volume));
    if (const double least = least_jacobian(cell.shape, nodes); least < least_share)
      throw InputError(
          fmt::format("{}: element {} of the mesh ({}) is inside out at a corner (its Jacobian there is {:.2g} of the "
                      "value in the middle); check the order of its nodes",
                      owner, e + 1, info_of(cell.shape).name, least));
  }
  if (turned > 0) notes.push_back(fmt::format("{}: {} mirrored elements of the mesh were reversed", owner, turned));
}

void check_places(const SpaceMesh& mesh, std::string_view owner) {
  const double near = 1e-9 * solid_size(mesh.node);
  std::vector<std::size_t> order(mesh.node.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(mesh.node[a].x(), a) < std::pair(mesh.node[b].x(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && mesh.node[order[j]].x() - mesh.node[order[i]].x() <= near; ++j)
      if ((mesh.node[order[j]] - mesh.node[order[i]]).norm() <= near)
        throw InputError(
            fmt::format("{}: nodes {} and {} of the mesh are at the same place, so the mesh is open there; merge them",
                        owner, std::min(order[i], order[j]) + 1, std::max(order[i], order[j]) + 1));
}

struct CellFace {
  std::size_t cell;
  int face;
};

/// Nodes of the mesh at the indices `places` of an element.
std::vector<int> nodes_at(const SpaceCell& cell, std::span<const int> places) {
  std::vector<int> out;
  for (const int i : places) out.push_back(cell.node[static_cast<std::size_t>(i)]);
  return out;
}
std::vector<int> corners_on(const SpaceCell& cell, int face) {
  return nodes_at(cell, info_of(cell.shape).corners_of_face(face));
}

/// Whether two loops of the same corners have the same orientation.
bool run_alike(const std::vector<int>& a, const std::vector<int>& b) {
  const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[static_cast<std::size_t>(at + 1) % b.size()] == a[1];
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i)
    i = parent[static_cast<std::size_t>(i)] = parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
  return i;
}

/// Each face is keyed by its sorted corners. It belongs to two elements, or to one and is then skin. All elements must
/// be connected by faces (union-find).
void find_surface(CheckedSpaceMesh& out, std::string_view owner) {
  const SpaceMesh& mesh = out.mesh;
  out.surface.assign(mesh.cell.size(), {});
  std::map<std::vector<int>, std::vector<CellFace>> faces;
  for (std::size_t e = 0; e < mesh.cell.size(); ++e)
    for (int f = 0; f < info_of(mesh.cell[e].shape).faces; ++f) {
      std::vector<int> key = corners_on(mesh.cell[e], f);
      std::sort(key.begin(), key.end());
      faces[key].push_back({e, f});
    }
  std::vector<int> parent(mesh.cell.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [key, who] : faces) {
    if (who.size() == 1) {
      out.surface[who[0].cell][static_cast<std::size_t>(who[0].face)] = 1;
      continue;
    }
    const SpaceCell &a = mesh.cell[who[0].cell], &b = mesh.cell[who[1].cell];
    const std::string pair = fmt::format("{}: elements {} and {} of the mesh", owner, who[0].cell + 1, who[1].cell + 1);
    if (who.size() > 2)
      throw InputError(fmt::format("{}, and {} more, have a face in common; a face belongs to at most two elements",
                                   pair, who.size() - 2));
    if (run_alike(corners_on(a, who[0].face), corners_on(b, who[1].face)))
      throw InputError(pair + " lie on the same side of the face they have in common");
    std::vector<int> of_a = nodes_at(a, info_of(a.shape).nodes_of_face(who[0].face)),
                     of_b = nodes_at(b, info_of(b.shape).nodes_of_face(who[1].face));
    std::sort(of_a.begin(), of_a.end()), std::sort(of_b.begin(), of_b.end());
    if (of_a != of_b)
      throw InputError(pair + " have other nodes on the face they have in common; mesh all with elements of one order");
    parent[static_cast<std::size_t>(root_of(parent, static_cast<int>(who[0].cell)))] =
        root_of(parent, static_cast<int>(who[1].cell));
  }
  for (int e = 1; e < static_cast<int>(mesh.cell.size()); ++e)
    if (root_of(parent, e) != root_of(parent, 0))
      throw InputError(fmt::format("{}: element {} of the mesh shares no face with the others; make each part a body",
                                   owner, e + 1));
}

/// Removes nodes without elements.
void keep_used(SpaceMesh& mesh, std::string_view owner, std::vector<std::string>& notes) {
  std::vector<int> number(mesh.node.size(), -1);
  for (const SpaceCell& cell : mesh.cell)
    for (int i = 0; i < count_of(cell); ++i)
      number[static_cast<std::size_t>(cell.node[static_cast<std::size_t>(i)])] = 0;
  std::vector<Vec3> kept;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] == 0) number[n] = static_cast<int>(kept.size()), kept.push_back(mesh.node[n]);
  if (kept.size() < mesh.node.size())
    notes.push_back(fmt::format("{}: {} nodes of the mesh are in no element", owner, mesh.node.size() - kept.size()));
  mesh.node = std::move(kept);
  for (SpaceCell& cell : mesh.cell)
    for (int i = 0; i < count_of(cell); ++i) {
      int& n = cell.node[static_cast<std::size_t>(i)];
      n = number[static_cast<std::size_t>(n)];
    }
}

}  // namespace

std::vector<Vec3> nodes_of(const SpaceMesh& mesh, std::size_t cell) {
  std::vector<Vec3> out;
  for (int i = 0; i < count_of(mesh.cell[cell]); ++i)
    out.push_back(mesh.node[static_cast<std::size_t>(mesh.cell[cell].node[static_cast<std::size_t>(i)])]);
  return out;
}

/// Cheap checks run first.
CheckedSpaceMesh check_space_mesh(SpaceMesh mesh, std::string_view owner) {
  CheckedSpaceMesh out;
  check_cells(mesh, owner);
  keep_used(mesh, owner, out.notes);
  check_places(mesh, owner);
  check_shapes(mesh, owner, out.notes);
  out.mesh = std::move(mesh);
  find_surface(out, owner);
  return out;
}

namespace {

/// Whether the faces of a solid match a brick whose nodes are the solid's corners in their order.
bool is_in_order(const FaceLoops& faces) {
  const ElementShapeInfo& brick = info_of(ElementShape::brick);
  for (int f = 0; f < faces.count(); ++f) {
    std::vector<int> loop(faces[f].begin(), faces[f].end());
    std::sort(loop.begin(), loop.end());
    const bool known = std::any_of(brick.face.begin(), brick.face.end(), [&](const auto& face) {
      std::vector<int> own(face.begin(), face.begin() + 4);
      std::sort(own.begin(), own.end());
      return own == loop;
    });
    if (!known) return false;
  }
  return true;
}

/// The corner at the other end of an edge from `corner` that is not on the loop.
int beyond(const FaceLoops& faces, int corner, std::span<const int> loop) {
  for (const SolidEdge& e : solid_edges(faces)) {
    if (e.from != corner && e.to != corner) continue;
    const int other = e.from == corner ? e.to : e.from;
    if (std::find(loop.begin(), loop.end(), other) == loop.end()) return other;
  }
  return -1;
}

}  // namespace

std::array<Vec3, 8> brick_corners(const Polyhedron& solid, std::string_view owner) {
  bool brick = solid.corners.size() == 8 && solid.faces.count() == 6;
  for (int f = 0; f < solid.faces.count(); ++f) brick = brick && solid.faces[f].size() == 4;
  if (!brick)
    throw InputError(fmt::format(
        "{}: it has {} corners and {} faces, but a brick element has 8 and 6; leave it rigid, or give it a mesh", owner,
        solid.corners.size(), solid.faces.count()));
  std::array<int, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
  if (!is_in_order(solid.faces)) {
    const std::span<const int> loop = solid.faces[0];
    order = {loop[0], loop[3], loop[2], loop[1], 0, 0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) order[4 + i] = beyond(solid.faces, order[i], loop);
  }
  std::array<Vec3, 8> out;
  for (std::size_t i = 0; i < 8; ++i) out[i] = solid.corners[static_cast<std::size_t>(order[i])];
  if (node_shares(ElementShape::brick, out).volume < 0)
    for (std::size_t i = 0; i < 4; ++i) std::swap(out[i], out[i + 4]);
  return out;
}

SpaceMesh brick_grid(const std::array<Vec3, 8>& c, const std::array<int, 3>& divisions) {
  const auto [nx, ny, nz] = divisions;
  SpaceMesh mesh;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const double x = static_cast<double>(i) / nx, y = static_cast<double>(j) / ny, z = static_cast<double>(k) / nz;
        const auto level = [&](std::size_t first) {
          return Vec3((1 - y) * ((1 - x) * c[first] + x * c[first + 1]) +
                      y * ((1 - x) * c[first + 3] + x * c[first + 2]));
        };
        mesh.node.emplace_back((1 - z) * level(0) + z * level(4));
      }
  const int up = (nx + 1) * (ny + 1);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int at = k * up + j * (nx + 1) + i;
        SpaceCell cell;
        const std::array<int, 4> base{at, at + 1, at + nx + 2, at + nx + 1};
        for (std::size_t s = 0; s < 4; ++s) cell.node[s] = base[s], cell.node[4 + s] = base[s] + up;
        mesh.cell.push_back(cell);
      }
  return mesh;
}

/// Along the diagonal from node 0 to 6, one tetrahedron for each order of the three sides (Kuhn 1960).
SpaceMesh tetrahedra_of(const SpaceMesh& bricks) {
  constexpr std::array<std::array<std::size_t, 4>, 6> parts{
      {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
  SpaceMesh out;
  out.node = bricks.node;
  for (const SpaceCell& brick : bricks.cell)
    for (const auto& part : parts) {
      SpaceCell cell;
      cell.shape = ElementShape::tetrahedron;
      for (std::size_t i = 0; i < 4; ++i) cell.node[i] = brick.node[part[i]];
      out.cell.push_back(cell);
    }
  return out;
}

SpaceMesh wedges_of(const SpaceMesh& bricks) {
  constexpr std::array<std::array<std::size_t, 6>, 2> parts{{{0, 1, 2, 4, 5, 6}, {0, 2, 3, 4, 6, 7}}};
  SpaceMesh out;
  out.node = bricks.node;
  for (const SpaceCell& brick : bricks.cell)
    for (const auto& part : parts) {
      SpaceCell& cell = out.cell.emplace_back();
      cell.shape = ElementShape::wedge;
      for (std::size_t i = 0; i < part.size(); ++i) cell.node[i] = brick.node[part[i]];
    }
  return out;
}

SpaceMesh extruded(const Mesh& flat, const Vec3& right, const Vec3& up, const Vec3& low, const Vec3& high) {
  SpaceMesh out;
  const auto nodes = static_cast<int>(flat.node.size());
  for (const Vec3& level : {low, high})
    for (const Vec2& p : flat.node) out.node.emplace_back(level + p.x() * right + p.y() * up);
  for (const std::array<int, 4>& element : flat.element) {
    SpaceCell& cell = out.cell.emplace_back();
    const auto corners = static_cast<std::size_t>(corners_of(element));
    cell.shape = corners == 3 ? ElementShape::wedge : ElementShape::brick;
    for (std::size_t i = 0; i < corners; ++i) cell.node[i] = element[i], cell.node[i + corners] = element[i] + nodes;
  }
  return out;
}

SpaceMesh quadratic_of(const SpaceMesh& tetrahedra) {
  constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
  SpaceMesh out;
  out.node = tetrahedra.node;
  std::map<std::pair<int, int>, int> middle;
  for (const SpaceCell& from : tetrahedra.cell) {
    SpaceCell cell = from;
    cell.shape = ElementShape::quadratic_tetrahedron;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = std::minmax(from.node[edges[e][0]], from.node[edges[e][1]]);
      const auto [at, fresh] = middle.try_emplace({a, b}, static_cast<int>(out.node.size()));
      if (fresh)
        out.node.emplace_back(0.5 * (out.node[static_cast<std::size_t>(a)] + out.node[static_cast<std::size_t>(b)]));
      cell.node[4 + e] = at->second;
    }
    out.cell.push_back(cell);
  }
  return out;
}

SpaceMesh divided_into(ElementShape shape, const SpaceMesh& bricks) {
  switch (shape) {
    case ElementShape::brick:
      return bricks;
    case ElementShape::wedge:
      return wedges_of(bricks);
    case ElementShape::tetrahedron:
      return tetrahedra_of(bricks);
    case ElementShape::quadratic_tetrahedron:
      break;
  }
  return quadratic_of(tetrahedra_of(bricks));
}

}  // namespace trilith
