// Memories of the contacts, row by row.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "contact/joint/joint_memory.hpp"
#include "contact/space/solid_contact.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// The two pieces of a contact, lower index first, as one sortable number.
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

/// Sorted by key; every contact with a memory, and any number of empty ones.
struct ContactHistory {
  std::vector<ContactKey> key;        ///< [contact]
  std::vector<ContactMemory> memory;  ///< [contact]
  std::vector<LawRow> law_row;        ///< [contact]
  std::vector<double> law_memory;     ///< memories of the laws, row after row

  [[nodiscard]] std::size_t size() const { return key.size(); }
  /// Memory of a contact's law.
  [[nodiscard]] const double* law_numbers(std::size_t row) const { return law_memory.data() + law_row[row].first; }
  [[nodiscard]] double* law_numbers(std::size_t row) { return law_memory.data() + law_row[row].first; }
  /// Clears the memory of a contact.
  void clear(std::size_t row);
  /// The row of a contact, or -1.
  [[nodiscard]] int find(ContactKey contact) const;
};

/// For solids in space. A bonding law's memory of bonded faces is stored in a separate joint.
struct SolidHistory {
  std::vector<ContactKey> key;         ///< [contact]
  std::vector<SolidMemory> memory;     ///< [contact]
  std::vector<std::int32_t> joint_of;  ///< [contact] index into `joint`, -1: none; empty if there is no joint at all
  std::vector<JointMemory> joint;

  [[nodiscard]] std::size_t size() const { return key.size(); }
  /// The joint of a contact, nullptr if there is none. Inline, because it is called for every row.
  [[nodiscard]] const JointMemory* joint_at(std::size_t row) const {
    return row < joint_of.size() && joint_of[row] >= 0 ? &joint[static_cast<std::size_t>(joint_of[row])] : nullptr;
  }
  [[nodiscard]] JointMemory* joint_at(std::size_t row) {
    return row < joint_of.size() && joint_of[row] >= 0 ? &joint[static_cast<std::size_t>(joint_of[row])] : nullptr;
  }
  /// Clears the memory of a contact.
  void clear(std::size_t row) {
    memory[row] = {};
    if (JointMemory* j = joint_at(row)) *j = {};
  }
  /// The row of a contact, or -1.
  [[nodiscard]] int find(ContactKey contact) const;
  /// Adds a joint to a contact without one.
  JointMemory& add_joint(std::size_t row) {
    joint_of.resize(key.size(), -1);
    joint_of[row] = static_cast<std::int32_t>(joint.size());
    return joint.emplace_back();
  }
};

/// Memories of the contacts of a model in D dimensions.
template <int D>
using Contacts = std::conditional_t<D == 2, ContactHistory, SolidHistory>;

}  // namespace trilith
