// Pairs of bodies that may meet and of which no contact statement speaks: they would pass through each other.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// In Model::law_of: no statement speaks of these two surfaces. As -1, of law "none", no contact.
inline constexpr int undeclared_law = -2;

/// A line for each two materials of which some bodies, at least one of them free to move, have no statement about their
/// contact, with a statement that would mend it; after some of them one line counts the rest. Empty where there are
/// none.
template <int D>
std::vector<std::string> missing_laws(const Model<D>& model);

/// Throws InputError with these lines, where there are any.
template <int D>
void require_laws(const Model<D>& model);

}  // namespace trilith
