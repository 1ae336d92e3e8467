#include "handles.hpp"

#include <algorithm>

namespace trilith::script {
namespace {

/// Pushes the row's handle from the cache `table` of the model's own table, making it where it is not there.
template <class H>
void push_row(lua_State* L, int model_index, int row, const char* table) {
  model_index = lua_absindex(L, model_index);
  lua_checkstack(L, 8);
  lua_getiuservalue(L, model_index, 1);
  lua_pushstring(L, table);
  if (lua_rawget(L, -2) != LUA_TTABLE) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushstring(L, table);
    lua_pushvalue(L, -2);
    lua_rawset(L, -4);
  }
  if (lua_rawgeti(L, -1, row + 1) == LUA_TNIL) {
    lua_pop(L, 1);
    H h;
    h.box = static_cast<const ModelBox*>(lua_touserdata(L, model_index));
    h.index = row;
    push_handle<H>(L, h, 1);
    lua_pushvalue(L, model_index);
    lua_setiuservalue(L, -2, 1);
    lua_pushvalue(L, -1);
    lua_rawseti(L, -3, row + 1);
  }
  lua_replace(L, -3);
  lua_pop(L, 1);
}

void add_named(std::vector<int>& list, const ScriptModel& model, const std::string& name, const std::string& owner) {
  const auto& bodies = model.builder.bodies();
  const std::size_t before = list.size();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& groups = bodies[i].groups;
    if (bodies[i].name == name || std::find(groups.begin(), groups.end(), name) != groups.end())
      list.push_back(static_cast<int>(i));
  }
  if (list.size() > before) return;
  std::vector<std::string> known = model.builder.body_names();
  for (const BodySpec& b : bodies)
    for (const std::string& g : b.groups)
      if (std::find(known.begin(), known.end(), g) == known.end()) known.push_back(g);
  throw InputError(fmt::format("{}: there is no body or group '{}'{}", owner, name, name_hint(name, known)));
}

template <class H>
void require_same(const H& h, const ScriptModel& model, const std::string& owner) {
  if (&h.model() != &model) throw InputError(fmt::format("{}: {} belongs to another model", owner, Kind<H>::title(h)));
}

void add_bodies(std::vector<int>& list, lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  if (const auto* body = test_handle<BodyHandle>(L, index)) {
    require_same(*body, model, owner);
    list.push_back(body->index);
  } else if (const auto* set = test_handle<BodySet>(L, index)) {
    require_same(*set, model, owner);
    list.insert(list.end(), set->bodies.begin(), set->bodies.end());
  } else if (lua_type(L, index) == LUA_TSTRING) {
    add_named(list, model, lua_tostring(L, index), owner);
  } else if (lua_type(L, index) == LUA_TTABLE && lua_rawlen(L, index) > 0) {
    const int table = lua_absindex(L, index);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, table));
    lua_checkstack(L, 8);
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L, table, i);
      if (lua_type(L, -1) == LUA_TTABLE)
        throw InputError(fmt::format("{}: a list of bodies holds another list", owner));
      add_bodies(list, L, -1, model, owner);
      lua_pop(L, 1);
    }
  } else {
    throw InputError(
        fmt::format("{}: {} is no body; give a body, a set, a name, or a list of these", owner, what_is(L, index)));
  }
}

}  // namespace

void push_model_of(lua_State* L, int index) {
  if (test_handle<ModelBox>(L, index) != nullptr)
    lua_pushvalue(L, index);
  else
    lua_getiuservalue(L, index, 1);
}

void push_body(lua_State* L, int model_index, int body) {
  push_row<BodyHandle>(L, model_index, body, "body handles");
}
void push_bearing(lua_State* L, int model_index, int row) {
  push_row<BearingHandle>(L, model_index, row, "bearing handles");
}
void push_seat(lua_State* L, int model_index, int seat) {
  push_row<SeatHandle>(L, model_index, seat, "seat handles");
}
void push_storey(lua_State* L, int model_index, int storey) {
  push_row<StoreyHandle>(L, model_index, storey, "storey handles");
}
void push_history(lua_State* L, int model_index, int row) {
  push_row<HistoryHandle>(L, model_index, row, "history handles");
}

void push_set(lua_State* L, int model_index, std::vector<int> bodies) {
  model_index = lua_absindex(L, model_index);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  push_handle<BodySet>(L, {static_cast<const ModelBox*>(lua_touserdata(L, model_index)), std::move(bodies)}, 1);
  lua_pushvalue(L, model_index);
  lua_setiuservalue(L, -2, 1);
}

std::vector<int> bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  std::vector<int> list;
  add_bodies(list, L, index, model, owner);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::vector<int> some_bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  std::vector<int> list = bodies_at(L, index, model, owner);
  if (list.empty())
    throw InputError(fmt::format(
        "{}: the set of bodies is empty, so nothing would be done; see what its m:bodies{{...}} asks for", owner));
  return list;
}

int body_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  if (const auto* body = test_handle<BodyHandle>(L, index)) {
    require_same(*body, model, owner);
    return body->index;
  }
  if (lua_type(L, index) == LUA_TSTRING) return model.require_body(lua_tostring(L, index), owner);
  throw InputError(fmt::format("{}: {} is no body; give a body or its name", owner, what_is(L, index)));
}

std::string body_name(Keys& keys, std::string_view key) {
  lua_State* L = keys.lua();
  std::string name;
  if (keys.push(key) == LUA_TNIL)
    keys.missing(key, "a body or its name");
  else if (const auto* body = test_handle<BodyHandle>(L, -1))
    name = body->model().builder.bodies()[body->index].name;
  else if (lua_type(L, -1) == LUA_TSTRING)
    name = lua_tostring(L, -1);
  else
    keys.wrong(key, "a body or its name");
  lua_pop(L, 1);
  return name;
}

bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
           matches(pattern.substr(1), name.substr(1));
  for (std::size_t skip = 0; skip <= name.size(); ++skip)
    if (matches(pattern.substr(1), name.substr(skip))) return true;
  return false;
}

}  // namespace trilith::script
