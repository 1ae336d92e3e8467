// Loads on bodies in space: forces at points, pressure on faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "geometry/space/face_overlap_3d.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/element/element_place.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Area centroid of a face [m], from the triangles between its first corner and its sides.
Vec3 middle_of(std::span<const Vec3> corners, std::span<const int> loop) {
  const Vec3& first = corners[loop[0]];
  const Vec3 normal = area_vector(corners, loop).normalized();
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const Vec3 a = corners[loop[i - 1]] - first, b = corners[loop[i]] - first;
    const double part = 0.5 * normal.dot(cross(a, b));
    sum += part / 3 * (a + b), area += part;
  }
  return first + sum / area;
}

std::string solid_load_owner(const SolidLoadSpec& spec, const Body& body) {
  return fmt::format("load '{}' on '{}'", spec.name, body.name);
}

void check_solid_load(const SolidLoadSpec& spec, const std::string& owner) {
  if (!spec.force.allFinite() || !spec.moment.allFinite() || (spec.at && !spec.at->allFinite()))
    throw InputError(owner + ": force, moment or place is not finite");
  check_load_curve(spec.curve, owner);
}

void check_pressure(const SolidPressureSpec& spec, const std::string& owner) {
  require_finite(spec.value, owner + ": value");
  check_load_curve(spec.curve, owner);
  if (spec.direction && (spec.follows || !(spec.direction->norm() > 0) || !spec.direction->allFinite()))
    throw InputError(fmt::format(
        "{}: a direction must be a nonzero vector, and is only for pressure that does not follow the face", owner));
}

}  // namespace

/// In the axes of the body if it follows, otherwise in world axes; by default at the centroid. On a frame a load acts
/// on the nearest node, on a body of elements on the nearest face of its skin, and moves with it (see
/// make_solid_loads).
PointLoad<3> make_solid_load(const Model<3>& model, int body, const SolidLoadSpec& spec) {
  const Body& b = model.bodies[body];
  const std::string owner = solid_load_owner(spec, b);
  if (!b.is_rigid() && !spec.at)
    throw InputError(fmt::format("{}: the body deforms; give 'at', the point where the load acts", owner));
  check_solid_load(spec, owner);
  if (b.is_rigid() && spec.at) {
    const double size = 2 * model.body_radius[body];
    require_near<3>(*spec.at, (*spec.at - model.start_position[b.first_node]).norm() - 0.5 * size, size, b.name, owner);
  }
  const BodyMotion begins = start_of(model, spec.at ? contact_frame_near(model, body, *spec.at) : b.first_node);
  const Turn3 start = turn_of(begins.rotation);
  PointLoad<3> load;
  load.name = spec.name, load.body = body, load.curve = spec.curve, load.follows = spec.follows;
  load.force = spec.follows ? start.undo(spec.force) : spec.force;
  load.moment = spec.follows ? start.undo(spec.moment) : spec.moment;
  load.at = spec.at ? tie_point(model, body, *spec.at) : Attachment<3>::to_node(b.first_node, Vec3::Zero());
  return load;
}

namespace {

/// Shares of a force at its point, at the nodes of the element that contains it.
std::vector<PointLoad<3>> element_load(const Model<3>& model, int body, const SolidLoadSpec& spec) {
  const std::string owner = solid_load_owner(spec, model.bodies[body]);
  check_solid_load(spec, owner);
  const ElementShares shares = element_shares(model, body, *spec.at, owner);
  const SpaceElement& element = model.space_elements[static_cast<std::size_t>(shares.element)];
  std::vector<PointLoad<3>> loads;
  for (int i = 0; i < info_of(element.shape).nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (std::abs(shares.share[k]) < 1e-12) continue;  // e.g. for a point on a face, the nodes off this face
    PointLoad<3> load;
    load.name = spec.name, load.body = body, load.curve = spec.curve;
    load.force = shares.share[k] * spec.force;
    load.at = Attachment<3>::to_node(element.node[k], Vec3::Zero());
    loads.push_back(std::move(load));
  }
  return loads;
}

/// Shares of a force by mass at all nodes.
std::vector<PointLoad<3>> spread_load(const Model<3>& model, int body, const SolidLoadSpec& spec) {
  const Body& b = model.bodies[body];
  const std::string owner = solid_load_owner(spec, b);
  check_solid_load(spec, owner);
  if (!spec.moment.isZero() || spec.follows)
    throw InputError(fmt::format("{}: the body deforms; give 'at', the point where the {} acts", owner,
                                 spec.moment.isZero() ? "force that follows" : "moment"));
  const double mass = body_mass(model, body);
  std::vector<PointLoad<3>> loads;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    if (!(model.mass[n] > 0)) continue;
    PointLoad<3> load;
    load.name = spec.name, load.body = body, load.curve = spec.curve;
    load.force = model.mass[n] / mass * spec.force;
    load.at = Attachment<3>::to_node(n, Vec3::Zero());
    loads.push_back(std::move(load));
  }
  return loads;
}

}  // namespace

std::vector<PointLoad<3>> make_solid_loads(const Model<3>& model, int body, const SolidLoadSpec& spec) {
  const Body& b = model.bodies[body];
  if (!b.is_rigid() && !spec.at) return spread_load(model, body, spec);
  if (!b.nodes_turn() && spec.moment.isZero() && !spec.follows) return element_load(model, body, spec);
  return {make_solid_load(model, body, spec)};
}

std::vector<SolidFace> surface_faces(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  std::vector<SolidFace> faces;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p)
    for (int f = 0; f < static_cast<int>(model.piece_solid[p].normals.size()); ++f)
      if (model.piece_solid[p].is_surface(f)) faces.push_back({p, f});
  return faces;
}

/// Faces whose outward normal is within 45 degrees of `side` at the start.
std::vector<SolidFace> faces_towards(const Model<3>& model, int body, const Vec3& side) {
  const double least = std::sqrt(0.5) - 1e-9;
  std::vector<SolidFace> faces;
  for (const SolidFace& f : surface_faces(model, body)) {
    const Turn3 turn = turn_of(model.start_rotation[model.node_of_piece(f.piece)]);
    if (turn.apply(model.piece_solid[f.piece].normals[f.face]).dot(side) >= least * side.norm()) faces.push_back(f);
  }
  return faces;
}

namespace {

/// A plane area [m2] and its first moment [m3].
struct FaceArea {
  double area = 0;
  Vec3 moment = Vec3::Zero();
};

/// Calls f(corners) for parts of a face about its first corner, each with no more corners than face overlaps support.
template <class F>
void for_parts(const Polyhedron& shape, int face, F&& f) {
  const auto loop = shape.faces[face];
  const auto corner = [&](std::size_t i) { return shape.corners[static_cast<std::size_t>(loop[i])]; };
  std::array<Vec3, max_face_corners> part;
  part[0] = corner(0);
  for (std::size_t from = 1; from + 1 < loop.size(); from += max_face_corners - 2) {
    const std::size_t count = std::min<std::size_t>(max_face_corners - 1, loop.size() - from);
    for (std::size_t i = 0; i < count; ++i) part[i + 1] = corner(from + i);
    f(std::span<const Vec3>(part.data(), count + 1));
  }
}

/// Adds the part of face f of one piece that is covered by the coincident face g of another.
void add_covered(const ConvexSolid& a, int f, const ConvexSolid& b, int g, FaceArea& sum) {
  const Vec3 &n = a.normals[static_cast<std::size_t>(f)], &m = b.normals[static_cast<std::size_t>(g)];
  constexpr double same_plane = 1e-7;
  const Vec3 &on_a = a.shape.corners[static_cast<std::size_t>(a.shape.faces[f][0])],
             &on_b = b.shape.corners[static_cast<std::size_t>(b.shape.faces[g][0])];
  if (n.dot(m) > -1 + same_plane || std::abs(n.dot(on_b - on_a)) > same_plane * (a.size + b.size)) return;
  FaceOverlap3 shared;
  for_parts(a.shape, f, [&](std::span<const Vec3> part) {
    for_parts(b.shape, g, [&](std::span<const Vec3> by) {
      if (!face_overlap({part, n}, {by, m}, shared)) return;
      const FaceIntegrals of = integrals_over_all(shared);
      if (!(of.area > 0)) return;
      sum.area += of.area, sum.moment += of.area * shared.plane.at(of.area_moment / of.area);
    });
  });
}

/// The part of a face covered by other pieces of a rigid body, which is not accessible from outside. The faces of
/// meshes and members match completely.
FaceArea covered_area(const Model<3>& model, int body, const SolidFace& face) {
  const Body& b = model.bodies[body];
  FaceArea sum;
  if (!b.is_rigid()) return sum;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    if (p == face.piece) continue;
    for (int g = 0; g < model.piece_solid[p].shape.faces.count(); ++g)
      add_covered(model.piece_solid[face.piece], face.face, model.piece_solid[p], g, sum);
  }
  return sum;
}

}  // namespace

/// A face is a rigid plate that moves with its contact frame (model/contact/contact_frame.hpp). Uniform pressure on it
/// is one force at the centroid of its uncovered area: value times area, against the outward normal or along
/// `direction`.
std::vector<PointLoad<3>> make_solid_pressure(const Model<3>& model, int body, const std::vector<SolidFace>& faces,
                                              const SolidPressureSpec& spec) {
  const std::string owner = fmt::format("pressure '{}' on '{}'", spec.name, model.bodies[body].name);
  check_pressure(spec, owner);
  std::vector<PointLoad<3>> loads;
  for (const SolidFace& face : faces) {
    const Polyhedron& shape = model.piece_solid[face.piece].shape;
    const int n = model.node_of_piece(face.piece), contact_frame = model.carrier_of(face.piece, face.face);
    const Turn3 piece = turn_of(model.start_rotation[n]);
    Vec3 whole = area_vector(shape.corners, shape.faces[face.face]);
    Vec3 within = middle_of(shape.corners, shape.faces[face.face]);
    if (const FaceArea covered = covered_area(model, body, face); covered.area > 0) {
      const double size = whole.norm(), left = size - covered.area;
      if (left <= 1e-9 * size) continue;
      within = (size * within - covered.moment) / left, whole *= left / size;
    }
    const Vec3 area = piece.apply(whole);
    const Vec3 middle = model.start_position[n] + piece.apply(within);
    const BodyMotion begins = start_of(model, contact_frame);
    const Turn3 start = turn_of(begins.rotation);
    PointLoad<3> load;
    load.name = spec.name, load.body = body, load.curve = spec.curve, load.follows = spec.follows;
    load.at = Attachment<3>::to_node(contact_frame, start.undo(Vec3(middle - begins.place)));
    if (spec.direction)
      load.force = spec.value * area.norm() * spec.direction->normalized();
    else
      load.force = -spec.value * (spec.follows ? start.undo(area) : area);
    const Body& owner_body = model.bodies[body];
    if (owner_body.is_rigid() && owner_body.pieces == 1) load.face = face.face;
    loads.push_back(std::move(load));
  }
  return loads;
}

}  // namespace trilith
