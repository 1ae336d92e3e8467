#include "results/file/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"

namespace trilith::results {
namespace {

void check_size(std::size_t given, std::size_t needed, const char* what) {
  if (given != needed)
    throw ResultsError(fmt::format("results header: {} has {} entries, needs {}", what, given, needed));
}

void check_finite(const std::vector<double>& values, const char* what) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad != values.end()) throw ResultsError(fmt::format("results header: {} holds {}", what, *bad));
}

void check_slice(std::int32_t first, std::int32_t count, std::size_t size, const BodyRow& body, const char* what) {
  const bool inside =
      first >= 0 && count >= 0 && static_cast<std::size_t>(first) + static_cast<std::size_t>(count) <= size;
  if (!inside) throw ResultsError(fmt::format("results header: body '{}' has {} outside the list", body.name, what));
}

void check_names(const std::vector<Quantity>& quantities, const char* kind, std::set<std::string> taken) {
  for (const Quantity& quantity : quantities) {
    const std::string& name = quantity.name;
    if (name.empty()) throw InputError(fmt::format("a {} has no name", kind));
    if (name == "." || name.find('/') != std::string::npos || name != h5::clean(name))
      throw InputError(
          fmt::format("{} '{}': a name must be UTF-8 text without '/', and not '.'; use e.g. '_' or '.' between words",
                      kind, h5::clean(name)));
    if (!taken.insert(name).second)
      throw InputError(fmt::format("{} '{}': the name is taken; choose another", kind, name));
  }
}

template <class Row>
void write_rows(hid_t file, const SetText& text, const std::vector<Row>& rows, int dim) {
  const TableType type = table_type(rows, dim);
  std::vector<std::byte> records(type.size * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) pack(type, dim, rows[i], records.data() + i * type.size);
  write_table(file, text, type, rows.size(), records.data());
}

void write_provenance(hid_t file, const Provenance& from) {
  make_group(file, "/provenance", "origin of this file");
  const h5::Handle group(H5Gopen2(file, "/provenance", H5P_DEFAULT), H5Gclose, "cannot open /provenance");
  for (const ProvenanceText& entry : provenance_texts) h5::write_attribute(group.get(), entry.name, from.*entry.member);
  write_text(file, {"/provenance/script", "", "full text of the script"}, from.script);
  write_rows(file, {"/provenance/parameters", "", "parameters of the script, as text"}, from.parameters, 2);
  write_texts(file, {"/provenance/motions", "", "ground motions used"}, from.motions);
}

void write_spheres(hid_t file, const Header& header) {
  write_numbers(file, {"/model/sphere_vertex", "1", "row of /model/vertices of the centre of each sphere"}, Kind::int32,
                {header.sphere_vertex.size()}, header.sphere_vertex.data());
  write_numbers(file, {"/model/sphere_radius", "m", "radius of each sphere"}, Kind::real, {header.sphere_radius.size()},
                header.sphere_radius.data());
}

void write_faces(hid_t file, const Header& header) {
  write_numbers(file, {"/model/face_first", "1", "where the loop of each face begins in face_vertex, and the end"},
                Kind::int32, {header.face_first.size()}, header.face_first.data());
  write_numbers(file, {"/model/face_vertex", "1", "rows of vertices, face after face, anticlockwise from outside"},
                Kind::int32, {header.face_vertex.size()}, header.face_vertex.data());
}

void write_model(hid_t file, const Header& header) {
  const auto dim = static_cast<hsize_t>(header.dim);
  const hsize_t nodes = header.node_count(), points = header.vertex_node.size();
  const auto turns = static_cast<hsize_t>(rotation_width(header.dim)),
             spins = static_cast<hsize_t>(spin_width(header.dim));
  const auto shape = [](hsize_t rows, hsize_t width) {
    return width == 1 ? std::vector<hsize_t>{rows} : std::vector<hsize_t>{rows, width};
  };
  make_group(file, "/model", "data that does not change during a run");
  write_rows(file, {"/model/bodies", "", "bodies"}, header.bodies, header.dim);
  write_rows(file, {"/model/laws", "", "materials and contact laws"}, header.laws, header.dim);
  write_rows(file, {"/model/bearings", "", "bearings"}, header.bearings, header.dim);
  if (!header.joints.empty())
    write_rows(file, {"/model/joints", "", "faces that lie on each other at the start"}, header.joints, header.dim);
  if (!header.members.empty()) {
    write_rows(file, {"/model/members", "", "members of frames"}, header.members, header.dim);
    write_rows(file, {"/model/beams", "", "beam elements of the members, in order"}, header.beams, header.dim);
  }
  write_numbers(file, {"/model/node_position", "m", "position of each node at the start"}, Kind::real, {nodes, dim},
                header.node_position.data());
  write_numbers(file,
                {header.dim == 2 ? "/model/node_angle" : "/model/node_quaternion", header.dim == 2 ? "rad" : "1",
                 "rotation of each node at the start"},
                Kind::real, shape(nodes, turns), header.node_rotation.data());
  write_numbers(file, {"/model/node_mass", "kg", "mass of each node"}, Kind::real, {nodes}, header.node_mass.data());
  write_numbers(file, {"/model/node_inertia", "kg m^2", "moment of inertia of each node about itself"}, Kind::real,
                shape(nodes, spins), header.node_inertia.data());
  write_numbers(file, {"/model/vertices", "m", "outline points in body axes, from their node"}, Kind::real,
                {points, dim}, header.vertices.data());
  write_numbers(file, {"/model/vertex_node", "1", "node of each outline point"}, Kind::int32, {points},
                header.vertex_node.data());
  if (header.face_count() > 0) write_faces(file, header);
  if (!header.sphere_vertex.empty()) write_spheres(file, header);
  if (header.element_count() == 0) return;
  write_numbers(file, {"/model/element_node", "1", "nodes of each finite element, -1 after a triangle's third"},
                Kind::int32, {header.element_count(), 4}, header.element_node.data());
  write_numbers(file, {"/model/element_body", "1", "row of /model/bodies of each finite element"}, Kind::int32,
                {header.element_count()}, header.element_body.data());
}

std::string longest_name(const std::vector<BodyRow>& bodies) {
  std::string longest;
  for (const BodyRow& body : bodies)
    if (body.name.size() > longest.size()) longest = body.name;
  return longest;
}

// Wide enough for the longest names of bodies and bearings.
TableType event_type(const Header& header) {
  EventRow widest;
  widest.body_a_name = widest.body_b_name = longest_name(header.bodies);
  for (const BearingRow& bearing : header.bearings)
    if (bearing.name.size() > widest.bearing_name.size()) widest.bearing_name = bearing.name;
  return table_type<EventRow>({widest}, header.dim);
}

// Text columns of a growing table have the least width that `describe` declares.
template <class Row>
TableType plain_type(int dim) {
  return table_type<Row>({}, dim);
}

// Groups must exist before the members of Layout are created in them.
hid_t with_groups(hid_t file) {
  make_group(file, "/frames", "motion, contact forces and bearings at an interval");
  make_group(file, "/histories", "named quantities over time, all sampled at /histories/time");
  make_group(file, "/energy", "terms of the energy balance");
  make_group(file, "/motions", "ground motions that bodies followed");
  make_group(file, "/modes", "natural modes, as they were found");
  return file;
}

std::vector<GrowingSet> columns(hid_t file, const std::string& group, const char* counter,
                                const std::vector<Quantity>& quantities) {
  std::vector<GrowingSet> sets;
  for (const Quantity& quantity : quantities)
    sets.emplace_back(file, SetText{group + quantity.name, quantity.unit, quantity.description}, counter, Kind::real,
                      std::vector<hsize_t>{});
  return sets;
}

std::vector<hsize_t> per_node(const Header& header, int width) {
  if (width == 1) return {header.node_count()};
  return {header.node_count(), static_cast<hsize_t>(width)};
}

std::vector<hsize_t> per_bearing(const Header& header) {
  return {header.bearings.size(), static_cast<hsize_t>(header.dim)};
}

/// Each sphere must refer to a point of some body.
void check_spheres(const Header& header) {
  check_size(header.sphere_radius.size(), header.sphere_vertex.size(), "sphere_radius");
  if (header.dim != 3 && !header.sphere_vertex.empty())
    throw ResultsError("results header: bodies in the plane have no spheres");
  for (std::size_t s = 0; s < header.sphere_vertex.size(); ++s) {
    const std::int32_t vertex = header.sphere_vertex[s];
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= header.vertex_node.size())
      throw ResultsError(
          fmt::format("results header: sphere {} has the centre vertex {}, which does not exist", s, vertex));
    if (!(header.sphere_radius[s] > 0) || !std::isfinite(header.sphere_radius[s]))
      throw ResultsError(
          fmt::format("results header: sphere {} has a radius of {}, must be above 0", s, header.sphere_radius[s]));
  }
}

/// Consecutive loops, each with 3 corners or more of the body that owns the face.
void check_faces(const Header& header) {
  const std::vector<std::int32_t>& first = header.face_first;
  const auto loops = static_cast<std::int32_t>(header.face_vertex.size());
  if (header.dim != 3 && !(first.empty() && loops == 0))
    throw ResultsError("results header: bodies in the plane have no faces");
  if (!first.empty() && (first.front() != 0 || first.back() != loops))
    throw ResultsError(fmt::format("results header: face_first runs from {} to {}, must be 0 to {}", first.front(),
                                   first.back(), loops));
  if (first.empty()) check_size(header.face_vertex.size(), 0, "face_vertex");
  // All loops first, so that none of the loops below begins or ends outside of the list.
  for (std::size_t f = 0; f < header.face_count(); ++f)
    if (first[f + 1] - std::int64_t{first[f]} < 3)
      throw ResultsError(
          fmt::format("results header: face {} has {} corners, needs 3", f, first[f + 1] - std::int64_t{first[f]}));
  for (const BodyRow& body : header.bodies) {
    check_slice(body.first_face, body.face_count, header.face_count(), body, "faces");
    if (body.face_count == 0) continue;
    const auto begin = header.face_vertex.begin();
    const auto outside = std::find_if(
        begin + first[body.first_face], begin + first[body.first_face + body.face_count],
        [&](std::int32_t v) { return v < body.first_vertex || v >= body.first_vertex + body.vertex_count; });
    if (outside != begin + first[body.first_face + body.face_count])
      throw ResultsError(fmt::format("results header: a face of body '{}' has corner {}, which is not the body's",
                                     body.name, *outside));
  }
}

/// Members must own consecutive beams of existing nodes.
void check_members(const Header& header) {
  const auto bodies = static_cast<std::int32_t>(header.bodies.size()),
             nodes = static_cast<std::int32_t>(header.node_count()),
             members = static_cast<std::int32_t>(header.members.size());
  for (const MemberRow& m : header.members) {
    if (m.body < 0 || m.body >= bodies)
      throw ResultsError(fmt::format("results header: member '{}' belongs to body {} of {}", m.name, m.body, bodies));
    const std::int64_t end = std::int64_t{m.first_beam} + m.beam_count;
    if (m.first_beam < 0 || m.beam_count < 1 || end > static_cast<std::int64_t>(header.beams.size()))
      throw ResultsError(fmt::format("results header: member '{}' has beams outside the list", m.name));
  }
  for (const BeamRow& b : header.beams)
    if (b.member < 0 || b.member >= members || std::min(b.node_a, b.node_b) < 0 ||
        std::max(b.node_a, b.node_b) >= nodes || !(b.length > 0))
      throw ResultsError(fmt::format("results header: a beam of member {} joins nodes {} and {} over {} m", b.member,
                                     b.node_a, b.node_b, b.length));
}

}  // namespace

void check_header(const Header& header) {
  if (header.dim != 2 && header.dim != 3)
    throw ResultsError(fmt::format("results header: dim is {}, must be 2 or 3", header.dim));
  const auto dim = static_cast<std::size_t>(header.dim);
  const std::size_t nodes = header.node_count(), points = header.vertex_node.size();
  if (nodes == 0) throw ResultsError("results header: there is no node; a model needs at least one body");
  check_size(header.node_position.size(), nodes * dim, "node_position");
  check_size(header.node_rotation.size(), nodes * static_cast<std::size_t>(rotation_width(header.dim)),
             "node_rotation");
  check_size(header.node_inertia.size(), nodes * static_cast<std::size_t>(spin_width(header.dim)), "node_inertia");
  check_size(header.vertices.size(), points * dim, "vertices");
  check_finite(header.node_position, "node_position");
  check_finite(header.node_rotation, "node_rotation");
  check_finite(header.node_mass, "node_mass");
  check_finite(header.node_inertia, "node_inertia");
  check_finite(header.vertices, "vertices");
  for (const BodyRow& body : header.bodies) {
    check_slice(body.first_node, body.node_count, nodes, body, "nodes");
    check_slice(body.first_vertex, body.vertex_count, points, body, "vertices");
  }
  for (const std::int32_t node : header.vertex_node)
    if (node < 0 || static_cast<std::size_t>(node) >= nodes)
      throw ResultsError(fmt::format("results header: an outline point belongs to node {} of {}", node, nodes));
  check_faces(header);
  check_spheres(header);
  const auto bodies = static_cast<std::int32_t>(header.bodies.size());
  for (const BearingRow& bearing : header.bearings)
    if (std::min(bearing.body_a, bearing.body_b) < 0 || std::max(bearing.body_a, bearing.body_b) >= bodies)
      throw ResultsError(fmt::format("results header: bearing '{}' joins bodies {} and {} of {}", bearing.name,
                                     bearing.body_a, bearing.body_b, bodies));
  check_size(header.element_node.size(), 4 * header.element_count(), "element_node");
  for (const std::int32_t body : header.element_body)
    if (body < 0 || body >= bodies)
      throw ResultsError(fmt::format("results header: an element belongs to body {} of {}", body, bodies));
  for (const std::int32_t node : header.element_node)
    if (node < -1 || node >= static_cast<std::int32_t>(nodes))
      throw ResultsError(fmt::format("results header: an element has node {} of {}", node, nodes));
  for (const JointRow& joint : header.joints)
    if (std::min(joint.body_a, joint.body_b) < 0 || std::max(joint.body_a, joint.body_b) >= bodies)
      throw ResultsError(
          fmt::format("results header: a joint of bodies {} and {} of {}", joint.body_a, joint.body_b, bodies));
  check_members(header);
  check_names(header.histories, "history", {"time"});
  check_names(header.energy_terms, "energy term", {"time", "residual"});
}

void write_header(hid_t file, const Header& header) {
  h5::write_attribute(file, "format", "trilith");
  h5::write_attribute(file, "format_version", format_version);
  h5::write_attribute(file, "finished", 0);
  h5::write_attribute(file, "dim", header.dim);
  write_provenance(file, header.provenance);
  write_model(file, header);
}

Layout::Layout(hid_t file, const Header& h)
    : time(with_groups(file), {"/frames/time", "s", "time of each frame"}, "frames", Kind::real, {}),
      step(file, {"/frames/step", "1", "number of steps before each frame"}, "frames", Kind::int64, {}),
      stage(file, {"/frames/stage", "1", "row of /stages"}, "frames", Kind::int32, {}),
      position(file, {"/frames/position", "m", "position of each node"}, "frames", Kind::real, per_node(h, h.dim)),
      rotation(file,
               {h.dim == 2 ? "/frames/angle" : "/frames/quaternion", h.dim == 2 ? "rad" : "1",
                h.dim == 2 ? "rotation of each node, anticlockwise" : "rotation of each node: w, x, y, z"},
               "frames", Kind::real, per_node(h, rotation_width(h.dim))),
      contact_first(file, {"/frames/contact_first", "1", "first row of /frames/contacts of each frame"}, "frames",
                    Kind::int64, {}),
      contact_count(file, {"/frames/contact_count", "1", "rows of /frames/contacts of each frame"}, "frames",
                    Kind::int32, {}),
      contacts(file, {"/frames/contacts", "", "contact forces of all frames, frame after frame"}, "contacts",
               plain_type<ContactRow>(h.dim)),
      history_time(file, {"/histories/time", "s", "time of each sample"}, "histories", Kind::real, {}),
      histories(columns(file, "/histories/", "histories", h.histories)),
      energy_time(file, {"/energy/time", "s", "time of each row"}, "energy", Kind::real, {}),
      energy_terms(columns(file, "/energy/", "energy", h.energy_terms)),
      energy_residual(file, {"/energy/residual", "J", "error of the energy balance"}, "energy", Kind::real, {}),
      events(file, {"/events", "", "events in the order of their times"}, "events", event_type(h)),
      stages(file, {"/stages", "", "stages of the run"}, "stages", plain_type<StageRow>(h.dim)),
      notes(file, {"/provenance/notes", "", "notes and warnings"}, "notes", plain_type<NoteRow>(h.dim)),
      modes(file, {"/modes/list", "", "natural modes, in the order of their computation"}, "modes",
            plain_type<ModeRow>(h.dim)),
      mode_position(file, {"/modes/position", "m", "position of each node at the time of the mode"}, "modes",
                    Kind::real, per_node(h, h.dim)),
      mode_rotation(file,
                    {h.dim == 2 ? "/modes/angle" : "/modes/quaternion", h.dim == 2 ? "rad" : "1",
                     "rotation of each node at the time of the mode"},
                    "modes", Kind::real, per_node(h, rotation_width(h.dim))),
      mode_displacement(file, {"/modes/displacement", "1/sqrt(kg)", "of each node; phi' M phi = 1"}, "modes",
                        Kind::real, per_node(h, h.dim)),
      mode_turn(file, {"/modes/rotation", "1/(m sqrt(kg))", "of each node, to the same scale"}, "modes", Kind::real,
                per_node(h, spin_width(h.dim))),
      motions(file, {"/motions/list", "", "each body and direction that a motion moved"}, "motions",
              plain_type<MotionRow>(h.dim)),
      motion_acceleration(file, {"/motions/acceleration", "m/s2", "samples of all motions, one after the other"},
                          "motion_samples", Kind::real, {}) {
  if (h.with_velocity) {
    velocity.emplace(file, SetText{"/frames/velocity", "m/s", "velocity of each node"}, "frames", Kind::real,
                     per_node(h, h.dim));
    spin.emplace(file, SetText{"/frames/spin", "rad/s", "angular velocity of each node"}, "frames", Kind::real,
                 per_node(h, spin_width(h.dim)));
  }
  if (h.element_count() > 0) {
    stress.emplace(file, SetText{"/frames/stress", "Pa", "mean stress of each element: xx, yy, xy, world axes"},
                   "frames", Kind::real, std::vector<hsize_t>{h.element_count(), 3});
    plastic.emplace(file, SetText{"/frames/plastic", "1", "mean plastic strain measure of each element"}, "frames",
                    Kind::real, std::vector<hsize_t>{h.element_count()});
  }
  for (const Field& f : h.fields)
    fields.emplace_back(
        file, SetText{"/frames/" + f.name, f.unit, f.description}, "frames", Kind::real,
        f.width == 1 ? std::vector<hsize_t>{f.rows} : std::vector<hsize_t>{f.rows, static_cast<hsize_t>(f.width)});
  if (h.bearings.empty()) return;
  bearing_state.emplace(file,
                        SetText{"/frames/bearing_state", "1", "0 intact, 1 yielded, 2 failed, 3 changed, 4 waiting"},
                        "frames", Kind::int8, std::vector<hsize_t>{h.bearings.size()});
  bearing_force.emplace(file, SetText{"/frames/bearing_force", "N", "force on body b of each bearing, world axes"},
                        "frames", Kind::real, per_bearing(h));
  bearing_displacement.emplace(
      file, SetText{"/frames/bearing_displacement", "m", "point b relative to point a, from the start"}, "frames",
      Kind::real, per_bearing(h));
}

std::vector<GrowingSet*> Layout::sets() {
  std::vector<GrowingSet*> all = {&contacts.set, &time,     &step,          &stage,
                                  &position,     &rotation, &contact_first, &contact_count};
  for (auto* set : {&velocity, &spin, &stress, &plastic, &bearing_state, &bearing_force, &bearing_displacement})
    if (*set) all.push_back(&**set);
  for (GrowingSet& set : fields) all.push_back(&set);
  all.push_back(&history_time);
  for (GrowingSet& set : histories) all.push_back(&set);
  all.push_back(&energy_time);
  for (GrowingSet& set : energy_terms) all.push_back(&set);
  for (GrowingSet* set : {&energy_residual, &events.set, &stages.set, &notes.set, &modes.set, &mode_position,
                          &mode_rotation, &mode_displacement, &mode_turn, &motions.set, &motion_acceleration})
    all.push_back(set);
  return all;
}

void write_seal(hid_t file, const std::vector<SealRow>& rows, int dim) {
  write_rows(file, {"/seal", "", "checks of the run, made while it ran"}, rows, dim);
}

}  // namespace trilith::results
