#include "bindings/readings/figures_reading.hpp"

#include <algorithm>
#include <cmath>

#include "base/terminal_text.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {
namespace {

void read_value(lua_State* L, StudyFigure& figure) {
  const int type = lua_type(L, -1);
  if (type == LUA_TNUMBER) {
    figure.value = require_finite(lua_tonumber(L, -1), "figure '" + figure.name + "'");
  } else if (type == LUA_TBOOLEAN) {
    figure.value = lua_toboolean(L, -1) != 0;
  } else if (type == LUA_TSTRING) {
    figure.value = text_at(L, -1);
  } else {
    throw InputError(fmt::format("figure '{}' is {}, must be a number, a flag, a text or {{value, unit = }}",
                                 figure.name, what_is(L, -1)));
  }
}

StudyFigure figure_at_top(lua_State* L, std::string name) {
  StudyFigure figure{std::move(name), "", 0.0};
  if (lua_type(L, -1) != LUA_TTABLE) {
    read_value(L, figure);
    return figure;
  }
  Keys keys(L, -1, fmt::format("figure '{}'", figure.name));
  keys.allow_list();
  figure.unit = keys.text("unit", "");
  keys.finish();
  lua_rawgeti(L, -1, 1);
  read_value(L, figure);
  lua_pop(L, 1);
  return figure;
}

}  // namespace

std::vector<StudyFigure> figures_at(lua_State* L, int index) {
  std::vector<StudyFigure> figures;
  if (lua_type(L, index) != LUA_TTABLE) return figures;
  index = lua_absindex(L, index);
  lua_checkstack(L, 10);
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw InputError(fmt::format("a figure that the script gives has no name; give {{ name = value, ... }}"));
    require_printable(text_at(L, -2), "figure");
    figures.push_back(figure_at_top(L, text_at(L, -2)));
  }
  std::sort(figures.begin(), figures.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return figures;
}

}  // namespace trilith::script
