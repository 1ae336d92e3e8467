// Readings of the water in joints at an instant.
#pragma once

#include <string>
#include <vector>

#include "assembly/field/joint_water.hpp"
#include "bindings/model/simulated_model.hpp"
#include "field/field.hpp"

namespace trilith::script {

/// The values of the field of seepage; nullptr before the first process.
template <int D>
const FieldState* seepage_values(const SimulatedModel<D>& m) {
  const Simulation<D>* s = m.if_built();
  const int row = s == nullptr ? -1 : row_of(s->model().fields, FieldKind::seepage);
  const auto at = static_cast<std::size_t>(row);
  return row < 0 || at >= s->state().fields.size() ? nullptr : &s->state().fields[at];
}

/// The field of seepage, or InputError, beginning with `owner`.
template <int D>
const Field& require_seepage(const Model<D>& model, const std::string& owner) {
  const int row = row_of(model.fields, FieldKind::seepage);
  if (row < 0) throw InputError(owner + ": there is no joint with seepage; declare m:seepage first");
  return *model.fields[static_cast<std::size_t>(row)];
}

/// The joint of that name, or InputError with the nearest name, beginning with `owner`.
const FlowJoint& require_flow_joint(const Field& field, const std::string& name, const std::string& owner);

/// Instantaneous flows: the heads of nodes follow from the balance of their links.
struct FlowPicture {
  std::vector<double> node_head;  ///< [node] [m]
  std::vector<double> into;       ///< [node] flow from the node into its joints [m3/s]
};

/// A joint at an instant.
struct JointReading {
  std::vector<double> head, pressure, aperture, fill;  ///< [cell] [m], [Pa], [m], [1]
  double volume = 0;                                   ///< of water [m3]
  double wet_length = 0, length = 0;                   ///< [m]
  double head_from = 0, head_to = 0;                   ///< at its nodes [m]
  double inflow = 0, outflow = 0;                      ///< at its first and at its second end [m3/s]
};

/// All joints at the present instant of a simulation whose model has seepage.
template <int D>
struct SeepageNow {
  const JointFlow& flow;
  FieldState state;  ///< with all cells
  Apertures apertures;
  FlowPicture flows;

  explicit SeepageNow(const Simulation<D>& s);
  /// All joints of the name of one, which a crack has divided.
  [[nodiscard]] JointReading joint(const FlowJoint& of) const;

 private:
  void add_cells(const FlowJoint& j, JointReading& out) const;
};

}  // namespace trilith::script
