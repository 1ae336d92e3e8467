// Which rows of faces that lie flat go four at a time through their kernel: those of one kind (FlatResponses::kind),
// which it answers by the same branches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contact/space/flat_contact.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {

/// Places of rows in their stretch, put in order by kind. By counting: comparisons of kinds that no processor foresees
/// cost more than half of what it saves that those of a kind go together. Now and then two kinds share a drawer; which
/// rows go together changes no bit.
class RowsByKind {
 public:
  static constexpr std::size_t most = 256;  ///< a place is a byte

  void put(int place, const FacePair& faces) {
    const std::uint32_t many = faces.few ? 0 : std::uint32_t{flat_kinds},
                        drawer = (many | static_cast<std::uint32_t>(faces.kind)) * golden >> (32 - drawer_bits);
    place_[count_] = static_cast<std::uint8_t>(place), drawer_[count_++] = static_cast<std::uint8_t>(drawer);
    ++next_[drawer];
  }
  /// To be asked for once.
  std::span<const std::uint8_t> ordered() {
    std::uint32_t sum = 0;
    for (std::uint16_t& next : next_) {
      const std::uint32_t size = next;
      next = static_cast<std::uint16_t>(sum);
      sum += size;
    }
    for (std::size_t i = 0; i < count_; ++i) ordered_[next_[drawer_[i]]++] = place_[i];
    return {ordered_.data(), count_};
  }

 private:
  static constexpr std::uint32_t golden = 0x9E3779B1;  // 2^32 over the golden ratio: neighbours come far apart
  static constexpr int drawer_bits = 7;
  std::array<std::uint16_t, 1 << drawer_bits> next_{};
  std::array<std::uint8_t, most> place_, drawer_, ordered_;
  std::size_t count_ = 0;
};

}  // namespace trilith
