// What the readers of geometry builders' tables share.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "handles.hpp"

namespace trilith::script {

/// Calls item(keys, i) for every table of the list under `key`; `owner` names one of them.
template <class Item>
void read_list(Keys& keys, std::string_view key, const std::string& owner, Item&& item) {
  lua_State* L = keys.lua();
  const int type = keys.push(key);
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong(key, "a list of tables");
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

/// Names of the entries of the table on top of the stack, in rising order: a Lua table has none of its own. Notes a
/// problem where a key is no text; `what` names the table.
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

/// What is said of a member that is asked for its fibres and has none.
inline std::string no_fibres_text(const std::string& member) {
  return fmt::format("fibres: member '{}' is not of fibres; give it section = trilith.fibre_section{{shape =, law =}}",
                     member);
}

/// How a member with that section yields: by its fibres, with the `rule` and the number of `stations` along each beam.
inline std::optional<MemberFibres> read_fibres(Keys& keys, const SectionValue* section) {
  const bool gauss = keys.choice("rule", {"lobatto", "gauss"}, 0) == 1;
  const int stations = keys.count("stations", 4);
  if (section == nullptr) return std::nullopt;
  for (const char* key : {"rule", "stations"})
    if (keys.has(key) && !section->fibres)
      keys.problem(fmt::format("'{}' is of a section of fibres, and this one has none; leave it out", key));
  if (!section->fibres) return std::nullopt;
  return MemberFibres{*section->fibres, gauss ? BeamRule::gauss : BeamRule::lobatto, stations};
}

/// A whole number or a list of them under `key`; {preset} where it is not there.
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
