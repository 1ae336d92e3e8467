#include "model/space_builder/solid_model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "model/bounds.hpp"
#include "model/builder/extend.hpp"
#include "model/check/check.hpp"
#include "model/check/frame_plausibility.hpp"
#include "model/check/piece_overlaps.hpp"
#include "model/check/small_gaps.hpp"
#include "model/check/sphere_laws.hpp"
#include "model/names.hpp"
#include "model/plausible_ranges.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {

void SolidModelBuilder::add_material(const Material& material) {
  check_material(material, materials_, notes_);
  materials_.push_back(material);
}

void SolidModelBuilder::add_law(const std::string& name, const ContactLaw& law) {
  rules_.add_law(name, law, notes_);
}

void SolidModelBuilder::take_contacts(const ContactRules& rules) {
  rules_ = rules;
}

double SolidModelBuilder::density_of(const SolidSpec& spec) const {
  const std::string owner = fmt::format("body '{}'", spec.name);
  if (spec.density && spec.mass) throw InputError(owner + ": both density and mass are given; keep one");
  if (spec.density) return require_positive(*spec.density, owner + ": density", "kg/m3");
  if (spec.mass)
    return require_positive(*spec.mass, owner + ": mass", "kg") / (spec.mesh ? volume_of(*spec.mesh)
                                                                   : spec.moments
                                                                       ? spec.moments->volume
                                                                       : mass_of(spec.pieces, 1, spec.spheres).mass);
  for (const Material& m : materials_)
    if (m.name == spec.material) return m.density;
  throw InputError(fmt::format("{}: give a density or mass, or a material that has a density", owner));
}

namespace {

/// Physically possible moments of inertia: above 0, and none above the sum of the other two.
void check_inertia(const SolidSpec& spec, const std::string& owner) {
  if (spec.frame || spec.deforms())
    throw InputError(owner + ": inertia is for rigid bodies; the inertia of a deformable body follows from its nodes");
  const Vec3& i = *spec.inertia;
  for (const double v : i) require_positive(v, owner + ": inertia", "kg m2");
  const double most = i.maxCoeff(), others = i.sum() - most;
  if (most > others * (1 + 1e-9))
    throw InputError(
        fmt::format("{}: inertia is {{{:g}, {:g}, {:g}}} kg m2, but no moment may exceed the sum of the other two; "
                    "give moments about x, y and z through its centroid",
                    owner, i.x(), i.y(), i.z()));
}

/// Sides of the axis-aligned box around all pieces [m].
Vec3 sides_of(const std::vector<Polyhedron>& pieces) {
  Vec3 low = pieces[0].corners[0], high = low;
  for (const Polyhedron& piece : pieces)
    for (const Vec3& x : piece.corners) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return high - low;
}

/// A note on sizes that are probably in mm. Fixed bodies may be ground, which extends far.
void note_sides(const SolidSpec& spec, const std::string& owner, std::vector<std::string>& notes) {
  for (const Sphere& sphere : spec.spheres)
    add_plausibility_note_once(notes, owner, "least side", "m", 2 * sphere.radius);
  if (spec.pieces.empty() || spec.frame) return;
  const Vec3 sides = sides_of(spec.pieces);
  add_plausibility_note_once(notes, owner, "least side", "m", sides.minCoeff());
  if (spec.support[0] == Support::free)
    add_plausibility_note_once(notes, owner, "greatest side", "m", sides.maxCoeff());
}

/// A held degree of freedom does not move, whatever its given velocity.
void note_held_solid(const SolidSpec& spec, const std::string& owner, std::vector<std::string>& notes) {
  constexpr std::array names{"a velocity along x", "a velocity along y", "a velocity along z",
                             "a spin about x",     "a spin about y",     "a spin about z"};
  const auto known = [](const std::string& note) {
    return note.find("but is held in that direction") != std::string::npos;
  };
  if (std::any_of(notes.begin(), notes.end(), known)) return;
  for (int k = 0; k < 6; ++k)
    if ((k < 3 ? spec.velocity[k] : spec.spin[k - 3]) != 0 &&
        spec.support[static_cast<std::size_t>(k)] != Support::free)
      notes.push_back(fmt::format(
          "{}: it is given {}, but is held in that direction and does not move; free that direction or leave it out",
          owner, names[static_cast<std::size_t>(k)]));
}

struct PieceBox {
  Vec3 low, high;
};

PieceBox piece_box(const Polyhedron& piece) {
  PieceBox box{piece.corners[0], piece.corners[0]};
  for (const Vec3& x : piece.corners) box.low = box.low.cwiseMin(x), box.high = box.high.cwiseMax(x);
  return box;
}

/// A piece whose box is farther from all others than its own size is probably misplaced, or a separate body: no visible
/// part connects it to the rest.
void note_lone_piece(const SolidSpec& spec, const std::string& owner, std::vector<std::string>& notes) {
  if (spec.frame || spec.mesh || spec.pieces.size() < 2 || !spec.spheres.empty()) return;
  std::vector<PieceBox> boxes;
  for (const Polyhedron& piece : spec.pieces) boxes.push_back(piece_box(piece));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    double nearest = unbounded;
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (j != i)
        nearest = std::min(
            nearest,
            (boxes[i].low - boxes[j].high).cwiseMax(boxes[j].low - boxes[i].high).cwiseMax(Vec3::Zero()).norm());
    const double size = (boxes[i].high - boxes[i].low).norm();
    if (!(nearest > size)) continue;
    notes.push_back(
        fmt::format("{}: its piece {} of {:.3g} m is {:.3g} m away from all others, but moves rigidly with them; move "
                    "it, or make it a separate body",
                    owner, i + 1, size, nearest));
    return;
  }
}

}  // namespace

void SolidModelBuilder::add_body(SolidSpec spec) {
  require_name(spec.name, "body");
  body_names_known_.require_new(bodies_, spec.name, "body");
  const std::string owner = fmt::format("body '{}'", spec.name);
  if (spec.frame) check_frame(spec, owner);
  if (spec.frame && spec.deforms()) throw InputError(owner + ": members of a frame always deform; leave out body");
  if (!spec.supports.empty() && !spec.deforms() && !spec.frame)
    throw InputError(owner + ": hold is for nodes of deformable bodies; give support, or body = \"brick\"");
  if (spec.deforms()) check_mesh_body(spec, owner);
  if (spec.pieces.empty() && spec.spheres.empty()) throw InputError(owner + " has no piece; it needs at least one");
  for (std::size_t s = 0; s < spec.spheres.size(); ++s)
    check_sphere(spec.spheres[s], spec.spheres.size() == 1 ? owner : fmt::format("{}, sphere {}", owner, s + 1));
  for (std::size_t p = 0; p < spec.pieces.size() && !spec.frame && !spec.mesh; ++p)
    check_convex(spec.pieces[p], spec.pieces.size() == 1 ? owner : fmt::format("{}, piece {}", owner, p + 1));
  if (!spec.frame && !spec.mesh) refuse_overlapping_pieces(spec.pieces, overlap_allowed, owner);
  for (const Vec3* v : {&spec.velocity, &spec.spin, &spec.load})
    if (!v->allFinite()) throw InputError(owner + ": velocity, spin or load is not finite");
  if (!spec.material.empty()) require_material(materials_, spec.material, owner);
  (void)(spec.frame ? frame_body(spec).material.front().mass : density_of(spec));
  if (spec.density) add_plausibility_note_once(notes_, owner, "density", "kg/m3", *spec.density);
  note_sides(spec, owner, notes_);
  if (spec.frame) add_frame_plausibility_notes(*spec.frame, owner, notes_);
  if (spec.inertia) check_inertia(spec, owner);
  check_cracks(spec, owner);
  note_held_solid(spec, owner, notes_);
  note_lone_piece(spec, owner, notes_);
  bodies_.push_back(std::move(spec));
}

namespace {

/// For a rigid body support and steady load; for a frame or elements the load alone, by nodal masses, because the nodes
/// have their own supports.
void set_up(const SolidSpec& spec, Model<3>& model, const Body& body) {
  if (body.is_rigid()) {
    model.support[body.first_node] = spec.support, model.load[body.first_node] = spec.load;
    return;
  }
  double mass = 0;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) mass += model.mass[n];
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    model.load[n] = spec.load * (model.mass[n] / mass);
}

}  // namespace

/// Faults are listed in the order of construction, so the first one causes others.
Model<3> SolidModelBuilder::assemble_bodies(std::vector<std::string>& faults) const {
  SpaceBuilder space;
  space.gravity(gravity);
  if (bodies_.empty()) faults.emplace_back("model: there is no body; add at least one");
  for (const SolidSpec& spec : bodies_)
    attempt(faults, [&] {
      if (spec.frame)
        space.add(frame_body(spec));
      else if (spec.mesh)
        space.add(mesh_body(spec));
      else
        space.add(SolidBody{spec.name, spec.pieces, density_of(spec), false, spec.velocity, spec.spin, 0, spec.spheres,
                            spec.moments, spec.inertia});
    });
  rules_.check(bodies_, materials_, faults);
  check_crack_laws(faults);
  if (!faults.empty()) return {};
  Model<3> model = space.build();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    model.bodies[b].material = bodies_[b].material, model.bodies[b].groups = bodies_[b].groups;
    // A part of one brick keeps the inertia of the nodal masses of its mesh, see model/element/one_element.hpp.
    if (bodies_[b].cracked_from >= 0 && bodies_[b].mesh) model.bodies[b].kind = BodyKind::mesh;
    set_up(bodies_[b], model, model.bodies[b]);
  }
  attempt(faults, [&] { rules_.fill(model); });
  complete_space(model);
  attempt(faults, [&] { model.mass_damping = require_not_negative(mass_damping, "model: mass_damping", "1/s"); });
  model.impact_speed = impact_speed, model.apart_time = apart_time;
  model.still_speed = still_speed, model.still_time = still_time;
  return model;
}

Model<3> SolidModelBuilder::assemble(std::vector<std::string>& faults, std::vector<std::string>& notes) const {
  Model<3> model = assemble_bodies(faults);
  if (model.bodies.empty()) return model;  // some body has a fault
  for (const BearingSpecOf<3>& spec : bearings_) attempt(faults, [&] { append_bearing(spec, model); });
  for (std::size_t i = 0; model.bearings.size() == bearings_.size() && i < bearings_.size(); ++i)
    attempt(faults, [&] { check_successor(model.bearings, i); });
  for (const SeatSpecOf<3>& spec : seats_) attempt(faults, [&] { append_seat(spec, model); });
  check_overlaps(model, overlap_allowed, faults, notes);
  std::vector<std::string> unjudged;
  check_held_up_and_gaps(model, floating_bodies(bodies_), judge_standing ? faults : unjudged, notes);
  note_sphere_laws(model, 0, notes);
  attempt(faults, [&] { set_bounds(model, bounds); });
  return model;
}

Model<3> SolidModelBuilder::extended(const Model<3>& model, const State<3>& state) {
  std::vector<std::string> faults, notes;
  Model<3> grown = assemble_bodies(faults);
  if (!faults.empty()) throw InputError(faults.front());
  carry_conditions(model, grown);
  append_links(model, state, grown);
  const Model<3> standing = as_it_stands(grown, state);
  note_sphere_laws(grown, static_cast<int>(model.bodies.size()), notes);
  check_newcomers(standing, state, overlap_allowed, floating_bodies(bodies_, judge_standing), faults, notes);
  if (!faults.empty()) throw InputError(faults.front());
  widen_bounds(standing, bounds, grown);
  notes_.insert(notes_.end(), notes.begin(), notes.end());
  return grown;
}

void SolidModelBuilder::shorten(std::size_t bodies, std::size_t bearings, std::size_t seats) {
  bodies_.resize(std::min(bodies, bodies_.size()));
  bearings_.resize(std::min(bearings, bearings_.size()));
  seats_.resize(std::min(seats, seats_.size()));
}

Model<3> SolidModelBuilder::build() {
  std::vector<std::string> faults, notes;
  Model<3> model = assemble(faults, notes);
  if (!faults.empty()) throw InputError(faults.front());
  notes_.insert(notes_.end(), notes.begin(), notes.end());
  for (const Material& m : materials_) {
    const auto is_idle = [&](const SolidSpec& b) { return b.material == m.name && !b.frame; };
    if (m.band && std::any_of(bodies_.begin(), bodies_.end(), is_idle))
      notes_.push_back(fmt::format(
          "material '{}': its band_damping acts only in members of frames; its other bodies have no band damping",
          m.name));
  }
  return model;
}

std::vector<std::string> SolidModelBuilder::faults() const {
  std::vector<std::string> faults, notes;
  assemble(faults, notes);
  return faults;
}

/// For a frame, and for elements, all nodes. Nodes of elements have no rotations.
void set_support(Model<3>& model, int body, int dof, Support support) {
  const Body& b = model.bodies[body];
  if (!b.nodes_turn() && dof >= 3) return;
  for (int node = b.first_node; node < b.first_node + b.nodes; ++node) {
    model.support[node][dof] = support;
    if (support != Support::driven) model.drive_of[node][dof] = -1;
  }
}

/// The initial displacement of the motion must not cause a jump of the ground. For a frame the held nodes follow; for
/// elements the held nodes, or all nodes if none is held.
void set_drive(Model<3>& model, int body, int dof, const std::shared_ptr<const GroundMotion>& motion, double start,
               double origin, const State<3>* state) {
  const Body& b = model.bodies[body];
  if (!b.is_rigid() && dof >= Space<3>::translations)
    throw InputError(
        fmt::format("body '{}' deforms and has no rotation to drive; drive x, y and z, or make it rigid", b.name));
  const std::vector<Vec3>& place = state != nullptr ? state->position : model.start_position;
  const auto is_held = [&](int node) { return model.support[node][dof] != Support::free; };
  bool all = b.is_rigid();
  if (!b.nodes_turn()) {
    all = true;
    for (int node = b.first_node; node < b.first_node + b.nodes; ++node) all = all && !is_held(node);
  }
  const auto held = [&](int node) { return all || is_held(node); };
  const double from = origin - motion->displacement(0);
  bool follows = false;
  for (int node = b.first_node; node < b.first_node + b.nodes; ++node) {
    if (!held(node)) continue;
    const double beside = node == b.first_node ? 0 : place[node][dof] - place[b.first_node][dof];
    model.support[node][dof] = Support::driven;
    model.drive_of[node][dof] = static_cast<int>(model.drives.size());
    model.drives.push_back({node, dof, from + beside, start, motion});
    follows = true;
  }
  if (!follows)
    throw InputError(fmt::format(
        "body '{}' is a frame and none of its joints is held along {}, so nothing follows the motion; give a joint "
        "support = \"fixed\"",
        b.name, "xyz"[dof]));
}

}  // namespace trilith
