// The handles that scripts hold: a model, and rows of a model. A row's user value is its model, so that it lives on.
#pragma once

#include <memory>
#include <vector>

#include "keys.hpp"
#include "kind.hpp"
#include "script_model.hpp"

namespace trilith::script {

/// User value 1 of its userdata is the model's own table for the library: handlers, cached handles, stories.
struct ModelBox {
  std::shared_ptr<ScriptModel> model;
  /// The model, or InputError where it has been closed.
  [[nodiscard]] ScriptModel& get() const {
    if (!model) throw InputError("the model is closed");
    return *model;
  }
};

/// A row of a model; user value 1 is the model.
struct Row {
  const ModelBox* box = nullptr;
  int index = 0;
  [[nodiscard]] ScriptModel& model() const { return box->get(); }
};
struct BodyHandle : Row {};
struct BearingHandle : Row {};
struct SeatHandle : Row {};
struct HistoryHandle : Row {};
struct StoreyHandle : Row {};  ///< index: its number less 1

/// Bodies of one model, in rising order; user value 1 is the model.
struct BodySet {
  const ModelBox* box = nullptr;
  std::vector<int> bodies;
  [[nodiscard]] ScriptModel& model() const { return box->get(); }
};

/// A ground motion; `steady` ones need not come to rest.
struct MotionValue {
  std::shared_ptr<const GroundMotion> motion;
  bool steady = false;
};

struct ContactLawValue {
  ContactLaw law;
  std::string name;  ///< "" where the script gave none
};

struct DirectionLawValue {
  DirectionLaw law;
};

struct SolidLawValue {
  SolidLaw law;
};

// NOLINTBEGIN(bugprone-macro-parentheses): a type as a template argument takes none.
#define TRILITH_KIND(Type, Name)                                                 \
  template <>                                                                    \
  struct Kind<Type> {                                                            \
    static constexpr const char* name = Name;                                    \
    static constexpr const char* key = "trilith." Name;                          \
    static std::span<const Property<Type>> properties();                         \
    static std::span<const Method> methods();                                    \
    static std::string title(const Type& h);                                     \
    static std::span<const std::pair<const char*, lua_CFunction>> metamethods(); \
    static bool read_item(lua_State* L, const Type& h);                          \
  }
// NOLINTEND(bugprone-macro-parentheses)
TRILITH_KIND(ModelBox, "model");
TRILITH_KIND(BodyHandle, "body");
TRILITH_KIND(BodySet, "set of bodies");
TRILITH_KIND(BearingHandle, "bearing");
TRILITH_KIND(SeatHandle, "seat");
TRILITH_KIND(HistoryHandle, "history");
TRILITH_KIND(StoreyHandle, "storey");
TRILITH_KIND(MotionValue, "motion");
TRILITH_KIND(ContactLawValue, "contact law");
TRILITH_KIND(DirectionLawValue, "direction law");
TRILITH_KIND(SolidLawValue, "solid law");
#undef TRILITH_KIND

/// Pushes the model that the row or set at `index` belongs to (the model itself for a model).
void push_model_of(lua_State* L, int index);
/// Pushes the handle of a body, bearing or seat; the same one each time. `model_index`: of the model's userdata.
void push_body(lua_State* L, int model_index, int body);
void push_bearing(lua_State* L, int model_index, int bearing);
void push_seat(lua_State* L, int model_index, int seat);
void push_storey(lua_State* L, int model_index, int storey);
void push_history(lua_State* L, int model_index, int history);
void push_set(lua_State* L, int model_index, std::vector<int> bodies);

/// Bodies named at `index`: a body, a set, a name, a group's name, or a list of these. InputError where it is nothing
/// of the model; `owner` begins the message.
std::vector<int> bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
/// The same for what is to be done to bodies: InputError too where there is none, as in an empty set.
std::vector<int> some_bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
/// One body: a body or a name.
int body_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
/// The same under a key; its name, "" with a problem noted where it is missing or wrong.
std::string body_name(Keys& keys, std::string_view key);

/// True where `name` matches `pattern`, in which '*' stands for any text and '?' for any letter.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace trilith::script
