// Digest of bytes: two results have the same bits if their sixteen hexadecimal digits agree.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace trilith {

/// FNV-1a, 64 bit (Fowler, Noll and Vo), fed eight bytes at a time. Not for cryptography.
class Hash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3ULL;
    value_ ^= value_ >> 29;
  }
  /// -0.0 and 0.0 give different digests, because the digest covers the bits.
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    add(static_cast<std::uint64_t>(text.size()));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace trilith
