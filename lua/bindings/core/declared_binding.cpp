// Declarations of the kinds of handles and of the laws, for the library: console, manual, completion. Not for scripts.
#include <filesystem>

#include "bindings/core/bindings.hpp"
#include "bindings/core/open.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/geometry/declared_reading.hpp"
#include "build/list.hpp"
#include "model/event/event_list.hpp"
#include "model/plausible_ranges.hpp"

namespace trilith::script {
namespace {

template <class H>
void push_properties(lua_State* L) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Property<H>& p : Kind<H>::properties()) {
    lua_newtable(L);
    set_text(L, "name", p.name);
    set_text(L, "unit", p.unit);
    set_text(L, "doc", p.doc);
    lua_pushboolean(L, p.number != nullptr ? 1 : 0);
    lua_setfield(L, -2, "number");
    lua_pushboolean(L, p.set != nullptr ? 1 : 0);
    lua_setfield(L, -2, "settable");
    lua_rawseti(L, -2, ++i);
  }
}

template <class H>
bool push_kind(lua_State* L, std::string_view name) {
  if (name != Kind<H>::name) return false;
  push_properties<H>(L);
  return true;
}

template <class... Hs>
bool push_any_kind(lua_State* L, std::string_view name) {
  return (push_kind<Hs>(L, name) || ...);
}

/// core.properties(kind): list of { name, unit, doc, number, settable }; nil if there is no such kind.
int properties(lua_State* L) {
  const std::string name = lua_type(L, 1) == LUA_TSTRING ? text_at(L, 1) : "";
  return push_any_kind<ModelBox, BodyHandle, BodySet, BearingHandle, SeatHandle, HistoryHandle, StoreyHandle,
                       MotionValue, ContactLawValue, DirectionLawValue, SolidLawValue, FibreLawValue, HingeLawValue,
                       SectionValue>(L, name)
             ? 1
             : 0;
}

struct PushLaw {
  lua_State* L;
  template <class T>
  void operator()() const {
    if constexpr (Declared<T>) {
      lua_newtable(L);
      set_text(L, "doc", T::sentence);
      lua_newtable(L);
      lua_Integer i = 0;
      for (const Parameter<T>& p : T::parameters()) {
        lua_newtable(L);
        set_text(L, "name", p.name);
        set_text(L, "unit", p.unit);
        set_text(L, "doc", p.sentence);
        set_text(L, "range", p.range());
        set_text(L, "usual", plausible_range_text(p.name, p.unit));
        if (!p.required()) {
          lua_pushnumber(L, p.preset);
          lua_setfield(L, -2, "preset");
        }
        lua_rawseti(L, -2, ++i);
      }
      lua_setfield(L, -2, "parameters");
      lua_setfield(L, -2, std::string(T::name).c_str());
    }
  }
};

/// core.laws(): by name, { doc, parameters = list of { name, unit, doc, range, usual, preset } }, in six tables:
/// contact laws, bearing direction laws, solids, fibre laws, hinge laws, and section shapes.
int laws(lua_State* L) {
  lua_newtable(L);
  ContactLaws::for_each(PushLaw{L});
  lua_newtable(L);
  DirectionLaws::for_each(PushLaw{L});
  lua_newtable(L);
  SolidLaws::for_each(PushLaw{L});
  lua_newtable(L);
  UniaxialLaws::for_each(PushLaw{L});
  lua_newtable(L);
  TypeList<HingeLaw>::for_each(PushLaw{L});
  lua_newtable(L);
  SectionShapes::for_each(PushLaw{L});
  return 6;
}

/// Keys of a builder in the format of the manual: one line each of name, kind and sentence.
template <DeclaredBuilder B>
std::string builder_keys(bool is_name_required) {
  const std::string name = B{}.name, doc = B::is_single ? "name" : "prefix of names";
  const std::string first = !name.empty()      ? fmt::format("name  text = \"{}\"  {}\n", name, doc)
                            : is_name_required ? fmt::format("name  text  {}\n", doc)
                                               : fmt::format("name  text?  {}\n", doc);
  if constexpr (requires { B::is_named; }) return declared_key_lines<B>();
  return first + declared_key_lines<B>();
}

/// Pushes a list of { name, doc, keys, single } for a list of builders. A single body needs a name, and a single part
/// of the plane may be a shape without one.
template <class Builders>
void push_builders(lua_State* L, bool is_name_required) {
  lua_newtable(L);
  lua_Integer row = 0;
  Builders::for_each([&]<class B>() {
    lua_newtable(L);
    set_text(L, "name", B::kind);
    set_text(L, "doc", B::sentence);
    set_text(L, "keys", builder_keys<B>(is_name_required && B::is_single));
    lua_pushboolean(L, B::is_single ? 1 : 0);
    lua_setfield(L, -2, "single");
    lua_rawseti(L, -2, ++row);
  });
}

/// core.builders(): a list of the builders of the plane, and a list of the builders of space.
int builders(lua_State* L) {
  push_builders<PlaneBuilders>(L, false);
  push_builders<SpaceBuilders>(L, true);
  return 2;
}

/// core.manual_pages(): the pages of the manual, each a function that returns its table.
int manual_pages(lua_State* L) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const LibraryFile* file = library_files(); file->name != nullptr; ++file) {
    if (!std::string_view(file->name).starts_with("manual/")) continue;
    load_library_file(L, file->name);
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// core.files_in(folder): names in the folder, with a slash after folders; nothing if it cannot be read.
int files_in(lua_State* L) {
  std::error_code error;
  lua_newtable(L);
  lua_Integer count = 0;
  for (std::filesystem::directory_iterator at(text_at(L, 1), error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const std::string name = at->path().filename().string() + (at->is_directory(ignored) ? "/" : "");
    lua_pushlstring(L, name.data(), name.size());
    lua_rawseti(L, -2, ++count);
  }
  return 1;
}

/// core.event_names(): names of all kinds of events.
int event_names(lua_State* L) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const EventTypeInfo& e : event_type_info) {
    lua_pushlstring(L, e.name.data(), e.name.size());
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// core.event_types(): rows of the types of events: name, severity, value, unit, value_doc, text_doc, doc, and whether
/// one has a place and the mode of a joint.
int event_types(lua_State* L) {
  lua_newtable(L);
  lua_Integer i = 0;
  const auto text = [&](const char* key, std::string_view value) {
    lua_pushlstring(L, value.data(), value.size());
    lua_setfield(L, -2, key);
  };
  const auto flag = [&](const char* key, bool value) {
    lua_pushboolean(L, value ? 1 : 0);
    lua_setfield(L, -2, key);
  };
  for (const EventTypeInfo& e : event_type_info) {
    lua_newtable(L);
    text("name", e.name);
    text("severity", name_of(e.severity));
    text("value", e.value.name);
    text("unit", e.value.unit);
    text("value_doc", e.value.doc);
    text("text_doc", e.text_doc);
    text("doc", e.doc);
    flag("place", (e.traits & has_place) != 0);
    flag("mode", (e.traits & of_joint) != 0);
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// core.history_names(model)
int history_names(lua_State* L) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const History& h : handle<ModelBox>(L, 1).get().histories) {
    lua_pushlstring(L, h.name.data(), h.name.size());
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// core.kind_of(value): the kind of a handle, nil for anything else.
int kind_of(lua_State* L) {
  if (lua_type(L, 1) != LUA_TUSERDATA || luaL_getmetafield(L, 1, "__metatable") != LUA_TSTRING) return 0;
  return 1;
}

/// core.is_built(handle): true if the model of the handle has been built.
int is_built(lua_State* L) {
  push_model_of(L, 1);
  const auto* box = test_handle<ModelBox>(L, -1);
  lua_pushboolean(L, box != nullptr && box->open() && box->model->built() ? 1 : 0);
  return 1;
}

}  // namespace

void open_declarations(lua_State* L) {
  set_function(L, "properties", guarded<properties>);
  set_function(L, "laws", guarded<laws>);
  set_function(L, "builders", guarded<builders>);
  set_function(L, "kind_of", guarded<kind_of>);
  set_function(L, "manual_pages", guarded<manual_pages>);
  set_function(L, "event_names", guarded<event_names>);
  set_function(L, "files_in", guarded<files_in>);
  set_function(L, "event_types", guarded<event_types>);
  set_function(L, "history_names", guarded<history_names>);
  set_function(L, "is_built", guarded<is_built>);
}

}  // namespace trilith::script
