// The pairs of pieces that may touch, and what the state remembers of their contacts.
#include <algorithm>

#include "detect/pairs.hpp"
#include "step/evaluate.hpp"
#include "step/stable_step.hpp"

namespace trilith {
namespace {

/// Where the laws of the pairs keep what they remember.
/// One after the other in one array, each as long as its law asks.
std::vector<LawRow> law_rows(const Model<2>& model, const Work<2>& work) {
  std::vector<LawRow> rows(work.pairs.size());
  std::uint32_t numbers = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t place = model.laws[work.pairs[row].law].index();
    rows[row] = {static_cast<std::uint32_t>(place), numbers};
    numbers += law_number_counts[place];
  }
  return rows;
}

/// Brings what the state remembers into the rows of the pairs just found: kept memories move, the rest start empty.
/// What a law remembers is of no use to one of another kind.
void match_contacts(const Model<2>& model, const ContactHistory& state, Work<2>& work) {
  ContactHistory& now = work.matched;
  now.key.resize(work.pairs.size());
  now.memory.assign(work.pairs.size(), {});
  now.law_row = law_rows(model, work);
  const auto numbers = [](const LawRow& row) { return law_number_counts[row.place]; };
  now.law_memory.assign(now.law_row.empty() ? 0 : now.law_row.back().first + numbers(now.law_row.back()), 0.0);
  // Both lists are sorted by key, the pieces of a pair: one pass over both.
  std::size_t old = 0;
  for (std::size_t row = 0; row < now.size(); ++row) {
    now.key[row] = contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b);
    while (old < state.size() && state.key[old] < now.key[row]) ++old;
    if (old == state.size() || state.key[old] != now.key[row]) continue;
    now.memory[row] = state.memory[old];
    if (now.law_row[row].place == state.law_row[old].place)
      std::copy_n(state.law_numbers(old), numbers(now.law_row[row]), now.law_numbers(row));
  }
  work.is_matched = true;
}

/// As many rows, and all empty.
ContactHistory emptied(const ContactHistory& rows) {
  return {rows.key, std::vector<ContactMemory>(rows.size()), rows.law_row, std::vector<double>(rows.law_memory.size())};
}

}  // namespace

/// Does nothing while the list of pairs still holds, as in nearly every step.
void find(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!pairs_outdated(model, state, work)) return;
  if (!work.valid) bound_faces(model, work);
  find_pairs(model, state, work);
  match_contacts(model, state.contacts, work);
  work.contacts = emptied(work.matched);
  work.changed_rows.clear();
  work.general_now.reserve(work.pairs.size());
  work.general_touching.reserve(work.pairs.size());
  work.changed_rows.reserve(work.pairs.size());
}

}  // namespace trilith
