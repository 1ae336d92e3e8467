#include "model/builder/crack_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "element/solid/plane_element.hpp"
#include "model/crack_cut.hpp"
#include "model/space_builder/crack_sections_space.hpp"

namespace trilith {
namespace {

/// A centroid within this share of the size of the mesh is on the plane, and its element behind it.
constexpr double on_plane_share = 1e-9;

// Elements, nodes and faces of both kinds of mesh.

template <class M>
auto& cells_of(M& mesh) {
  if constexpr (std::is_same_v<std::remove_const_t<M>, Mesh>)
    return mesh.element;
  else
    return mesh.cell;
}
/// The nodes of an element.
template <class Cell>
auto cell_nodes(Cell& cell) {
  if constexpr (std::is_same_v<std::remove_const_t<Cell>, SpaceCell>)
    return std::span(cell.node).first(static_cast<std::size_t>(info_of(cell.shape).nodes));
  else
    return std::span(cell).first(static_cast<std::size_t>(corners_of(cell)));
}
Vec2 centroid_of_cell(const Mesh& mesh, std::size_t e) {
  return polygon_moments(corners_of(mesh, e)).centroid;
}
Vec3 centroid_of_cell(const SpaceMesh& mesh, std::size_t e) {
  Vec3 sum = Vec3::Zero();
  const int corners = info_of(mesh.cell[e].shape).corners;
  for (int i = 0; i < corners; ++i)
    sum += mesh.node[static_cast<std::size_t>(mesh.cell[e].node[static_cast<std::size_t>(i)])];
  return sum / corners;
}
/// [node of the element] in proportion to their masses; see model/element/element_rows.hpp.
auto masses_of_cell(const Mesh& mesh, std::size_t e) {
  return node_areas(corners_of(mesh, e));
}
auto masses_of_cell(const SpaceMesh& mesh, std::size_t e) {
  ElementVolume of = node_shares(mesh.cell[e].shape, nodes_of(mesh, e));
  for (double& share : of.share) share *= of.volume;
  return of.share;
}
int faces_of_cell(const std::array<int, 4>& cell) {
  return corners_of(cell);
}
int faces_of_cell(const SpaceCell& cell) {
  return info_of(cell.shape).faces;
}
/// The nodes of a face, outward or counter-clockwise.
std::vector<int> face_of_cell(const std::array<int, 4>& cell, int face) {
  return {cell[static_cast<std::size_t>(face)], cell[static_cast<std::size_t>((face + 1) % corners_of(cell))]};
}
std::vector<int> face_of_cell(const SpaceCell& cell, int face) {
  std::vector<int> nodes;
  for (const int i : info_of(cell.shape).nodes_of_face(face)) nodes.push_back(cell.node[static_cast<std::size_t>(i)]);
  return nodes;
}
void check_whole(const Mesh& mesh) {
  check_mesh(mesh, "");
}
void check_whole(const SpaceMesh& mesh) {
  check_space_mesh(mesh, "");
}

/// Opposite corners of the box around a mesh.
template <class V>
std::array<V, 2> corners_of_box(const std::vector<V>& nodes) {
  std::array<V, 2> box{nodes.front(), nodes.front()};
  for (const V& x : nodes) box[0] = box[0].cwiseMin(x), box[1] = box[1].cwiseMax(x);
  return box;
}

template <class M, int D>
std::vector<std::uint8_t> elements_behind(const M& mesh, const CrackPlane<D>& plane) {
  const Vec<D> normal = plane.normal.normalized();
  const auto box = corners_of_box(mesh.node);
  const double slack = on_plane_share * (box[1] - box[0]).norm();
  std::vector<std::uint8_t> behind;
  for (std::size_t e = 0; e < cells_of(mesh).size(); ++e)
    behind.push_back(normal.dot(centroid_of_cell(mesh, e) - plane.point) <= slack ? 1 : 0);
  return behind;
}

/// A face between an element behind and an element ahead: its nodes in the order of the element behind, both elements,
/// and the number of the face in both.
struct CrossedFace {
  std::vector<int> node;
  std::array<int, 2> element, face;
};

/// In the order of the elements behind.
template <class M>
std::vector<CrossedFace> crossed_faces(const M& mesh, const std::vector<std::uint8_t>& behind) {
  const auto& cells = cells_of(mesh);
  const auto each = [&](bool side, auto&& see) {
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (int f = 0; (behind[e] != 0) == side && f < faces_of_cell(cells[e]); ++f) {
        std::vector<int> key = face_of_cell(cells[e], f);
        std::sort(key.begin(), key.end());
        see(static_cast<int>(e), f, key);
      }
  };
  std::map<std::vector<int>, std::array<int, 2>> ahead;
  each(false, [&](int e, int f, const std::vector<int>& key) { ahead[key] = {e, f}; });
  std::vector<CrossedFace> faces;
  each(true, [&](int e, int f, const std::vector<int>& key) {
    if (const auto other = ahead.find(key); other != ahead.end())
      faces.push_back(
          {face_of_cell(cells[static_cast<std::size_t>(e)], f), {e, other->second[0]}, {f, other->second[1]}});
  });
  return faces;
}

/// The edges in the order of the crack. At holes of the mesh one chain ends and another one begins.
void follow_chains(const std::vector<CrossedFace>& faces, MeshCut& cut) {
  std::map<int, int> next;
  std::vector<int> ends;
  for (const CrossedFace& f : faces) next[f.node[0]] = f.node[1], ends.push_back(f.node[1]);
  std::sort(ends.begin(), ends.end());
  for (const auto& [start, unused] : next) {
    if (std::binary_search(ends.begin(), ends.end(), start)) continue;
    cut.nodes.push_back(start);
    for (auto at = next.find(start); at != next.end(); at = next.find(at->second)) {
      cut.faces.push_back({at->first, at->second, -1, -1});
      cut.nodes.push_back(at->second);
    }
  }
}

/// Elements with a node on the cut, in their order.
template <class M>
std::vector<int> elements_at(const M& mesh, const MeshCut& cut) {
  std::vector<std::uint8_t> on(mesh.node.size(), 0);
  for (const int n : cut.nodes) on[static_cast<std::size_t>(n)] = 1;
  std::vector<int> out;
  for (std::size_t e = 0; e < cells_of(mesh).size(); ++e) {
    const auto nodes = cell_nodes(cells_of(mesh)[e]);
    if (std::any_of(nodes.begin(), nodes.end(), [&](int n) { return on[static_cast<std::size_t>(n)] != 0; }))
      out.push_back(static_cast<int>(e));
  }
  return out;
}

/// Areas at the nodes of a cut, summed in the order of the elements.
void set_areas(const Mesh& mesh, PlaneCut& cut) {
  for (const std::size_t side : {0, 1}) {
    std::vector<double> area(mesh.node.size(), 0.0);
    for (const int e : cut.elements) {
      const auto at = static_cast<std::size_t>(e);
      if ((cut.behind[at] != 0) != (side == 0)) continue;
      const auto own = masses_of_cell(mesh, at);
      for (int i = 0; i < corners_of(mesh.element[at]); ++i)
        area[static_cast<std::size_t>(mesh.element[at][static_cast<std::size_t>(i)])] +=
            own[static_cast<std::size_t>(i)];
    }
    for (const int n : cut.nodes) cut.area[side].push_back(area[static_cast<std::size_t>(n)]);
  }
}

/// True if elements hang together by faces, and in the plane no node is a hinge.
template <class M>
bool hangs_together(const M& mesh) {
  try {
    check_whole(mesh);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// A body of one triangle or one tetrahedron has the rotary inertia of the solid, and not of masses at its nodes. One
/// quadrilateral or brick has it by its kind, which a part does not have; see model/element/one_element.hpp.
bool turns_as_solid(const Mesh& mesh) {
  return mesh.element.size() == 1 && corners_of(mesh.element[0]) == 3;
}
bool turns_as_solid(const SpaceMesh& mesh) {
  return mesh.cell.size() == 1 && mesh.cell[0].shape == ElementShape::tetrahedron;
}

template <class V>
std::string vector_text(const V& v) {
  std::string text;
  for (Eigen::Index k = 0; k < v.size(); ++k) text += fmt::format("{}{:g}", k > 0 ? ", " : "", v[k]);
  return "(" + text + ")";
}

template <class M, int D>
std::string plane_fault_of(const M& mesh, const CrackPlane<D>& plane, int number) {
  const std::string where = fmt::format("plane {} through {} with the normal {}", number, vector_text(plane.point),
                                        vector_text(plane.normal));
  if (cells_of(mesh).size() < 2)
    return fmt::format(
        "the mesh has one element, which has no inner {} to crack along: give it divisions (body = {{ mesh = {} }} "
        "cracks into two bodies of one element), a finer mesh, or body = \"rigid\"",
        D == 2 ? "edge" : "face", D == 2 ? "{ 2, 1 }" : "{ 2, 1, 1 }");
  MeshCut cut;
  cut.behind = elements_behind(mesh, plane);
  const auto count = static_cast<std::size_t>(std::count(cut.behind.begin(), cut.behind.end(), 1));
  if (count == 0 || count == cut.behind.size()) {
    const auto box = corners_of_box(mesh.node);
    return fmt::format(
        "{} meets no inner {} of the mesh, all elements are on one side of it; the body is between {} and {}. Give a "
        "point inside it, in the coordinates of the model, or a finer mesh",
        where, D == 2 ? "edge" : "face", vector_text(box[0]), vector_text(box[1]));
  }
  for (const bool behind : {true, false}) {
    const M part = part_of_mesh(mesh, cut, behind).mesh;
    const char* const side = behind ? "behind" : "ahead of";
    if (!hangs_together(part))
      return fmt::format(
          "{} does not divide the mesh into two parts along {}s of elements: the part {} it falls apart or hangs on "
          "one node. Move or turn the plane, or give a finer mesh",
          where, D == 2 ? "edge" : "face", side);
    if (turns_as_solid(part))
      return fmt::format(
          "{} leaves one {} {} it, whose rotary inertia as a body of its own differs from its inertia in the mesh. "
          "Move the plane, or give a finer mesh",
          where, D == 2 ? "triangle" : "tetrahedron", side);
  }
  return "";
}

/// A face as a plate, with its polygon. `at`: place of each node among the nodes of the cut.
CutFace plate_of(const SpaceMesh& mesh, const CrossedFace& face, const std::vector<int>& at, int number) {
  const auto e = static_cast<std::size_t>(face.element[0]);
  const ElementShape shape = mesh.cell[e].shape;
  const std::vector<Vec3> nodes = nodes_of(mesh, e);
  CutFace plate;
  plate.nodes = static_cast<int>(face.node.size());
  for (std::size_t i = 0; i < face.node.size(); ++i) plate.node[i] = at[static_cast<std::size_t>(face.node[i])];
  plate.element = face.element, plate.face = face.face;
  plate.fit = fit_face(shape, nodes, face.face[0]);
  plate.integrals = face_products(shape, nodes, face.face[0]);
  plate.section.number = number, plate.section.normal = plate.fit.normal;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < info_of(shape).corners_of_face(face.face[0]).size(); ++i) {
    const Vec3& x = mesh.node[static_cast<std::size_t>(face.node[i])];
    corners.push_back(x - plate.fit.normal.dot(x - plate.fit.middle) * plate.fit.normal);
  }
  set_section_polygon(corners, plate.section);
  return plate;
}

}  // namespace

CrackSection<2> mesh_section(const Mesh& mesh, const CrackPlane<2>& plane, int number) {
  const auto cut = std::make_shared<PlaneCut>();
  cut->behind = elements_behind(mesh, plane);
  follow_chains(crossed_faces(mesh, cut->behind), *cut);
  cut->elements = elements_at(mesh, *cut);
  set_areas(mesh, *cut);
  CrackSection<2> section;
  section.number = number;
  section.normal = plane.normal.normalized();
  section.from = mesh.node[static_cast<std::size_t>(cut->nodes.front())];
  section.to = mesh.node[static_cast<std::size_t>(cut->nodes.back())];
  section.cut = cut;
  return section;
}

/// The centre of the section is the centroid of its faces.
CrackSection<3> mesh_section(const SpaceMesh& mesh, const CrackPlane<3>& plane, int number) {
  const auto cut = std::make_shared<SpaceCut>();
  cut->behind = elements_behind(mesh, plane);
  const std::vector<CrossedFace> faces = crossed_faces(mesh, cut->behind);
  for (const CrossedFace& face : faces) cut->nodes.insert(cut->nodes.end(), face.node.begin(), face.node.end());
  std::sort(cut->nodes.begin(), cut->nodes.end());
  cut->nodes.erase(std::unique(cut->nodes.begin(), cut->nodes.end()), cut->nodes.end());
  std::vector<int> at(mesh.node.size(), -1);
  for (std::size_t i = 0; i < cut->nodes.size(); ++i) at[static_cast<std::size_t>(cut->nodes[i])] = static_cast<int>(i);
  CrackSection<3> section;
  section.number = number;
  section.normal = plane.normal.normalized();
  for (const CrossedFace& face : faces) {
    auto& corners = cut->faces.emplace_back();
    corners.fill(-1);
    const std::size_t count = face.node.size() == 4 ? 4 : 3;
    std::copy_n(face.node.begin(), count, corners.begin());
    cut->plates.push_back(plate_of(mesh, face, at, number));
    const CrackSection<3>& own = cut->plates.back().section;
    section.centre += own.area * own.centre, section.area += own.area;
  }
  section.centre /= section.area;
  cut->elements = elements_at(mesh, *cut);
  const std::vector<double> share = shares_behind(mesh, *cut);
  for (const int n : cut->nodes) cut->behind_share.push_back(share[static_cast<std::size_t>(n)]);
  section.cut = cut;
  return section;
}

std::string mesh_plane_fault(const Mesh& mesh, const CrackPlane<2>& plane, int number) {
  return plane_fault_of(mesh, plane, number);
}
std::string mesh_plane_fault(const SpaceMesh& mesh, const CrackPlane<3>& plane, int number) {
  return plane_fault_of(mesh, plane, number);
}

template <class M>
MeshPart<M> part_of_mesh(const M& whole, const MeshCut& cut, bool behind) {
  MeshPart<M> part;
  std::vector<int> number(whole.node.size(), -1);
  for (std::size_t e = 0; e < cells_of(whole).size(); ++e) {
    if ((cut.behind[e] != 0) != behind) continue;
    auto cell = cells_of(whole)[e];
    for (int& node : cell_nodes(cell)) {
      int& own = number[static_cast<std::size_t>(node)];
      if (own < 0) {
        own = static_cast<int>(part.node.size());
        part.node.push_back(node);
        part.mesh.node.push_back(whole.node[static_cast<std::size_t>(node)]);
      }
      node = own;
    }
    cells_of(part.mesh).push_back(cell);
  }
  return part;
}

template <class M>
std::vector<double> shares_behind(const M& mesh, const MeshCut& cut) {
  std::vector<double> all(mesh.node.size(), 0), behind = all;
  for (std::size_t e = 0; e < cells_of(mesh).size(); ++e) {
    const auto masses = masses_of_cell(mesh, e);
    const auto nodes = cell_nodes(cells_of(mesh)[e]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto n = static_cast<std::size_t>(nodes[i]);
      all[n] += masses[i];
      if (cut.behind[e] != 0) behind[n] += masses[i];
    }
  }
  for (std::size_t n = 0; n < all.size(); ++n) behind[n] /= all[n];
  return behind;
}

template MeshPart<Mesh> part_of_mesh(const Mesh&, const MeshCut&, bool);
template MeshPart<SpaceMesh> part_of_mesh(const SpaceMesh&, const MeshCut&, bool);
template std::vector<double> shares_behind(const Mesh&, const MeshCut&);
template std::vector<double> shares_behind(const SpaceMesh&, const MeshCut&);

}  // namespace trilith
