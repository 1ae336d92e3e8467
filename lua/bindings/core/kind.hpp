// Implementation of the handles that scripts hold: one table of properties and methods for each kind, from which
// reading, writing, messages, tostring, histories, help and completion are derived.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "bindings/core/guard.hpp"

namespace trilith::script {

/// A named value of a handle. Exactly one of `number` and `push` is set; a number can be recorded as a history.
template <class H>
struct Property {
  std::string_view name, unit, doc;  ///< unit "" if it is not a number
  double (*number)(const H&) = nullptr;
  void (*push)(lua_State*, const H&) = nullptr;      ///< pushes one value; the handle is at stack index 1
  void (*set)(lua_State*, H&, int index) = nullptr;  ///< nullptr: cannot be set
  int dim = 0;                                       ///< for models of this dimension only; 0: all
};

struct Method {
  std::string_view name;
  lua_CFunction call;  ///< guarded<...>; its text is in lua/manual
  int dim = 0;         ///< for models of this dimension only; 0: all
};

/// Specialised for each kind of handle: name (for messages), key (of the metatable), properties(), methods(),
/// title(handle) for tostring, and optionally further metamethods.
template <class H>
struct Kind;

/// Its address marks objects that were created as a handle of this kind.
template <class H>
inline constexpr char kind_mark = 0;

/// Content of the userdata of a handle. The metatable alone is not a proof, because debug.setmetatable can assign it to
/// any value.
template <class H>
struct Held {
  const void* mark = &kind_mark<H>;  ///< nullptr after its destructor has run
  H value;
};

/// A handle that can report whether its model is open; a destroyed one reports closed.
template <class H>
concept OfModel = requires(const H& h) {
  {h.open()};
};

template <class H>
H* test_handle(lua_State* L, int index) {
  auto* held = static_cast<Held<H>*>(luaL_testudata(L, index, Kind<H>::key));
  if (held == nullptr || lua_rawlen(L, index) != sizeof(Held<H>) || held->mark != &kind_mark<H>) return nullptr;
  return &held->value;
}

/// The handle at `index`, or InputError: "method must be called on a body, with ':'".
template <class H>
H& handle(lua_State* L, int index) {
  H* h = test_handle<H>(L, index);
  if (h == nullptr)
    throw InputError(fmt::format("argument {} is a {}, must be a {}; call methods with ':'", index,
                                 luaL_typename(L, index), Kind<H>::name));
  return *h;
}

template <class H>
const Property<H>* find_property(std::string_view name) {
  for (const Property<H>& p : Kind<H>::properties())
    if (p.name == name) return &p;
  return nullptr;
}

/// True if the handle has the property: some belong to models in the plane, or in space, only.
template <class H>
bool has_property(const Property<H>& p, const H& h) {
  if constexpr (requires { dimension_of(h); })
    return p.dim == 0 || p.dim == dimension_of(h);
  else
    return true;
}

/// True if the handle has the method; methods that the library adds belong to all.
template <class H>
bool has_method(std::string_view name, const H& h) {
  if constexpr (requires { dimension_of(h); })
    for (const Method& m : Kind<H>::methods())
      if (m.name == name) return m.dim == 0 || m.dim == dimension_of(h);
  return true;
}

template <class H>
std::vector<std::string> member_names(lua_State* L, int lookup, const H& h) {
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, lookup) != 0; lua_pop(L, 1)) {
    const std::string name = lua_tostring(L, -2);
    const Property<H>* p = find_property<H>(name);
    if (p != nullptr ? has_property(*p, h) : has_method(name, h)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

template <class H>
void push_property(lua_State* L, const Property<H>& p, const H& h) {
  if (p.number != nullptr)
    lua_pushnumber(L, p.number(h));
  else
    p.push(L, h);
}

/// InputError if the model of a handle is closed: then it has no members any more.
template <class H>
void require_open(const H& h) {
  if constexpr (OfModel<H>)
    if (!h.open()) throw InputError("the model is closed");
}

/// __index: upvalue 1 holds name -> light userdata of the property, or the method.
template <class H>
int read_member(lua_State* L) {
  H& h = handle<H>(L, 1);
  require_open(h);
  lua_pushvalue(L, 2);
  const int found = lua_rawget(L, lua_upvalueindex(1));
  const auto* property = found == LUA_TLIGHTUSERDATA ? static_cast<const Property<H>*>(lua_touserdata(L, -1)) : nullptr;
  if (property != nullptr && has_property(*property, h)) {
    if constexpr (requires { require_readable(h, property->name); }) require_readable(h, property->name);
    push_property(L, *property, h);
    return 1;
  }
  if (found == LUA_TFUNCTION) return 1;
  if constexpr (requires { Kind<H>::read_item(L, h); })
    if (Kind<H>::read_item(L, h)) return 1;
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(fmt::format("a {} has no members by {}", Kind<H>::name, luaL_typename(L, 2)));
  const std::string name = text_at(L, 2);
  throw InputError(fmt::format("{} has no '{}'{}", Kind<H>::title(h), name,
                               name_hint(name, member_names<H>(L, lua_upvalueindex(1), h))));
}

template <class H>
int write_member(lua_State* L) {
  H& h = handle<H>(L, 1);
  require_open(h);
  const std::string name = lua_type(L, 2) == LUA_TSTRING ? text_at(L, 2) : luaL_typename(L, 2);
  const Property<H>* p = find_property<H>(name);
  if (p == nullptr) throw InputError(fmt::format("{} has no '{}' that could be set", Kind<H>::title(h), name));
  if (p->set == nullptr) throw InputError(fmt::format("'{}' of {} can be read, not set", name, Kind<H>::title(h)));
  p->set(L, h, 3);
  return 0;
}

template <class H>
int describe_handle(lua_State* L) {
  const std::string title = Kind<H>::title(handle<H>(L, 1));
  lua_pushlstring(L, title.data(), title.size());
  return 1;
}

/// __gc. Finalizers of the script may run later and still read the handle, so an empty one remains.
template <class H>
int destroy_handle(lua_State* L) {
  H* h = test_handle<H>(L, 1);
  if (h == nullptr) return 0;
  if constexpr (requires { h->close(); }) h->close();
  h->~H();
  new (h) H();
  if constexpr (!OfModel<H>) static_cast<Held<H>*>(lua_touserdata(L, 1))->mark = nullptr;
  return 0;
}

/// Pushes a new handle that holds `value`.
template <class H>
H& push_handle(lua_State* L, H value, int uservalues = 0) {
  auto* held = new (lua_newuserdatauv(L, sizeof(Held<H>), uservalues)) Held<H>{&kind_mark<H>, std::move(value)};
  luaL_setmetatable(L, Kind<H>::key);
  return held->value;
}

inline void set_function(lua_State* L, const char* name, lua_CFunction f) {
  lua_pushcfunction(L, f);
  lua_setfield(L, -2, name);
}

/// Creates the metatable of a kind. Its lookup table remains in the metatable as "members", to which the library adds.
template <class H>
void register_kind(lua_State* L) {
  if (luaL_newmetatable(L, Kind<H>::key) == 0) {
    lua_pop(L, 1);
    return;
  }
  lua_newtable(L);
  for (const Property<H>& p : Kind<H>::properties()) {
    lua_pushlightuserdata(L, const_cast<Property<H>*>(&p));
    lua_setfield(L, -2, std::string(p.name).c_str());
  }
  for (const Method& m : Kind<H>::methods()) set_function(L, std::string(m.name).c_str(), m.call);
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, "members");
  lua_pushcclosure(L, guarded<read_member<H>>, 1);
  lua_setfield(L, -2, "__index");
  set_function(L, "__newindex", guarded<write_member<H>>);
  set_function(L, "__tostring", guarded<describe_handle<H>>);
  if constexpr (!std::is_trivially_destructible_v<H>) set_function(L, "__gc", destroy_handle<H>);
  if constexpr (requires { Kind<H>::metamethods(); })
    for (const auto& [name, f] : Kind<H>::metamethods()) set_function(L, name, f);
  lua_pushstring(L, Kind<H>::name);
  lua_setfield(L, -2, "__metatable");  // getmetatable returns the kind's name, and scripts cannot change it
  lua_pop(L, 1);
}

}  // namespace trilith::script
