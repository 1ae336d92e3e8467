// A run's hash: identifies its result to the bit.
#pragma once

#include <cstdint>

#include "model/state.hpp"

namespace trilith {

/// Digest of time, motion and ledger, independent of the laws' memories and their storage.
template <int D>
std::uint64_t motion_hash(const State<D>& state);

}  // namespace trilith
