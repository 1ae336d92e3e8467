#include "results/reading/header_reading.hpp"

#include <algorithm>
#include <string_view>

#include "results/file/layout.hpp"
#include "results/reading/set_reading.hpp"

namespace trilith::results {
namespace {

Provenance read_provenance(hid_t file) {
  const h5::Handle group(H5Gopen2(file, "/provenance", H5P_DEFAULT), H5Gclose, "there is no /provenance");
  Provenance result;
  for (const ProvenanceText& entry : provenance_texts) {
    const bool later =
        std::ranges::find(later_provenance_texts, std::string_view(entry.name)) != later_provenance_texts.end();
    if (!later || H5Aexists(group.get(), entry.name) > 0) result.*entry.member = h5::read_text(group.get(), entry.name);
  }
  result.script = read_text_set(file, "/provenance/script");
  result.parameters = read_table<ParameterRow>(file, "/provenance/parameters", 2);
  result.motions = read_texts(file, "/provenance/motions");
  return result;
}

std::vector<Quantity> read_quantities(hid_t file, const char* path, const std::vector<std::string>& but) {
  const h5::Handle group(H5Gopen2(file, path, H5P_DEFAULT), H5Gclose, std::string("there is no ") + path);
  std::vector<Quantity> quantities;
  for (const std::string& name : h5::member_names(group.get())) {
    if (std::find(but.begin(), but.end(), name) != but.end()) continue;
    const h5::Handle set(H5Dopen2(group.get(), name.c_str(), H5P_DEFAULT), H5Dclose, "cannot open " + name);
    quantities.push_back({name, h5::read_text(set.get(), "units"), h5::read_text(set.get(), "description")});
  }
  return quantities;
}

template <class T>
std::vector<T> read_all(hid_t file, const std::string& path, int width = 1) {
  std::vector<hsize_t> shape;
  if (width > 1) shape.push_back(static_cast<hsize_t>(width));
  return read_rows<T>(file, path, 0, row_count(file, path), shape);
}

void read_model(hid_t file, Header& header) {
  const int dim = header.dim;
  header.bodies = read_table<BodyRow>(file, "/model/bodies", dim);
  header.laws = read_table<LawRow>(file, "/model/laws", dim);
  header.bearings = read_table<BearingRow>(file, "/model/bearings", dim);
  if (H5Lexists(file, "/model/joints", H5P_DEFAULT) > 0)
    header.joints = read_table<JointRow>(file, "/model/joints", dim);
  if (H5Lexists(file, "/model/members", H5P_DEFAULT) > 0) {
    header.members = read_table<MemberRow>(file, "/model/members", dim);
    header.beams = read_table<BeamRow>(file, "/model/beams", dim);
  }
  header.node_position = read_all<double>(file, "/model/node_position", dim);
  header.node_rotation =
      read_all<double>(file, dim == 2 ? "/model/node_angle" : "/model/node_quaternion", rotation_width(dim));
  header.node_mass = read_all<double>(file, "/model/node_mass");
  header.node_inertia = read_all<double>(file, "/model/node_inertia", spin_width(dim));
  header.vertices = read_all<double>(file, "/model/vertices", dim);
  header.vertex_node = read_all<std::int32_t>(file, "/model/vertex_node");
  if (H5Lexists(file, "/model/face_first", H5P_DEFAULT) > 0) {
    header.face_first = read_all<std::int32_t>(file, "/model/face_first");
    header.face_vertex = read_all<std::int32_t>(file, "/model/face_vertex");
  }
  if (H5Lexists(file, "/model/sphere_vertex", H5P_DEFAULT) > 0) {
    header.sphere_vertex = read_all<std::int32_t>(file, "/model/sphere_vertex");
    header.sphere_radius = read_all<double>(file, "/model/sphere_radius");
  }
  if (H5Lexists(file, "/model/element_body", H5P_DEFAULT) <= 0) return;
  header.element_node = read_all<std::int32_t>(file, "/model/element_node", 4);
  header.element_body = read_all<std::int32_t>(file, "/model/element_body");
}

/// Data sets of /frames that no other part of the header describes.
std::vector<Field> read_fields(hid_t file) {
  static const std::vector<std::string> known{
      "time",   "step",          "stage",         "position", "angle",         "quaternion",    "velocity",
      "spin",   "contact_first", "contact_count", "contacts", "bearing_state", "bearing_force", "bearing_displacement",
      "stress", "plastic"};
  std::vector<Field> fields;
  for (const Quantity& q : read_quantities(file, "/frames", known)) {
    const h5::Handle set(H5Dopen2(file, ("/frames/" + q.name).c_str(), H5P_DEFAULT), H5Dclose, "cannot open " + q.name);
    const std::vector<hsize_t> extents = h5::extents(set.get());
    if (extents.size() < 2 || extents.size() > 3) continue;
    fields.push_back({q.name, q.unit, q.description, static_cast<std::size_t>(extents[1]),
                      extents.size() == 3 ? static_cast<int>(extents[2]) : 1});
  }
  return fields;
}

}  // namespace

Header read_header(hid_t file) {
  Header header;
  header.dim = h5::read_int(file, "dim");
  if (header.dim != 2 && header.dim != 3) throw h5::Failure("attribute 'dim' is neither 2 nor 3");
  header.provenance = read_provenance(file);
  read_model(file, header);
  header.histories = read_quantities(file, "/histories", {"time"});
  header.energy_terms = read_quantities(file, "/energy", {"time", "residual"});
  header.with_velocity = H5Lexists(file, "/frames/velocity", H5P_DEFAULT) > 0;
  header.fields = read_fields(file);
  check_header(header);
  return header;
}

Frame read_frame(hid_t file, const Header& header, const Committed& committed, std::size_t index) {
  const auto row = static_cast<std::int64_t>(index);
  const auto one = [&]<class T>(T, const char* path) { return read_rows<T>(file, path, row, 1, {}).at(0); };
  const auto block = [&](const std::string& path, std::size_t rows, int width) {
    std::vector<hsize_t> shape = {rows};
    if (width > 1) shape.push_back(static_cast<hsize_t>(width));
    return read_rows<double>(file, "/frames/" + path, row, 1, shape);
  };
  const int dim = header.dim;
  const std::size_t nodes = header.node_count(), bearings = header.bearings.size();
  Frame frame;
  frame.time = one(double{}, "/frames/time");
  frame.step = one(std::int64_t{}, "/frames/step");
  frame.stage = one(std::int32_t{}, "/frames/stage");
  frame.position = block("position", nodes, dim);
  frame.rotation = block(dim == 2 ? "angle" : "quaternion", nodes, rotation_width(dim));
  if (header.with_velocity) {
    frame.velocity = block("velocity", nodes, dim);
    frame.spin = block("spin", nodes, spin_width(dim));
  }
  if (header.element_count() > 0) {
    frame.stress = block("stress", header.element_count(), 3);
    frame.plastic = block("plastic", header.element_count(), 1);
  }
  if (bearings > 0) {
    for (const std::int8_t state : read_rows<std::int8_t>(file, "/frames/bearing_state", row, 1, {bearings}))
      frame.bearing_state.push_back(static_cast<BearingState>(state));
    frame.bearing_force = block("bearing_force", bearings, dim);
    frame.bearing_displacement = block("bearing_displacement", bearings, dim);
  }
  for (const Field& f : header.fields) frame.fields.push_back(block(f.name, f.rows, f.width));
  const std::int64_t first = one(std::int64_t{}, "/frames/contact_first");
  const std::int32_t count = one(std::int32_t{}, "/frames/contact_count");
  if (first < 0 || count < 0 || first > committed.contacts - count)
    throw h5::Failure("/frames/contacts has fewer rows than were flushed");
  for (const ContactRow& contact : read_table<ContactRow>(file, "/frames/contacts", first, count, dim))
    frame.contacts.push_back(contact.contact);
  return frame;
}

}  // namespace trilith::results
