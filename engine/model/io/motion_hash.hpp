// A run's hash: what it came to, to the bit.
#pragma once

#include <cstdint>

#include "model/state.hpp"

namespace trilith {

/// Digest of time, motion and ledger, whatever the laws remember and how they keep it.
template <int D>
std::uint64_t motion_hash(const State<D>& state);

}  // namespace trilith
