#include "model/builder/builder.hpp"
#include "model/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/nearest.hpp"
#include "contact/plane/overlap_pair.hpp"
#include "geometry/plane/convex_parts.hpp"
#include "model/builder/extend.hpp"
#include "model/builder/mesh_pieces.hpp"
#include "model/check/check.hpp"
#include "model/check/frame_plausibility.hpp"
#include "model/check/small_gaps.hpp"
#include "model/check/thickness.hpp"
#include "model/element/element_rows.hpp"
#include "model/flatness.hpp"
#include "model/names.hpp"
#include "model/plausible_ranges.hpp"

namespace trilith {
namespace {

/// Sides of the box around an outline [m].
Vec2 sides_of(const Polygon& outline) {
  Vec2 low = Vec2::Constant(unbounded), high = -low;
  for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return outline.empty() ? Vec2::Zero() : Vec2(high - low);
}

/// A note on sizes that are probably in mm. Fixed bodies may be ground, which extends far.
void note_sides(const BodySpec& spec, const std::string& owner, std::vector<std::string>& notes) {
  const Vec2 sides = sides_of(spec.outline);
  add_plausibility_note_once(notes, owner, "least side", "m", sides.minCoeff());
  if (spec.support[0] == Support::free)
    add_plausibility_note_once(notes, owner, "greatest side", "m", sides.maxCoeff());
}

double mass_of(const BodySpec& spec, double area, double thickness, const std::vector<Material>& materials) {
  const std::string owner = fmt::format("body '{}'", spec.name);
  const int given = int(spec.density.has_value()) + int(spec.mass.has_value()) + int(spec.weight.has_value());
  if (given > 1) throw InputError(owner + ": more than one of density, mass and weight is given; keep one");
  const double volume = area * require_positive(spec.thickness.value_or(thickness), owner + ": thickness", "m");
  if (spec.mass) return require_positive(*spec.mass, owner + ": mass", "kg");
  if (spec.weight) return require_positive(*spec.weight, owner + ": weight", "N") / standard_gravity;
  if (spec.density) return require_positive(*spec.density, owner + ": density", "kg/m3") * volume;
  for (const Material& m : materials)
    if (m.name == spec.material) return m.density * volume;
  throw InputError(fmt::format("{}: give a density, mass or weight, or a material that has a density", owner));
}

}  // namespace

std::vector<std::string> ModelBuilder::body_names() const {
  std::vector<std::string> names;
  for (const BodySpec& b : bodies_) names.push_back(b.name);
  return names;
}

void ModelBuilder::add_material(const Material& material) {
  check_material(material, materials_, notes_);
  materials_.push_back(material);
}

namespace {

/// A held degree of freedom does not move, whatever its given velocity.
void note_held_motion(const BodySpec& spec, const std::string& owner, std::vector<std::string>& notes) {
  const std::array given{spec.velocity.x(), spec.velocity.y(), spec.spin};
  constexpr std::array names{"a velocity along x", "a velocity along y", "a spin"};
  const auto known = [](const std::string& note) {
    return note.find("but is held in that direction") != std::string::npos;
  };
  if (std::any_of(notes.begin(), notes.end(), known)) return;
  for (std::size_t k = 0; k < given.size(); ++k)
    if (given[k] != 0 && spec.support[k] != Support::free)
      notes.push_back(fmt::format(
          "{}: it is given {}, but is held in that direction and does not move; free that direction or leave it out",
          owner, names[k]));
}

}  // namespace

void ModelBuilder::add_body(BodySpec spec) {
  require_name(spec.name, "body");
  body_names_known_.require_new(bodies_, spec.name, "body");
  const std::string owner = fmt::format("body '{}'", spec.name);
  CheckedPolygon checked;
  if (!spec.mesh && !spec.frame) {
    checked = check_polygon(std::move(spec.outline), owner);
    spec.outline = std::move(checked.outline);
  }
  if (spec.mesh && spec.kind == BodyKind::rigid) take_checked_mesh(spec, owner);
  for (const double v : {spec.velocity.x(), spec.velocity.y(), spec.spin, spec.load.x(), spec.load.y()})
    require_finite(v, owner + ": velocity, spin or load");
  if (spec.inertia) require_positive(*spec.inertia, owner + ": inertia", "kg m2");
  if (!spec.material.empty()) require_material(materials_, spec.material, owner);
  if (spec.frame)
    check_frame(spec, owner);
  else if (info_of(spec.kind).resistance == Resistance::elements)
    check_deformable(spec, owner);
  check_cracks(spec, owner);
  mass_of(spec, 1.0, thickness, materials_);
  notes_.insert(notes_.end(), checked.notes.begin(), checked.notes.end());
  if (spec.density) add_plausibility_note_once(notes_, owner, "density", "kg/m3", *spec.density);
  if (spec.frame)
    add_frame_plausibility_notes(*spec.frame, owner, notes_);
  else
    note_sides(spec, owner, notes_);
  note_held_motion(spec, owner, notes_);
  bodies_.push_back(std::move(spec));
}

int ModelBuilder::require_body(const std::string& name, const std::string& owner) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].name == name) return static_cast<int>(i);
  throw InputError(fmt::format("{}: there is no body '{}'{}", owner, name, name_hint(name, body_names())));
}

void ModelBuilder::check_deformable(BodySpec& spec, const std::string& owner) {
  const std::string kind = fmt::format("{}: body = \"{}\"", owner, name_of(spec.kind));
  const auto material =
      std::find_if(materials_.begin(), materials_.end(), [&](const Material& m) { return m.name == spec.material; });
  if (material == materials_.end() || !material->solid)
    throw InputError(fmt::format("{} needs a material with a stiffness (E, nu); {} has none", kind,
                                 spec.material.empty() ? "it" : "'" + spec.material + "'"));
  if (spec.inertia) throw InputError(kind + " takes no inertia, which follows from its nodes; leave it out");
  const auto& s = spec.support;
  if (s[2] != Support::free && (s[0] == Support::free || s[1] == Support::free))
    throw InputError(kind + " has no rotation to hold; hold x and y of some of its nodes");
  if (!spec.mesh) {
    if (info_of(spec.kind).nodes == 4) spec.divisions = {1, 1};
    if (spec.outline.size() != 4)
      throw InputError(
          fmt::format("{} takes an outline of four corners, this one has {}; make it rigid, or give it a mesh", kind,
                      spec.outline.size()));
    for (const int n : spec.divisions)
      if (n < 1 || n > 1000) throw InputError(fmt::format("{}: {} divisions of a side, must be 1 to 1000", kind, n));
    spec.mesh = grid_mesh({spec.outline[0], spec.outline[1], spec.outline[2], spec.outline[3]}, spec.divisions[0],
                          spec.divisions[1]);
  }
  take_checked_mesh(spec, owner);
  // Only a part of a mesh that has cracked is a mesh of one quadrilateral: it keeps the inertia of its nodal masses.
  if (spec.mesh->element.size() == 1 && corners_of(spec.mesh->element[0]) == 4) spec.kind = BodyKind::quad;
}

/// Repairs the mesh; the outline becomes its outer boundary.
void ModelBuilder::take_checked_mesh(BodySpec& spec, const std::string& owner) {
  CheckedMesh checked = check_mesh(std::move(*spec.mesh), owner);
  notes_.insert(notes_.end(), checked.notes.begin(), checked.notes.end());
  spec.outline.assign(checked.mesh.node.begin(), checked.mesh.node.begin() + checked.outline);
  spec.mesh = std::move(checked.mesh);
}

/// The elements of a mesh may leave holes, which the outline does not show.
PolygonMoments moments_of(const BodySpec& spec) {
  if (!spec.mesh || spec.kind != BodyKind::rigid)
    return polygon_moments(spec.solid.empty() ? spec.outline : spec.solid);
  std::vector<PolygonMoments> parts;
  for (std::size_t e = 0; e < spec.mesh->element.size(); ++e)
    parts.push_back(polygon_moments(corners_of(*spec.mesh, e)));
  PolygonMoments sum{};
  Vec2 first = Vec2::Zero();
  for (const PolygonMoments& p : parts) sum.area += p.area, first += p.area * p.centroid;
  sum.centroid = first / sum.area;
  for (const PolygonMoments& p : parts)
    sum.second_moment += p.second_moment + p.area * (p.centroid - sum.centroid).squaredNorm();
  return sum;
}

Model<2> ModelBuilder::build() {
  std::vector<std::string> faults, notes;
  Model<2> model = assemble(faults, notes);
  if (!faults.empty()) throw InputError(faults.front());
  notes_.insert(notes_.end(), notes.begin(), notes.end());
  for (const Material& m : materials_) {
    const auto is_idle = [&](const BodySpec& b) {
      return b.material == m.name && info_of(b.kind).resistance != Resistance::beams;
    };
    if (m.band && std::any_of(bodies_.begin(), bodies_.end(), is_idle))
      notes_.push_back(fmt::format(
          "material '{}': its band_damping acts only in members of frames; its other bodies have no band damping",
          m.name));
  }
  return model;
}

std::vector<std::string> ModelBuilder::faults() const {
  std::vector<std::string> faults, notes;
  assemble(faults, notes);
  return faults;
}

/// Each part is tried, so that all faults are found; the result is valid only if there is none. Without bearings and
/// seats.
Model<2> ModelBuilder::assemble_bodies(std::vector<std::string>& faults) const {
  Model<2> model;
  attempt(faults, [&] { model.thickness = require_positive(thickness, "model: thickness", "m"); });
  attempt(faults, [&] { model.mass_damping = require_not_negative(mass_damping, "model: mass_damping", "1/s"); });
  model.gravity.field = gravity;
  model.impact_speed = impact_speed;
  model.apart_time = apart_time;
  model.still_speed = still_speed;
  model.still_time = still_time;
  if (bodies_.empty()) faults.emplace_back("model: there is no body; add at least one");
  for (const BodySpec& spec : bodies_) attempt(faults, [&] { append_body(spec, model); });
  const bool whole = faults.empty();
  rules_.check(bodies_, materials_, faults);
  check_crack_laws(faults);
  if (!whole) return model;
  model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
  model.drive_of.assign(model.mass.size(), {-1, -1, -1});
  attempt(faults, [&] { rules_.fill(model); });
  find_thickness(model);
  if (!model.skin_after.empty()) fill_lines(model);
  return model;
}

Model<2> ModelBuilder::assemble(std::vector<std::string>& faults, std::vector<std::string>& notes) const {
  Model<2> model = assemble_bodies(faults);
  if (model.drive_of.empty()) return model;  // some body has a fault
  for (const BearingSpec& spec : bearings_) attempt(faults, [&] { append_bearing(spec, model); });
  for (std::size_t i = 0; model.bearings.size() == bearings_.size() && i < bearings_.size(); ++i)
    attempt(faults, [&] { check_successor(model.bearings, i); });
  for (const SeatSpec& spec : seats_) attempt(faults, [&] { append_seat(spec, model); });
  check_overlaps(model, overlap_allowed, faults, notes);
  std::vector<std::string> unjudged;
  check_held_up_and_gaps(model, floating_bodies(bodies_), judge_standing ? faults : unjudged, notes);
  attempt(faults, [&] { set_bounds(model, bounds); });
  return model;
}

namespace {

/// Index of `solid` in the model's table; it is added if it is missing.
int solid_index(Model<2>& model, const Solid& solid) {
  for (std::size_t i = 0; i < model.solids.size(); ++i)
    if (model.solids[i] == solid) return static_cast<int>(i);
  model.solids.push_back(solid);
  return static_cast<int>(model.solids.size()) - 1;
}

double mesh_area(const Mesh& mesh) {
  double area = 0;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) area += signed_area(corners_of(mesh, e));
  return area;
}

/// Appends a node without rotation at `place`, for a body with the initial motion of `spec` about `centre`.
void append_node(const BodySpec& spec, const Vec2& place, const Vec2& centre, Model<2>& model) {
  std::array<Support, 3> support{spec.support[0], spec.support[1], Support::fixed};
  for (const NodeSupport& hold : spec.supports)
    for (const int k : {0, 1})
      if (is_supported_at(hold, place) && hold.support[k] != Support::free) support[k] = hold.support[k];
  model.skin_place.push_back(Vec2::Zero());
  model.skin_node.push_back(model.nodes());
  model.skin_turn.push_back(model.nodes());
  model.mass.push_back(0);
  model.inertia.push_back(0);
  model.support.push_back(support);
  model.start_position.push_back(place);
  model.start_rotation.push_back(0);
  model.start_velocity.emplace_back(spec.velocity + cross(spec.spin, Vec2(place - centre)));
  model.start_spin.push_back(0);
  model.load.push_back(Vec2::Zero());
}

}  // namespace

void ModelBuilder::append_deformable(const BodySpec& spec, Model<2>& model) const {
  const Mesh& mesh = *spec.mesh;
  const int index = static_cast<int>(model.bodies.size()), first = model.nodes();
  const Vec2 centre = polygon_moments(spec.outline).centroid;
  Body body;
  body.name = spec.name;
  body.kind = spec.kind;
  body.material = spec.material;
  body.groups = spec.groups;
  body.area = mesh_area(mesh);
  body.first_node = first;
  body.nodes = body.skins = static_cast<int>(mesh.node.size());
  body.first_skin = static_cast<int>(model.skin_place.size());
  body.outline = static_cast<int>(spec.outline.size());
  body.first_piece = model.pieces();
  double radius = 0;
  for (const Vec2& place : mesh.node) {
    append_node(spec, place, centre, model);
    radius = std::max(radius, (place - centre).norm());
  }
  model.body_radius.push_back(radius);
  model.bodies.push_back(body);
  model.element_bound.emplace_back();
  const auto material =
      std::find_if(materials_.begin(), materials_.end(), [&](const Material& m) { return m.name == spec.material; });
  const double wide = spec.thickness.value_or(thickness), mass = mass_of(spec, body.area, thickness, materials_);
  Element element;
  element.body = index;
  element.solid = solid_index(model, *material->solid);
  element.thickness = wide;
  for (const auto& corners : mesh.element) {
    element.nodes = corners_of(corners);
    for (int i = 0; i < max_element_nodes; ++i) element.node[i] = i < element.nodes ? first + corners[i] : -1;
    append_element(model, element, mass / (body.area * wide));
  }
  std::copy(spec.node_mass.begin(), spec.node_mass.end(), model.mass.begin() + first);
  for (int n = first; n < first + body.nodes; ++n) model.load[n] = spec.load * (model.mass[n] / mass);
  append_element_pieces(mesh, false, index, model);
  model.bodies[index].pieces = model.pieces() - body.first_piece;
}

void ModelBuilder::append_body(const BodySpec& spec, Model<2>& model) const {
  if (spec.frame) {
    append_frame(spec, model);
    return;
  }
  if (info_of(spec.kind).resistance == Resistance::elements) {
    append_deformable(spec, model);
    return;
  }
  const PolygonMoments moments = moments_of(spec);
  const Polygon& skin = spec.mesh ? spec.mesh->node : spec.outline;
  const double mass = mass_of(spec, moments.area, thickness, materials_);
  Body body;
  body.name = spec.name;
  body.material = spec.material;
  body.groups = spec.groups;
  body.area = moments.area;
  body.first_node = model.nodes();
  body.first_skin = static_cast<int>(model.skin_place.size());
  body.skins = static_cast<int>(skin.size());
  body.outline = static_cast<int>(spec.outline.size());
  body.first_piece = model.pieces();
  model.mass.push_back(mass);
  model.inertia.push_back(spec.inertia.value_or(mass * moments.second_moment / moments.area));
  model.support.push_back(spec.support);
  model.start_position.push_back(moments.centroid);
  model.start_rotation.push_back(0);
  model.start_velocity.push_back(spec.velocity);
  model.start_spin.push_back(spec.spin);
  model.load.push_back(spec.load);
  double radius = 0;
  for (const Vec2& p : skin) {
    model.skin_place.emplace_back(p - moments.centroid);
    model.skin_node.push_back(body.first_node);
    model.skin_turn.push_back(body.first_node);
    radius = std::max(radius, (p - moments.centroid).norm());
  }
  model.body_radius.push_back(radius);
  model.element_bound.emplace_back();
  const auto index = static_cast<int>(model.bodies.size());
  model.bodies.push_back(std::move(body));
  if (spec.mesh)
    append_element_pieces(*spec.mesh, true, index, model);
  else
    append_pieces(spec.outline, index, model);
  model.bodies[index].pieces = model.pieces() - model.bodies[index].first_piece;
}

void ModelBuilder::append_pieces(const Polygon& outline, int body, Model<2>& model) const {
  const int first_skin = static_cast<int>(model.skin_place.size()) - static_cast<int>(outline.size());
  for (const ConvexPiece& piece : convex_parts(outline)) {
    const PieceEdges edges = piece_edges(outline, piece);
    if (edges.corner.size() > max_piece_corners)
      throw InputError(fmt::format("body '{}': a convex part has {} corners, at most {} are allowed; use fewer points",
                                   bodies_[body].name, edges.corner.size(), max_piece_corners));
    model.piece_body.push_back(body);
    model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
    for (std::size_t c = 0; c < edges.corner.size(); ++c) {
      model.corner_skin.push_back(first_skin + edges.corner[c]);
      model.edge_is_face.push_back(edges.is_face[c]);
      model.edge_corner.push_back(edges.flatness[c]);
    }
  }
}

}  // namespace trilith
