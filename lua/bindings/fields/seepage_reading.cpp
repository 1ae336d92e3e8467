#include "bindings/fields/seepage_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "field/field_step.hpp"
#include "model/field/seepage.hpp"
#include "model/names.hpp"

namespace trilith::script {
namespace {

struct NodeSum {
  double conductance = 0, drive = 0;
};
double half_conductance(const FlowJoint& j, double a0, double a1) {
  const double length = 0.5 * j.cell_length();
  return j.width * j.weight * 2 * a0 * a0 * a1 * a1 / (12 * j.viscosity * length * (a0 + a1));
}

template <class F>
void for_joint_ends(const JointFlow& flow, const Apertures& apertures, const FieldState& state, F&& f) {
  for (const FlowJoint& j : flow.joints)
    for (const bool first : {true, false}) {
      const int i = first ? 0 : j.cells - 1;
      const auto cell = static_cast<std::size_t>(j.first_cell + i);
      const auto [a0, a1] = apertures[cell];
      const double middle = 0.5 * (a0 + a1),
                   k = first ? half_conductance(j, a0, middle) : half_conductance(j, middle, a1);
      const bool wet = state.value[static_cast<std::size_t>(flow.cells()) + cell] > 0;
      f(j, first ? j.from : j.to, k, j.elevation_at((i + 0.5) / j.cells) + state.value[cell], wet);
    }
}

FlowPicture picture_of(const JointFlow& flow, const Apertures& apertures, const FieldState& state,
                       const std::vector<double>& heads) {
  std::vector<NodeSum> sums(flow.nodes.size());
  for_joint_ends(flow, apertures, state, [&](const FlowJoint&, int node, double k, double head, bool wet) {
    if (wet)
      sums[static_cast<std::size_t>(node)].conductance += k, sums[static_cast<std::size_t>(node)].drive += k * head;
  });
  FlowPicture out;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const FlowNode& node = flow.nodes[i];
    const bool given = node.surrounding >= 0;
    out.node_head.push_back(given ? std::max(heads[static_cast<std::size_t>(node.surrounding)], node.elevation)
                            : sums[i].conductance > 0 ? sums[i].drive / sums[i].conductance
                                                      : node.elevation);
  }
  out.into.assign(sums.size(), 0);
  for_joint_ends(flow, apertures, state, [&](const FlowJoint&, int node, double k, double head, bool wet) {
    const auto n = static_cast<std::size_t>(node);
    const bool air = flow.nodes[n].surrounding >= 0 && out.node_head[n] <= flow.nodes[n].elevation;
    if (air && (!wet || head <= out.node_head[n])) return;
    out.into[n] += k * (out.node_head[n] - head);
  });
  return out;
}

template <int D>
FieldState whole_seepage_state(const Simulation<D>& s, const Field& field) {
  const auto at = static_cast<std::size_t>(row_of(s.model().fields, FieldKind::seepage));
  FieldState state;
  if (at < s.state().fields.size()) state = s.state().fields[at];
  extend_field(field, state);
  return state;
}

}  // namespace

const FlowJoint& require_flow_joint(const Field& field, const std::string& name, const std::string& owner) {
  const FlowJoint* joint = field.flow->find(name);
  if (joint != nullptr) return *joint;
  std::vector<std::string> names;
  for (const FlowJoint& j : field.flow->joints) names.push_back(j.name);
  throw InputError(fmt::format("{}: there is no joint '{}'{}", owner, name, name_hint(name, names)));
}

template <int D>
SeepageNow<D>::SeepageNow(const Simulation<D>& s)
    : flow(*field_of(s.model().fields, FieldKind::seepage)->flow),
      state(whole_seepage_state(s, *field_of(s.model().fields, FieldKind::seepage))),
      apertures(joint_apertures(flow, state, s.model(), s.state())),
      flows(picture_of(
          flow, apertures, state,
          seepage_heads(*field_of(s.model().fields, FieldKind::seepage), s.model(), state.clock, s.state().time))) {}

/// The parts of a joint that a crack has divided follow each other.
template <int D>
JointReading SeepageNow<D>::joint(const FlowJoint& of) const {
  JointReading out;
  const FlowJoint *first = nullptr, *last = nullptr;
  for (const FlowJoint& j : flow.joints) {
    if (j.name != of.name) continue;
    if (first == nullptr) first = &j;
    last = &j;
    add_cells(j, out);
  }
  out.head_from = flows.node_head[static_cast<std::size_t>(first->from)];
  out.head_to = flows.node_head[static_cast<std::size_t>(last->to)];
  for_joint_ends(flow, apertures, state, [&](const FlowJoint& one, int node, double k, double h, bool /*wet*/) {
    const double q = k * (flows.node_head[static_cast<std::size_t>(node)] - h);
    if (&one == first && node == first->from) out.inflow = q;
    if (&one == last && node == last->to) out.outflow = -q;
  });
  return out;
}

template <int D>
void SeepageNow<D>::add_cells(const FlowJoint& j, JointReading& out) const {
  out.length += j.length;
  for (int i = 0; i < j.cells; ++i) {
    const auto cell = static_cast<std::size_t>(j.first_cell + i);
    const double psi = state.value[cell], water = state.value[static_cast<std::size_t>(flow.cells()) + cell];
    const double a = 0.5 * (apertures[cell][0] + apertures[cell][1]), room = j.width * j.cell_length() * a;
    out.head.push_back(j.elevation_at((i + 0.5) / j.cells) + psi), out.pressure.push_back(j.weight * psi);
    out.aperture.push_back(a), out.fill.push_back(std::min(1.0, water / room));
    out.volume += water, out.wet_length += out.fill.back() * j.cell_length();
  }
}

template struct SeepageNow<2>;
template struct SeepageNow<3>;

}  // namespace trilith::script
