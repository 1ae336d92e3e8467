// Bonds of joints in space; the plane version is assembly/start.cpp.
#include <algorithm>
#include <bit>

#include "assembly/contact/solid_joints.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "contact/joint/joint.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {
namespace {

/// Areas narrower than this share of the smaller body's size belong to neighbours across an edge.
constexpr double least_joint = 1e-3;

/// Finds the candidate pairs and moves the contacts of the state to their rows.
void find_near_solids(const Model<3>& model, State<3>& state, Work<3>& work) {
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  state.contacts = work.matched;
}

double size_of_smaller(const Model<3>& model, const NearPair& p) {
  return 2 * std::min(model.body_radius[model.piece_body[p.piece_a]], model.body_radius[model.piece_body[p.piece_b]]);
}

bool holds_all_over(const JointMemory* joint) {
  return joint != nullptr && !joint->empty() && std::popcount(joint->bonds) == joint->plan->patches;
}

/// Elastic energy of a row, with or without joint [J].
double energy_of_row(const Model<3>& model, const State<3>& state, Work<3>& work, std::size_t row) {
  const NearPair& p = work.pairs[row];
  const LawInUse law{model.laws[p.law], model.thickness, 0};
  if (const JointMemory* joint = state.contacts.joint_at(row); joint != nullptr && !joint->empty())
    return joint_energy(*joint, law);
  const SolidMemory& memory = state.contacts.memory[row];
  if ((memory.state & contact_touching) == 0) return 0;
  SolidOverlapBuffer shared, cell;
  return solid_contact_energy(work.solids.placed[p.piece_a], work.solids.placed[p.piece_b], memory, law, shared, cell);
}

/// The joint that sets between two faces. Its seats move with the faces of deformable pieces.
JointMemory joint_between(const Model<3>& model, const State<3>& state, const NearPair& pair, FaceOverlap3 faces,
                          const SolidMemory& memory) {
  if (!model.is_fitted(pair.piece_a)) faces.face_a = -1;
  if (!model.is_fitted(pair.piece_b)) faces.face_b = -1;
  return set_joint(faces, body_motion(model, state, pair.piece_a, faces.face_a),
                   body_motion(model, state, pair.piece_b, faces.face_b), memory, model.laws[pair.law]);
}

/// Removes a joint with the memories of its patches; the largest crushed depth of a patch remains in the contact.
void forget_joint(JointMemory& joint, SolidMemory& memory) {
  memory.keep_crushed(memory.crushed + joint.most_crushed(), 0);
  joint = {};
}

/// change() modifies the memory of a row; the ledger receives the difference in elastic energy.
template <class Change>
void change_row(const Model<3>& model, State<3>& state, Work<3>& work, std::size_t row, Change&& change) {
  const double before = energy_of_row(model, state, work, row);
  change();
  state.given[EnergyTerm::contact_fracture] += before - energy_of_row(model, state, work, row);
}

}  // namespace

void set_bonds(const Model<3>& model, State<3>& state, double reach, int first_body) {
  Work<3> work;
  find_near_solids(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    if (std::max(model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]) < first_body) continue;
    if (model.piece_solid[pair.piece_a].is_sphere() || model.piece_solid[pair.piece_b].is_sphere()) continue;
    // A joint bonded all over remains unchanged, so the function can be called again. A bearing replaces flat faces.
    if (pair.replaced || !may_bond(model.laws[pair.law]) || holds_all_over(state.contacts.joint_at(row))) continue;
    const double size = size_of_smaller(model, pair);
    FaceOverlap3 faces;
    if (!meeting_faces(work.solids.placed[pair.piece_a], work.solids.placed[pair.piece_b], reach * size,
                       least_joint * size, faces))
      continue;
    change_row(model, state, work, row, [&] {
      SolidMemory& memory = state.contacts.memory[row];
      JointMemory* joint = state.contacts.joint_at(row);
      if (joint != nullptr) forget_joint(*joint, memory);
      (joint != nullptr ? *joint : state.contacts.add_joint(row)) = joint_between(model, state, pair, faces, memory);
      memory.state |= contact_touching | contact_general;
    });
  }
}

/// The shear of a joint continues in the single slider of faces without bonds.
void lift_bonds(const Model<3>& model, State<3>& state) {
  Work<3> work;
  find_near_solids(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row)
    if (JointMemory* joint = state.contacts.joint_at(row); joint != nullptr && !joint->empty())
      change_row(model, state, work, row, [&] { forget_joint(*joint, state.contacts.memory[row]); });
}

State<3> start_state(const Model<3>& model, double reach) {
  State<3> state = initial_state(model);
  set_bonds(model, state, reach);
  return state;
}

}  // namespace trilith
