// Whether Ctrl-C was pressed, for what runs long without entering Lua.
#pragma once

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// The program counts its interrupts (Host::interrupted). Stock lua tells nobody: it sets a hook on its main thread
/// that raises once Lua code runs. So there it is a hook that was not there when this was made, and is not one of the
/// script's own, set by debug.sethook.
class InterruptWatch {
 public:
  InterruptWatch(lua_State* L, const Host& host);
  [[nodiscard]] bool pressed() const;

 private:
  const Host& host_;
  lua_State* main_ = nullptr;
  lua_Hook before_ = nullptr, of_scripts_ = nullptr;
};

}  // namespace trilith::script
