#include "assembly/start.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/bonded_length.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/joint/face_resultant.hpp"

namespace trilith {
namespace {

/// change(law, memory, law memory) modifies the memory of a contact of two faces whose law has bonds; the ledger
/// receives the difference in elastic energy.
template <class Change>
void change_bond(const Model<2>& model, const Work<2>& work, std::size_t row, State<2>& state, Change&& change) {
  const NearPair& pair = work.pairs[row];
  const FaceOverlap<double> overlap = face_overlap(work, pair);
  ContactMemory& memory = state.contacts.memory[row];
  with_kernel(law_in_use(model, pair.law), [&]<class K>(const K& law) {
    if constexpr (K::bonds) {
      LawMemory<K> own = law_memory<K>(state.contacts.law_numbers(row));
      const double before = pressing_energy(overlap, memory, own, law);
      change(law, memory, own);
      keep_law_memory<K>(own, state.contacts.law_numbers(row));
      state.given[EnergyTerm::contact_fracture] += before - pressing_energy(overlap, memory, own, law);
    }
  });
}

/// Finds the candidate pairs and moves the contacts of the state to their rows.
void find_contacts(const Model<2>& model, State<2>& state, Work<2>& work) {
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  state.contacts = work.matched;
}

}  // namespace

/// Puts mortar between opposed faces within `reach` of the smaller body's size, in their present position. Stresses
/// remain (see Filling); the ledger receives the change of stored energy.
void set_bonds(const Model<2>& model, State<2>& state, double reach, int first_body) {
  Work<2> work;
  find_contacts(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    NearPair& pair = work.pairs[row];
    const ContactMemory& memory = state.contacts.memory[row];
    if (std::max(model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]) < first_body) continue;
    // A joint bonded on both halves remains unchanged, so the function can be called again.
    if (!may_bond(model.laws[pair.law]) || memory.bonds == 3) continue;
    if (!choose_face_pair(model, work, true, pair)) continue;
    const FaceOverlap<double> overlap = face_overlap(work, pair);
    // Length and gap of the joint are compared with the smaller of both bodies.
    const double size = smaller_size(model, pair.piece_a, pair.piece_b);
    if (std::max(std::abs(overlap.gap_lo), std::abs(overlap.gap_hi)) > reach * size) continue;
    if (overlap.shared < least_bonded_share * size) continue;
    change_bond(model, work, row, state, [&](const auto& law, ContactMemory& contact, auto& own) {
      contact.bonds = 3;
      contact.state |= contact_touching;
      law.set_bond(own, overlap.gap_lo, overlap.gap_hi);
    });
  }
}

/// Removes the bonds, as of fresh mortar: joints have pressure and friction only.
void lift_bonds(const Model<2>& model, State<2>& state) {
  Work<2> work;
  find_contacts(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row)
    if (state.contacts.memory[row].bonds != 0 && choose_face_pair(model, work, true, work.pairs[row]))
      change_bond(model, work, row, state, [](const auto& law, ContactMemory& contact, auto& own) {
        contact.bonds = 0;
        law.lift_bond(own);
      });
}

State<2> start_state(const Model<2>& model, double reach) {
  State<2> state = initial_state(model);
  set_bonds(model, state, reach);
  return state;
}

}  // namespace trilith
