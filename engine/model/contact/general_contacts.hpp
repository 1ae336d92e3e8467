// What contacts of general shape came to: a table with a place for each row that may touch, and a list of those that
// do.
//
// Threads write to the places of their own rows, and the list alone is put together once all are answered: nothing is
// moved.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "base/make_room.hpp"
#include "base/space.hpp"

namespace trilith {

/// What the general contact of one row came to, for the step estimate, events and recording.
template <int D>
struct GeneralContact {
  int row;
  double size;    ///< length in contact [m], in space the area [m2]
  double depth;   ///< greatest overlap [m]
  Vec<D> centre;  ///< centre of pressure [m]
  Vec<D> force;   ///< on the second body [N]
};

/// Contacts that touch, in the order in which they were listed.
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
  /// That of a row; nullptr: it does not touch. The rows of the list rise.
  [[nodiscard]] const GeneralContact<D>* find(int row) const {
    const auto at = std::lower_bound(listed_.begin(), listed_.end(), row,
                                     [&](int p, int r) { return table_[static_cast<std::size_t>(p)].row < r; });
    if (at == listed_.end()) return nullptr;
    const GeneralContact<D>& found = table_[static_cast<std::size_t>(*at)];
    return found.row == row ? &found : nullptr;
  }

  /// Room for so many, so that none is asked for within a step.
  void reserve(std::size_t count) { make_room(table_, count), make_room(listed_, count); }
  /// None touches; there are `places`, of no meaning yet.
  void begin_anew(std::size_t places) {
    listed_.clear();
    if (table_.size() < places) table_.resize(places);
  }
  /// To be written by whoever answers the row that has this place.
  [[nodiscard]] GeneralContact<D>& at(int place) { return table_[static_cast<std::size_t>(place)]; }
  /// Places of contacts that touch.
  void list(const std::vector<int>& places) { listed_.insert(listed_.end(), places.begin(), places.end()); }

 private:
  std::vector<GeneralContact<D>> table_;  ///< [place]
  std::vector<int> listed_;               ///< places of those that touch

  [[nodiscard]] std::size_t place(std::size_t i) const { return static_cast<std::size_t>(listed_[i]); }
};

}  // namespace trilith
