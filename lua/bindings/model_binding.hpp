// The constructors of models, which the library wraps.
#pragma once

#include "lua_api.hpp"

namespace trilith::script {

/// model{...}: a model whose own table is empty.
int make_model(lua_State* L);
/// extruded(model, { name =, held = }): the model in space that one of the plane is, its own table empty.
int make_extruded(lua_State* L);

}  // namespace trilith::script
