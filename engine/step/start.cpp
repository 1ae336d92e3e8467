#include "step/start.hpp"

#include <algorithm>
#include <cmath>

#include "contact/face_overlap.hpp"
#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"
#include "step/stored_energy.hpp"

namespace trilith {
namespace {

/// Faces that share less than this of the smaller body's size are those of neighbours across a corner, which settling
/// has pushed past each other by a hair; no mortar holds there.
constexpr double least_shared = 1e-3;

double smaller_size(const Model<2>& model, const NearPair& p) {
  return 2 * std::min(model.body_radius[model.piece_body[p.piece_a]], model.body_radius[model.piece_body[p.piece_b]]);
}

ContactMemory with_bond(ContactMemory memory, const FaceOverlap<double>& o) {
  memory.bonds = 3;
  memory.state |= contact_touching;
  memory.own[0] = memory.own[1] = 0;
  memory.set[0] = o.gap_lo + memory.crushed[0];
  memory.set[1] = o.gap_hi + memory.crushed[1];
  return memory;
}

ContactMemory without_bond(ContactMemory memory) {
  memory.bonds = 0;
  memory.own[0] = memory.own[1] = 0;
  return memory;
}

/// Gives a contact of two faces another memory; the ledger has the difference of the elastic energy.
void change_memory(const Model<2>& model, const Work<2>& work, std::size_t row, const ContactMemory& to,
                   State<2>& state) {
  const NearPair& pair = work.pairs[row];
  const FaceLaw law = face_law(model, pair.law, 0);
  const double before = pressing_energy(work, pair, state.memory[row], law);
  state.memory[row] = to;
  state.given[EnergyTerm::contact_fracture] += before - pressing_energy(work, pair, to, law);
}

}  // namespace

void set_bonds(const Model<2>& model, State<2>& state, double reach) {
  Work<2> work;
  place(model, state, work);
  find(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    NearPair& pair = work.pairs[row];
    const ContactMemory& memory = state.memory[row];
    if (bond_of(model.laws[pair.law]) == Bond::none || memory.bonds == 3) continue;
    if (!choose_face_pair(model, work, true, pair)) continue;
    const FaceOverlap<double> overlap = face_overlap(work, pair);
    const double size = smaller_size(model, pair);
    if (std::max(std::abs(overlap.gap_lo), std::abs(overlap.gap_hi)) > reach * size) continue;
    if (overlap.shared < least_shared * size) continue;
    change_memory(model, work, row, with_bond(memory, overlap), state);
  }
}

void lift_bonds(const Model<2>& model, State<2>& state) {
  Work<2> work;
  place(model, state, work);
  find(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row)
    if (state.memory[row].bonds != 0 && choose_face_pair(model, work, true, work.pairs[row]))
      change_memory(model, work, row, without_bond(state.memory[row]), state);
}

State<2> start_state(const Model<2>& model, double reach) {
  State<2> state = initial_state(model);
  set_bonds(model, state, reach);
  return state;
}

}  // namespace trilith
