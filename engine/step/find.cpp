// The pairs of pieces that may touch, and what the state remembers of their contacts.
#include <algorithm>

#include "base/make_room.hpp"
#include "detect/pairs.hpp"
#include "step/evaluate.hpp"
#include "step/impact_step.hpp"
#include "step/parted_contacts.hpp"
#include "step/stable_step.hpp"

namespace trilith {
namespace {

/// Where the laws of the pairs keep what they remember: one after the other in one array, each as long as its law asks.
/// Returns how long that is.
std::uint32_t lay_law_rows(const Model<2>& model, const Work<2>& work, std::vector<LawRow>& rows) {
  make_room(rows, work.pairs.size());
  rows.resize(work.pairs.size());
  std::uint32_t numbers = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t place = model.laws[work.pairs[row].law].index();
    rows[row] = {static_cast<std::uint32_t>(place), numbers};
    numbers += law_number_counts[place];
  }
  return numbers;
}

/// Brings what the state remembers into the rows of the pairs just found: kept memories move, the rest start empty.
/// What a law remembers is of no use to one of another kind.
void match_contacts(const Model<2>& model, const ContactHistory& state, Work<2>& work) {
  ContactHistory& now = work.matched;
  make_room(now.key, work.pairs.size()), make_room(now.memory, work.pairs.size());
  now.key.resize(work.pairs.size());
  now.memory.resize(work.pairs.size());
  now.law_memory.assign(lay_law_rows(model, work, now.law_row), 0.0);
  // Both lists are sorted by key, the pieces of a pair: one pass over both.
  std::size_t old = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {
    now.key[row] = contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b);
    while (old < state.size() && state.key[old] < now.key[row]) ++old;
    const bool remembers = old < state.size() && state.key[old] == now.key[row] && !state.memory[old].empty();
    now.memory[row] = remembers ? state.memory[old] : ContactMemory{};
    if (!remembers) continue;
    if (now.law_row[row].place == state.law_row[old].place)
      std::copy_n(state.law_numbers(old), law_number_counts[now.law_row[row].place], now.law_numbers(row));
  }
  work.is_matched = true;
}

/// As many rows, and all empty.
void copy_emptied(const ContactHistory& rows, ContactHistory& out) {
  make_room(out.key, rows.size()), make_room(out.memory, rows.size()), make_room(out.law_row, rows.size());
  out.key = rows.key;
  out.memory.assign(rows.size(), {});
  out.law_row = rows.law_row;
  out.law_memory.assign(rows.law_memory.size(), 0.0);
}

}  // namespace

/// Does nothing while all pieces keep within their boxes, as in nearly every step of what stands; nothing but to look
/// at faces again where those that left theirs have the same neighbours as before.
void find(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!pairs_outdated(model, state, work)) return;
  if (!work.valid) bound_faces(model, work), list_masses(model, work), work.ridges = shared_ridges(model);
  if (!find_pairs(model, state, work)) return;
  match_contacts(model, state.contacts, work);
  copy_emptied(work.matched, work.contacts);
  work.changed_rows.clear();
  work.row_shares.forget();
  if (work.threads > 1)  // what share_rows() will fill within a step
    make_room(work.row_shares.border, work.pairs.size()), make_room(work.row_shares.share_of, model.bodies.size());
  make_room(work.general_now, work.pairs.size());
  make_room(work.general_touching, work.pairs.size());
  make_room(work.changed_rows, work.pairs.size());
  make_room_for_closing(work);
}

}  // namespace trilith
