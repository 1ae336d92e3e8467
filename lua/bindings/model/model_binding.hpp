// The constructors of models, which the library wraps.
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// model{...}: a model whose own table is empty.
int make_model(lua_State* L);
/// extruded(model, { name =, held = }): the model in space that one of the plane is, its own table empty.
int make_extruded(lua_State* L);

/// Pushes a text as it is, zero bytes included.
inline void push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace trilith::script
