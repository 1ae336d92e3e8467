// The heat of a body that is replaced by two parts.
#include <algorithm>
#include <utility>

#include "field/field_step.hpp"
#include "model/field/heat.hpp"

namespace trilith {
namespace {

/// Consecutive cells that a field loses.
struct LostCells {
  int first, count;

  [[nodiscard]] bool has(int cell) const { return cell >= first && cell < first + count; }
  void move(int& cell) const {
    if (cell >= first + count) cell -= count;
  }
  void erase_from(std::vector<double>& of_cells) const {
    const auto begin = of_cells.begin() + first;
    of_cells.erase(begin, begin + count);
  }
};

/// Removes the elements of a body that expand, whose numbers follow each other.
void remove_shapes(Field& field, const LostCells& lost) {
  const auto is_lost = [&](const FreeShape& s) { return lost.has(s.cell[0]); };
  int from = static_cast<int>(field.free_number.size()), to = 0;
  for (const FreeShape& s : field.free_shapes)
    if (is_lost(s)) from = std::min(from, s.first_number), to = std::max(to, s.first_number + s.nodes * s.dofs);
  if (from < to) field.free_number.erase(field.free_number.begin() + from, field.free_number.begin() + to);
  std::vector<FreeShape> kept;
  for (int& row : field.free_shape_of) {
    if (row < 0) continue;
    FreeShape shape = field.free_shapes[static_cast<std::size_t>(row)];
    row = -1;
    if (is_lost(shape)) continue;
    if (shape.first_number >= to) shape.first_number -= std::max(0, to - from);
    for (int i = 0; i < shape.nodes; ++i) lost.move(shape.cell[static_cast<std::size_t>(i)]);
    row = static_cast<int>(kept.size());
    kept.push_back(shape);
  }
  field.free_shapes = std::move(kept);
}

void remove_cells(Field& field, const LostCells& lost) {
  lost.erase_from(field.capacity), lost.erase_from(field.start);
  std::erase_if(field.links, [&](const FieldLink& l) { return lost.has(l.a) || lost.has(l.b); });
  std::erase_if(field.exchange, [&](const FieldExchange& e) { return lost.has(e.cell); });
  std::erase_if(field.held, [&](const FieldHeld& h) { return lost.has(h.cell); });
  for (FieldLink& l : field.links) lost.move(l.a), lost.move(l.b);
  for (FieldExchange& e : field.exchange) lost.move(e.cell);
  for (FieldHeld& h : field.held) lost.move(h.cell);
  for (FreeBeam& beam : field.free_beams)
    for (const std::size_t end : {0, 1}) lost.move(beam.lower[end]), lost.move(beam.upper[end]);
  remove_shapes(field, lost);
}

void remove_body(Field& field, int body) {
  std::erase_if(field.bodies, [&](const FieldBody& b) { return b.body == body; });
  std::fill(field.row_of.begin(), field.row_of.end(), -1);
  for (std::size_t i = 0; i < field.bodies.size(); ++i)
    field.row_of[static_cast<std::size_t>(field.bodies[i].body)] = static_cast<int>(i);
}

/// A row that names the body becomes one for each part, at its place.
void divide_contacts(Field& field, int body, const std::array<int, 2>& parts) {
  std::vector<ContactConductance> rows;
  for (const ContactConductance& row : field.contacts) {
    if (row.body_a != body && row.body_b != body) {
      rows.push_back(row);
      continue;
    }
    for (const int part : parts)
      rows.push_back({row.body_a == body ? part : row.body_a, row.body_b == body ? part : row.body_b, row.conductance});
  }
  field.contacts = std::move(rows);
}

}  // namespace

template <int D>
void divide_heat(Field& field, const Model<D>& model, int body, const std::array<int, 2>& parts,
                 const std::vector<int>& source, FieldState& values) {
  divide_contacts(field, body, parts);
  if (field.find(body) == nullptr) return;
  const FieldBody whole = *field.find(body);
  const bool has_values = !values.value.empty();
  if (has_values) extend_field(field, values);
  std::vector<double> start, now;
  for (const int node : source) {
    const auto cell = static_cast<std::size_t>(whole.cell_of(node));
    start.push_back(field.start[cell]);
    if (has_values) now.push_back(values.value[cell]);
  }
  const LostCells lost{whole.first_cell, whole.cells};
  remove_cells(field, lost);
  remove_body(field, body);
  for (FieldBody& other : field.bodies) lost.move(other.first_cell);
  if (has_values) lost.erase_from(values.value);
  HeatSpec spec;
  spec.conductivity = whole.conductivity, spec.heat_capacity = whole.heat_capacity;
  spec.expansion = whole.expansion, spec.reference = whole.reference;
  const std::size_t first = field.start.size();
  for (const int part : parts) add_heat(field, model, part, spec);
  std::copy(start.begin(), start.end(), field.start.begin() + static_cast<std::ptrdiff_t>(first));
  values.value.insert(values.value.end(), now.begin(), now.end());
  for (const ExchangeFaces<D>& of : heat_faces<D>(field).rows)
    for (const WetFace<D>& face : of.faces)
      if (face.body == parts[0] || face.body == parts[1]) add_exchange_face(field, model, of, face);
}
template void divide_heat(Field&, const Model<2>&, int, const std::array<int, 2>&, const std::vector<int>&,
                          FieldState&);
template void divide_heat(Field&, const Model<3>&, int, const std::array<int, 2>&, const std::vector<int>&,
                          FieldState&);

}  // namespace trilith
