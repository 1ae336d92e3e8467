// Grouping of rows with flat faces for their kernel: groups of four rows of one kind (FlatResponses::kind), which
// follow the same branches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "contact/space/flat_contact.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {

/// Positions of rows in their chunk, sorted by kind. A counting sort, because comparisons of kinds mispredict and would
/// cost more than half of the gain. Two kinds may share a bucket; the grouping does not change the results.
class RowsByKind {
 public:
  static constexpr std::size_t most = 256;  ///< a position is a byte

  void put(int place, const FacePair& faces) {
    const std::uint32_t many = faces.few ? 0 : std::uint32_t{flat_kinds},
                        drawer = (many | static_cast<std::uint32_t>(faces.kind)) * golden >> (32 - drawer_bits);
    place_[count_] = static_cast<std::uint8_t>(place), drawer_[count_++] = static_cast<std::uint8_t>(drawer);
    ++next_[drawer];
  }
  /// Call it once.
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
  static constexpr std::uint32_t golden = 0x9E3779B1;  // 2^32 over the golden ratio: spreads neighbouring kinds
  static constexpr int drawer_bits = 7;
  std::array<std::uint16_t, 1 << drawer_bits> next_{};
  std::array<std::uint8_t, most> place_, drawer_, ordered_;
  std::size_t count_ = 0;
};

}  // namespace trilith
