#include "model/check/check_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "field/field.hpp"

namespace trilith {
namespace {

[[noreturn]] void fail(const std::string& owner, std::string_view what) {
  throw InputError(damaged_state(owner, what));
}

/// Both pieces exist, the lower index first.
template <int D>
bool is_contact_of(const Model<D>& model, ContactKey key) {
  return first_piece(key) >= 0 && first_piece(key) < second_piece(key) && second_piece(key) < model.pieces();
}

bool in_known_state(const ContactMemory& m) {
  return !m.empty() && m.bonds <= 3 && m.state <= contact_states;
}
bool in_known_state(const SolidMemory& m) {
  return !m.empty() && m.state <= contact_states && m.crushed >= 0;
}

/// Rows are found by binary search, so their keys must increase.
template <int D>
void check_contacts(const std::string& owner, const Model<D>& model, const State<D>& s) {
  const Contacts<D>& c = s.contacts;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (!is_contact_of(model, c.key[i]) || (i > 0 && c.key[i - 1] >= c.key[i]))
      fail(owner, "has a contact of pieces that do not exist, or out of order");
    if (!in_known_state(c.memory[i])) fail(owner, "has a contact in an unknown state");
  }
  for (const Parted& p : s.parted)
    if (!is_contact_of(model, p.contact)) fail(owner, "has a lost contact of pieces that do not exist");
}

template <int D>
void check_passed(const std::string& owner, const Model<D>& model, const State<D>& s) {
  const int bodies = static_cast<int>(model.bodies.size());
  for (std::size_t i = 0; i < s.passed.size(); ++i) {
    const int a = first_piece(s.passed[i]), b = second_piece(s.passed[i]);
    if (a < 0 || a >= b || b >= bodies || (i > 0 && s.passed[i - 1] >= s.passed[i]))
      fail(owner, "has penetrated bodies that do not exist, or out of order");
  }
}

template <int D>
void check_accelerations(const std::string& owner, const State<D>& s) {
  if (s.implicit() && s.acceleration.size() != s.position.size())
    fail(owner, "has accelerations for other numbers of nodes than the model");
}

/// A square matrix in compressed columns, rows in order.
template <int D>
void check_tangent(const std::string& owner, const State<D>& s) {
  if (!s.tangent) return;
  const KeptTangent& t = *s.tangent;
  bool sound = !t.column.empty() && t.column.front() == 0 && t.row.size() == t.value.size() &&
               t.column.back() == static_cast<int>(t.row.size()) && std::is_sorted(t.column.begin(), t.column.end());
  for (int c = 0; sound && c < t.size(); ++c)
    for (int i = t.column[c]; i < t.column[c + 1]; ++i)
      sound = sound && t.row[i] < t.size() && (i == t.column[c] || t.row[i - 1] < t.row[i]);
  if (!sound) fail(owner, "has a tangent that is not a matrix");
}

template <int D>
void check_bearings(const std::string& owner, const State<D>& s) {
  constexpr std::uint32_t last = D == 2 ? 2 : 6;  // in space the horizontal resultant is last
  for (const BearingMemory<D>& m : s.bearing)
    if (m.status > BearingStatus::removed || m.failed_direction > last || !(m.stood_for >= 0))
      fail(owner, "has a bearing in an unknown state");
}

/// A body is removed if it is held out and has a time that is not negative.
template <int D>
void check_removed(const std::string& owner, const State<D>& s) {
  if (!s.removed_at.empty() && s.removed_at.size() != s.left.size())
    fail(owner, "has times of removal for other numbers of bodies than the model");
  for (std::size_t b = 0; b < s.removed_at.size(); ++b)
    if (s.is_removed(b) && (s.removed_at[b] < 0 || s.left[b] == 0)) fail(owner, "marks a present body as removed");
}

/// A field has at most the cells of the model; cells added later are missing.
template <int D>
void check_fields(const std::string& owner, const Model<D>& model, const State<D>& s) {
  if (s.fields.size() > model.fields.size()) fail(owner, "has a field that the model lacks");
  for (std::size_t i = 0; i < s.fields.size(); ++i)
    if (s.fields[i].value.size() > model.fields[i]->capacity.size() ||
        s.fields[i].supplied.size() > model.fields[i]->surroundings.size())
      fail(owner, "has a field with other numbers of cells than the model");
}

}  // namespace

std::string damaged_state(const std::string& owner, std::string_view what) {
  return fmt::format("{} {}; it is damaged, use an earlier one", owner, what);
}

template <int D>
void check_state(const Model<D>& model, const State<D>& state, const std::string& owner) {
  check_accelerations(owner, state);
  check_tangent(owner, state);
  check_contacts(owner, model, state);
  check_passed(owner, model, state);
  check_bearings(owner, state);
  check_removed(owner, state);
  check_fields(owner, model, state);
}

template void check_state(const Model<2>&, const State<2>&, const std::string&);
template void check_state(const Model<3>&, const State<3>&, const std::string&);

}  // namespace trilith
