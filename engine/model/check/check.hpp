// Checks of a model before it runs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Which bodies are looked at: those from `first` on, beside all others but those that are out; or those that come
/// back, beside what is there.
struct Newcomers {
  int first = 0;
  const std::vector<std::uint8_t>* out = nullptr;   ///< [body] 1: it is not there; nullptr: all are
  const std::vector<std::uint8_t>* back = nullptr;  ///< [body] 1: it comes back; nullptr: none does

  [[nodiscard]] bool is_there(int body) const {
    return out == nullptr || static_cast<std::size_t>(body) >= out->size() || (*out)[body] == 0;
  }
  [[nodiscard]] bool concerns(int a, int b) const {
    if (back != nullptr && (*back)[a] == (*back)[b]) return false;
    return std::max(a, b) >= first && is_there(a) && is_there(b);
  }
};

/// A fault for each two bodies that may touch and overlap deeper at the start than `allowed` times the smaller one's
/// size: their names and the depth, the deepest for its size first. Where there is none, the deepest is noted.
template <int D>
void check_overlaps(const Model<D>& model, double allowed, std::vector<std::string>& faults,
                    std::vector<std::string>& notes, const Newcomers& among = {});

/// A fault for each free body on which gravity acts and that neither touches, nor is linked to, anything that leads to
/// a fixed or driven body. `floating`: [body] 1 where that is meant. What came before `among` is not asked.
template <int D>
void check_held_up(const Model<D>& model, const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                   const Newcomers& among = {});

}  // namespace trilith
