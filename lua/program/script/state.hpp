// A Lua state for one script or console: libraries, module, strict globals.
#pragma once

#include <memory>
#include <string>

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::program {

struct CloseState {
  void operator()(lua_State* L) const { lua_close(L); }
};
using ScriptState = std::unique_ptr<lua_State, CloseState>;

/// A state with add_traceback at stack index 1, prepared for `host`, which must outlive it. Throws InputError if that
/// fails.
ScriptState new_script_state(script::Host& host);

/// Reads host.script into host.script_text. Throws InputError if it cannot be read.
void read_script(script::Host& host);

/// Pushes the script as a function, or a message: LUA_OK or an error, as luaL_loadbuffer. `before` is inserted before
/// its first line.
int load_script(lua_State* L, const script::Host& host, const std::string& before = "");

/// The error message on top of the stack.
std::string message_at_top(lua_State* L);

}  // namespace trilith::program
