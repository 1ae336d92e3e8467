// Contacts of solids in space: of faces, of any other shape, or apart by the axis that parted them last.
#include <algorithm>

#include "contact/solid_contact.hpp"
#include "step/evaluate.hpp"

namespace trilith {
namespace {

MovingSolid moving_solid(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  const int n = model.bodies[model.piece_body[piece]].first_node;
  return {work.solids.placed[piece], state.position[n], state.velocity[n], state.spin[n]};
}

/// The force of a contact on both bodies, about their nodes.
void add_to_bodies(const Model<3>& model, const State<3>& state, const NearPair& pair, const SolidResponse& r,
                   Work<3>& work) {
  const int a = model.bodies[model.piece_body[pair.piece_a]].first_node,
            b = model.bodies[model.piece_body[pair.piece_b]].first_node;
  work.solids.force[a] -= r.force, work.solids.force[b] += r.force;
  work.solids.moment[a] -= r.moment + cross(Vec3(r.centre - state.position[a]), r.force);
  work.solids.moment[b] += r.moment + cross(Vec3(r.centre - state.position[b]), r.force);
}

void respond_row(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt) {
  const auto r = static_cast<std::size_t>(row);
  const SolidMemory& before = contacts_before(state, work).memory[r];
  const bool was = (before.state & contact_touching) != 0;
  // A pair found apart sleeps until the fastest point has gone far enough to have brought it together.
  if (!was && work.travel < work.asleep_until[r]) return;
  const NearPair& pair = work.pairs[r];
  const MovingSolid a = moving_solid(model, state, work, pair.piece_a),
                    b = moving_solid(model, state, work, pair.piece_b);
  Separation3& apart = work.solids.separation[r];
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  const SolidPressure pressed = pressure_between(a, b, law, apart, work.solids.shared);
  const SolidResponse response = respond_solids(a, b, before, law, pressed);
  work.contacts.memory[r] = response.memory;
  if (was != response.touching) work.changed_rows.push_back(row);
  work.given[EnergyTerm::contact_damping] += response.lost_damping;
  work.given[EnergyTerm::contact_friction] += response.lost_friction;
  if (!response.touching) {
    // Each of the two may come nearer by the path of the fastest point.
    work.asleep_until[r] = work.travel + 0.5 * (1 - 1e-9) * apart.distance;
    return;
  }
  add_to_bodies(model, state, pair, response, work);
  work.general_touching.push_back({row, response.area, response.depth, response.centre, response.normal_force});
  work.solids.areas.push_back({pressed.middle, response.normal_force.normalized(), pressed.radius, pressed.spread});
}

}  // namespace

/// All rows, in their order.
void respond_general(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  work.general_touching.clear();
  work.solids.areas.clear();
  work.solids.force.assign(model.mass.size(), Vec3::Zero());
  work.solids.moment.assign(model.mass.size(), Vec3::Zero());
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) respond_row(model, state, work, row, dt);
}

}  // namespace trilith
