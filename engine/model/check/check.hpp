// Checks of a model before it runs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Bodies to be checked: the bodies from `first` on, against all others that are present; or the bodies that return,
/// against the present ones.
struct Newcomers {
  int first = 0;
  const std::vector<std::uint8_t>* out = nullptr;   ///< [body] 1: absent; nullptr: all are present
  const std::vector<std::uint8_t>* back = nullptr;  ///< [body] 1: it returns; nullptr: none does

  [[nodiscard]] bool is_there(int body) const {
    return out == nullptr || static_cast<std::size_t>(body) >= out->size() || (*out)[body] == 0;
  }
  [[nodiscard]] bool concerns(int a, int b) const {
    if (back != nullptr && (*back)[a] == (*back)[b]) return false;
    return std::max(a, b) >= first && is_there(a) && is_there(b);
  }
};

/// Adds a fault for each two bodies that may touch and overlap at the start by more than `allowed` times the smaller
/// one's size: their names and the depth, the largest relative depth first. Without faults, the deepest overlap is
/// noted.
template <int D>
void check_overlaps(const Model<D>& model, double allowed, std::vector<std::string>& faults,
                    std::vector<std::string>& notes, const Newcomers& among = {});

/// Adds a fault for each free body under gravity that is not connected, by contact or links, to a fixed or driven body.
/// `floating`: [body] 1 where this is intended. Bodies before `among` are not checked.
template <int D>
void check_held_up(const Model<D>& model, const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                   const Newcomers& among = {});

}  // namespace trilith
