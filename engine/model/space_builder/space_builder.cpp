#include "model/space_builder/space_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/bounds.hpp"

namespace trilith {
namespace {

/// Tolerance for coincident faces, relative to the size of their solids.
constexpr double same_plane = 1e-7;

/// Height of a point above the plane of a face [m].
double plane_distance(const ConvexSolid& solid, int face, const Vec3& x) {
  const Vec3& on = solid.shape.corners[static_cast<std::size_t>(solid.shape.faces[face][0])];
  return solid.normals[static_cast<std::size_t>(face)].dot(x - on);
}

/// The face of another piece that covers a face completely; -1 if there is none.
int covering_face(const ConvexSolid& piece, int face, const ConvexSolid& by, double within) {
  for (int f = 0; f < by.shape.faces.count(); ++f) {
    if (piece.normals[static_cast<std::size_t>(face)].dot(by.normals[static_cast<std::size_t>(f)]) > -1 + same_plane)
      continue;
    bool covered = true;
    for (const int corner : piece.shape.faces[face]) {
      const Vec3& x = piece.shape.corners[static_cast<std::size_t>(corner)];
      covered = covered && std::abs(plane_distance(by, f, x)) <= within;
      for (int g = 0; g < by.shape.faces.count() && covered; ++g) covered = plane_distance(by, g, x) <= within;
    }
    if (covered) return f;
  }
  return -1;
}

/// A face of a piece inside a face of another piece of the same body.
struct InnerCut {
  std::size_t piece;
  int face;
  std::size_t by;
  int by_face;
};

/// Whether a surface face, or a cut with pressure, is coplanar with this one: all faces of a convex solid with the same
/// normal are. Overlaps do not distinguish coplanar faces.
bool shares_plane_with_pressed(const ConvexSolid& piece, int face) {
  const Vec3& n = piece.normals[static_cast<std::size_t>(face)];
  for (int f = 0; f < piece.shape.faces.count(); ++f)
    if (piece.is_pressed(f) && piece.normals[static_cast<std::size_t>(f)].dot(n) > 1 - same_plane) return true;
  return false;
}

/// If the other side of a cut carries pressure because it is partly surface, the cut must too; repeated until both
/// sides of each cut agree.
void press_one_sided_cuts(std::vector<ConvexSolid>& pieces, const std::vector<InnerCut>& cuts) {
  for (bool more = true; more;) {
    more = false;
    for (const InnerCut& cut : cuts) {
      ConvexSolid& piece = pieces[cut.piece];
      if (piece.is_pressed(cut.face)) continue;
      if (!pieces[cut.by].is_pressed(cut.by_face) && !shares_plane_with_pressed(piece, cut.face)) continue;
      piece.pressed_cuts.resize(static_cast<std::size_t>(piece.shape.faces.count()), 0);
      piece.pressed_cuts[static_cast<std::size_t>(cut.face)] = 1;
      more = true;
    }
  }
}

/// True if a law holds between a surface and any other.
bool touches_something(const Model<3>& model, int surface) {
  for (int other = 0; other < model.surfaces; ++other)
    if (model.law_of[surface * model.surfaces + other] >= 0) return true;
  return false;
}

void check_solid_body(const SolidBody& body) {
  if (body.pieces.empty() && body.spheres.empty())
    throw InputError(fmt::format("body '{}' has no piece; it needs at least one", body.name));
  for (std::size_t s = 0; s < body.spheres.size(); ++s)
    check_sphere(body.spheres[s], fmt::format("body '{}', sphere {}", body.name, s + 1));
  if (!(body.density > 0) || !std::isfinite(body.density))
    throw InputError(fmt::format("body '{}' has a density of {} kg/m3; it must be above 0", body.name, body.density));
  if (!body.velocity.allFinite() || !body.spin.allFinite())
    throw InputError(fmt::format("body '{}' has an initial velocity or spin that is not finite", body.name));
}

}  // namespace

/// The least distance between a face and the farthest corner behind it.
double solid_width(const ConvexSolid& solid) {
  double least = unbounded;
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    double behind = 0;
    for (const Vec3& x : solid.shape.corners) behind = std::max(behind, -plane_distance(solid, f, x));
    least = std::min(least, behind);
  }
  return least;
}

void mark_inner_faces(std::vector<ConvexSolid>& pieces) {
  if (pieces.size() < 2) return;
  std::vector<InnerCut> cuts;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    ConvexSolid& piece = pieces[p];
    const double within = same_plane * solid_size(piece.shape.corners);
    piece.surface.assign(static_cast<std::size_t>(piece.shape.faces.count()), 1);
    for (int f = 0; f < piece.shape.faces.count(); ++f)
      for (std::size_t q = 0; q < pieces.size(); ++q) {
        const int by = q == p ? -1 : covering_face(piece, f, pieces[q], within);
        if (by < 0) continue;
        piece.surface[static_cast<std::size_t>(f)] = 0;
        cuts.push_back({p, f, q, by});
      }
  }
  press_one_sided_cuts(pieces, cuts);
}

SolidMass mass_of(const std::vector<Polyhedron>& pieces, double density, const std::vector<Sphere>& spheres) {
  std::vector<SolidMoments> parts;
  for (const Polyhedron& piece : pieces) parts.push_back(solid_moments(piece));
  if (!spheres.empty()) parts.push_back(sphere_moments(spheres));
  double volume = 0;
  Vec3 first = Vec3::Zero();
  for (const SolidMoments& m : parts) volume += m.volume, first += m.volume * m.centroid;
  const Vec3 centroid = first / volume;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const SolidMoments& m : parts) {
    const Vec3 arm = m.centroid - centroid;
    inertia += m.inertia + m.volume * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  return {density * volume, centroid, principal_inertia(density * inertia)};
}

SolidMass mass_of(const SolidMoments& moments, double density) {
  return {density * moments.volume, moments.centroid, principal_inertia(density * moments.inertia)};
}

/// A solid becomes one node at its centroid, with its principal axes, and its pieces about the node.
void SpaceBuilder::require_new_body(const std::string& name) {
  if (names_.contains(model_.bodies, name)) throw InputError(fmt::format("there is a body '{}' already", name));
}

int SpaceBuilder::add(const SolidBody& body) {
  require_new_body(body.name), check_solid_body(body);
  for (std::size_t p = 0; p < body.pieces.size(); ++p)
    check_convex(body.pieces[p], fmt::format("body '{}', piece {}", body.name, p + 1));
  SolidMass mass =
      body.moments ? mass_of(*body.moments, body.density) : mass_of(body.pieces, body.density, body.spheres);
  if (body.inertia) mass.inertia = principal_inertia(Eigen::Matrix3d(body.inertia->asDiagonal()));
  Body row;
  row.name = body.name, row.first_node = model_.nodes(), row.surface = body.surface;
  row.first_skin = static_cast<int>(model_.skin_place.size()), row.first_piece = model_.pieces();
  row.pieces = static_cast<int>(body.pieces.size() + body.spheres.size());
  add_node(body, mass);
  add_pieces(body, mass);
  row.skins = static_cast<int>(model_.skin_place.size()) - row.first_skin;
  model_.surfaces = std::max(model_.surfaces, body.surface + 1);
  model_.bodies.push_back(row);
  return static_cast<int>(model_.bodies.size()) - 1;
}

void SpaceBuilder::add_node(const SolidBody& body, const SolidMass& mass) {
  model_.mass.push_back(mass.mass), model_.inertia.push_back(mass.inertia.moments);
  model_.support.emplace_back().fill(body.fixed ? Support::fixed : Support::free);
  model_.drive_of.emplace_back().fill(-1);
  model_.start_position.push_back(mass.centroid), model_.start_rotation.push_back(mass.inertia.axes);
  model_.start_velocity.push_back(body.velocity), model_.start_spin.push_back(body.spin);
  model_.load.push_back(Vec3::Zero());
}

/// In the principal axes of the body, about its centroid.
void SpaceBuilder::add_pieces(const SolidBody& body, const SolidMass& mass) {
  const UnitQuaternion back = inverse(mass.inertia.axes);
  const int node = model_.nodes() - 1, index = static_cast<int>(model_.bodies.size());
  std::vector<ConvexSolid> pieces;
  for (const Polyhedron& piece : body.pieces)
    pieces.push_back(convex_solid(placed(placed(piece, {}, -mass.centroid), back, Vec3::Zero()), body.name, 1e-8));
  mark_inner_faces(pieces);
  for (const Sphere& s : body.spheres)
    pieces.push_back(convex_sphere({turn_of(back).apply(s.centre - mass.centroid), s.radius}));
  if (model_.piece_first.empty()) model_.piece_first.push_back(0);
  double radius = 0;
  for (const ConvexSolid& piece : pieces) {
    for (const Vec3& x : piece.shape.corners) radius = std::max(radius, x.norm() + piece.radius);
    add_piece(piece, node, index);
  }
  model_.body_radius.push_back(radius);
}

/// In the axes of its node.
void SpaceBuilder::add_piece(const ConvexSolid& piece, int node, int body) {
  for (const Vec3& x : piece.shape.corners) {
    model_.corner_skin.push_back(static_cast<int>(model_.skin_place.size()));
    model_.skin_place.push_back(x), model_.skin_node.push_back(node), model_.skin_turn.push_back(node);
  }
  model_.piece_body.push_back(body);
  model_.piece_first.push_back(static_cast<int>(model_.corner_skin.size()));
  model_.piece_thickness.push_back(piece.is_sphere() ? 2 * piece.radius : solid_width(piece));
  model_.piece_solid.push_back(piece);
}

void SpaceBuilder::contact(int surface_a, int surface_b, const ContactLaw& law, const std::string& name) {
  if (surface_a < 0 || surface_b < 0)
    throw InputError(fmt::format("contact '{}' is between surfaces {} and {}; they are numbered from 0", name,
                                 surface_a, surface_b));
  pairings_.push_back({surface_a, surface_b, static_cast<int>(model_.laws.size())});
  model_.laws.push_back(law), model_.law_names.push_back(name);
}

/// Quantities of all bodies together: the least thickness of any body with contact, which limits the displacement in a
/// step, and the bounds.
void complete_space(Model<3>& model) {
  model.least_thickness = unbounded;
  for (int p = 0; p < model.pieces(); ++p)
    if (touches_something(model, model.bodies[model.piece_body[p]].surface))
      model.least_thickness = std::min(model.least_thickness, model.piece_thickness[p]);
  model.bounds = default_bounds(model);
}

/// Pairings become the table of laws by surface and surface; the last one counts.
Model<3> SpaceBuilder::build() const {
  Model<3> model = model_;
  if (!model.beams_3d.empty() || !model.space_elements.empty()) model.element_bound.resize(model.bodies.size());
  if (!model.fits.empty()) model.piece_fit.resize(model.piece_body.size(), -1);
  if (!model.piece_bounds.empty()) model.piece_bounds.resize(model.piece_body.size());
  for (const Pairing& p : pairings_) model.surfaces = std::max({model.surfaces, p.a + 1, p.b + 1});
  model.law_of.assign(static_cast<std::size_t>(model.surfaces) * static_cast<std::size_t>(model.surfaces), -1);
  const auto row = [&](int a, int b) { return static_cast<std::size_t>(a * model.surfaces + b); };
  for (const Pairing& p : pairings_) model.law_of[row(p.a, p.b)] = model.law_of[row(p.b, p.a)] = p.law;
  complete_space(model);
  return model;
}

}  // namespace trilith
