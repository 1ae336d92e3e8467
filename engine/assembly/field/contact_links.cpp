#include "assembly/field/contact_links.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/space/solid_faces.hpp"
#include "load/water/uplift.hpp"
#include "model/loads.hpp"

namespace trilith {
namespace {

/// Largest gap or overlap of two faces in space that may be closed somewhere, over the size of the smaller solid.
constexpr double linked_reach = 0.01;

/// A point of a face as a weighted sum of cells; the weights add up to 1.
struct PointCells {
  int count = 0;
  std::array<int, most_fit_nodes> cell{};
  std::array<double, most_fit_nodes> weight{};

  void add(int of, double share) {
    cell[static_cast<std::size_t>(count)] = of, weight[static_cast<std::size_t>(count++)] = share;
  }
  /// A node of a body; at a node of a frame both faces of its sections count equally.
  void add_node(const FieldBody& row, int node, double share) {
    if (row.layout != CellLayout::sections) return add(row.cell_of(node), share);
    add(row.cell_of(node, 0), 0.5 * share), add(row.cell_of(node, 1), 0.5 * share);
  }
};

/// Adds the links of a flow k (phi_a - phi_b) between two points.
void link_points(const PointCells& a, const PointCells& b, double k, std::vector<FieldLink>& out) {
  const auto add = [&](int i, int j, double conductance) {
    if (i != j && conductance != 0) out.push_back({std::min(i, j), std::max(i, j), conductance});
  };
  for (int i = 0; i < a.count; ++i) {
    const auto p = static_cast<std::size_t>(i);
    for (int j = 0; j < b.count; ++j) {
      const auto q = static_cast<std::size_t>(j);
      add(a.cell[p], b.cell[q], k * a.weight[p] * b.weight[q]);
    }
  }
  for (const PointCells* side : {&a, &b})
    for (int i = 0; i < side->count; ++i)
      for (int j = 0; j < i; ++j) {
        const auto p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
        add(side->cell[p], side->cell[q], -k * side->weight[p] * side->weight[q]);
      }
}

/// Both bodies of a pair with their cells; `conductance` is 0 where no heat flows.
struct LinkedBodies {
  const FieldBody *a = nullptr, *b = nullptr;
  double conductance = 0;  ///< [W/(m2 K)]

  template <int D>
  LinkedBodies(const Field& field, const Model<D>& model, const NearPair& pair) {
    if (pair.replaced) return;
    const int body_a = model.piece_body[pair.piece_a], body_b = model.piece_body[pair.piece_b];
    a = field.find(body_a), b = field.find(body_b);
    if (a != nullptr && b != nullptr) conductance = field.conductance_between(body_a, body_b);
  }
};

struct LinkedSkins {
  const Work<2>& work;
  [[nodiscard]] Vec2 skin(int i) const { return {work.skin[i].x, work.skin[i].y}; }
};

/// Closed parts of two faces, without overlaps, along their common direction [m].
std::vector<std::array<double, 2>> closed_parts(const JointStretch& stretch, unsigned bonds) {
  std::vector<std::array<double, 2>> parts, out;
  stretch.for_closed(bonds, [&](double from, double to) { parts.push_back({from, to}); });
  std::sort(parts.begin(), parts.end());
  for (const auto& part : parts) {
    if (!out.empty() && part[0] <= out.back()[1])
      out.back()[1] = std::max(out.back()[1], part[1]);
    else
      out.push_back(part);
  }
  return out;
}

/// Two faces in the plane. Two Gauss points for each closed part are exact for linear shape functions on both sides.
void link_faces(const LinkedBodies& bodies, const Model<2>& model, const Work<2>& work, const std::array<int, 2>& on_a,
                const std::array<int, 2>& on_b, unsigned bonds, std::vector<FieldLink>& out) {
  const JointStretch stretch(LinkedSkins{work}, WetFace<2>{bodies.a->body, on_a[0], on_a[1]},
                             WetFace<2>{bodies.b->body, on_b[0], on_b[1]});
  if (!stretch.overlap.sane) return;
  const double depth = std::min(depth_of(model, bodies.a->body), depth_of(model, bodies.b->body));
  const double at = 0.5 / std::sqrt(3.0);
  for (const auto& [from, to] : closed_parts(stretch, bonds))
    for (const double share : {0.5 - at, 0.5 + at}) {
      const double t = from + share * (to - from);
      PointCells a, b;
      const auto add = [&](PointCells& cells, const FieldBody& row, const std::array<int, 2>& skin, double s) {
        cells.add_node(row, model.skin_node[skin[0]], 1 - s), cells.add_node(row, model.skin_node[skin[1]], s);
      };
      add(a, *bodies.a, on_a, stretch.on_a(t)), add(b, *bodies.b, on_b, stretch.on_b(t));
      link_points(a, b, 0.5 * bodies.conductance * depth * (to - from), out);
    }
}

/// Skin points of the outer edges of a piece.
template <class F>
void for_outer_edges(const Model<2>& model, int piece, F&& f) {
  const int first = model.piece_first[piece], end = model.piece_first[piece + 1];
  for (int c = first; c < end; ++c)
    if (model.edge_is_face[c] != 0) f(std::array{model.corner_skin[c], model.corner_skin[c + 1 < end ? c + 1 : first]});
}

/// Cells at a point of a face in space. The nodes of a face of elements have the weights of its fit, a linear field.
PointCells cells_at(const Model<3>& model, const Work<3>& work, const FieldBody& row, int piece, int face,
                    const Vec3& x) {
  PointCells out;
  const int frame = model.carrier_of(piece, face);
  if (frame >= 0) {
    out.add_node(row, frame, 1);
    return out;
  }
  const auto index = static_cast<std::size_t>(-1 - frame);
  const Fit& fit = model.fits[index];
  const Fitted& now = work.solids.fitted[index];
  const Vec3 local = now.axes.transpose() * (x - now.place);
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const n = &model.fit_number[static_cast<std::size_t>(fit.first_number + 4 * i)];
    out.add_node(row, fit.node[static_cast<std::size_t>(i)],
                 n[0] + n[1] * local.x() + n[2] * local.y() + n[3] * local.z());
  }
  return out;
}

bool is_bonded(const Work<3>& work, std::size_t row) {
  const JointMemory* joint = work.contacts.joint_at(row);
  return joint != nullptr && (joint->sound || joint->bonds != 0);
}

/// Over a convex polygon in triangles; the middles of their edges are exact for linear shape functions on both sides.
void link_polygon(const LinkedBodies& bodies, const Model<3>& model, const Work<3>& work, const NearPair& pair,
                  const FaceOverlap3& faces, const WetPolygon& closed, std::vector<FieldLink>& out) {
  for (int i = 2; i < closed.count; ++i) {
    const std::array<Vec3, 3> corner{closed.at(0), closed.at(i - 1), closed.at(i)};
    const double area = 0.5 * cross(Vec3(corner[1] - corner[0]), Vec3(corner[2] - corner[0])).norm();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 x = 0.5 * (corner[k] + corner[(k + 1) % 3]);
      link_points(cells_at(model, work, *bodies.a, pair.piece_a, faces.face_a, x),
                  cells_at(model, work, *bodies.b, pair.piece_b, faces.face_b, x), bodies.conductance * area / 3, out);
    }
  }
}

}  // namespace

std::vector<FieldLink> contact_links(const Field& field, const Model<2>& model, const Work<2>& work) {
  std::vector<FieldLink> out;
  if (field.contacts.empty()) return out;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    const LinkedBodies bodies(field, model, pair);
    if (pair.facing == 0 || !(bodies.conductance > 0)) continue;
    const unsigned bonds = row < work.contacts.memory.size() ? work.contacts.memory[row].bonds & 3U : 0U;
    if (pair.facing == 1) {
      link_faces(bodies, model, work, {pair.a0, pair.a1}, {pair.b0, pair.b1}, bonds, out);
      continue;
    }
    for_outer_edges(model, pair.piece_a, [&](const std::array<int, 2>& on_a) {
      for_outer_edges(model, pair.piece_b,
                      [&](const std::array<int, 2>& on_b) { link_faces(bodies, model, work, on_a, on_b, bonds, out); });
    });
  }
  merge_links(out);
  return out;
}

std::vector<FieldLink> contact_links(const Field& field, const Model<3>& model, const Work<3>& work) {
  std::vector<FieldLink> out;
  if (field.contacts.empty()) return out;
  FaceOverlap3 faces;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    const LinkedBodies bodies(field, model, pair);
    if (!(bodies.conductance > 0)) continue;
    const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
    if (model.piece_solid[pair.piece_a].is_sphere() || model.piece_solid[pair.piece_b].is_sphere()) continue;
    if (!meeting_faces(a, b, linked_reach * std::min(a.solid->size, b.solid->size), 0, faces)) continue;
    const WetPolygon shared = polygon_of(faces);
    const WetPolygon closed = is_bonded(work, row) ? shared : cut(shared.corners(), closed_field(faces));
    link_polygon(bodies, model, work, pair, faces, closed, out);
  }
  merge_links(out);
  return out;
}

}  // namespace trilith
