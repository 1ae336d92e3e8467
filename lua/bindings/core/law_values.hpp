// Common parts of laws as values: variants of declared types.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "bindings/core/handles.hpp"

namespace trilith::script {

/// A declared number of a law by name: law.kn. False if the key is not a text.
template <class Law>
bool push_declared(lua_State* L, const Law& law) {
  if (lua_type(L, 2) != LUA_TSTRING) return false;
  const std::string key = text_at(L, 2);
  std::vector<std::string> known;
  bool found = false;
  std::visit(
      [&](const auto& l) {
        using T = std::decay_t<decltype(l)>;
        if constexpr (Declared<T>)
          for (const Parameter<T>& p : T::parameters()) {
            known.emplace_back(p.name);
            if (p.name != key) continue;
            lua_pushnumber(L, l.*(p.member));
            found = true;
          }
      },
      law);
  if (!found) throw InputError(fmt::format("this law has no '{}'{}", key, name_hint(key, known)));
  return true;
}

/// "frictional{kn=1e+08 Pa/m, mu=0.6}": describe() with the unit 1 for dimensionless numbers, for display.
template <class Law>
std::string law_text(const Law& law) {
  std::string text;
  std::visit(
      [&](const auto& l) {
        if constexpr (Declared<std::decay_t<decltype(l)>>) text = describe(l);
      },
      law);
  for (std::size_t at = text.find(" 1"); at != std::string::npos; at = text.find(" 1", at + 1))
    if (at + 2 < text.size() && (text[at + 2] == ',' || text[at + 2] == '}')) text.erase(at, 2);
  return text;
}

/// Checks numbers of a contact law that are valid individually, but not between two options or without each other.
template <class L>
void check_ways(Keys& keys, const L& law) {
  if constexpr (requires { law.loss_by_point; })
    if (law.loss_by_point != 0 && law.loss_by_point != 1)
      keys.problem(fmt::format("'loss_by_point' is {:g}, must be 0 or 1", law.loss_by_point));
  if constexpr (requires { law.dilation_slip; })
    if ((law.dilation > 0) != (law.dilation_slip > 0))
      keys.problem(fmt::format(
          "'{}' is given without '{}', so that the joint does not dilate; give both, the opening per slip and the "
          "slip up to which it opens",
          law.dilation > 0 ? "dilation" : "dilation_slip", law.dilation > 0 ? "dilation_slip" : "dilation"));
}

/// Constructor of a law that consists of declared numbers only, as a `Value` (handles.hpp).
template <class Value, class L>
int make_law(lua_State* lua) {
  Keys keys(lua, 1, std::string(L::name));
  L law;
  keys.declared(law);
  keys.finish();
  if constexpr (requires { law.check(); }) law.check();
  push_handle(lua, Value{law});
  return 1;
}
/// Adds the constructor of each law of a list to the table on top of the stack.
template <class Value>
struct AddLaw {
  lua_State* lua;
  template <class L>
  void operator()() const {
    set_function(lua, std::string(L::name).c_str(), guarded<make_law<Value, L>>);
  }
};

// NOLINTBEGIN(bugprone-macro-parentheses): a type as a template argument takes none.
/// Kind of a handle that holds only a law.
#define TRILITH_LAW_KIND(Value)                                                       \
  std::span<const Property<Value>> Kind<Value>::properties() {                        \
    return {};                                                                        \
  }                                                                                   \
  std::span<const Method> Kind<Value>::methods() {                                    \
    return {};                                                                        \
  }                                                                                   \
  std::string Kind<Value>::title(const Value& v) {                                    \
    return law_text(v.law);                                                           \
  }                                                                                   \
  std::span<const std::pair<const char*, lua_CFunction>> Kind<Value>::metamethods() { \
    return {};                                                                        \
  }                                                                                   \
  bool Kind<Value>::read_item(lua_State* L, const Value& v) {                         \
    return push_declared(L, v.law);                                                   \
  }
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace trilith::script
