// The constructors of models, which the library wraps.
#pragma once

#include <string>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// model{...}: creates a model with an empty table of its own.
int make_model(lua_State* L);
/// extruded(model, { name =, held = }): the model in space of a plane model, with an empty table of its own.
int make_extruded(lua_State* L);

/// Pushes a text unchanged, including zero bytes.
inline void push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace trilith::script
