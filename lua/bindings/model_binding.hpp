// The constructor of models, which the library wraps.
#pragma once

#include "lua_api.hpp"

namespace trilith::script {

/// model{...}: a model whose own table is empty.
int make_model(lua_State* L);

}  // namespace trilith::script
