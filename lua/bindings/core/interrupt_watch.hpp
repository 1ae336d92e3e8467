// Detection of Ctrl-C for long computations that do not enter Lua.
#pragma once

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// The program counts its interrupts (Host::interrupted). Stock lua has no such count: it sets a hook on its main
/// thread that raises an error when Lua code runs. There a new hook that debug.sethook did not set indicates the
/// interrupt.
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
