#include "bindings/core/handles.hpp"

#include <algorithm>

#include "base/terminal_text.hpp"

namespace trilith::script {
namespace {

/// Pushes the row's handle from the cache `table` of the model's own table; creates it if necessary.
template <class H>
void push_row(lua_State* L, int model_index, int row, const char* table) {
  model_index = lua_absindex(L, model_index);
  lua_checkstack(L, 8);
  push_own_table(L, model_index);
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
    push_handle<H>(L, row_of<H>(handle<ModelBox>(L, model_index).get(), row), 1);
    lua_pushvalue(L, model_index);
    lua_setiuservalue(L, -2, 1);
    lua_pushvalue(L, -1);
    lua_rawseti(L, -3, row + 1);
  }
  lua_replace(L, -3);
  lua_pop(L, 1);
}

void add_named(std::vector<int>& list, const ScriptModel& model, const std::string& name, const std::string& owner) {
  const std::size_t before = list.size();
  for (int b = 0; b < model.body_count(); ++b) {
    const auto& groups = model.groups_of(b);
    if (model.body_name(b) == name || std::find(groups.begin(), groups.end(), name) != groups.end()) list.push_back(b);
  }
  if (list.size() > before) return;
  std::vector<std::string> known = model.body_names();
  for (int b = 0; b < model.body_count(); ++b)
    for (const std::string& g : model.groups_of(b))
      if (std::find(known.begin(), known.end(), g) == known.end()) known.push_back(g);
  throw InputError(fmt::format("{}: there is no body or group '{}'{}", owner, one_line(name), name_hint(name, known)));
}

std::string names_begin(const std::string& owner) {
  return owner.empty() ? "" : owner + ": ";
}

template <class H>
std::vector<std::string> names_of(const ScriptModel& model) {
  if constexpr (std::is_same_v<H, BodyHandle>)
    return model.body_names();
  else if constexpr (std::is_same_v<H, BearingHandle>)
    return model.bearings;
  else
    return model.seats;
}

void add_bodies(std::vector<int>& list, lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  if (const auto* body = test_handle<BodyHandle>(L, index)) {
    list.push_back(require_own(*body, model, owner).index);
  } else if (const auto* set = test_handle<BodySet>(L, index)) {
    const std::vector<int>& bodies = require_own(*set, model, owner).bodies;
    list.insert(list.end(), bodies.begin(), bodies.end());
  } else if (lua_type(L, index) == LUA_TSTRING) {
    add_named(list, model, text_at(L, index), owner);
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
        fmt::format("{}: {} is not a body; give a body, a set, a name, or a list of these", owner, what_is(L, index)));
  }
}

}  // namespace

ScriptModel& ModelBox::get() const {
  if (!open()) throw InputError("the model is closed");
  return *model;
}

ScriptModel& this_model(lua_State* L) {
  return handle<ModelBox>(L, 1).get();
}

namespace {

/// Name by which the running function was called, such as "bearing" for m:bearing{...}.
std::string called_name(lua_State* L) {
  lua_Debug call{};
  if (lua_getstack(L, 0, &call) == 0 || lua_getinfo(L, "n", &call) == 0 || call.name == nullptr) return "this";
  return call.name;
}

}  // namespace

PlaneModel& require_plane(ScriptModel& m, const std::string& what) {
  if (PlaneModel* plane = as_plane(m)) return *plane;
  throw InputError(fmt::format("{}: is for models in the plane, but {} has dim = 3", what, m.title()));
}
PlaneModel& this_plane(lua_State* L) {
  return require_plane(this_model(L), called_name(L));
}
SpaceModel& this_space(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m)) return *space;
  throw InputError(
      fmt::format("{}: is for models in space, but {} is in the plane; give it dim = 3", called_name(L), m.title()));
}

void ModelBox::close() {
  if (!model) return;
  model->closed = true;
  keep_until_idle(std::exchange(model, nullptr));
}

void push_model_of(lua_State* L, int index) {
  if (test_handle<ModelBox>(L, index) != nullptr)
    lua_pushvalue(L, index);
  else if (lua_type(L, index) == LUA_TUSERDATA)
    lua_getiuservalue(L, index, 1);
  else
    lua_pushnil(L);
}

void push_own_table(lua_State* L, int model_index) {
  require_open(handle<ModelBox>(L, model_index));
  if (lua_getiuservalue(L, model_index, 1) != LUA_TTABLE) throw InputError("the model has lost its own table");
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
  push_handle<BodySet>(L, {Owner(handle<ModelBox>(L, model_index).model), std::move(bodies)}, 1);
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
        "{}: the set of bodies is empty, so the call has no effect; check the filters of its m:bodies{{...}}", owner));
  for (const int body : list) model.require_present(body, owner);
  return list;
}

namespace {

/// A removed body cannot be used.
template <class H>
int usable(const ScriptModel& model, int row, const std::string& owner) {
  if constexpr (std::is_same_v<H, BodyHandle>)
    if (model.removed_at(row)) model.require_present(row, owner);
  return row;
}

}  // namespace

template <class H>
int row_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner) {
  if (const auto* h = test_handle<H>(L, index)) return usable<H>(model, require_own(*h, model, owner).index, owner);
  if (lua_type(L, index) != LUA_TSTRING)
    throw InputError(fmt::format("{}{} is not a {}; give a {} or its name", names_begin(owner), what_is(L, index),
                                 Kind<H>::name, Kind<H>::name));
  const std::string name = text_at(L, index);
  const std::vector<std::string> names = names_of<H>(model);
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end())
    throw InputError(fmt::format("{}there is no {} '{}'{}", names_begin(owner), Kind<H>::name, one_line(name),
                                 name_hint(name, names)));
  return usable<H>(model, static_cast<int>(it - names.begin()), owner);
}
template int row_at<BodyHandle>(lua_State*, int, const ScriptModel&, const std::string&);
template int row_at<BearingHandle>(lua_State*, int, const ScriptModel&, const std::string&);
template int row_at<SeatHandle>(lua_State*, int, const ScriptModel&, const std::string&);

std::string body_name(Keys& keys, std::string_view key, const ScriptModel& model) {
  lua_State* L = keys.lua();
  std::string name;
  if (keys.push(key) == LUA_TNIL) {
    keys.missing(key, "a body or its name");
  } else if (lua_type(L, -1) != LUA_TSTRING && test_handle<BodyHandle>(L, -1) == nullptr) {
    keys.wrong(key, "a body or its name");
  } else {
    try {
      name = model.body_name(row_at<BodyHandle>(L, -1, model, ""));
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  }
  lua_pop(L, 1);
  return name;
}

bool matches(std::string_view pattern, std::string_view name) {
  constexpr std::size_t none = std::string_view::npos;
  std::size_t p = 0, n = 0, star = none, taken = 0;  // the last '*' matches the text before name[taken]
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p, ++n;
    } else if (star != none) {
      p = star + 1;  // an earlier '*' need not match more: the part between it and this one matches already
      n = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == none;
}

}  // namespace trilith::script
