// A State as a row of 64-bit words: what checkpoints hold and what the hash is of. Which fields there are, and in which
// order, is written once, in model/io/state_words.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Empty contacts, which come and go with the search for pairs and mean nothing, are left out.
template <int D>
std::vector<std::uint64_t> state_words(const State<D>& state);

/// Throws InputError, beginning with `owner`, where `words` are no state of `model`.
template <int D>
State<D> state_from_words(const Model<D>& model, std::span<const std::uint64_t> words, const std::string& owner);

}  // namespace trilith
