// Checks whether a state read from a file is valid for its model.
#pragma once

#include <string>
#include <string_view>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The message for a file or text `owner`; `what` is the defect: "... is too short".
std::string damaged_state(const std::string& owner, std::string_view what);

/// Throws InputError, which begins with `owner`, if contacts, penetrated bodies, bearings, removed bodies or the data
/// of implicit schemes are invalid for `model`. Numbers of rows were compared as the state was read.
template <int D>
void check_state(const Model<D>& model, const State<D>& state, const std::string& owner);

}  // namespace trilith
