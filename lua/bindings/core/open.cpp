#include "bindings/core/open.hpp"

#include <cstring>
#include <stdexcept>

#include "bindings/core/bindings.hpp"

namespace trilith::script {
namespace {

const char host_key = 'h', core_key = 'c', environment_key = 'e';

void add_version(lua_State* L) {
  lua_pushstring(L, TRILITH_VERSION);
  lua_setfield(L, -2, "version");
}

void load_file(lua_State* L, const LibraryFile& file) {
  lua_pushfstring(L, "=trilith/%s.lua", file.name);
  if (luaL_loadbufferx(L, file.text, std::strlen(file.text), lua_tostring(L, -1), "t") != LUA_OK) lua_error(L);
  lua_remove(L, -2);
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &environment_key) == LUA_TTABLE)
    lua_setupvalue(L, -2, 1);
  else
    lua_pop(L, 1);
}

/// Replaces the table on top of the stack by a copy.
void copy_table(lua_State* L) {
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, -3) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
  lua_remove(L, -2);
}

/// Runs each file of the library with (module, core); no C++ object lives here, so a Lua error may pass.
void run_library(lua_State* L, int module, int core) {
  const LibraryFile* file = library_files();
  while (std::strcmp(file->name, "module") != 0) ++file;
  for (; file->name != nullptr; ++file) {
    load_file(L, *file);
    lua_pushvalue(L, module);
    lua_pushvalue(L, core);
    lua_call(L, 2, 0);
  }
}

int fill(lua_State* L) {
  lua_newtable(L);
  add_version(L);
  open_units(L);
  open_math(L);
  open_laws(L);
  open_sections(L);
  open_yields(L);
  open_motions(L);
  open_build(L);
  open_study(L);
  lua_newtable(L);
  open_core(L);
  lua_pushglobaltable(L);
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, "globals");
  copy_table(L);
  lua_setfield(L, -2, "first_globals");
  return 2;
}

}  // namespace

void load_library_file(lua_State* L, const char* name) {
  for (const LibraryFile* file = library_files(); file->name != nullptr; ++file)
    if (std::strcmp(file->name, name) == 0) {
      load_file(L, *file);
      return;
    }
  luaL_error(L, "there is no library file '%s'", name);
}

const char* library_text(const std::string& name) {
  for (const LibraryFile* file = library_files(); file->name != nullptr; ++file)
    if (name == file->name) return file->text;
  throw std::out_of_range("there is no library file " + name);
}

void keep_library_environment(lua_State* L) {
  lua_pushglobaltable(L);
  copy_table(L);
  for (const char* name : {"string", "table", "math", "coroutine", "utf8", "os", "io", "debug", "package"}) {
    lua_getfield(L, -1, name);
    copy_table(L);
    lua_setfield(L, -2, name);
  }
  lua_rawsetp(L, LUA_REGISTRYINDEX, &environment_key);
}

void push_core(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &core_key);
}

void set_host(lua_State* L, Host& h) {
  lua_pushlightuserdata(L, &h);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &host_key);
}

Host& host(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &host_key);
  auto* h = static_cast<Host*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  if (h == nullptr) throw InputError("trilith was not opened in this Lua state");
  return *h;
}

int open_trilith(lua_State* L) {
  run_guarded(L, fill);
  const int core = lua_gettop(L), module = core - 1;
  lua_pushvalue(L, core);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &core_key);
  run_library(L, module, core);
  lua_settop(L, module);
  return 1;
}

}  // namespace trilith::script
