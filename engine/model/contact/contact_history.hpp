// What the contacts remember, row by row.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "contact/joint/joint_memory.hpp"
#include "contact/space/solid_contact.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// The two pieces of a contact, lower index first, in one sortable number.
using ContactKey = std::uint64_t;
constexpr ContactKey contact_key(int piece_a, int piece_b) {
  return static_cast<ContactKey>(static_cast<std::uint32_t>(piece_a)) << 32 | static_cast<std::uint32_t>(piece_b);
}
constexpr int first_piece(ContactKey key) {
  return static_cast<int>(key >> 32);
}
constexpr int second_piece(ContactKey key) {
  return static_cast<int>(key & 0xffffffffU);
}

/// Sorted by key; every contact that remembers something, and any number of empty ones.
struct ContactHistory {
  std::vector<ContactKey> key;        ///< [contact]
  std::vector<ContactMemory> memory;  ///< [contact]
  std::vector<LawRow> law_row;        ///< [contact]
  std::vector<double> law_memory;     ///< what the laws remember beside that, row after row

  [[nodiscard]] std::size_t size() const { return key.size(); }
  /// What the law of a contact remembers.
  [[nodiscard]] const double* law_numbers(std::size_t row) const { return law_memory.data() + law_row[row].first; }
  [[nodiscard]] double* law_numbers(std::size_t row) { return law_memory.data() + law_row[row].first; }
  /// Lets a contact forget everything.
  void clear(std::size_t row);
  /// The row of a contact, or -1.
  [[nodiscard]] int find(ContactKey contact) const;
};

/// The same of solids in space. What a bonding law remembers of faces that hold together is in a joint of their own.
struct SolidHistory {
  std::vector<ContactKey> key;         ///< [contact]
  std::vector<SolidMemory> memory;     ///< [contact]
  std::vector<std::int32_t> joint_of;  ///< [contact] index into `joint`, -1: none; empty where there is no joint at all
  std::vector<JointMemory> joint;

  [[nodiscard]] std::size_t size() const { return key.size(); }
  /// The joint of a contact, nullptr where there is none. Inline: asked of every row.
  [[nodiscard]] const JointMemory* joint_at(std::size_t row) const {
    return row < joint_of.size() && joint_of[row] >= 0 ? &joint[static_cast<std::size_t>(joint_of[row])] : nullptr;
  }
  [[nodiscard]] JointMemory* joint_at(std::size_t row) {
    return row < joint_of.size() && joint_of[row] >= 0 ? &joint[static_cast<std::size_t>(joint_of[row])] : nullptr;
  }
  /// Lets a contact forget everything.
  void clear(std::size_t row) {
    memory[row] = {};
    if (JointMemory* j = joint_at(row)) *j = {};
  }
  /// The row of a contact, or -1.
  [[nodiscard]] int find(ContactKey contact) const;
  /// Gives a contact a joint; it had none.
  JointMemory& add_joint(std::size_t row) {
    joint_of.resize(key.size(), -1);
    joint_of[row] = static_cast<std::int32_t>(joint.size());
    return joint.emplace_back();
  }
};

/// What the contacts of a model of D dimensions remember.
template <int D>
using Contacts = std::conditional_t<D == 2, ContactHistory, SolidHistory>;

}  // namespace trilith
