// Two directions of a bearing at once: input and output of a law of both.
//
// A law that slips or yields under the resultant of the two has, in addition to its `respond` for one direction:
//
//     struct Horizontal { double ...; };                      its memory: doubles only, any number of them
//     respond_horizontal(const HorizontalMotion&, const Horizontal& before) -> HorizontalResponse<Horizontal>
//
// It also has begin_horizontal_at(displacement) unless its memory starts at 0. Signs follow law/bearing/direction.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>

#include "base/space.hpp"

namespace trilith {

/// The two numbers of a vector as stored in a memory.
using AlongAcross = std::array<double, 2>;
inline Vec2 vector_of(const AlongAcross& p) {
  return {p[0], p[1]};
}
inline AlongAcross along_across(const Vec2& v) {
  return {v.x(), v.y()};
}

struct HorizontalMotion {
  Vec2 displacement;   ///< along and across [m]
  Vec2 rate;           ///< [m/s]
  double dt;           ///< [s]
  double compression;  ///< compressive force of the bearing's axial direction, at least 0 [N]
  Vec2 mean = rate;    ///< rate over the step, as in DirectionMotion [m/s]
};

template <class Memory>
struct HorizontalResponse {
  Memory memory;
  Vec2 force = Vec2::Zero();  ///< without the dashpot [N]
  double stored = 0;          ///< elastic energy [J]
  double lost_inner = 0;      ///< plastic or frictional energy dissipated in this step [J]
  bool yielding = false;
};

template <class L>
concept HorizontalLaw = requires(const L& law, const HorizontalMotion& m, const typename L::Horizontal& before) {
  { law.respond_horizontal(m, before) } -> std::same_as<HorizontalResponse<typename L::Horizontal>>;
  { law.damping } -> std::convertible_to<double>;
};

/// Number of doubles in the memory of a law of both directions.
template <HorizontalLaw L>
inline constexpr std::size_t horizontal_numbers = sizeof(typename L::Horizontal) / sizeof(double);

/// The memory of such a law, from and to the first numbers that a bearing reserves for it.
template <HorizontalLaw L, std::size_t room>
typename L::Horizontal horizontal_memory(const std::array<double, room>& numbers) {
  static_assert(horizontal_numbers<L> <= room);
  std::array<double, horizontal_numbers<L>> own;
  std::copy_n(numbers.begin(), own.size(), own.begin());
  return std::bit_cast<typename L::Horizontal>(own);
}
template <class Memory, std::size_t room>
void keep_horizontal(const Memory& memory, std::array<double, room>& numbers) {
  const auto own = std::bit_cast<std::array<double, sizeof(Memory) / sizeof(double)>>(memory);
  std::copy(own.begin(), own.end(), numbers.begin());
}

}  // namespace trilith
