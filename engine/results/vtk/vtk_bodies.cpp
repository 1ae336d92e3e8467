#include "results/vtk/vtk_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "results/file/body_mass.hpp"

namespace trilith::results {
namespace {

// Cell types of VTK.
constexpr std::int8_t vertex = 1, poly_vertex = 2, triangle = 5, polygon = 7, quad = 9, polyhedron = 42;

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

void append_vector(std::vector<double>& to, const Vec3& v) {
  to.insert(to.end(), {v.x(), v.y(), v.z()});
}

}  // namespace

void VtkBodies::Cells::close(std::int8_t kind, std::int32_t of_body, std::int32_t of_element) {
  ends.push_back(static_cast<std::int32_t>(corners.size()));
  face_ends.push_back(kind == polyhedron ? static_cast<std::int32_t>(faces.size()) : -1);
  kinds.push_back(kind);
  body.push_back(of_body);
  element.push_back(of_element);
}

VtkBodies::VtkBodies(const Header& header, const std::vector<bool>& left_out) : header_(&header) {
  std::vector<bool> meshed(header.bodies.size());
  for (const std::int32_t body : header.element_body) meshed[static_cast<std::size_t>(body)] = true;
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    if (left_out[i]) continue;
    const auto index = static_cast<std::int32_t>(i);
    if (meshed[i])
      add_elements(index);
    else if (header.bodies[i].face_count > 0)
      add_solid(header.bodies[i], index);
    else if (!header.sphere_vertex.empty() && header.dim == 3)
      continue;
    else
      add_outline(header.bodies[i], index);
  }
  for (std::size_t i = 0; i < header.bodies.size(); ++i)
    if (!left_out[i]) add_spheres(header.bodies[i], static_cast<std::int32_t>(i));
  const Frame first = start_frame(header);
  const Placement at(header, first);
  for (const Point& p : points_) start_.push_back(at.at(p.node, p.local));
  topology_ = {vtk_integers("connectivity", cells_.corners), vtk_integers("offsets", cells_.ends),
               vtk_bytes("types", cells_.kinds)};
  if (!cells_.faces.empty()) {
    topology_.push_back(vtk_integers("faces", cells_.faces));
    topology_.push_back(vtk_integers("faceoffsets", cells_.face_ends));
  }
  add_names();
}

/// A polyhedron: number of faces, then for each face the number of its corners, and their indices.
void VtkBodies::add_solid(const BodyRow& body, std::int32_t index) {
  const auto base = static_cast<std::int32_t>(points_.size()) - body.first_vertex;
  cells_.faces.push_back(body.face_count);
  for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
    const std::int32_t begin = header_->face_first[f], end = header_->face_first[f + 1];
    cells_.faces.push_back(end - begin);
    for (std::int32_t i = begin; i < end; ++i) cells_.faces.push_back(base + header_->face_vertex[i]);
  }
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    cells_.corners.push_back(base + v);
    const double* at = header_->vertices.data() + 3 * static_cast<std::size_t>(v);
    points_.push_back({header_->vertex_node[v], {at[0], at[1], at[2]}});
  }
  cells_.close(polyhedron, index, -1);
}

/// A point with a radius for each sphere: ParaView draws points as spheres with a radius from an array.
void VtkBodies::add_spheres(const BodyRow& body, std::int32_t index) {
  const auto end = header_->sphere_vertex.end();
  auto at = std::lower_bound(header_->sphere_vertex.begin(), end, body.first_vertex);
  for (; at != end && *at < body.first_vertex + body.vertex_count; ++at) {
    radius_.resize(points_.size());
    radius_.push_back(header_->sphere_radius[static_cast<std::size_t>(at - header_->sphere_vertex.begin())]);
    cells_.corners.push_back(static_cast<std::int32_t>(points_.size()));
    const double* local = header_->vertices.data() + 3 * static_cast<std::size_t>(*at);
    points_.push_back({header_->vertex_node[static_cast<std::size_t>(*at)], {local[0], local[1], local[2]}});
    cells_.close(vertex, index, -1);
  }
}

/// A polygon in the plane; in space, if a file contains no faces, only its corners.
void VtkBodies::add_outline(const BodyRow& body, std::int32_t index) {
  const bool plane = header_->dim == 2;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    cells_.corners.push_back(static_cast<std::int32_t>(points_.size()));
    const double* at = header_->vertices.data() + static_cast<std::size_t>(header_->dim) * static_cast<std::size_t>(v);
    points_.push_back({header_->vertex_node[v], {at[0], at[1], plane ? 0 : at[2]}});
  }
  cells_.close(plane ? polygon : poly_vertex, index, -1);
}

/// The finite elements of a deformable body, each a cell, between the body's nodes.
void VtkBodies::add_elements(std::int32_t index) {
  const BodyRow& body = header_->bodies[static_cast<std::size_t>(index)];
  const auto base = static_cast<std::int32_t>(points_.size()) - body.first_node;
  for (int n = body.first_node; n < body.first_node + body.node_count; ++n) points_.push_back({n, Vec3::Zero()});
  for (std::size_t e = 0; e < header_->element_count(); ++e) {
    if (header_->element_body[e] != index) continue;
    const std::int32_t* node = header_->element_node.data() + 4 * e;
    const int corners = node[3] < 0 ? 3 : 4;
    for (int k = 0; k < corners; ++k) cells_.corners.push_back(base + node[k]);
    cells_.close(corners == 3 ? triangle : quad, index, static_cast<std::int32_t>(e));
  }
}

/// Body, name, mass, a mark for fixed bodies, the first of its groups, and for each group its membership.
void VtkBodies::add_names() {
  std::set<std::string> groups;
  for (const BodyRow& body : header_->bodies)
    for (const std::string& word : words_of(body.groups)) groups.insert(word);
  std::vector<std::string> name, group;
  std::vector<double> mass;
  std::vector<std::int8_t> held;
  for (const std::int32_t i : cells_.body) {
    const BodyRow& body = header_->bodies[static_cast<std::size_t>(i)];
    const std::vector<std::string> in = words_of(body.groups);
    name.push_back(body.name);
    group.push_back(in.empty() ? body.material : in.front());
    held.push_back(!body.support.empty() && body.support.find("free") == std::string::npos);
    mass.push_back(mass_of(*header_, body));
  }
  fixed_ = {vtk_integers("body", cells_.body), vtk_texts("name", name), vtk_texts("group", group),
            vtk_bytes("held", held), vtk_numbers("mass", 1, mass)};
  for (const std::string& g : groups) {
    std::vector<std::int8_t> in;
    for (const std::int32_t i : cells_.body) {
      const std::vector<std::string> of_body = words_of(header_->bodies[static_cast<std::size_t>(i)].groups);
      in.push_back(std::find(of_body.begin(), of_body.end(), g) != of_body.end());
    }
    fixed_.push_back(vtk_bytes("in " + g, in));
  }
}

std::vector<double> VtkBodies::per_cell(const std::vector<double>& of_bodies, int width) const {
  std::vector<double> out;
  for (const std::int32_t body : cells_.body) {
    const auto from = of_bodies.begin() + static_cast<std::ptrdiff_t>(body) * width;
    out.insert(out.end(), from, from + width);
  }
  return out;
}

std::vector<double> VtkBodies::per_point(const std::vector<double>& of_nodes, int width) const {
  std::vector<double> out;
  for (const Point& p : points_) {
    const auto from = of_nodes.begin() + static_cast<std::ptrdiff_t>(p.node) * width;
    out.insert(out.end(), from, from + width);
  }
  return out;
}

std::string VtkBodies::file(const Frame& frame) const {
  const Placement at(*header_, frame);
  std::vector<double> place, displacement, velocity, turned;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& p = points_[i];
    const Vec3 now = at.at(p.node, p.local);
    append_vector(place, now);
    append_vector(displacement, now - start_[i]);
    if (header_->with_velocity) append_vector(velocity, at.velocity(p.node, now - at.node(p.node)));
  }
  for (const std::int32_t body : cells_.body)
    turned.push_back(at.turned(header_->bodies[static_cast<std::size_t>(body)].first_node));

  const VtkArray points = vtk_coordinates(place);
  std::vector<VtkArray> moving{vtk_numbers("displacement", 3, displacement)},
      of_cells{vtk_numbers("turned", 1, turned)};
  if (header_->with_velocity) moving.push_back(vtk_numbers("velocity", 3, velocity));
  for (std::size_t f = 0; f < header_->fields.size(); ++f) {
    const Field& field = header_->fields[f];
    if (field.rows == header_->node_count() && field.name.starts_with("node_"))
      moving.push_back(vtk_numbers(field.name, field.width, per_point(frame.fields[f], field.width)));
    if (field.rows == header_->bodies.size() && field.name.starts_with("body_"))
      of_cells.push_back(vtk_numbers(field.name, field.width, per_cell(frame.fields[f], field.width)));
  }
  if (header_->element_count() > 0) {
    std::vector<double> stress, plastic;
    for (const std::int32_t e : cells_.element) {
      for (int k = 0; k < 3; ++k) stress.push_back(e < 0 ? 0 : frame.stress[3 * static_cast<std::size_t>(e) + k]);
      plastic.push_back(e < 0 ? 0 : frame.plastic[static_cast<std::size_t>(e)]);
    }
    of_cells.push_back(vtk_numbers("stress", 3, stress));
    of_cells.push_back(vtk_numbers("plastic", 1, plastic));
  }
  std::vector<VtkSection> sections{{"PointData", {}}, {"CellData", {}}, {"Points", {&points}}, {"Cells", {}}};
  for (const VtkArray& a : moving) sections[0].arrays.push_back(&a);
  const VtkArray radius = vtk_numbers("radius", 1, radius_);
  if (!radius_.empty()) sections[0].arrays.push_back(&radius);
  for (const VtkArray& a : fixed_) sections[1].arrays.push_back(&a);
  for (const VtkArray& a : of_cells) sections[1].arrays.push_back(&a);
  for (const VtkArray& a : topology_) sections[3].arrays.push_back(&a);
  return vtk_file("UnstructuredGrid", {{"NumberOfPoints", points_.size()}, {"NumberOfCells", cells_.kinds.size()}},
                  sections, frame.time);
}

}  // namespace trilith::results
