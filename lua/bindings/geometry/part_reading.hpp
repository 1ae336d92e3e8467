// Common functions of the readers of geometry builders' tables.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/terminal_text.hpp"
#include "bindings/core/handles.hpp"

namespace trilith::script {

/// Notes a problem if the table on top of the stack, from `key`, has a named key in addition to its entries. Examples
/// are a table of one entry without its braces, or an entry one brace too deep. `wanted` as for wrong().
inline void require_plain_list(Keys& keys, std::string_view key, std::string_view wanted) {
  lua_State* L = keys.lua();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  std::string found;  // first by name: a Lua table has no order
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) != 0 && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= count) continue;
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? fmt::format("the key '{}'", one_line(text_at(L, -2)))
                                                            : std::string("a key that is not a place");
    found = found.empty() ? name : std::min(found, name);
  }
  if (!found.empty()) keys.problem(fmt::format("'{}' has {} in it, must be {}", key, found, wanted));
}

/// Note on a body with a mesh whose `body` requests other elements.
inline std::string own_elements_note(const std::string& name) {
  return fmt::format(
      "body '{}': its mesh already has elements, which body does not change; leave body out, or give body = \"rigid\" "
      "for a rigid body of these pieces",
      name);
}

/// mesh = {nx, ny, ...}: integers from 1 to 1000; `wanted` describes them.
template <std::size_t sides>
void read_divisions(Keys& keys, std::array<int, sides>& divisions, const char* wanted) {
  lua_State* L = keys.lua();
  bool good = keys.push("mesh") == LUA_TTABLE && lua_rawlen(L, -1) == sides;
  if (good) require_plain_list(keys, "mesh", wanted);
  for (std::size_t i = 0; i < sides && good; ++i) {
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i) + 1);
    int whole = 0;
    const lua_Integer n = lua_tointegerx(L, -1, &whole);
    good = whole != 0 && lua_type(L, -1) == LUA_TNUMBER;
    lua_pop(L, 1);
    if (good && (n < 1 || n > 1000))
      keys.problem(fmt::format("'mesh' has {} divisions of a side, must be 1 to 1000", n));
    divisions[i] = static_cast<int>(std::clamp<lua_Integer>(n, 1, 1000));
  }
  if (!good) keys.wrong("mesh", wanted);
  lua_pop(L, 1);
}

/// Calls item(keys, i) for every table of the list under `key`; `owner` names one of them.
template <class Item>
void read_list(Keys& keys, std::string_view key, const std::string& owner, Item&& item) {
  lua_State* L = keys.lua();
  const int type = keys.push(key);
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong(key, "a list of tables");
  if (type == LUA_TTABLE) require_plain_list(keys, key, "a list of tables: { { ... }, { ... } }");
  const auto count = type == LUA_TTABLE ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    try {
      Keys own(L, -1, fmt::format("{} {}", owner, i));
      item(own);
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

/// Names of the entries of the table on top of the stack, sorted, because a Lua table has no order. Notes a problem if
/// a key is not a text; `what` names the table.
inline std::vector<std::string> names_in_table(Keys& keys, const char* what) {
  lua_State* L = keys.lua();
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TSTRING)
      names.push_back(text_at(L, -2));
    else
      keys.problem(what);
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline std::string read_name(Keys& keys, const std::string& preset) {
  std::string name = keys.text("name", preset);
  keys.name_owner(name);
  return name;
}

/// Error text for fibres of a member without fibres.
inline std::string no_fibres_text(const std::string& member) {
  return fmt::format(
      "fibres: member '{}' has no fibre section; give it section = trilith.fibre_section{{shape =, law =}}", member);
}

/// Yielding of a member with that section by its fibres, with the `rule` and the number of `stations` along each beam.
inline std::optional<MemberFibres> read_fibres(Keys& keys, const SectionValue* section) {
  const bool gauss = keys.choice("rule", {"lobatto", "gauss"}, 0) == 1;
  const int stations = keys.count("stations", 4);
  if (section == nullptr) return std::nullopt;
  for (const char* key : {"rule", "stations"})
    if (keys.has(key) && !section->fibres)
      keys.problem(fmt::format("'{}' is for fibre sections, but this section has no fibres; leave it out", key));
  if (!section->fibres) return std::nullopt;
  if (stations < 2 || stations > 6)
    keys.problem(fmt::format("'stations' is {}, must be 3 to 6 (lobatto) or 2 to 5 (gauss)", stations));
  return MemberFibres{*section->fibres, gauss ? BeamRule::gauss : BeamRule::lobatto, stations};
}

/// An integer or a list of integers under `key`; {preset} if not given.
inline std::vector<int> read_counts(Keys& keys, std::string_view key, int preset) {
  lua_State* L = keys.lua();
  std::vector<int> counts;
  const int type = keys.push(key);
  const bool list = type == LUA_TTABLE;
  const auto size = list ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 1;
  if (type == LUA_TNIL) counts.push_back(preset);
  for (lua_Integer i = 1; i <= size && type != LUA_TNIL; ++i) {
    if (list)
      lua_rawgeti(L, -1, i);
    else
      lua_pushvalue(L, -1);
    const std::optional<int> value = count_at(L, -1);
    if (!value) keys.wrong(key, "a whole number or a list of whole numbers");
    counts.push_back(value.value_or(preset));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return counts;
}

}  // namespace trilith::script
