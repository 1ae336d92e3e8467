// Results of general contacts: a table with a slot for each row that may touch, and a list of the slots that touch.
//
// Threads write to the slots of their rows, and only the list is assembled afterwards: nothing is moved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "base/make_room.hpp"
#include "base/space.hpp"

namespace trilith {

/// Result of one row's general contact, for the step estimate, events and recording.
template <int D>
struct GeneralContact {
  int row;
  double size;    ///< length in contact [m], in space the area [m2]
  double depth;   ///< largest overlap [m]
  Vec<D> centre;  ///< centre of pressure [m]
  Vec<D> force;   ///< on the second body [N]
};

/// Contacts that touch, in the order of listing.
template <int D>
class GeneralContacts {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = GeneralContact<D>;
    using difference_type = std::ptrdiff_t;
    using pointer = const value_type*;
    using reference = const value_type&;

    Iterator(const GeneralContact<D>* table, const int* at) : table_(table), at_(at) {}
    reference operator*() const { return table_[*at_]; }
    Iterator& operator++() { return ++at_, *this; }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    const GeneralContact<D>* table_;
    const int* at_;
  };

  [[nodiscard]] std::size_t size() const { return listed_.size(); }
  [[nodiscard]] bool empty() const { return listed_.empty(); }
  [[nodiscard]] const GeneralContact<D>& operator[](std::size_t i) const { return table_[place(i)]; }
  [[nodiscard]] Iterator begin() const { return {table_.data(), listed_.data()}; }
  [[nodiscard]] Iterator end() const { return {table_.data(), listed_.data() + listed_.size()}; }
  /// The result of a row; nullptr: it does not touch. The rows of the list increase.
  [[nodiscard]] const GeneralContact<D>* find(int row) const {
    const auto at = std::lower_bound(listed_.begin(), listed_.end(), row,
                                     [&](int p, int r) { return table_[static_cast<std::size_t>(p)].row < r; });
    if (at == listed_.end()) return nullptr;
    const GeneralContact<D>& found = table_[static_cast<std::size_t>(*at)];
    return found.row == row ? &found : nullptr;
  }

  /// Reserves capacity, so that nothing is allocated within a step.
  void reserve(std::size_t count) { make_room(table_, count), make_room(listed_, count); }
  /// Clears the list; there are `places` slots with undefined contents.
  void begin_anew(std::size_t places) {
    listed_.clear();
    if (table_.size() < places) table_.resize(places);
  }
  /// To be written by the thread that computes the slot's row.
  [[nodiscard]] GeneralContact<D>& at(int place) { return table_[static_cast<std::size_t>(place)]; }
  /// Appends the slots of contacts that touch.
  void list(const std::vector<int>& places) { listed_.insert(listed_.end(), places.begin(), places.end()); }

 private:
  std::vector<GeneralContact<D>> table_;  ///< [slot]
  std::vector<int> listed_;               ///< slots that touch

  [[nodiscard]] std::size_t place(std::size_t i) const { return static_cast<std::size_t>(listed_[i]); }
};

}  // namespace trilith
