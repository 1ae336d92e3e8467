// Units, and the parameters that a script declares.
#include <algorithm>
#include <cmath>

#include "base/terminal_text.hpp"
#include "base/units.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/parameter_list.hpp"
#include "bindings/core/unit_door.hpp"

namespace trilith::script {
namespace {

/// units "ft inch kip": one SI factor for each.
int units(lua_State* L) {
  if (lua_type(L, 1) != LUA_TSTRING)
    throw InputError(fmt::format("units: takes one text, as in units \"ft inch kip\"; this is {}", what_is(L, 1)));
  const std::string_view text = lua_tostring(L, 1);
  count_quantity();
  int count = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ' || text[i] == ',' || text[i] == '\n') {
      ++i;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" ,\n", i), text.size());
    if (lua_checkstack(L, 2) == 0) throw InputError("units: too many units in one call");
    lua_pushnumber(L, parse_unit(text.substr(i, end - i)).factor);
    ++count;
    i = end;
  }
  return count;
}

/// A parameter as declared: {default, unit =, choices =, sentence}, or only a default.
struct Declaration {
  std::string name, unit, sentence;
  std::vector<std::string> choices;
  int type = LUA_TNIL;
  double number = 0;   ///< in `unit`
  bool whole = false;  ///< the default is a whole number
  bool flag = false;
  std::string text;

  [[nodiscard]] std::string preset() const {
    if (type == LUA_TNUMBER) return fmt::format("{}", number);
    return type == LUA_TBOOLEAN ? (flag ? "true" : "false") : text;
  }
};

void read_preset(lua_State* L, Declaration& d, Keys* keys) {
  d.type = lua_type(L, -1);
  if (d.type == LUA_TNUMBER)
    d.number = lua_tonumber(L, -1), d.whole = lua_isinteger(L, -1) != 0;
  else if (d.type == LUA_TSTRING)
    d.text = text_at(L, -1);
  else if (d.type == LUA_TBOOLEAN)
    d.flag = lua_toboolean(L, -1) != 0;
  else if (keys != nullptr)
    keys->problem(fmt::format("the default (entry 1) is {}, must be a number, a text, true or false", what_is(L, -1)));
}

Declaration read_declaration(lua_State* L, const std::string& name) {
  Declaration d;
  d.name = name;
  if (lua_type(L, -1) != LUA_TTABLE) {
    read_preset(L, d, nullptr);
    if (d.type != LUA_TNUMBER && d.type != LUA_TSTRING && d.type != LUA_TBOOLEAN)
      throw InputError(fmt::format("params: '{}' is {}, must be {{default, unit = , choices = , \"sentence\"}}", name,
                                   what_is(L, -1)));
    return d;
  }
  Keys keys(L, -1, fmt::format("params: '{}'", name));
  keys.allow_list();
  lua_rawgeti(L, -1, 1);
  read_preset(L, d, &keys);
  lua_pop(L, 1);
  if (lua_rawgeti(L, -1, 2) == LUA_TSTRING) d.sentence = text_at(L, -1);
  lua_pop(L, 1);
  d.unit = keys.text("unit", "");
  d.choices = keys.names("choices");
  if (d.type == LUA_TNUMBER && !std::isfinite(d.number))
    keys.problem(fmt::format("the default is {}, must be finite", d.number));
  if (!d.unit.empty() && d.type != LUA_TNUMBER) keys.problem("has a unit, but its default is not a number");
  if (!d.choices.empty() &&
      (d.type != LUA_TSTRING || std::find(d.choices.begin(), d.choices.end(), d.text) == d.choices.end()))
    keys.problem(fmt::format("the default must be one of {}", fmt::join(d.choices, ", ")));
  keys.finish();
  return d;
}

/// Takes the value of the command line.
void take_given(Declaration& d, const std::string& given) {
  const std::string what = fmt::format("parameter '{}'", d.name);
  if (d.type == LUA_TNUMBER) {
    const std::string unit = d.unit.empty() ? "1" : d.unit;
    const double si = parse_quantity(given, unit, what);
    const bool plain = given.find_first_not_of("0123456789+-.eE") == std::string::npos;
    d.number = plain ? parse_quantity(given, "1", what) : si / parse_unit(unit).factor;  // avoids rounding if there is
                                                                                         // no conversion
  } else if (d.type == LUA_TBOOLEAN) {
    if (given != "true" && given != "false")
      throw InputError(fmt::format("{} is '{}', must be true or false", what, given));
    d.flag = given == "true";
  } else {
    if (!d.choices.empty() && std::find(d.choices.begin(), d.choices.end(), given) == d.choices.end())
      throw InputError(fmt::format("{} is '{}', must be one of {}", what, given, fmt::join(d.choices, ", ")));
    d.text = given;
  }
}

/// An integer parameter with an integer value remains an integer: a count may be an index or a number of repetitions.
void push_value(lua_State* L, const Declaration& d) {
  constexpr double most_whole = 0x1p53;
  if (d.type == LUA_TNUMBER && d.whole && d.unit.empty() && d.number == std::floor(d.number) &&
      std::abs(d.number) < most_whole)
    lua_pushinteger(L, static_cast<lua_Integer>(d.number));
  else if (d.type == LUA_TNUMBER)
    lua_pushnumber(L, d.unit.empty() ? d.number : d.number * parse_unit(d.unit).factor);
  else if (d.type == LUA_TBOOLEAN)
    lua_pushboolean(L, d.flag ? 1 : 0);
  else
    lua_pushstring(L, d.text.c_str());
}

std::vector<std::string> sorted_keys(lua_State* L, int table) {
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw InputError(fmt::format("params: {} is given without a name", what_is(L, -1)));
    names.push_back(text_at(L, -2));
    require_printable(names.back(), "parameter");
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Takes the value of `d` from the command line; removes it from the list.
void take_from_host(Host& host, Declaration& d) {
  for (auto it = host.given.begin(); it != host.given.end();) {
    if (it->substr(0, it->find('=')) != d.name) {
      ++it;
      continue;
    }
    take_given(d, it->substr(it->find('=') + 1));
    it = host.given.erase(it);
  }
}

/// Prints the list for --params or --help in a stock interpreter. The library then ends the script.
void print_list(const Host& h) {
  const auto& words = h.arguments;
  if (std::find(words.begin(), words.end(), "--help") != words.end())
    fmt::print(
        "Give NAME=VALUE after the script, in the declared unit or with a unit, as in pga=0.6g; --params lists the "
        "parameters.\n");
  fmt::print("{}", parameter_lines(h, "the script"));
}

/// Rejects the remaining words of the command line after all parameters have taken their values.
void refuse_leftover(const Host& h, const std::vector<std::string>& names) {
  if (h.given.empty()) return;
  const std::string& word = h.given.front();
  if (word.starts_with("-"))
    throw InputError(fmt::format("there is no option '{}'{}; 'trilith run --help' lists the other options", word,
                                 name_hint(word, {"--params", "--help"})));
  const std::size_t at = word.find('=');
  if (at == std::string::npos || at == 0) throw InputError(fmt::format("'{}' is not NAME=VALUE", word));
  const std::string name = word.substr(0, at);
  if (names.empty())
    throw InputError(fmt::format("the script declares no parameters, so '{}' cannot be set; see trilith.params", word));
  throw InputError(fmt::format("there is no parameter '{}'{}", name, name_hint(name, names)));
}

/// trilith.params{...}: the values; nil if a stock interpreter has listed them, so that the library ends the script.
int params(lua_State* L) {
  Host& h = host(L);
  if (h.given_used) throw InputError("params: called a second time; declare all parameters in one table");
  if (lua_type(L, 1) != LUA_TTABLE) throw InputError(fmt::format("params: takes one table; this is {}", what_is(L, 1)));
  lua_settop(L, 1);
  const std::vector<std::string> names = sorted_keys(L, 1);
  h.given_used = true;
  lua_newtable(L);
  for (const std::string& name : names) {
    lua_getfield(L, 1, name.c_str());
    Declaration d = read_declaration(L, name);
    lua_pop(L, 1);
    if (!d.unit.empty()) parse_unit(d.unit), count_quantity();
    const std::string preset = d.preset();
    take_from_host(h, d);
    h.parameters.push_back({name, d.preset(), d.unit, preset, d.sentence});
    push_value(L, d);
    lua_setfield(L, 2, name.c_str());
  }
  if (h.list_parameters && !h.script.empty()) throw InputError(parameters_listed);
  if (h.list_parameters) {
    print_list(h);
    lua_pushnil(L);
    return 1;
  }
  refuse_leftover(h, names);
  return 1;
}

}  // namespace

std::string parameter_lines(const Host& host, const std::string& title) {
  std::string lines;
  for (const auto& p : host.parameters)
    lines += fmt::format("{:<16} {:>10} {:<6} {}\n", p.name, p.value, p.unit, p.text);
  return lines.empty() ? title + " declares no parameters\n" : lines;
}

void open_units(lua_State* L) {
  set_function(L, "units", guarded<units>);
  set_function(L, "params", guarded<params>);
}

}  // namespace trilith::script
