#include "field/field.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "base/hash.hpp"

namespace trilith {

void merge_links(std::vector<FieldLink>& links) {
  std::stable_sort(links.begin(), links.end(),
                   [](const FieldLink& p, const FieldLink& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (kept > 0 && links[kept - 1].a == links[i].a && links[kept - 1].b == links[i].b)
      links[kept - 1].conductance += links[i].conductance, links[kept - 1].capacity += links[i].capacity;
    else
      links[kept++] = links[i];
  }
  links.resize(kept);
}

double Field::conductance_between(int body_a, int body_b) const {
  const auto fits = [](int given, int body) { return given < 0 || given == body; };
  for (auto row = contacts.rbegin(); row != contacts.rend(); ++row)
    if ((fits(row->body_a, body_a) && fits(row->body_b, body_b)) ||
        (fits(row->body_a, body_b) && fits(row->body_b, body_a)))
      return row->conductance;
  return 0;
}

namespace {

void add_number(Hash& hash, double v) {
  hash.add(v);
}
void add_number(Hash& hash, int v) {
  hash.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(v)));
}
template <class T>
void add_numbers(Hash& hash, const std::vector<T>& values) {
  hash.add(static_cast<std::uint64_t>(values.size()));
  for (const T& v : values) add_number(hash, v);
}

void add_bodies(Hash& hash, const Field& f) {
  for (const FieldBody& b : f.bodies) {
    for (const int v : {b.body, static_cast<int>(b.layout), b.first_node, b.first_cell, b.cells}) add_number(hash, v);
    for (const double v : {b.conductivity, b.heat_capacity, b.expansion, b.reference, b.depth, b.width})
      add_number(hash, v);
  }
  for (const ContactConductance& c : f.contacts)
    add_number(hash, c.body_a), add_number(hash, c.body_b), add_number(hash, c.conductance);
}

void add_surroundings(Hash& hash, const Field& f) {
  for (const FieldSurrounding& s : f.surroundings) {
    hash.add(std::string_view(s.name));
    add_numbers(hash, s.course.time), add_numbers(hash, s.course.value);
    add_number(hash, s.course.start), add_number(hash, s.course.period);
  }
  for (const FieldExchange& e : f.exchange)
    add_number(hash, e.cell), add_number(hash, e.surrounding), add_number(hash, e.conductance);
  for (const FieldHeld& h : f.held) add_number(hash, h.cell), add_number(hash, h.surrounding);
}

void add_attachment(Hash& hash, const Attachment<2>& at) {
  add_number(hash, at.nodes);
  for (int i = 0; i < at.nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    add_number(hash, at.node[k]), add_number(hash, at.weight[k]);
    add_number(hash, at.arm[k].x()), add_number(hash, at.arm[k].y());
  }
}

void add_flow(Hash& hash, const JointFlow& flow) {
  for (const FlowJoint& j : flow.joints) {
    hash.add(std::string_view(j.name));
    for (const int v : {j.from, j.to, j.first_cell, j.cells}) add_number(hash, v);
    for (const double v : {j.length, j.width, j.elevation[0], j.elevation[1], j.aperture[0], j.aperture[1],
                           j.compliance, j.coupling, j.density, j.viscosity, j.bulk_modulus, j.weight})
      add_number(hash, v);
    if (j.crack_aperture > 0) add_number(hash, j.crack_aperture);
    for (const std::vector<FlowFace>* faces : {&j.upper, &j.lower})
      for (const FlowFace& f : *faces)
        add_number(hash, f.body), add_number(hash, f.skin_a), add_number(hash, f.skin_b), add_number(hash, f.depth);
    add_attachment(hash, j.heel), add_attachment(hash, j.toe);
    const FlowRectangle& r = j.rectangle;
    if (r.normal != Vec3::Zero())
      for (const Vec3* v : {&r.heel, &r.toe, &r.normal, &r.face, &r.face_normal})
        for (const int k : {0, 1, 2}) add_number(hash, (*v)[k]);
  }
  for (const FlowNode& n : flow.nodes)
    hash.add(std::string_view(n.name)), add_number(hash, n.elevation), add_number(hash, n.surrounding);
  if (flow.in_motion) add_number(hash, 1);
}

}  // namespace

std::uint64_t Field::digest() const {
  Hash hash;
  add_number(hash, static_cast<int>(kind));
  add_numbers(hash, capacity), add_numbers(hash, start);
  for (const FieldLink& l : links) {
    add_number(hash, l.a), add_number(hash, l.b);
    add_number(hash, l.conductance), add_number(hash, l.capacity);
  }
  add_surroundings(hash, *this);
  add_bodies(hash, *this);
  add_numbers(hash, free_shape_of), add_numbers(hash, free_number), add_numbers(hash, free_beam_of);
  for (const FreeBeam& b : free_beams)
    for (const double v : {b.reference, b.expansion, b.depth, b.length}) add_number(hash, v);
  if (flow) add_flow(hash, *flow);
  if (friction >= 0) add_number(hash, friction);
  return hash.value();
}

void FieldValues::subtract_free(const FreeShape& shape, double* d) const {
  const double* column = field_->free_number.data() + shape.first_number;
  for (int j = 0; j < shape.nodes; ++j, column += shape.dofs) {
    const double rise = at(shape.cell[static_cast<std::size_t>(j)]) - shape.reference;
    for (int i = 0; i < shape.dofs; ++i) d[i] -= column[i] * rise;
  }
}

double FieldValues::mean_rise(const FreeShape& shape) const {
  double sum = 0;
  for (int j = 0; j < shape.nodes; ++j) sum += at(shape.cell[static_cast<std::size_t>(j)]) - shape.reference;
  return sum / shape.nodes;
}

/// The curvature k = alpha (lower - upper) / depth is linear along the beam;
/// with the deflection 0 at both ends the slopes there are -L (k_0 / 3 + k_1 /
/// 6) and L (k_0 / 6 + k_1 / 3).
FreeStrain FieldValues::strain_of(const FreeBeam& beam) const {
  std::array<double, 2> mean, curvature;
  for (const std::size_t end : {0, 1}) {
    const double low = at(beam.lower[end]), high = at(beam.upper[end]);
    mean[end] = 0.5 * (low + high) - beam.reference;
    curvature[end] = beam.expansion * (low - high) / beam.depth;
  }
  const double l = beam.length;
  return {beam.expansion * l * 0.5 * (mean[0] + mean[1]),
          {-l * (curvature[0] / 3 + curvature[1] / 6), l * (curvature[0] / 6 + curvature[1] / 3)}};
}

int row_of(const Fields& fields, FieldKind kind) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i]->kind == kind) return static_cast<int>(i);
  return -1;
}

std::shared_ptr<const Field> field_of(const Fields& fields, FieldKind kind) {
  const int row = row_of(fields, kind);
  return row < 0 ? nullptr : fields[static_cast<std::size_t>(row)];
}

void set_field(Fields& fields, Field field) {
  const int row = row_of(fields, field.kind);
  auto made = std::make_shared<const Field>(std::move(field));
  if (row < 0)
    fields.push_back(std::move(made));
  else
    fields[static_cast<std::size_t>(row)] = std::move(made);
}

FieldValues values_of(const Fields& fields, const std::vector<FieldState>& states, FieldKind kind) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i]->kind == kind) return {fields[i].get(), i < states.size() ? &states[i] : nullptr};
  return {};
}

}  // namespace trilith
