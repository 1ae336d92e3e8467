// Makes the module table in a Lua state.
#pragma once

#include <string>

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// Makes `host` known to the state; it must outlive it.
void set_host(lua_State* L, Host& host);

/// Pushes the module table, made anew; set_host comes first. Raises a Lua error where the library does not load.
int open_trilith(lua_State* L);

/// From now on files of the library see a copy of today's globals, and of the standard libraries: whatever a script
/// changes or is refused, the library has what it had.
void keep_library_environment(lua_State* L);

/// Pushes what the library gets of the engine beside the module; open_trilith comes first.
void push_core(lua_State* L);

/// Pushes a file of the library as a function; raises a Lua error where there is none.
void load_library_file(lua_State* L, const char* name);

/// The text of a file of the library; throws std::out_of_range where there is none.
const char* library_text(const std::string& name);

/// A file of the Lua library that is compiled in.
struct LibraryFile {
  const char* name;  ///< "story"
  const char* text;
};
/// All of them; the last is nullptr. Those from "module" on are run, in order, when the module is opened.
const LibraryFile* library_files();

}  // namespace trilith::script
