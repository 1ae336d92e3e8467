// Contact pairs: candidate pairs of pieces, and their contact memories from the state.
#include <algorithm>

#include "assembly/bounds/face_bounds.hpp"
#include "assembly/contact/body_masses.hpp"
#include "assembly/contact/closing_contacts.hpp"
#include "assembly/evaluate.hpp"
#include "base/make_room.hpp"
#include "base/team.hpp"
#include "broad_phase/pairs.hpp"

namespace trilith {
namespace {

/// Assigns each pair its part of the array of law memories, contiguous, with the size that its law requires. Returns
/// the total size.
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

/// match_contacts() for the pairs from `first` to before `last`. Both lists are sorted by key (the two pieces), so one
/// pass over both is sufficient.
void match_rows(const Work<2>& work, const ContactHistory& state, std::size_t first, std::size_t last,
                ContactHistory& now) {
  if (first == last) return;
  const auto key_at = [&](std::size_t row) { return contact_key(work.pairs[row].piece_a, work.pairs[row].piece_b); };
  auto old =
      static_cast<std::size_t>(std::lower_bound(state.key.begin(), state.key.end(), key_at(first)) - state.key.begin());
  for (std::size_t row = first; row < last; ++row) {
    now.key[row] = key_at(row);
    while (old < state.size() && state.key[old] < now.key[row]) ++old;
    const bool remembers = old < state.size() && state.key[old] == now.key[row] && !state.memory[old].empty();
    now.memory[row] = remembers ? state.memory[old] : ContactMemory{};
    if (!remembers) continue;
    if (now.law_row[row].place == state.law_row[old].place)
      std::copy_n(state.law_numbers(old), law_number_counts[now.law_row[row].place], now.law_numbers(row));
  }
}

/// Resizes the rows; their content is undefined.
void resize_rows(std::size_t count, ContactHistory& rows) {
  make_room(rows.key, count), make_room(rows.memory, count);
  rows.key.resize(count), rows.memory.resize(count);
}

/// Rows per chunk of a thread, about 10 microseconds.
constexpr int matched_stretch = 512;

/// Transfers the contact memories of the state to the rows of the new pairs; new pairs start empty. A memory is reset
/// if the law of the pair is of another kind. The trial gets the same number of empty rows.
void match_contacts(const Model<2>& model, const ContactHistory& state, Work<2>& work) {
  ContactHistory &now = work.matched, &trial = work.contacts;
  resize_rows(work.pairs.size(), now), resize_rows(work.pairs.size(), trial);
  now.law_memory.assign(lay_law_rows(model, work, now.law_row), 0.0);
  trial.law_memory.assign(now.law_memory.size(), 0.0);
  make_room(trial.law_row, now.size());
  trial.law_row = now.law_row;
  share(work.threads, static_cast<int>(now.size()), matched_stretch, [&](int first, int last, int /*thread*/) {
    match_rows(work, state, static_cast<std::size_t>(first), static_cast<std::size_t>(last), now);
    std::copy(now.key.begin() + first, now.key.begin() + last, trial.key.begin() + first);
    std::fill(trial.memory.begin() + first, trial.memory.begin() + last, ContactMemory{});
  });
  work.is_matched = true;
}

}  // namespace

/// Does nothing while all pieces remain in their fat boxes, as in nearly every step of a standing structure. If the
/// pieces that left their boxes have the same neighbours as before, only their faces are updated.
void update_contact_pairs(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (!pairs_outdated(model, state, work)) return;
  if (!work.valid) bound_faces(model, work), list_masses(model, work), work.ridges = shared_edges(model);
  if (!find_pairs(model, state, work)) return;
  match_contacts(model, state.contacts, work);
  work.changed_rows.clear();
  work.row_shares.forget();
  if (work.threads > 1)  // buffers that partition_face_contacts() fills within a step
    make_room(work.row_shares.border, work.pairs.size()), make_room(work.row_shares.share_of, model.bodies.size());
  make_room(work.general_now, work.pairs.size());
  work.general_touching.reserve(work.pairs.size());
  make_room(work.changed_rows, work.pairs.size());
  reserve_closing_contacts(work);
}

}  // namespace trilith
