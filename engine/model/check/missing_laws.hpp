// Pairs of bodies that may meet without a contact statement: they would pass through each other.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// In Model::law_of: no statement covers these two surfaces. -1 means the law "none": declared without contact.
inline constexpr int undeclared_law = -2;

/// A line for each two materials that have bodies, at least one of them free to move, without a statement about their
/// contact. It suggests a statement as remedy. After several lines one counts the rest. Empty if nothing is missing.
template <int D>
std::vector<std::string> missing_laws(const Model<D>& model);

/// Throws InputError with these lines, if there are any.
template <int D>
void require_laws(const Model<D>& model);

}  // namespace trilith
