#include "model/builder/crack_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "element/solid/plane_element.hpp"

namespace trilith {
namespace {

/// A centroid within this share of the size of the mesh is on the plane, and its element behind it.
constexpr double on_plane_share = 1e-9;

Box2 box_of(const Mesh& mesh) {
  return bounding_box(mesh.node);
}

std::vector<std::uint8_t> elements_behind(const Mesh& mesh, const CrackPlane<2>& plane) {
  const Vec2 normal = plane.normal.normalized();
  const Box2 box = box_of(mesh);
  const double slack = on_plane_share * (box.high - box.low).norm();
  std::vector<std::uint8_t> behind;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const Vec2 centre = polygon_moments(corners_of(mesh, e)).centroid;
    behind.push_back(normal.dot(centre - plane.point) <= slack ? 1 : 0);
  }
  return behind;
}

/// Edges of elements behind whose other element is ahead, from one node to the next, by their first node.
std::map<int, int> crossed_edges(const Mesh& mesh, const std::vector<std::uint8_t>& behind) {
  std::map<std::pair<int, int>, int> ahead;
  for (std::size_t e = 0; e < mesh.element.size(); ++e)
    for (int i = 0, count = corners_of(mesh.element[e]); i < count && behind[e] == 0; ++i)
      ahead[{mesh.element[e][i], mesh.element[e][(i + 1) % count]}] = static_cast<int>(e);
  std::map<int, int> next;
  for (std::size_t e = 0; e < mesh.element.size(); ++e)
    for (int i = 0, count = corners_of(mesh.element[e]); i < count && behind[e] != 0; ++i) {
      const int from = mesh.element[e][i], to = mesh.element[e][(i + 1) % count];
      if (ahead.count({to, from}) != 0) next[from] = to;
    }
  return next;
}

/// The edges in the order of the crack. At holes of the mesh one chain ends and another one begins.
void follow_chains(const std::map<int, int>& next, MeshCut& cut) {
  std::vector<int> ends;
  for (const auto& [from, to] : next) ends.push_back(to);
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
std::vector<int> elements_at(const Mesh& mesh, const MeshCut& cut) {
  std::vector<std::uint8_t> on(mesh.node.size(), 0);
  for (const int n : cut.nodes) on[static_cast<std::size_t>(n)] = 1;
  std::vector<int> out;
  for (std::size_t e = 0; e < mesh.element.size(); ++e)
    for (int i = 0; i < corners_of(mesh.element[e]); ++i)
      if (on[static_cast<std::size_t>(mesh.element[e][i])] != 0) {
        out.push_back(static_cast<int>(e));
        break;
      }
  return out;
}

/// True if elements hang together by edges, and no node is a hinge.
bool hangs_together(const Mesh& mesh) {
  try {
    check_mesh(mesh, "");
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

CrackSection<2> mesh_section(const Mesh& mesh, const CrackPlane<2>& plane, int number) {
  const auto cut = std::make_shared<MeshCut>();
  cut->behind = elements_behind(mesh, plane);
  follow_chains(crossed_edges(mesh, cut->behind), *cut);
  cut->elements = elements_at(mesh, *cut);
  CrackSection<2> section;
  section.number = number;
  section.normal = plane.normal.normalized();
  section.from = mesh.node[static_cast<std::size_t>(cut->nodes.front())];
  section.to = mesh.node[static_cast<std::size_t>(cut->nodes.back())];
  section.cut = cut;
  return section;
}

std::string mesh_plane_fault(const Mesh& mesh, const CrackPlane<2>& plane, int number) {
  const std::string where = fmt::format("plane {} through ({:g}, {:g}) with the normal ({:g}, {:g})", number,
                                        plane.point.x(), plane.point.y(), plane.normal.x(), plane.normal.y());
  if (mesh.element.size() < 2)
    return "the mesh has one element, which has no inner edge to crack along: give it divisions, a finer mesh, or body "
           "= \"rigid\"";
  MeshCut cut;
  cut.behind = elements_behind(mesh, plane);
  const auto count = static_cast<std::size_t>(std::count(cut.behind.begin(), cut.behind.end(), 1));
  if (count == 0 || count == cut.behind.size()) {
    const Box2 box = box_of(mesh);
    return fmt::format(
        "{} meets no inner edge of the mesh, all elements are on one side of it; the body is between ({:g}, {:g}) and "
        "({:g}, {:g}). Give a point inside it, in the coordinates of the model, or a finer mesh",
        where, box.low.x(), box.low.y(), box.high.x(), box.high.y());
  }
  for (const bool behind : {true, false})
    if (!hangs_together(part_of_mesh(mesh, cut, behind).mesh))
      return fmt::format(
          "{} does not divide the mesh into two parts along edges of elements: the part {} it falls apart or hangs on "
          "one node. Move or turn the plane, or give a finer mesh",
          where, behind ? "behind" : "ahead of");
  return "";
}

MeshPart part_of_mesh(const Mesh& whole, const MeshCut& cut, bool behind) {
  MeshPart part;
  std::vector<int> number(whole.node.size(), -1);
  for (std::size_t e = 0; e < whole.element.size(); ++e) {
    if ((cut.behind[e] != 0) != behind) continue;
    auto element = whole.element[e];
    for (int i = 0; i < corners_of(whole.element[e]); ++i) {
      int& own = number[static_cast<std::size_t>(element[i])];
      if (own < 0) {
        own = static_cast<int>(part.node.size());
        part.node.push_back(element[i]);
        part.mesh.node.push_back(whole.node[static_cast<std::size_t>(element[i])]);
      }
      element[i] = own;
    }
    part.mesh.element.push_back(element);
  }
  return part;
}

/// Masses are lumped by the integrals of the shape functions, see model/element/element_rows.hpp.
std::vector<double> shares_behind(const Mesh& mesh, const MeshCut& cut) {
  std::vector<double> all(mesh.node.size(), 0), behind = all;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const auto areas = node_areas(corners_of(mesh, e));
    for (int i = 0; i < corners_of(mesh.element[e]); ++i) {
      const auto n = static_cast<std::size_t>(mesh.element[e][i]), at = static_cast<std::size_t>(i);
      all[n] += areas[at];
      if (cut.behind[e] != 0) behind[n] += areas[at];
    }
  }
  for (std::size_t n = 0; n < all.size(); ++n) behind[n] /= all[n];
  return behind;
}

}  // namespace trilith
