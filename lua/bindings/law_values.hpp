// What laws as values have in common: variants of declared types.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "keys.hpp"

namespace trilith::script {

/// A declared number of a law, looked up by name: law.kn. False where the key is no text.
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

template <class Law>
std::string law_text(const Law& law) {
  std::string text;
  std::visit(
      [&](const auto& l) {
        if constexpr (Declared<std::decay_t<decltype(l)>>) text = describe(l);
      },
      law);
  return text;
}

}  // namespace trilith::script
