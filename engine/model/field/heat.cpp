#include "model/field/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "load/water/pressure.hpp"
#include "model/contact/skin_places.hpp"
#include "model/element/element_rows.hpp"
#include "model/field/free_shapes.hpp"

namespace trilith {
namespace {

template <int D>
std::string owner_of_heat(const Model<D>& model, int body) {
  return fmt::format("heat of '{}'", model.bodies[static_cast<std::size_t>(body)].name);
}

void check_spec(const HeatSpec& spec, const Body& body, const std::string& owner) {
  require_not_negative(spec.conductivity, owner + ": conductivity", "W/(m K)");
  require_positive(spec.heat_capacity, owner + ": heat_capacity", "J/(kg K)");
  require_not_negative(spec.expansion, owner + ": expansion", "1/K");
  for (const double t : {spec.temperature, spec.reference})
    if (!std::isfinite(t)) throw InputError(owner + ": a temperature is not finite");
  if (body.is_rigid() && spec.expansion > 0)
    throw InputError(owner +
                     ": expansion needs a body that deforms, and this one is rigid: its shape cannot change; leave out "
                     "expansion, or "
                     "give it body = \"quad\" (in space \"brick\") with a material that has a solid");
  if (body.kind == BodyKind::frame) require_positive(spec.depth, owner + ": depth", "m");
}

/// Gradients of the shape functions at an integration point, a column each, and its weight [m3].
struct PointGradients {
  Eigen::MatrixXd gradient;  // D x nodes
  double weight;
};
std::vector<PointGradients> gradients_of(const Model<2>& model, const Element& e) {
  std::vector<Vec2> corners;
  for (int i = 0; i < e.nodes; ++i) corners.push_back(model.start_position[static_cast<std::size_t>(e.node[i])]);
  const ElementStrain field = plain_strain(corners);
  std::vector<PointGradients> out;
  for (int p = 0; p < field.points; ++p) {
    Eigen::MatrixXd g(2, e.nodes);
    for (int i = 0; i < e.nodes; ++i) g.col(i) << field.matrix[p](0, 2 * i), field.matrix[p](1, 2 * i + 1);
    out.push_back({g, field.area[p] * e.thickness});
  }
  return out;
}
std::vector<PointGradients> gradients_of(const Model<3>& model, const SpaceElement& e) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < nodes_of(e); ++i)
    nodes.push_back(model.start_position[static_cast<std::size_t>(e.node[static_cast<std::size_t>(i)])]);
  const SpaceElementStrain field = plain_strain(e.shape, nodes);
  std::vector<PointGradients> out;
  for (std::size_t p = 0; p < static_cast<std::size_t>(field.points); ++p) {
    Eigen::MatrixXd g(3, nodes_of(e));
    for (int i = 0; i < nodes_of(e); ++i)
      g.col(i) << field.matrix[p](0, 3 * i), field.matrix[p](1, 3 * i + 1), field.matrix[p](2, 3 * i + 2);
    out.push_back({g, field.volume[p]});
  }
  return out;
}

void add_link(Field& field, int a, int b, double conductance, double capacity = 0) {
  if (a != b) field.links.push_back({std::min(a, b), std::max(a, b), conductance, capacity});
}

/// Heat capacity of a body of elements for its volume [J/(K m3)].
template <int D>
double volume_capacity(const Model<D>& model, const FieldBody& row) {
  double mass = 0, volume = 0;
  const Body& b = model.bodies[static_cast<std::size_t>(row.body)];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) mass += model.mass[static_cast<std::size_t>(n)];
  for (const auto& e : elements_of(model))
    if (e.body == row.body)
      for (const PointGradients& p : gradients_of(model, e)) volume += p.weight;
  return row.heat_capacity * mass / volume;
}

/// Conduction in the elements of a body, k int grad N_i . grad N_j dV, as links; and half of the consistent capacity, c
/// int N_i N_j dV, where the points of an element integrate it (quadrilaterals, bricks and wedges).
template <int D>
void add_element_links(Field& field, const Model<D>& model, const FieldBody& row) {
  const double capacity = volume_capacity(model, row);
  for (const auto& e : elements_of(model)) {
    if (e.body != row.body) continue;
    const std::vector<PointGradients> points = gradients_of(model, e);
    const Eigen::MatrixXd value = point_values(e);
    const double share = points.size() >= static_cast<std::size_t>(nodes_of(e)) ? 0.5 * capacity : 0;
    for (std::size_t p = 0; p < points.size(); ++p)
      for (int i = 0; i < nodes_of(e); ++i)
        for (int j = 0; j < i; ++j) {
          const auto at = static_cast<Eigen::Index>(p);
          add_link(field, row.cell_of(e.node[static_cast<std::size_t>(i)]),
                   row.cell_of(e.node[static_cast<std::size_t>(j)]),
                   -row.conductivity * points[p].weight * points[p].gradient.col(i).dot(points[p].gradient.col(j)),
                   share * points[p].weight * value(at, i) * value(at, j));
        }
  }
}

/// Conduction along the beams of a frame, half of the section at each face, and from face to face.
template <int D>
void add_beam_links(Field& field, const Model<D>& model, const FieldBody& row) {
  const double half = 0.5 * row.conductivity * row.width * row.depth;
  for (const auto& beam : beams_of(model))
    for (const int face : {0, 1})
      if (beam.body == row.body)
        add_link(field, row.cell_of(beam.node[0], face), row.cell_of(beam.node[1], face), half / beam.length);
  const std::vector<double> length = beam_lengths(model, row.body);
  for (std::size_t n = 0; n < length.size(); ++n) {
    const int node = row.first_node + static_cast<int>(n);
    add_link(field, row.cell_of(node, 0), row.cell_of(node, 1), row.conductivity * row.width / row.depth * length[n]);
  }
}

/// The surrounding of that name; -1: none.
int find_surrounding(const Field& field, const std::string& name) {
  for (std::size_t i = 0; i < field.surroundings.size(); ++i)
    if (field.surroundings[i].name == name) return static_cast<int>(i);
  return -1;
}

int add_surrounding(Field& field, const HeatExchangeSpec& spec) {
  const std::string owner = fmt::format("heat exchange '{}'", spec.name);
  check_course(spec.course, owner + ": temperature");
  if (spec.exchange) require_positive(*spec.exchange, owner + ": exchange", "W/(m2 K)");
  field.surroundings.push_back({spec.name, spec.course});
  return static_cast<int>(field.surroundings.size()) - 1;
}

/// A part of a face with the cell that it belongs to.
void add_face_part(Field& field, const std::optional<double>& exchange, int surrounding, int cell, double area) {
  if (exchange) {
    field.exchange.push_back({cell, surrounding, *exchange * area});
    return;
  }
  const auto same = [&](const FieldHeld& h) { return h.cell == cell; };
  field.held.erase(std::remove_if(field.held.begin(), field.held.end(), same), field.held.end());
  field.held.push_back({cell, surrounding});
}

void add_face(Field& field, const Model<2>& model, const FieldBody& row, const std::optional<double>& exchange,
              int surrounding, const WetFace<2>& face) {
  const auto place = [&](int skin) { return skin_start(model, skin); };
  const double length = (place(face.skin_b) - place(face.skin_a)).norm(), area = length * face.depth;
  // Integrals of the two linear shape functions over the part of the face.
  const double whole = face.to - face.from, at_b = 0.5 * (face.to * face.to - face.from * face.from);
  add_face_part(field, exchange, surrounding, row.cell_of(model.skin_node[face.skin_a]), area * (whole - at_b));
  add_face_part(field, exchange, surrounding, row.cell_of(model.skin_node[face.skin_b]), area * at_b);
}

void add_face(Field& field, const Model<3>& model, const FieldBody& row, const std::optional<double>& exchange,
              int surrounding, const WetFace<3>& face) {
  const auto area_of = [&](const std::vector<Vec3>& corners) {
    PressureSum sum;
    sum.add(corners, face.normal, {1, Vec3::Zero()}, 1);
    return sum.force;
  };
  double area = area_of(face.corners);
  for (const std::vector<Vec3>& inner : face.inner) area -= area_of(inner);
  if (row.layout == CellLayout::one) return add_face_part(field, exchange, surrounding, row.first_cell, area);
  const Fit& fit = model.fits[static_cast<std::size_t>(-1 - model.carrier_of(face.piece, face.face))];
  for (int i = 0; i < fit.nodes; ++i) {
    const double mean = model.fit_number[static_cast<std::size_t>(fit.first_number + 4 * i)];
    add_face_part(field, exchange, surrounding, row.cell_of(fit.node[static_cast<std::size_t>(i)]), area * mean);
  }
}

/// Of the sections of a frame, from its mass [m2].
template <int D>
double mean_area(const Model<D>& model, int body, double density) {
  double mass = 0, length = 0;
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) mass += model.mass[static_cast<std::size_t>(n)];
  for (const auto& beam : beams_of(model))
    if (beam.body == body) length += beam.length;
  return mass / (density * length);
}

}  // namespace

template <int D>
void add_heat(Field& field, const Model<D>& model, int body, const HeatSpec& spec) {
  const std::string owner = owner_of_heat(model, body);
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  check_spec(spec, b, owner);
  if (field.find(body) != nullptr)
    throw InputError(owner +
                     ": it has thermal properties already; give them once, and change the temperature by "
                     "m:set_temperature");
  FieldBody row;
  row.body = body, row.first_node = b.first_node, row.first_cell = field.cells();
  row.conductivity = spec.conductivity, row.heat_capacity = spec.heat_capacity;
  row.expansion = spec.expansion, row.reference = spec.reference;
  row.layout = b.is_rigid() ? CellLayout::one : b.kind == BodyKind::frame ? CellLayout::sections : CellLayout::nodes;
  const int faces = row.layout == CellLayout::sections ? 2 : 1;
  row.cells = b.nodes * faces;
  if (faces == 2) row.depth = spec.depth, row.width = mean_area(model, body, spec.density) / spec.depth;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    for (int face = 0; face < faces; ++face) {
      const double capacity = spec.heat_capacity * model.mass[static_cast<std::size_t>(n)] / faces;
      if (!(capacity > 0))
        throw InputError(owner + ": it has no mass, and so no heat capacity; give its material a density");
      field.capacity.push_back(capacity), field.start.push_back(spec.temperature);
    }
  field.row_of.resize(std::max(field.row_of.size(), model.bodies.size()), -1);
  field.row_of[static_cast<std::size_t>(body)] = static_cast<int>(field.bodies.size());
  field.bodies.push_back(row);
  if (row.layout == CellLayout::nodes) add_element_links(field, model, row);
  if (row.layout == CellLayout::sections) add_beam_links(field, model, row);
  merge_links(field.links);
  if (spec.expansion > 0) add_free_shapes(field, model, row);
}

template <int D>
void add_heat_exchange(Field& field, const Model<D>& model, const HeatExchangeSpec& spec,
                       const std::vector<WetFace<D>>& faces) {
  if (find_surrounding(field, spec.name) >= 0)
    throw InputError(
        fmt::format("heat exchange '{}': there is one of that name already; choose another name", spec.name));
  if (faces.empty())
    throw InputError(fmt::format("heat exchange '{}': no face of its bodies points to that side", spec.name));
  const int surrounding = add_surrounding(field, spec);
  const ExchangeFaces<D> exchange{surrounding, spec.exchange, faces};
  for (const WetFace<D>& face : faces) {
    if (field.find(face.body) == nullptr)
      throw InputError(
          fmt::format("heat exchange '{}': body '{}' has no thermal properties; give them first: m:heat {{ "
                      "body = \"{}\", conductivity =, heat_capacity = }}",
                      spec.name, model.bodies[static_cast<std::size_t>(face.body)].name,
                      model.bodies[static_cast<std::size_t>(face.body)].name));
    add_exchange_face(field, model, exchange, face);
  }
  auto known = std::make_shared<HeatFaces<D>>(heat_faces<D>(field));
  known->rows.push_back(exchange);
  field.faces = std::move(known);
}

template <int D>
HeatFaces<D> heat_faces(const Field& field) {
  return field.faces ? static_cast<const HeatFaces<D>&>(*field.faces) : HeatFaces<D>{};
}

template <int D>
void add_exchange_face(Field& field, const Model<D>& model, const ExchangeFaces<D>& of, const WetFace<D>& face) {
  add_face(field, model, *field.find(face.body), of.exchange, of.surrounding, face);
}

void add_friction_heat(Field& field) {
  constexpr const char* name = "friction of contacts";
  if (field.friction >= 0) return;
  if (find_surrounding(field, name) >= 0)
    throw InputError(fmt::format(
        "heat_contact: a heat exchange has the name '{}', under which the heat of friction is counted; choose another "
        "name for it",
        name));
  field.friction = static_cast<int>(field.surroundings.size());
  field.surroundings.push_back({name, {{}, {0.0}, 0, 0}});
}

void add_frame_exchange(Field& field, const std::vector<double>& node_length, const HeatExchangeSpec& spec, int body,
                        bool lower, bool upper) {
  const FieldBody row = *field.find(body);
  const int known = find_surrounding(field, spec.name);
  const int surrounding = known >= 0 ? known : add_surrounding(field, spec);
  for (std::size_t n = 0; n < node_length.size(); ++n)
    for (const int face : {0, 1})
      if (face == 0 ? lower : upper)
        add_face_part(field, spec.exchange, surrounding, row.cell_of(row.first_node + static_cast<int>(n), face),
                      row.width * node_length[n]);
}

template <int D>
std::vector<double> beam_lengths(const Model<D>& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  std::vector<double> length(static_cast<std::size_t>(b.nodes), 0);
  for (const auto& beam : beams_of(model))
    for (const int node : beam.node)
      if (beam.body == body) length[static_cast<std::size_t>(node - b.first_node)] += 0.5 * beam.length;
  return length;
}

template void add_heat(Field&, const Model<2>&, int, const HeatSpec&);
template void add_heat(Field&, const Model<3>&, int, const HeatSpec&);
template void add_heat_exchange(Field&, const Model<2>&, const HeatExchangeSpec&, const std::vector<WetFace<2>>&);
template void add_heat_exchange(Field&, const Model<3>&, const HeatExchangeSpec&, const std::vector<WetFace<3>>&);
template HeatFaces<2> heat_faces(const Field&);
template HeatFaces<3> heat_faces(const Field&);
template void add_exchange_face(Field&, const Model<2>&, const ExchangeFaces<2>&, const WetFace<2>&);
template void add_exchange_face(Field&, const Model<3>&, const ExchangeFaces<3>&, const WetFace<3>&);
template std::vector<double> beam_lengths(const Model<2>&, int);
template std::vector<double> beam_lengths(const Model<3>&, int);

}  // namespace trilith
