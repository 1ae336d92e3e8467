// Pictures of strained meshes in space: edges of elements on the skin are drawn exactly where they are visible.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "draw/inside_outline.hpp"
#include "draw/results/results_solids.hpp"
#include "near.hpp"
#include "physics/space/space_solids.hpp"
#include "results/file/placement.hpp"
#include "run/record/recording_header.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

namespace {

using Map = std::function<Vec3(const Vec3&)>;

constexpr double half_stroke = 2e-3;  ///< half line width, as a share of the side of the picture's box

/// A body of elements with displaced nodes, as in results files.
struct StrainedBody {
  results::Header header;
  results::Frame frame;

  StrainedBody(const SolidSpec& spec, const Map& moved) {
    const Model<3> model = alone_in_space(elastic_in("m", 1000, 1e7, 0.3), spec);
    State<3> state = initial_state(model);
    for (Vec3& x : state.position) x = moved(x);
    header = recording_header(model, state, {});
    frame.position = header.node_position, frame.rotation = header.node_rotation;
  }
  [[nodiscard]] Scene scene(const SolidsView& shown) const {
    Scene out;
    out.bodies.resize(1);
    add_solids(header, frame, shown, {false}, out);
    return out;
  }
};

/// A position of the picture with its depth towards the eye as z.
using Seen = Vec3;

struct SkinFace {
  std::vector<Seen> corners;
  bool is_seen = false;
};

/// A side of one or two faces.
struct SkinEdge {
  Seen a, b;
  std::vector<std::size_t> faces;
};

struct Skin {
  std::vector<SkinFace> faces;
  std::vector<SkinEdge> edges;
  double size = 0;
};

Skin skin_of(const StrainedBody& body, const ViewAxes& view) {
  const results::Placement at(body.header, body.frame);
  Skin out;
  std::map<std::array<double, 6>, std::size_t> known;
  for (std::size_t f = 0; f + 1 < body.header.face_first.size(); ++f) {
    SkinFace face;
    for (auto i = body.header.face_first[f]; i < body.header.face_first[f + 1]; ++i) {
      const Vec3 x = at.vertex(body.header.face_vertex[static_cast<std::size_t>(i)]);
      face.corners.emplace_back(view.right.dot(x), view.up.dot(x), view.toward.dot(x));
    }
    const std::size_t count = face.corners.size();
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < count; ++i)
      normal += cross(Vec3(face.corners[i] - face.corners[0]), Vec3(face.corners[i + 1] - face.corners[0]));
    face.is_seen = normal.z() > 1e-9 * normal.norm();
    for (std::size_t i = 0; i < count; ++i) {
      Seen a = face.corners[i], b = face.corners[(i + 1) % count];
      if (std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end())) std::swap(a, b);
      const auto [row, is_new] = known.try_emplace({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}, out.edges.size());
      if (is_new) out.edges.push_back({a, b, {}});
      out.edges[row->second].faces.push_back(f);
    }
    out.faces.push_back(std::move(face));
  }
  Seen low = out.faces[0].corners[0], high = low;
  for (const SkinFace& face : out.faces)
    for (const Seen& c : face.corners) low = low.cwiseMin(c), high = high.cwiseMax(c);
  out.size = (high - low).head<2>().norm();
  return out;
}

/// Whether a triangle of the face's fan covers `p` of the picture with a point nearer to the eye than `depth`.
bool is_nearer(const SkinFace& face, const Vec2& p, double depth) {
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
    const Seen &a = face.corners[0], &b = face.corners[i], &c = face.corners[i + 1];
    const Vec2 u = (b - a).head<2>(), v = (c - a).head<2>(), w = p - a.head<2>();
    const double area = cross(u, v), s = cross(w, v) / area, t = cross(u, w) / area;
    if (s >= 0 && t >= 0 && s + t <= 1 && a.z() + s * (b.z() - a.z()) + t * (c.z() - a.z()) > depth) return true;
  }
  return false;
}

/// Whether another face than the two adjacent ones covers `p`, or nearly so, as where these are seen edge-on.
bool is_hidden(const Skin& skin, const SkinEdge& edge, const Vec2& p, double depth) {
  depth -= 0.1 * skin.size;
  for (std::size_t f = 0; f < skin.faces.size(); ++f)
    if (skin.faces[f].is_seen && std::find(edge.faces.begin(), edge.faces.end(), f) == edge.faces.end() &&
        is_nearer(skin.faces[f], p, depth))
      return true;
  return false;
}

bool draws_edge_at(const SceneFace& face, const Vec2& p, double slack) {
  const std::size_t count = face.outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 &a = face.outline[i], along = face.outline[(i + 1) % count] - a;
    const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
    if (face.is_edge[i] && (a + share * along - p).norm() <= slack) return true;
  }
  return false;
}

struct Looked {
  int seen = 0, missing = 0, not_once = 0;
};

/// Checks points of all visible edges: each adjacent face that is turned towards the eye draws the edge, and nothing
/// painted later covers the edge or its immediate neighbourhood.
void look_at(const Scene& scene, const Skin& skin, const SkinEdge& edge, double share, Looked& out) {
  const Seen at = edge.a + share * (edge.b - edge.a);
  const Vec2 p = at.head<2>(), along = (edge.b - edge.a).head<2>();
  const double width = half_stroke * skin.size;
  if (along.norm() < 20 * width) return;
  const Vec2 across = width * Vec2(-along.y(), along.x()).normalized();
  const std::array<Vec2, 3> places{p, p + across, p - across};
  for (const Vec2& q : places)
    if (is_hidden(skin, edge, q, at.z())) return;
  ++out.seen;
  const auto looking =
      std::count_if(edge.faces.begin(), edge.faces.end(), [&](std::size_t f) { return skin.faces[f].is_seen; });
  int drawn = 0;
  bool is_whole = false;
  for (const SceneFace& face : scene.faces)
    if (draws_edge_at(face, p, 1e-9 * skin.size))
      ++drawn, is_whole = true;
    else if (std::any_of(places.begin(), places.end(), [&](const Vec2& q) { return contains(face.outline, q); }))
      is_whole = false;
  out.missing += is_whole ? 0 : 1;
  out.not_once += drawn == looking ? 0 : 1;
}

void check_edges(const StrainedBody& body, const std::string& from) {
  CAPTURE(from);
  SolidsView shown;
  shown.from = view_direction(from);
  const Skin skin = skin_of(body, ViewAxes(shown.from));
  const Scene scene = body.scene(shown);
  Looked looked;
  for (const SkinEdge& edge : skin.edges)
    if (std::any_of(edge.faces.begin(), edge.faces.end(), [&](std::size_t f) { return skin.faces[f].is_seen; }))
      for (const double share : {0.13, 0.5, 0.89}) look_at(scene, skin, edge, share, looked);
  CHECK(looked.seen > 90);
  CHECK(looked.missing == 0);
  CHECK(looked.not_once == 0);
}

SolidSpec bar_of(ElementShape shape) {
  return box_of("b", box_solid(Vec3::Zero(), Vec3(4, 0.8, 0.6)), "m", {8, 2, 2}, shape);
}

/// Rolled up about y: a bar of length 4 along x becomes three quarters of a ring.
Vec3 rolled(const Vec3& x) {
  const double radius = 4 / 4.7, angle = x.x() / radius, r = radius + x.z();
  return {r * std::sin(angle), x.y(), r * std::cos(angle)};
}
Vec3 twisted(const Vec3& x) {
  const double angle = 0.3 * x.x();
  const Vec3 m(0, 0.4, 0.3), d = x - m;
  return m + Vec3(d.x(), std::cos(angle) * d.y() - std::sin(angle) * d.z(),
                  std::sin(angle) * d.y() + std::cos(angle) * d.z());
}
/// Waves along x and y.
Vec3 waved(const Vec3& x) {
  return x + Vec3(0, 0, 0.25 * std::sin(2.2 * x.x()) * std::cos(1.9 * x.y()));
}
/// An invisibly small displacement.
Vec3 hardly(const Vec3& x) {
  return x + 2e-5 * Vec3(std::sin(9 * x.y()), std::cos(7 * x.z()), std::sin(5 * x.x() + 3 * x.y()));
}

const std::array<std::string, 4> views{"iso", "20,10", "-100,55", "133,-31"};

double area_of(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

/// Visible area of the sections [m2], and length of their edges [m].
struct Sections {
  double area = 0, edges = 0;
};

Sections sections_of(const StrainedBody& body, const char* from, const CutPlane& cut) {
  SolidsView shown;
  shown.from = view_direction(from), shown.cut = cut;
  Sections out;
  for (const SceneFace& face : body.scene(shown).faces) {
    if (!face.is_section) continue;
    const std::size_t count = face.outline.size();
    out.area += area_of(face.outline);
    for (std::size_t i = 0; i < count; ++i)
      if (face.is_edge[i]) out.edges += (face.outline[(i + 1) % count] - face.outline[i]).norm();
  }
  return out;
}

}  // namespace

TEST_CASE("each edge of elements on the skin of a strained mesh in space is drawn over its whole visible part") {
  for (const ElementShape shape : all_shapes)
    for (const Map& moved : {Map(rolled), Map(twisted), Map(hardly)}) {
      CAPTURE(std::string(info_of(shape).name));
      const StrainedBody bar(bar_of(shape), moved);
      for (const std::string& from : views) check_edges(bar, from);
    }
}

TEST_CASE("visible parts of edges of plates of elements in space are drawn, strained or not") {
  for (const ElementShape shape : all_shapes)
    for (const Map& moved : {Map(waved), Map(hardly), Map([](const Vec3& x) { return x; })}) {
      CAPTURE(std::string(info_of(shape).name));
      const StrainedBody plate(box_of("b", box_solid(Vec3::Zero(), Vec3(3, 3, 0.1)), "m", {6, 6, 1}, shape), moved);
      for (const std::string& from : views) check_edges(plate, from);
    }
}

TEST_CASE("the section of a strained mesh in space is complete and has the edges of the skin") {
  for (const ElementShape shape : all_shapes) {
    CAPTURE(std::string(info_of(shape).name));
    // No displacement along y: one polygon at each y.
    std::vector<Vec2> outline;
    for (int i = 0; i <= 8; ++i)
      outline.push_back(Vec2(rolled(Vec3(0.5 * i, 0, 0)).x(), rolled(Vec3(0.5 * i, 0, 0)).z()));
    for (int i = 8; i >= 0; --i)
      outline.push_back(Vec2(rolled(Vec3(0.5 * i, 0, 0.6)).x(), rolled(Vec3(0.5 * i, 0, 0.6)).z()));
    double around = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) around += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    const Sections seen = sections_of(StrainedBody(bar_of(shape), rolled), "front", {Vec3::UnitY(), 0.3});
    CHECK(near(seen.area, std::abs(area_of(outline)), 1e-9));
    CHECK(near(seen.edges, around, 1e-9));
  }
}

TEST_CASE("the section of a mesh in space with a hole shows the hole") {
  SpaceMesh ring =
      mesh_of(box_solid(Vec3::Zero(), Vec3(3, 3, 1)), {BodyKind::mesh, {3, 3, 1}, ElementShape::brick}, "r");
  std::erase_if(ring.cell, [&](const SpaceCell& cell) {
    Vec3 middle = Vec3::Zero();
    for (int i = 0; i < 8; ++i)
      middle += ring.node[static_cast<std::size_t>(cell.node[static_cast<std::size_t>(i)])] / 8;
    return (middle - Vec3(1.5, 1.5, 0.5)).norm() < 0.1;
  });
  REQUIRE(ring.cell.size() == 8);
  const StrainedBody body(mesh_spec("r", "m", ring), [](const Vec3& x) { return x; });
  const Sections seen = sections_of(body, "top", {Vec3::UnitZ(), 0.4});
  CHECK(near(seen.area, 8, 1e-9));
  CHECK(near(seen.edges, 16, 1e-9));
}

TEST_CASE("a ball behind a strained plate is painted first, a ball in front of it last") {
  for (const double height : {-1.0, 1.0}) {
    const SolidSpec plate = box_of("b", box_solid(Vec3::Zero(), Vec3(3, 3, 0.1)), "m", {6, 6, 1});
    StrainedBody body(plate, waved);
    results::Header& header = body.header;
    const std::array place{1.5, 1.5, height}, zero{0.0, 0.0, 0.0};
    const std::array turn{1.0, 0.0, 0.0, 0.0};
    header.add_solid_body({"ball", "rigid", "m", "", "free"}, place, turn, 1, zero, zero, {});
    header.add_sphere(0, 0.2);
    body.frame.position = header.node_position, body.frame.rotation = header.node_rotation;
    for (const char* from : {"iso", "-100,55", "133,-31"}) {
      CAPTURE(std::string(from));
      Scene scene;
      scene.bodies.resize(2);
      SolidsView shown;
      shown.from = view_direction(from);
      add_solids(header, body.frame, shown, {false, false}, scene);
      const auto ball =
          std::find_if(scene.faces.begin(), scene.faces.end(), [](const SceneFace& f) { return f.radius > 0; });
      REQUIRE(ball != scene.faces.end());
      const bool is_before = (shown.from.elevation > 0) == (height > 0);
      // Faces of the plate that it covers, or that cover it, in the picture.
      const auto over = [&](auto first, auto last) {
        return std::any_of(first, last,
                           [&](const SceneFace& f) { return f.radius == 0 && contains(f.outline, ball->centre); });
      };
      CHECK(over(is_before ? scene.faces.begin() : ball, is_before ? ball : scene.faces.end()));
      CHECK_FALSE(over(is_before ? ball : scene.faces.begin(), is_before ? scene.faces.end() : ball));
    }
  }
}
