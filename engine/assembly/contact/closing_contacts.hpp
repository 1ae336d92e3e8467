// Memory for the contacts that close in a step, reserved with the list of pairs so that a step allocates none.
#pragma once

#include <cstddef>

#include "model/work.hpp"

namespace trilith {

/// Index of a contact in the table of flags of closing contacts (Fibonacci hashing; Knuth, The Art of Computer
/// Programming 3, 1998, 6.4).
constexpr std::size_t closing_flag(ContactKey contact) {
  return static_cast<std::size_t>(contact * 0x9e3779b97f4a7c15U >> 48U);
}
inline constexpr std::size_t closing_flags = std::size_t{1} << 16U;

/// Reserves work.closing, work.closed_again and work.may_close for the present list of pairs.
template <int D>
void reserve_closing_contacts(Work<D>& work);

}  // namespace trilith
