// Support reactions for scripts.
#pragma once

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// body:reactions(): support reactions of each of its nodes.
int push_body_reactions(lua_State* L);
/// The sum over a body's nodes along an axis [N].
double reaction_along(const BodyHandle& b, int axis);

}  // namespace trilith::script
