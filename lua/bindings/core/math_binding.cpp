// trilith.math: functions of Lua's `math` with the same bits on every processor.
#include "base/portable.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/keys.hpp"

namespace trilith::script {
namespace {

constexpr int function_name = 1;  ///< upvalue

double number_of(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TNUMBER)
    throw InputError(fmt::format("trilith.math.{}: takes numbers; argument {} is {}",
                                 text_at(L, lua_upvalueindex(function_name)), index, what_is(L, index)));
  return lua_tonumber(L, index);
}

int give(lua_State* L, double value) {
  lua_pushnumber(L, value);
  return 1;
}

template <double (*f)(double)>
int of_one(lua_State* L) {
  return give(L, f(number_of(L, 1)));
}

int arc_of_point(lua_State* L) {
  const double y = number_of(L, 1);
  return give(L, portable::atan2(y, lua_isnoneornil(L, 2) ? 1 : number_of(L, 2)));
}

int logarithm(lua_State* L) {
  if (!lua_isnoneornil(L, 2))
    throw InputError(
        "trilith.math.log: returns only the natural logarithm; for another base divide log(x) by log(base)");
  return of_one<portable::log>(L);
}

int power(lua_State* L) {
  const double base = number_of(L, 1);
  return give(L, portable::pow(base, number_of(L, 2)));
}

}  // namespace

void open_math(lua_State* L) {
  lua_newtable(L);
  const auto add = [L](const char* name, lua_CFunction f) {
    lua_pushstring(L, name);
    lua_pushcclosure(L, f, 1);
    lua_setfield(L, -2, name);
  };
  add("sin", guarded<of_one<portable::sin>>), add("cos", guarded<of_one<portable::cos>>);
  add("tan", guarded<of_one<portable::tan>>), add("asin", guarded<of_one<portable::asin>>);
  add("acos", guarded<of_one<portable::acos>>), add("atan", guarded<arc_of_point>);
  add("exp", guarded<of_one<portable::exp>>), add("log", guarded<logarithm>), add("pow", guarded<power>);
  lua_setfield(L, -2, "math");
}

}  // namespace trilith::script
