#include "draw/results/results_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "draw/results/trimmed_ground.hpp"
#include "draw/scene/paint_order.hpp"
#include "draw/scene/scene_spheres.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {

using results::BodyRow;
using results::Frame;
using results::Header;
using results::Placement;

namespace {

/// Rounding error of lengths, as a share of them.
constexpr double rounding = 1e-9;
/// Largest height of a convex solid above one of its faces, as a share of its size.
constexpr double flat_share = 1e-6;

/// Newell's normal (Sutherland, Sproull and Schumacker, 1974): valid for any plane polygon.
Vec3 normal_of(const std::vector<Vec3>& loop) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += cross(Vec3(loop[i] - loop[0]), Vec3(loop[i + 1] - loop[0]));
  return sum.normalized();
}

using NodeValues = std::vector<std::optional<double>>;

/// Mean value at the nodes of the corners of a face; none without values.
std::optional<double> value_of_face(const Header& header, int face, const NodeValues& node_value) {
  if (node_value.empty()) return std::nullopt;
  const std::int32_t first = header.face_first[face], end = header.face_first[face + 1];
  double sum = 0;
  for (std::int32_t i = first; i < end; ++i) {
    const auto& value = node_value[static_cast<std::size_t>(header.vertex_node[header.face_vertex[i]])];
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / (end - first);
}

SolidPiece piece_of(const Header& header, const Placement& at, int index, const NodeValues& node_value) {
  const BodyRow& body = header.bodies[static_cast<std::size_t>(index)];
  SolidPiece out{index, {}};
  for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
    PieceFace face;
    for (std::int32_t i = header.face_first[f]; i < header.face_first[f + 1]; ++i)
      face.corners.push_back(at.vertex(header.face_vertex[i]));
    face.is_edge.assign(face.corners.size(), true);
    face.normal = normal_of(face.corners);
    face.value = value_of_face(header, f, node_value);
    if (face.normal.allFinite()) out.faces.push_back(std::move(face));
  }
  return out;
}

/// True if the skin of a body is attached to its nodes, as in a meshed body: one closed surface that does not intersect
/// itself.
bool has_stretched_skin(const Header& header, const BodyRow& body) {
  const auto first = header.vertices.begin() + 3 * static_cast<std::ptrdiff_t>(body.first_vertex);
  return body.node_count > 1 && std::all_of(first, first + 3 * static_cast<std::ptrdiff_t>(body.vertex_count),
                                            [](double arm) { return arm == 0; });
}

/// Skins of meshed bodies as a whole, of any shape, and all other bodies as convex pieces.
std::vector<SolidPiece> all_pieces(const Header& header, const Placement& at, const std::vector<bool>& left_out,
                                   const NodeValues& node_value) {
  std::vector<SolidPiece> out;
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    SolidPiece solid = piece_of(header, at, static_cast<int>(i), node_value);
    if (solid.faces.empty() || left_out[i]) continue;
    if (has_stretched_skin(header, header.bodies[i])) {
      out.push_back(std::move(solid));
      continue;
    }
    const double slack = flat_share * piece_size(solid);
    for (SolidPiece& piece : convex_pieces(std::move(solid), slack)) out.push_back(std::move(piece));
  }
  return out;
}

/// For a strained skin each visible face is a piece: nothing is divided, so that edges remain whole.
std::vector<SolidPiece> with_seen_faces(std::vector<SolidPiece> pieces, const ViewAxes& view) {
  std::vector<SolidPiece> out;
  for (SolidPiece& piece : pieces) {
    if (is_convex(piece, flat_share * piece_size(piece))) {
      out.push_back(std::move(piece));
      continue;
    }
    for (PieceFace& face : piece.faces)
      if (face.kind != FaceKind::border && face.normal.dot(view.toward) > rounding)
        out.push_back({piece.body, {std::move(face)}});
  }
  return out;
}

/// Removes the part on the eye's side of the plane.
void cut_away(std::vector<SolidPiece>& pieces, CutPlane plane, const ViewAxes& view) {
  if (plane.normal.dot(view.toward) < -rounding) plane = {-plane.normal, -plane.offset};
  std::vector<SolidPiece> kept;
  for (const SolidPiece& piece : pieces)
    if (auto below = divided(piece, plane, rounding * piece_size(piece), FaceKind::section).first)
      kept.push_back(std::move(*below));
  pieces = std::move(kept);
}

/// Light from the upper left, behind the eye; half of it is ambient.
double light_on(const Vec3& normal, const ViewAxes& view) {
  const Vec3 from = (-0.5 * view.right + 0.8 * view.up + 0.6 * view.toward).normalized();
  return 0.5 + 0.5 * normal.dot(from);
}

/// The cracks of each body.
std::vector<std::vector<const SolidCrack*>> by_body(const std::vector<SolidCrack>& cracks, std::size_t bodies) {
  std::vector<std::vector<const SolidCrack*>> out(bodies);
  for (const SolidCrack& crack : cracks) out[static_cast<std::size_t>(crack.body)].push_back(&crack);
  return out;
}

/// `cracks`: of the piece's body. Cracks between bodies with a small gap are drawn on their faces.
void add_faces(const SolidPiece& piece, const std::vector<const SolidCrack*>& cracks, const ViewAxes& view,
               Scene& scene) {
  const double slack = 2e-3 * piece_size(piece);
  for (const PieceFace& face : piece.faces) {
    if (face.kind == FaceKind::border || face.normal.dot(view.toward) <= rounding) continue;
    SceneFace seen;
    for (const Vec3& p : face.corners) seen.outline.push_back(view.flat(p));
    seen.is_edge = face.is_edge;
    seen.light = light_on(face.normal, view);
    seen.body = piece.body, seen.value = face.value;
    seen.is_section = face.kind == FaceKind::section;
    for (const SolidCrack* crack : cracks) add_cracks_on(face, *crack, slack, view, seen.cracks);
    scene.faces.push_back(std::move(seen));
  }
}

/// Spheres with centres on the eye's side of the plane are removed; the others remain whole.
void cut_away(std::vector<SeenSphere>& spheres, CutPlane plane, const ViewAxes& view) {
  if (plane.normal.dot(view.toward) < -rounding) plane = {-plane.normal, -plane.offset};
  std::erase_if(spheres, [&](const SeenSphere& s) { return plane.above(s.centre) > 0; });
}

/// Adds pieces in their order, with the spheres at their positions in this order.
void add_all_faces(const std::vector<SolidPiece>& pieces, const std::vector<SeenSphere>& spheres,
                   const std::vector<SolidCrack>& cracks, const ViewAxes& view, Scene& scene) {
  const auto own_cracks = by_body(cracks, scene.bodies.size());
  const std::vector<SpherePlace> places = sphere_places(spheres, pieces, view);
  auto next = places.begin();
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    for (; next != places.end() && next->pieces_before <= i; ++next)
      scene.faces.push_back(sphere_face(spheres[next->sphere], view));
    if (i < pieces.size()) add_faces(pieces[i], own_cracks[static_cast<std::size_t>(pieces[i].body)], view, scene);
  }
}

std::vector<Vec2> outline_as_seen(const BodyRow& body, const Placement& at, const ViewAxes& view) {
  std::vector<Vec2> points;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
    points.push_back(view.flat(at.vertex(v)));
  return hull_of(std::move(points));
}

/// Removes bodies without remaining faces, and adapts the body index of faces; outlines contain the remaining faces.
void set_outlines(const std::vector<SolidPiece>& pieces, const ViewAxes& view, Scene& scene) {
  std::vector<std::vector<Vec2>> points(scene.bodies.size());
  for (const SceneFace& face : scene.faces)
    if (face.radius > 0) {
      std::vector<Vec2>& own = points[static_cast<std::size_t>(face.body)];
      own.insert(own.end(), face.outline.begin(), face.outline.end());
    }
  for (const SolidPiece& piece : pieces)
    for (const PieceFace& face : piece.faces)
      for (const Vec3& p : face.corners) points[static_cast<std::size_t>(piece.body)].push_back(view.flat(p));
  std::vector<int> row(scene.bodies.size(), -1);
  std::vector<SceneBody> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    scene.bodies[i].outline = hull_of(std::move(points[i]));
    if (scene.bodies[i].outline.size() < 3) continue;
    row[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(scene.bodies[i]));
  }
  scene.bodies = std::move(kept);
  for (SceneFace& face : scene.faces) face.body = row[static_cast<std::size_t>(face.body)];
  std::erase_if(scene.faces, [](const SceneFace& face) { return face.body < 0; });
}

}  // namespace

void add_solids(const Header& header, const Frame& frame, const SolidsView& shown, const std::vector<bool>& left_out,
                Scene& scene) {
  const Placement at(header, frame);
  const ViewAxes view(shown.from);
  std::vector<SolidPiece> pieces = all_pieces(header, at, left_out, shown.node_value);
  std::vector<SeenSphere> spheres = seen_spheres(header, at, left_out);
  if (pieces.empty() && spheres.empty())
    throw InputError("the results contain no faces of solids, so there is nothing to draw");
  if (shown.cut) cut_away(pieces, *shown.cut, view), cut_away(spheres, *shown.cut, view);
  if (shown.around) {
    const auto is_held = [&](const SolidPiece& piece) {
      return scene.bodies[static_cast<std::size_t>(piece.body)].role != BodyRole::free;
    };
    pieces = trimmed_ground(std::move(pieces), is_held, *shown.around);
  }
  if (pieces.empty() && spheres.empty()) throw InputError("no body lies behind the cut, so there is nothing to draw");
  pieces = paint_order(with_seen_faces(std::move(pieces), view), view);
  add_all_faces(pieces, spheres, shown.cracks, view, scene);
  set_outlines(pieces, view, scene);
  static constexpr const char* names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) scene.axes.push_back({names[k], view.flat(Vec3::Unit(k))});
}

void add_solid_ghosts(const Header& header, const Frame& start, const Frame& frame, const ViewAxes& view,
                      Scene& scene) {
  constexpr double least_share = 0.05;  // of a body's size; smaller displacements get no second outline
  const Placement before(header, start), now(header, frame);
  for (const BodyRow& body : header.bodies) {
    if (role_of(body.support) != BodyRole::free) continue;
    double moved = 0, size = 0;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      moved = std::max(moved, (now.vertex(v) - before.vertex(v)).norm());
      size = std::max(size, (before.vertex(v) - before.vertex(body.first_vertex)).norm());
    }
    if (size > 0 && moved > least_share * size) scene.ghosts.push_back(outline_as_seen(body, before, view));
  }
}

}  // namespace trilith::draw
