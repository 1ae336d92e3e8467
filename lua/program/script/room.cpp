#include "program/script/room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/core/open.hpp"
#include "interrupt.hpp"

namespace trilith::program {
namespace {

script::Host& host_of(lua_State* L) {
  return *static_cast<script::Host*>(lua_touserdata(L, lua_upvalueindex(1)));
}

/// Files that scripts of this process have created; only these can be removed, renamed or replaced by renaming.
std::set<std::filesystem::path>& made_files() {
  static std::set<std::filesystem::path> made;
  return made;
}

std::filesystem::path path_at(lua_State* L, int index, const char* owner) {
  if (lua_type(L, index) != LUA_TSTRING)
    throw InputError(fmt::format("{}: needs the path of a file as a text, not a {}", owner, luaL_typename(L, index)));
  return script::text_at(L, index);
}

void note_made(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) made_files().insert(path);
}

int push_path(lua_State* L, const std::filesystem::path& path) {
  lua_pushlstring(L, path.c_str(), path.native().size());
  return 1;
}

/// room.readable(path, owner)
int readable(lua_State* L) {
  const std::string owner = script::text_at(L, 2);
  return push_path(L, host_of(L).room.readable(path_at(L, 1, owner.c_str()), owner));
}

/// room.writable(path, owner)
int writable(lua_State* L) {
  const std::string owner = script::text_at(L, 2);
  const std::filesystem::path path = host_of(L).room.writable(path_at(L, 1, owner.c_str()), owner);
  note_made(path);
  return push_path(L, path);
}

/// room.for_mode(path, mode): the path that io.open may open.
int for_mode(lua_State* L) {
  const std::string mode = lua_isnoneornil(L, 2) ? "r" : script::text_at(L, 2);
  const std::filesystem::path path = path_at(L, 1, "io.open");
  if (mode == "r" || mode == "rb") return push_path(L, host_of(L).room.readable(path, "io.open"));
  const std::filesystem::path real = host_of(L).room.writable(path, "io.open");
  note_made(real);
  return push_path(L, real);
}

std::filesystem::path made_at(lua_State* L, int index, const char* owner) {
  const std::filesystem::path given = path_at(L, index, owner);
  const std::filesystem::path path = host_of(L).room.writable(given, owner);
  if (made_files().count(path) == 0)
    throw InputError(
        fmt::format("{}: '{}' is refused: a script may remove and rename only files that it has made "
                    "itself in this run; `trilith run --trust SCRIPT` allows it",
                    owner, given.string()));
  return path;
}

/// Result of os.remove and os.rename: true, or nil and the reason.
int push_done(lua_State* L, bool good, const std::string& path, int reason) {
  if (good) {
    lua_pushboolean(L, 1);
    return 1;
  }
  lua_pushnil(L);
  lua_pushstring(L, (path + ": " + std::generic_category().message(reason)).c_str());
  lua_pushinteger(L, reason);
  return 3;
}

int remove_file(lua_State* L) {
  const std::filesystem::path path = made_at(L, 1, "os.remove");
  const bool good = std::remove(path.c_str()) == 0;
  return push_done(L, good, script::text_at(L, 1), errno);
}

int rename_file(lua_State* L) {
  const std::filesystem::path from = made_at(L, 1, "os.rename"), given = path_at(L, 2, "os.rename");
  const std::filesystem::path to = host_of(L).room.writable(given, "os.rename");
  std::error_code error;
  if (std::filesystem::exists(to, error)) static_cast<void>(made_at(L, 2, "os.rename"));
  const bool good = std::rename(from.c_str(), to.c_str()) == 0;
  if (good) made_files().insert(to);
  return push_done(L, good, script::text_at(L, 1), errno);
}

/// room.fail(message): a line with the script's place, without traceback.
int fail(lua_State* L) {
  throw InputError(script::text_at(L, 1));
}

/// room.variable(name): permitted values of os.getenv.
int variable(lua_State* L) {
  const std::string name = script::text_at(L, 1);
  if (!std::string_view(name).starts_with("TRILITH_"))
    throw InputError(fmt::format(
        "os.getenv: '{}' is refused: a script sees only variables whose names begin with TRILITH_, as others may hold "
        "passwords; declare a parameter instead (trilith.params), or run it with --trust",
        name));
  const char* const value = std::getenv(name.c_str());
  lua_pushstring(L, value);
  return 1;
}

/// room.module_file(name, path): the first file that require may load, or nil.
int module_file(lua_State* L) {
  std::string name = script::text_at(L, 1);
  const std::string templates = script::text_at(L, 2);
  for (char& letter : name)
    if (letter == '.') letter = '/';
  for (std::size_t at = 0, end = 0; at <= templates.size(); at = end + 1) {
    end = std::min(templates.find(';', at), templates.size());
    std::string file = templates.substr(at, end - at);
    for (std::size_t mark = 0; (mark = file.find('?', mark)) != std::string::npos; mark += name.size())
      file.replace(mark, 1, name);
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error)) continue;
    push_path(L, host_of(L).room.readable(file, "require"));
    push_path(L, file);
    return 2;
  }
  return 0;
}

}  // namespace

void close_room(lua_State* L, script::Host& host) {
  script::load_library_file(L, "room");
  lua_newtable(L);
  const luaL_Reg functions[] = {{"readable", script::guarded<readable>},
                                {"writable", script::guarded<writable>},
                                {"for_mode", script::guarded<for_mode>},
                                {"remove", script::guarded<remove_file>},
                                {"rename", script::guarded<rename_file>},
                                {"variable", script::guarded<variable>},
                                {"fail", script::guarded<fail>},
                                {"module_file", script::guarded<module_file>},
                                {nullptr, nullptr}};
  lua_pushlightuserdata(L, &host);
  luaL_setfuncs(L, functions, 1);
  lua_call(L, 1, 0);
}

}  // namespace trilith::program
