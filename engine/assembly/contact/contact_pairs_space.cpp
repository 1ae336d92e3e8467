// Contact pairs in space: candidate pairs of pieces, and their contact memories from the state.
#include <algorithm>

#include "assembly/bounds/face_bounds.hpp"
#include "assembly/contact/body_masses.hpp"
#include "assembly/contact/closing_contacts.hpp"
#include "assembly/evaluate.hpp"
#include "base/make_room.hpp"
#include "broad_phase/solid_pairs.hpp"

namespace trilith {
namespace {

/// Transfers the contact memories of the state to the rows of the new pairs; new pairs start empty. Both lists are
/// sorted by key.
void match_solids(const SolidHistory& state, Work<3>& work) {
  SolidHistory& now = work.matched;
  make_room(now.key, work.pairs.size()), make_room(now.memory, work.pairs.size());
  now.key.resize(work.pairs.size());
  now.memory.resize(work.pairs.size());
  now.joint_of.clear(), now.joint.clear();
  now.joint.reserve(state.joint.size());
  std::size_t old = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {
    now.key[row] = contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b);
    while (old < state.size() && state.key[old] < now.key[row]) ++old;
    const bool was_there = old < state.size() && state.key[old] == now.key[row];
    now.memory[row] = was_there ? state.memory[old] : SolidMemory{};
    if (!was_there) continue;
    if (const JointMemory* joint = state.joint_at(old); joint != nullptr && !joint->empty())
      now.add_joint(row) = *joint;
  }
  work.is_matched = true;
}

/// Copies the size of rows and joints, all empty. The memory is reused: granular flow has a new list every few steps.
void copy_emptied(const SolidHistory& rows, SolidHistory& out) {
  make_room(out.key, rows.size()), make_room(out.memory, rows.size());
  out.key = rows.key, out.joint_of = rows.joint_of;
  out.memory.assign(rows.size(), {});
  out.joint.assign(rows.joint.size(), {});
}

}  // namespace

/// Does nothing while the list of pairs is valid, or if the updated pieces have the same neighbours as before.
void update_contact_pairs(const Model<3>& model, const State<3>& state, Work<3>& work) {
  if (!solids_are_due(model, state, work)) return;
  if (!work.valid) bound_faces(model, work), list_masses(model, work), work.ridges = shared_edges(model);
  if (!find_solid_pairs(model, state, work)) return;
  match_solids(state.contacts, work);
  copy_emptied(work.matched, work.contacts);
  work.changed_rows.clear();
  make_room(work.changed_rows, work.pairs.size());
  reserve_closing_contacts(work);
  work.general_touching.reserve(work.pairs.size());
}

}  // namespace trilith
