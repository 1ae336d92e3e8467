// A State as a sequence of 64-bit words, for checkpoints and the hash. Fields and their order are defined once, in
// model/io/state_words.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Empty contacts are omitted: they depend on the search for pairs and have no meaning.
template <int D>
std::vector<std::uint64_t> state_words(const State<D>& state);

/// Throws InputError, which begins with `owner`, if `words` are not a state of `model`.
template <int D>
State<D> state_from_words(const Model<D>& model, std::span<const std::uint64_t> words, const std::string& owner);

}  // namespace trilith
