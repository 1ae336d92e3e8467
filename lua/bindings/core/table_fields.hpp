// Fields of the table on top of the stack.
#pragma once

#include <cstdint>
#include <string_view>

#include "bindings/core/lua_api.hpp"

namespace trilith::script {

inline void set_number(lua_State* L, const char* key, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, key);
}

inline void set_integer(lua_State* L, const char* key, std::int64_t value) {
  lua_pushinteger(L, value);
  lua_setfield(L, -2, key);
}

inline void set_text(lua_State* L, const char* key, std::string_view text) {
  lua_pushlstring(L, text.data(), text.size());
  lua_setfield(L, -2, key);
}

}  // namespace trilith::script
