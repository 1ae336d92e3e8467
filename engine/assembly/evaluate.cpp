#include "assembly/evaluate.hpp"

namespace trilith {

/// The stages of a step in the plane, each writing the parts of Work that the next ones read:
///
///     place    State          -> skin points and their velocities, how far anything has moved; no forces yet
///     find     skin points    -> near pairs, where something has left its box
///     respond  pairs          -> forces on skin points; bearings: forces on their ends
///     resist   nodes          -> forces of elements and beams on nodes
///     sum      all forces     -> force and moment on each node
///
/// and in space the same by solids in place of skin points.
/// State is not touched: losses are added to a copy of the ledger's sums, trial memories lie in Work.
template <>
void evaluate(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  update_kinematics(model, state, work);
  clock.mark(StepPart::place);
  update_contact_pairs(model, state, work);
  clock.mark(StepPart::find);
  work.given = state.given;
  // Rows that are not worked on hold an empty memory, before and after: those that turned last are cleared here.
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
