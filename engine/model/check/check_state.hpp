// Whether a state that was read from a file is one of its model.
#pragma once

#include <string>
#include <string_view>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The message for a file or text, `owner`, in which `what` is wrong: "... is too short".
std::string damaged_state(const std::string& owner, std::string_view what);

/// Throws InputError, beginning with `owner`, where contacts, bodies that passed, bearings, removed bodies or what the
/// implicit schemes keep are not those that `model` can have. Numbers of rows were compared as the state was read.
template <int D>
void check_state(const Model<D>& model, const State<D>& state, const std::string& owner);

}  // namespace trilith
