// Creates the module table in a Lua state.
#pragma once

#include <string>

#include "bindings/core/host.hpp"
#include "bindings/core/lua_api.hpp"

namespace trilith::script {

/// Registers `host` in the state; it must outlive it.
void set_host(lua_State* L, Host& host);

/// Pushes a new module table; call set_host first. Raises a Lua error if the library does not load.
int open_trilith(lua_State* L);

/// From now on files of the library use a copy of the present globals and of the standard libraries, so that changes
/// and restrictions of a script do not affect the library.
void keep_library_environment(lua_State* L);

/// Pushes the engine functions for the library, in addition to the module; call open_trilith first.
void push_core(lua_State* L);

/// Pushes a file of the library as a function; raises a Lua error if there is none.
void load_library_file(lua_State* L, const char* name);

/// The text of a file of the library; throws std::out_of_range if there is none.
const char* library_text(const std::string& name);

/// A file of the built-in Lua library.
struct LibraryFile {
  const char* name;  ///< "story"
  const char* text;
};
/// All files; the last is nullptr. Files from "module" on are run, in order, when the module is opened.
const LibraryFile* library_files();

}  // namespace trilith::script
