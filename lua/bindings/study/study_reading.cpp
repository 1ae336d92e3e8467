#include "bindings/study/study_reading.hpp"

#include <algorithm>
#include <map>

#include "base/terminal_text.hpp"

namespace trilith::script {
namespace {

/// The names of the table on top of the stack, sorted; entries without a name are rejected.
std::vector<std::string> sorted_names(lua_State* L, const std::string& owner) {
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw InputError(fmt::format("{}: {} is given without a name", owner, what_is(L, -1)));
    names.push_back(text_at(L, -2));
    require_printable(names.back(), owner + ": name");
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The value on top of the stack, from `key`, must be a table of cases.
void require_table(lua_State* L, std::string_view key) {
  if (lua_type(L, -1) != LUA_TTABLE)
    throw InputError(fmt::format("study: '{}' is {}, must be a table", key, what_is(L, -1)));
}

StudyValue value_at_top(lua_State* L, const std::string& name) {
  switch (lua_type(L, -1)) {
    case LUA_TNUMBER:
      return require_finite(lua_tonumber(L, -1), "study: parameter '" + name + "'");
    case LUA_TBOOLEAN:
      return lua_toboolean(L, -1) != 0;
    case LUA_TSTRING:
      return text_at(L, -1);
    default:
      throw InputError(
          fmt::format("study: a value of '{}' is {}, must be a number, a text or a flag", name, what_is(L, -1)));
  }
}

StudyParameter parameter_at_top(lua_State* L, const std::string& name) {
  // It becomes a word of a command line, where it must not look like an option.
  if (name.empty() || name.starts_with("-") || name.find('=') != std::string::npos)
    throw InputError(fmt::format(
        "study: '{}' is not a parameter name; it must not be empty, begin with '-' or hold '='", one_line(name)));
  StudyParameter p{name, "", {}};
  if (lua_type(L, -1) != LUA_TTABLE) {
    p.values.push_back(value_at_top(L, name));
    return p;
  }
  Keys keys(L, -1, fmt::format("study: parameter '{}'", name));
  keys.allow_list();
  p.unit = keys.text("unit", "");
  keys.finish();
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    p.values.push_back(value_at_top(L, name));
    lua_pop(L, 1);
  }
  return p;
}

StudyPlan product_at_top(lua_State* L) {
  std::vector<StudyParameter> parameters;
  for (const std::string& name : sorted_names(L, "study: 'parameters'")) {
    lua_getfield(L, -1, name.c_str());
    parameters.push_back(parameter_at_top(L, name));
    lua_pop(L, 1);
  }
  return product_plan(parameters);
}

/// { {mu = 0.4, copy = 1}, ... }: all with the same names.
StudyPlan list_at_top(lua_State* L) {
  std::vector<StudyParameter> parameters;
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    if (lua_type(L, -1) != LUA_TTABLE)
      throw InputError(fmt::format("study: case {} is {}, must be a table {{ name = value, ... }}", i, what_is(L, -1)));
    const std::vector<std::string> names = sorted_names(L, fmt::format("study: case {}", i));
    if (i == 1)
      for (const std::string& name : names) parameters.push_back({name, "", {}});
    if (!std::equal(names.begin(), names.end(), parameters.begin(), parameters.end(),
                    [](const std::string& name, const StudyParameter& p) { return name == p.name; }))
      throw InputError(fmt::format(
          "study: case {} has the parameters {}, which differ from the first case; give the same parameters in all", i,
          fmt::join(names, ", ")));
    for (StudyParameter& p : parameters) {
      lua_getfield(L, -1, p.name.c_str());
      p.values.push_back(value_at_top(L, p.name));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  return list_plan(parameters);
}

/// { mu = { uniform = {0.4, 0.8} }, tension = { normal = {100, 20}, unit = "psf" } }
StudySpread spread_at_top(lua_State* L, const std::string& name) {
  StudySpread spread;
  spread.name = name;
  const std::string owner = fmt::format("study: samples of '{}'", name);
  Keys keys(L, -1, owner);
  spread.unit = keys.text("unit", "");
  const std::array kinds{
      std::pair{"uniform", StudySpread::Kind::uniform}, std::pair{"log_uniform", StudySpread::Kind::log_uniform},
      std::pair{"normal", StudySpread::Kind::normal}, std::pair{"log_normal", StudySpread::Kind::log_normal}};
  int given = 0;
  for (const auto& [key, kind] : kinds) {
    const auto pair = keys.maybe_point(key);
    if (!pair) continue;
    ++given;
    spread.kind = kind;
    spread.first = pair->x();
    spread.second = pair->y();
  }
  if (given != 1) keys.problem("give just one of uniform, log_uniform, normal and log_normal, each with two numbers");
  keys.finish();
  return spread;
}

StudyPlan samples_at_top(lua_State* L, int count, int seed) {
  std::vector<StudySpread> spreads;
  for (const std::string& name : sorted_names(L, "study: 'samples'")) {
    lua_getfield(L, -1, name.c_str());
    spreads.push_back(spread_at_top(L, name));
    lua_pop(L, 1);
  }
  return sampled_plan(spreads, count, static_cast<std::uint64_t>(seed));
}

StudyTake take_at_top(lua_State* L, const std::string& history) {
  const auto& takes = study_takes();
  const std::string text = lua_type(L, -1) == LUA_TSTRING ? text_at(L, -1) : "";
  const auto it = std::find(takes.begin(), takes.end(), text);
  if (it == takes.end())
    throw InputError(fmt::format("study: history '{}': the value is {}, must be one of {}", history, what_is(L, -1),
                                 fmt::join(takes, ", ")));
  return static_cast<StudyTake>(it - takes.begin());
}

/// Names in a list, without a reduction, use the largest absolute value, which usually characterises a response.
/// Entries with a key remain, in a separate table that replaces the one on top of the stack.
void take_names_out(lua_State* L, std::vector<StudyHistory>& wanted) {
  const int given = lua_gettop(L);
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, given));
  for (lua_Integer i = 1; i <= count; ++i) {
    if (lua_rawgeti(L, given, i) != LUA_TSTRING)
      throw InputError(
          fmt::format("study: entry {} of 'histories' is {}, must be the name of a history", i, what_is(L, -1)));
    wanted.push_back({text_at(L, -1), StudyTake::largest});
    lua_pop(L, 1);
  }
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, given) != 0; lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) != 0 && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= count) continue;
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, given + 1);
  }
  lua_replace(L, given);
}

}  // namespace

StudyPlan read_plan(Keys& keys) {
  lua_State* L = keys.lua();
  lua_checkstack(L, 20);
  const bool samples = keys.has("samples");
  const int count = keys.count("count", 0), seed = keys.count("seed", 1);
  if (!samples && count != 0) keys.problem("'count' needs samples");
  if (keys.has("parameters") + keys.has("cases") + (samples ? 1 : 0) != 1)
    throw InputError(
        "study: give just one of parameters = { name = {values} }, cases = { {name = value}, ... } and "
        "samples = { name = { uniform = {least, most} } }");
  const char* const key = samples ? "samples" : keys.has("cases") ? "cases" : "parameters";
  keys.push(key);
  require_table(L, key);
  StudyPlan plan = samples ? samples_at_top(L, count, seed) : keys.has("cases") ? list_at_top(L) : product_at_top(L);
  lua_pop(L, 1);
  return plan;
}

std::vector<StudyHistory> read_histories(Keys& keys) {
  lua_State* L = keys.lua();
  std::vector<StudyHistory> wanted;
  if (keys.push("histories") != LUA_TNIL) {
    require_table(L, "histories");
    take_names_out(L, wanted);
    for (const std::string& name : sorted_names(L, "study: 'histories'")) {
      lua_getfield(L, -1, name.c_str());
      if (lua_type(L, -1) == LUA_TBOOLEAN && lua_toboolean(L, -1) != 0) {
        wanted.push_back({name, StudyTake::largest});
      } else if (lua_type(L, -1) != LUA_TTABLE) {
        wanted.push_back({name, take_at_top(L, name)});
      } else {
        const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
        for (lua_Integer i = 1; i <= count; ++i) {
          lua_rawgeti(L, -1, i);
          wanted.push_back({name, take_at_top(L, name)});
          lua_pop(L, 1);
        }
      }
      lua_pop(L, 1);
    }
  }
  lua_pop(L, 1);
  return wanted;
}

}  // namespace trilith::script
