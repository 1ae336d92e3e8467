#include "run/field/friction_heat.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/solid_resultants.hpp"
#include "field/field_step.hpp"

namespace trilith {
namespace {

/// A contact that carries shear.
template <int D>
struct ShearedContact {
  int body_a = -1, body_b = -1;
  Vec<D> point = Vec<D>::Zero();
  double shear = 0;  ///< [N]
  bool slides = false;
};

std::vector<ShearedContact<2>> sheared_contacts(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  std::vector<TouchingContact> touching;
  contact_resultants(model, state, work, touching);
  std::vector<ShearedContact<2>> out;
  for (const TouchingContact& c : touching)
    out.push_back({c.body_a, c.body_b, c.resultant.point, std::abs(c.resultant.shear), c.hold == ContactHold::sliding});
  return out;
}
std::vector<ShearedContact<3>> sheared_contacts(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  std::vector<ShearedContact<3>> out;
  for (std::size_t i = 0; i < work.general_touching.size(); ++i) {
    const SolidResultant r = solid_resultant(model, state, work, i);
    const Vec3 shear = r.force - r.normal.dot(r.force) * r.normal;
    out.push_back({r.body_a, r.body_b, r.point, shear.norm(), r.hold == ContactHold::sliding});
  }
  return out;
}

template <int D>
int nearest_node(const Model<D>& model, const State<D>& state, int body, const Vec<D>& point) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  int best = b.first_node;
  double least = std::numeric_limits<double>::infinity();
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    const double distance = (state.position[static_cast<std::size_t>(n)] - point).squaredNorm();
    if (distance < least) least = distance, best = n;
  }
  return best;
}

template <int D>
Vec<D> velocity_at(const Model<D>& model, const State<D>& state, int body, const Vec<D>& point) {
  const auto n = static_cast<std::size_t>(nearest_node(model, state, body, point));
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  if (!b.is_rigid()) return state.velocity[n];
  return state.velocity[n] + cross(state.spin[n], Vec<D>(point - state.position[n]));
}

template <int D>
std::vector<double> powers(const Model<D>& model, const State<D>& state,
                           const std::vector<ShearedContact<D>>& contacts) {
  std::vector<double> out;
  for (const ShearedContact<D>& c : contacts) {
    const double speed =
        (velocity_at(model, state, c.body_b, c.point) - velocity_at(model, state, c.body_a, c.point)).norm();
    out.push_back(c.slides ? c.shear * speed : 0);
  }
  return out;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum;
}

/// Half of the energy for either body; all of it for one of them if the other has no cells.
template <int D>
void deposit(const Field& heat, const Model<D>& model, const State<D>& state, const ShearedContact<D>& contact,
             double energy, std::vector<HeatDeposit>& out) {
  const std::array<int, 2> bodies{contact.body_a, contact.body_b};
  const std::array<const FieldBody*, 2> rows{heat.find(bodies[0]), heat.find(bodies[1])};
  const int heated = (rows[0] != nullptr ? 1 : 0) + (rows[1] != nullptr ? 1 : 0);
  for (const std::size_t side : {0, 1}) {
    const FieldBody* const row = rows[side];
    if (row == nullptr) continue;
    const int node = nearest_node(model, state, bodies[side], contact.point);
    const int faces = row->layout == CellLayout::sections ? 2 : 1;
    for (int face = 0; face < faces; ++face) out.push_back({row->cell_of(node, face), energy / (heated * faces)});
  }
}

}  // namespace

template <int D>
const Field* friction_heated(const Model<D>& model) {
  for (const auto& field : model.fields)
    if (field->friction >= 0) return field.get();
  return nullptr;
}

template <int D>
std::vector<HeatDeposit> friction_deposits(const Field& heat, const Model<D>& model, const State<D>& state,
                                           const Work<D>& work, double energy) {
  std::vector<HeatDeposit> out;
  if (!(energy > 0)) return out;
  const std::vector<ShearedContact<D>> contacts = sheared_contacts(model, state, work);
  std::vector<double> share = powers(model, state, contacts);
  double all = sum_of(share);
  if (!(all > 0)) {
    for (std::size_t i = 0; i < share.size(); ++i) share[i] = contacts[i].shear;
    all = sum_of(share);
  }
  for (std::size_t i = 0; i < share.size(); ++i)
    if (share[i] > 0) deposit(heat, model, state, contacts[i], energy * share[i] / all, out);
  return out;
}

template <int D>
std::vector<HeatDeposit> friction_of_step(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  if (model.fields.empty()) return {};
  const Field* const heat = friction_heated(model);
  if (heat == nullptr) return {};
  constexpr EnergyTerm term = EnergyTerm::contact_friction;
  return friction_deposits(*heat, model, state, work, work.given[term] - state.given[term]);
}

template <int D>
void add_deposits(const Model<D>& model, const std::vector<HeatDeposit>& deposits, std::vector<FieldState>& fields) {
  const Field& heat = *friction_heated(model);
  FieldState& state = fields[static_cast<std::size_t>(row_of(model.fields, FieldKind::heat))];
  extend_field(heat, state);
  for (const HeatDeposit& d : deposits) {
    const auto cell = static_cast<std::size_t>(d.cell);
    state.value[cell] += d.energy / heat.capacity[cell];
    state.supplied[static_cast<std::size_t>(heat.friction)] += d.energy;
  }
}

template const Field* friction_heated(const Model<2>&);
template const Field* friction_heated(const Model<3>&);
template std::vector<HeatDeposit> friction_of_step(const Model<2>&, const State<2>&, const Work<2>&);
template std::vector<HeatDeposit> friction_of_step(const Model<3>&, const State<3>&, const Work<3>&);
template void add_deposits(const Model<2>&, const std::vector<HeatDeposit>&, std::vector<FieldState>&);
template void add_deposits(const Model<3>&, const std::vector<HeatDeposit>&, std::vector<FieldState>&);
template std::vector<HeatDeposit> friction_deposits(const Field&, const Model<2>&, const State<2>&, const Work<2>&,
                                                    double);
template std::vector<HeatDeposit> friction_deposits(const Field&, const Model<3>&, const State<3>&, const Work<3>&,
                                                    double);

}  // namespace trilith
