// Contacts of solids in space: of faces, bonded or not, of any other shape, or apart by the axis that parted them last.
#include <algorithm>

#include "base/team.hpp"
#include "contact/joint.hpp"
#include "contact/sphere_contact.hpp"
#include "detect/bearing_rules.hpp"
#include "step/evaluate.hpp"
#include "step/solid_joints.hpp"

namespace trilith {
namespace {

/// A piece where its body is now, with the velocity and spin of the body's one node.
MovingSolid moving_solid(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  const int n = model.node_of_piece(piece);
  return {work.solids.placed[piece], state.position[n], state.velocity[n], state.spin[n], step_behind(work, n)};
}

/// The force of a contact on both bodies, about their nodes.
void add_to_bodies(const Model<3>& model, const State<3>& state, const NearPair& pair, const SolidResponse& r,
                   Work<3>& work) {
  const int a = model.node_of_piece(pair.piece_a), b = model.node_of_piece(pair.piece_b);
  work.solids.force[a] -= r.force, work.solids.force[b] += r.force;
  work.solids.moment[a] -= r.moment + cross(Vec3(r.centre - state.position[a]), r.force);
  work.solids.moment[b] += r.moment + cross(Vec3(r.centre - state.position[b]), r.force);
}

/// Adds what a contact gives to forces, ledger and lists.
void take_up(const Model<3>& model, const State<3>& state, Work<3>& work, const SolidAnswer& answer) {
  const auto r = static_cast<std::size_t>(answer.row);
  const SolidResponse& response = answer.response;
  work.contacts.memory[r] = response.memory;
  if (answer.was_touching != response.touching) work.changed_rows.push_back(answer.row);
  work.given[EnergyTerm::contact_damping] += response.lost_damping;
  work.given[EnergyTerm::contact_friction] += response.lost_friction;
  work.given[EnergyTerm::contact_fracture] += response.lost_fracture;
  if (!response.touching) {
    // Each of the two may come nearer by the path of the fastest point.
    work.asleep_until[r] = work.travel + 0.5 * (1 - 1e-9) * work.solids.separation[r].distance;
    return;
  }
  add_to_bodies(model, state, work.pairs[r], response, work);
  work.general_touching.push_back({answer.row, response.area, response.depth, response.centre, response.normal_force});
  const JointMemory* joint = work.contacts.joint_at(r);
  const double area = joint != nullptr && joint->bonds != 0 ? joint->plan->whole.area : response.area;
  work.solids.areas.push_back(
      {response.middle, response.normal, area, response.radius, response.friction_arm, response.arm});
  if (answer.joint_changed) work.changed_rows.push_back(answer.row);
}

/// What the rows of one evaluation are found from. Each writes what is its own row's alone, and `room`.
struct SolidPass {
  const Model<3>& model;
  const State<3>& state;
  Work<3>& work;
  double dt;

  bool respond(int row, SolidOverlapBuffer& room, SolidAnswer& answer) const;

 private:
  void respond_bonded(int row, const JointMemory& before, SolidOverlapBuffer& room, SolidAnswer& answer) const;
};

/// Faces that mortar holds together, or did until now.
void SolidPass::respond_bonded(int row, const JointMemory& before, SolidOverlapBuffer& room,
                               SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  JointMemory& after = *work.contacts.joint_at(r);
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  const SolidMemory& contact = contacts_before(state, work).memory[r];
  JointResponse joint = respond_joint(body_motion(model, state, work, pair.piece_a),
                                      body_motion(model, state, work, pair.piece_b), contact, before, law, after);
  if (joint.ends) {
    SolidOverlapBuffer cell;  // room; joints end once
    // What the joint stores more than two other solids there do is given off as it ends.
    const double left = !joint.contact.touching
                            ? 0.0
                            : solid_contact_energy(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b],
                                                   joint.contact.memory, law, room, cell);
    joint.contact.lost_friction += joint_energy(after, law) - left;
    after = {};
    work.solids.separation[r].distance = 0;
  }
  answer = {row, true, joint.changed, joint.contact};
}

bool has_sphere(const Work<3>& work, const NearPair& pair) {
  const std::vector<Sphere>& sphere = work.solids.sphere;
  return !sphere.empty() && (sphere[pair.piece_a].radius > 0 || sphere[pair.piece_b].radius > 0);
}

/// The same of a piece that may be a sphere: its centre and radius beside its corners, of which a sphere has one.
SphereSide sphere_side(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  const int n = model.node_of_piece(piece);
  return {work.solids.sphere[piece], work.solids.placed[piece], state.position[n], state.velocity[n], state.spin[n],
          step_behind(work, n)};
}

/// False where there is nothing to be found out: the two were apart, and still are.
bool SolidPass::respond(int row, SolidOverlapBuffer& room, SolidAnswer& answer) const {
  const auto r = static_cast<std::size_t>(row);
  const Contacts<3>& contacts = contacts_before(state, work);
  if (const JointMemory* joint = contacts.joint_at(r); joint != nullptr) {
    if (!joint->empty()) return respond_bonded(row, *joint, room, answer), true;
    if (JointMemory& over = *work.contacts.joint_at(r); !over.empty()) over = {};
  }
  const SolidMemory& before = contacts.memory[r];
  const bool was = (before.state & contact_touching) != 0;
  // A pair found apart sleeps until the fastest point has gone far enough to have brought it together.
  if (!was && work.travel < work.asleep_until[r]) return false;
  const NearPair& pair = work.pairs[r];
  if (has_sphere(work, pair)) {
    const LawInUse law{model.laws[pair.law], model.thickness, dt};
    answer = {
        row, was, false,
        respond_spheres(sphere_side(model, state, work, pair.piece_a), sphere_side(model, state, work, pair.piece_b),
                        before, law, work.solids.separation[r].distance)};
    return true;
  }
  const MovingSolid a = moving_solid(model, state, work, pair.piece_a),
                    b = moving_solid(model, state, work, pair.piece_b);
  const LawInUse law{model.laws[pair.law], model.thickness, dt};
  const SolidPressure pressed = pressure_between(a, b, law, work.solids.separation[r], room);
  // A bearing carries what its two faces would: flat contact is held off, a corner that strikes is not.
  const bool held_off = pair.replaced && presses_flat(model, state, work.search, state.bearing, pair, pressed.force);
  answer = {row, was, false, held_off ? SolidResponse{} : respond_solids(a, b, before, law, pressed)};
  return true;
}

/// Rows that threads take at a time: some ten microseconds of what touches.
constexpr int solid_row_stretch = 16;

}  // namespace

/// Several threads answer the rows; the answers are taken up in the order of rows, so that sums and lists have the bits
/// of one row after the other.
void respond_general(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  work.general_touching.clear();
  work.solids.areas.clear();
  work.solids.force.assign(model.mass.size(), Vec3::Zero());
  work.solids.moment.assign(model.mass.size(), Vec3::Zero());
  SolidWork<3>& solids = work.solids;
  solids.room.resize(static_cast<std::size_t>(work.threads));
  solids.answer.resize(static_cast<std::size_t>(stretches_under_way(work.threads)) * solid_row_stretch);
  const SolidPass pass{model, state, work, dt};
  const auto answer_of = [&](int slot, int i) -> SolidAnswer& {
    return solids.answer[static_cast<std::size_t>(slot * solid_row_stretch + i)];
  };
  share_in_order(
      work.threads, static_cast<int>(work.pairs.size()), solid_row_stretch,
      [&](int first, int last, int thread, int slot) {
        for (int row = first; row < last; ++row) {
          SolidAnswer& answer = answer_of(slot, row - first);
          if (!pass.respond(row, solids.room[static_cast<std::size_t>(thread)], answer)) answer.row = -1;
        }
      },
      [&](int first, int last, int slot) {
        for (int i = 0; i < last - first; ++i)
          if (answer_of(slot, i).row >= 0) take_up(model, state, work, answer_of(slot, i));
      });
}

}  // namespace trilith
