// Events of a step in space: bonds, contacts made and lost, impacts, bearings, seats, rest.
#include <algorithm>

#include "assembly/contact/bond_figure.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/solid_joints.hpp"
#include "contact/joint/joint.hpp"
#include "contact/joint/joint_step.hpp"
#include "events/beam_events.hpp"
#include "events/bearing_events.hpp"
#include "events/body_events.hpp"
#include "events/find_events.hpp"
#include "events/parted_contacts.hpp"
#include "events/seat_events.hpp"
#include "events/water_events.hpp"

namespace trilith {
namespace {

/// The speed at which two bodies close along the force of their contact, at its centre [m/s].
double closing_speed(const Model<3>& model, const State<3>& state, const Work<3>& work, const GeneralContact<3>& c) {
  const NearPair& pair = work.pairs[c.row];
  const auto velocity = [&](int piece) {
    return motion_of(model, state, model.carrier_of(piece)).velocity_at(c.centre);
  };
  return -c.force.normalized().dot(velocity(pair.piece_b) - velocity(pair.piece_a));
}

/// True for two spheres. In granular flow they touch and separate by the million, so only impacts are reported.
bool are_grains(const Model<3>& model, const NearPair& pair) {
  return model.piece_solid[pair.piece_a].is_sphere() && model.piece_solid[pair.piece_b].is_sphere();
}

/// Event of a contact that begins: an impact if the closing speed is above the model's impact_speed, otherwise a
/// contact made.
void made_event(const Model<3>& model, State<3>& state, Work<3>& work, int row) {
  // A contact that closes again is reported only as an impact.
  const bool again = has_closed_again(work, work.contacts.key[row]);
  const GeneralContact<3>* contact = work.general_touching.find(row);
  const double closing = closing_speed(model, state, work, *contact);
  const bool strikes = closing > model.impact_speed;
  if ((again || are_grains(model, work.pairs[row])) && !strikes) return;
  const NearPair& pair = work.pairs[row];
  Event e = event_now(state, strikes ? EventType::impact : EventType::contact_made, model.piece_body[pair.piece_a],
                      model.piece_body[pair.piece_b]);
  e.set_place(contact->centre);
  e.value = closing;
  work.events.push_back(e);
}

/// Largest opening of the patches of a joint in its present position, with its committed memory [m].
template <class K>
double widest_opening(const K& law, JointMemory before, std::uint32_t patches, const JointMotion& now) {
  divide(before);
  const JointPlan& plan = *before.plan;
  double widest = 0;
  for (std::size_t k = 0; k < plan.patch.size(); ++k) {
    if ((patches >> k & 1U) == 0) continue;
    const JointPatch& p = plan.patch[k];
    const PatchMemory& m = before.patch[k];
    const PatchOverlaps o(plan, p, now.moved.raised(opened_by(law, m.slip) - m.crushed));
    for (const Vec2& x : plan.corners(p)) widest = std::max(widest, -o.asked(p, x));
  }
  return widest;
}

/// Couple of the springs of a joint about its normal if they carry nothing else [N m].
double couple_of(const JointMemory& joint) {
  if (joint.sound) return joint.elastic.z();
  double couple = 0;
  for (std::size_t k = 0; k < joint.plan->patch.size(); ++k) {
    const JointPatch& p = joint.plan->patch[k];
    const PatchMemory& m = joint.patch[k];
    couple += sum_of(lanes_of(p.point_x) * lanes_of(m.elastic_y) - lanes_of(p.point_y) * lanes_of(m.elastic_x));
  }
  return couple;
}

/// Sets the mode and value of the event of a joint's bond. The mode is tension if a patch that was lost opened beyond
/// its limit.
void tell_mode(const Model<3>& model, const NearPair& pair, const JointMemory& before, const JointMemory& after,
               const JointMotion& now, Event& e) {
  const JointPlan& plan = *before.plan;
  const bool broken = e.type == EventType::bond_broken;
  with_kernel({model.laws[pair.law]}, [&]<class K>(const K& law) {
    if constexpr (K::bonds) {
      const std::uint32_t went = broken ? before.bonds & ~after.bonds : before.bonds;
      const bool pulled = law.kn * widest_opening(law, before, went, now) > law.tension;
      e.mode = pulled ? JointMode::tension : JointMode::shear;
      tell_figure(e, {.tension = law.tension * plan.whole.area,
                      .cohesion = law.cohesion * plan.whole.area,
                      .stress = law.tension,
                      .couple = couple_of(before),
                      .arm = plan.friction_arm,
                      .softened = broken && K::softens});
    }
  });
}

/// Crushed depth of the mortar of a row at any point [m].
double crushed_depth(const Contacts<3>& contacts, std::size_t row) {
  const JointMemory* joint = contacts.joint_at(row);
  return contacts.memory[row].crushed + (joint != nullptr ? joint->most_crushed() : 0);
}

/// Event of mortar that begins to crush: its present resultant and place.
void crushing_event(const Model<3>& model, const State<3>& state, Work<3>& work, int row) {
  const auto r = static_cast<std::size_t>(row);
  if (crushed_depth(contacts_before(state, work), r) > 0 || !(crushed_depth(work.contacts, r) > 0)) return;
  const GeneralContact<3>* contact = work.general_touching.find(row);
  if (contact == nullptr) return;
  const NearPair& pair = work.pairs[row];
  Event e = event_now(state, EventType::joint_crushed, model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]);
  e.set_place(contact->centre);
  e.value = (contact->force - work.contacts.memory[r].shear.total).norm();
  e.mode = JointMode::compression;
  work.events.push_back(e);
}

/// Event of a lost bond or its first damage: its last resultant, its place, and the limit that was reached.
void joint_events(const Model<3>& model, const State<3>& state, Work<3>& work, int row) {
  const auto r = static_cast<std::size_t>(row);
  const Contacts<3>& contacts = contacts_before(state, work);
  const JointMemory* before = contacts.joint_at(r);
  if (before == nullptr || before->empty()) return;
  const JointChange change = joint_change(*before, *work.contacts.joint_at(r));
  if (!change.broken && !change.cracked) return;
  const NearPair& pair = work.pairs[row];
  Event e = event_now(state, change.broken ? EventType::bond_broken : EventType::bond_cracked,
                      model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]);
  const JointPlan& plan = *before->plan;
  const JointMotion now(plan, body_motion(model, state, pair.piece_a, plan.face_a),
                        body_motion(model, state, pair.piece_b, plan.face_b));
  e.set_place(now.origin);
  e.value = carried_force(*before, contacts.memory[r], {model.laws[pair.law]});
  tell_mode(model, pair, *before, *work.contacts.joint_at(r), now, e);
  work.events.push_back(e);
}

void contact_events(const Model<3>& model, State<3>& state, Work<3>& work, int row) {
  joint_events(model, state, work, row);
  crushing_event(model, state, work, row);
  const bool was = (contacts_before(state, work).memory[row].state & contact_touching) != 0,
             is = (work.contacts.memory[row].state & contact_touching) != 0;
  if (was == is) return;
  if (is)
    made_event(model, state, work, row);
  else if (!are_grains(model, work.pairs[row]))
    state.parted.push_back({work.contacts.key[row], state.time});
}

}  // namespace

void find_events(const Model<3>& model, State<3>& state, Work<3>& work) {
  work.events.clear();
  take_back(state, work);
  for (const int row : work.changed_rows) contact_events(model, state, work, row);
  if (!state.parted.empty()) parted_events(model, state, work);
  bearing_events(model, state, work);
  beam_events(model, state, work);
  seat_events(model, state, work);
  water_events(model, state, work);
  body_events(model, state, work);
}

}  // namespace trilith
