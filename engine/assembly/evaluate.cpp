#include "assembly/evaluate.hpp"

namespace trilith {

/// The stages of an evaluation in the plane. Each writes the parts of Work that the next ones read.
///
///     update_kinematics      State        -> skin points, their velocities, and the displacement bound
///     update_contact_pairs   skin points  -> candidate pairs, if a piece has left its box
///     contact forces         pairs        -> forces on skin points; bearings: forces on their ends
///     internal_forces        nodes        -> forces of elements and beams on nodes
///     assemble_forces        all forces   -> force and moment on each node
///
/// In space polyhedra take the place of skin points. State is not modified: dissipated energies are added to a copy of
/// the ledger's sums, and trial memories are in Work.
template <>
void evaluate(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  update_kinematics(model, state, work);
  clock.mark(StepPart::place);
  update_contact_pairs(model, state, work);
  clock.mark(StepPart::find);
  work.given = state.given;
  // Inactive rows have an empty memory, before and after; the rows that changed last are cleared here.
  for (const int row : work.changed_rows) work.contacts.clear(static_cast<std::size_t>(row));
  work.changed_rows.clear();
  clock.mark(StepPart::place);
  face_contact_forces(model, state, work, dt, times);
  clock.skip();
  polygon_contact_forces(model, state, work, dt);
  clock.mark(StepPart::general);
  bearing_forces(model, state, work, dt);
  clock.mark(StepPart::bearings);
  internal_forces(model, state, work, dt);
  clock.mark(StepPart::resist);
  apply_loads(model, state, work);
  assemble_forces(model, state, work);
  clock.mark(StepPart::sum);
}

template <>
void evaluate(const Model<3>& model, const State<3>& state, Work<3>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  update_kinematics(model, state, work);
  clock.mark(StepPart::place);
  update_contact_pairs(model, state, work);
  clock.mark(StepPart::find);
  work.given = state.given;
  for (const int row : work.changed_rows) work.contacts.clear(static_cast<std::size_t>(row));
  work.changed_rows.clear();
  clock.mark(StepPart::place);
  polygon_contact_forces(model, state, work, dt);
  clock.mark(StepPart::general);
  bearing_forces(model, state, work, dt);
  clock.mark(StepPart::bearings);
  internal_forces(model, state, work, dt);
  clock.mark(StepPart::resist);
  apply_loads(model, state, work);
  assemble_forces(model, state, work);
  clock.mark(StepPart::sum);
}

}  // namespace trilith
