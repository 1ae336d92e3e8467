// The words of a state, for files: a writer and a reader with the same functions, so that one walk over the fields
// serves both.
#pragma once

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "model/check/check_state.hpp"
#include "model/state.hpp"

namespace trilith {

/// Two halves of a word.
constexpr std::uint64_t word_of(std::uint32_t high, std::uint32_t low) {
  return std::uint64_t{high} << 32 | low;
}
constexpr std::uint32_t high_half(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32);
}
constexpr std::uint32_t low_half(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}

/// Converts the parts of a state to words.
class StateWriter {
 public:
  std::vector<std::uint64_t> words;

  void number(const double& v) { words.push_back(std::bit_cast<std::uint64_t>(v)); }
  void whole(const std::int64_t& v) { words.push_back(std::bit_cast<std::uint64_t>(v)); }
  void key(const ContactKey& v) { words.push_back(v); }
  void flag(const std::uint8_t& v) { words.push_back(v); }
  void index(const int& v) { words.push_back(static_cast<std::uint64_t>(v)); }
  template <class T, class U>
  void pair(const T& high, const U& low) {
    words.push_back(word_of(static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(low)));
  }
  template <class Rows>
  std::size_t count(const Rows& rows) {
    words.push_back(rows.size());
    return rows.size();
  }
  template <class Rows>
  std::size_t open_count(const Rows& rows, std::size_t /*least*/) {
    return count(rows);
  }
  /// Whether masses are scaled; their shares then follow.
  template <int D>
  [[nodiscard]] bool scaled(const State<D>& s) const {
    return !s.added_share.empty() || flooded(s);
  }
  /// Whether there are data of water; they then follow.
  template <int D>
  [[nodiscard]] bool flooded(const State<D>& s) const {
    return !s.flooded.empty() || s.given[EnergyTerm::water] != 0 || heated(s);
  }
  /// Whether there are fields; they then follow.
  template <int D>
  [[nodiscard]] bool heated(const State<D>& s) const {
    return !s.fields.empty() || s.given[EnergyTerm::heat] != 0;
  }
  /// Whether there are data of changing models or of mass scaling; they then follow.
  template <int D>
  [[nodiscard]] bool changed(const State<D>& s) const {
    const auto later = std::span(s.given.value).subspan(plain_energy_terms);
    return !s.removed_at.empty() || !s.added_share.empty() || flooded(s) ||
           std::any_of(later.begin(), later.end(), [](double v) { return v != 0; });
  }
};

/// Converts words to the parts of a state; reports the defect if that fails.
class StateReader {
 public:
  StateReader(std::span<const std::uint64_t> words, std::string owner) : words_(words), owner_(std::move(owner)) {}

  void number(double& v) {
    v = std::bit_cast<double>(next());
    if (!std::isfinite(v)) fail("holds a number that is not finite");
  }
  void whole(std::int64_t& v) {
    v = std::bit_cast<std::int64_t>(next());
    if (v < 0) fail("holds a negative number of steps");
  }
  void key(ContactKey& v) { v = next(); }
  void flag(std::uint8_t& v) {
    const std::uint64_t word = next();
    if (word > 1) fail("holds a flag that is neither 0 nor 1");
    v = static_cast<std::uint8_t>(word);
  }
  void index(int& v) {
    const std::uint64_t word = next();
    if (word > INT_MAX) fail("holds an impossible table index");
    v = static_cast<int>(word);
  }
  template <class T, class U>
  void pair(T& high, U& low) {
    const std::uint64_t word = next();
    high = static_cast<T>(high_half(word));
    low = static_cast<U>(low_half(word));
  }
  /// Reads a count that must equal the size of `rows`.
  template <class Rows>
  std::size_t count(const Rows& rows) {
    if (next() != rows.size()) fail("has other numbers of rows than the model");
    return rows.size();
  }
  /// Reads a count of rows of at least `least` words each, and resizes the rows.
  template <class Rows>
  std::size_t open_count(Rows& rows, std::size_t least) {
    const std::uint64_t n = next();
    if (n > words_.size() / least) fail("is shorter than it announces");
    rows.resize(static_cast<std::size_t>(n));
    return rows.size();
  }
  /// See StateWriter: the data follow if more words remain.
  template <int D>
  [[nodiscard]] bool changed(const State<D>& /*s*/) const {
    return at_ < words_.size();
  }
  template <int D>
  [[nodiscard]] bool scaled(const State<D>& s) const {
    return changed(s);
  }
  template <int D>
  [[nodiscard]] bool flooded(const State<D>& s) const {
    return changed(s);
  }
  template <int D>
  [[nodiscard]] bool heated(const State<D>& s) const {
    return changed(s);
  }
  void done() const {
    if (at_ != words_.size()) fail("is longer than its contents");
  }
  [[noreturn]] void fail(std::string_view what) const { throw InputError(damaged_state(owner_, what)); }

 private:
  std::uint64_t next() {
    if (at_ >= words_.size()) fail("is shorter than it announces");
    return words_[at_++];
  }
  std::span<const std::uint64_t> words_;
  std::size_t at_ = 0;
  std::string owner_;
};

}  // namespace trilith
