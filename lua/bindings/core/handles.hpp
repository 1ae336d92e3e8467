// Handles that scripts hold: a model, and rows of a model. The user value of a row is its model, which keeps the model
// alive.
//
// Handles outlive models: a model may be closed, and finalizers at the end of a script may read destroyed objects. So a
// row holds its model weakly and checks it at each access (Owner), and every handle argument is checked by require_own.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "bindings/core/keys.hpp"
#include "bindings/core/kind.hpp"
#include "bindings/model/built_model.hpp"

namespace trilith::script {

/// User value 1 of its userdata is the model's own table for the library: handlers, cached handles, stories.
struct ModelBox {
  std::shared_ptr<ScriptModel> model;
  [[nodiscard]] bool open() const { return model != nullptr && !model->closed; }
  /// The model, or InputError if it has been closed.
  [[nodiscard]] ScriptModel& get() const;
  /// As above; InputError too if the model is in space.
  [[nodiscard]] PlaneModel& plane() const;
  /// Closes the model for all its handles. It is freed when no call of the interface runs.
  void close();
};

/// The model of a handle.
class Owner {
 public:
  Owner() = default;
  explicit Owner(const std::shared_ptr<ScriptModel>& model) : model_(model) {}
  [[nodiscard]] bool open() const { return ModelBox{model_.lock()}.open(); }
  /// The model, or InputError if it has been closed. It remains alive until the present call of the interface ends.
  [[nodiscard]] ScriptModel& get() const { return ModelBox{model_.lock()}.get(); }
  [[nodiscard]] bool same(const Owner& other) const {
    return !model_.owner_before(other.model_) && !other.model_.owner_before(model_);
  }

 private:
  std::weak_ptr<ScriptModel> model_;
};

/// A row of a model; user value 1 is the model.
struct Row {
  Owner owner = {};
  int index = 0;
  [[nodiscard]] bool open() const { return owner.open(); }
  [[nodiscard]] ScriptModel& model() const { return owner.get(); }
  /// For features of plane models; InputError if the model is in space.
  [[nodiscard]] PlaneModel& plane() const;
};
struct BodyHandle : Row {};
struct BearingHandle : Row {};
struct SeatHandle : Row {};
struct HistoryHandle : Row {};
struct StoreyHandle : Row {};  ///< index: its number minus 1

/// Bodies of one model, sorted; user value 1 is the model.
struct BodySet {
  Owner owner = {};
  std::vector<int> bodies = {};
  [[nodiscard]] bool open() const { return owner.open(); }
  [[nodiscard]] ScriptModel& model() const { return owner.get(); }
};

/// A ground motion; a `steady` one need not end at rest.
struct MotionValue {
  std::shared_ptr<const GroundMotion> motion;
  bool steady = false;
};

struct ContactLawValue {
  ContactLaw law;
  std::string name;  ///< "" if the script gave none
};

struct DirectionLawValue {
  DirectionLaw law;
};

struct SolidLawValue {
  SolidLaw law;
};

struct FibreLawValue {
  UniaxialLaw law;
};

/// Law of a plastic hinge; one kind at present.
struct HingeLawValue {
  std::variant<HingeLaw> law;
};

/// A cross-section of beams.
struct SectionValue {
  Section numbers;
  std::string text;                 ///< its constructor call
  std::optional<FibreShape> shape;  ///< if it can be divided into fibres
  std::optional<FibreSpec> fibres;  ///< if it consists of fibres
  Section3 in_space = {};           ///< section for members in space
  std::string not_in_space = {};    ///< reason for which it is not possible there
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
TRILITH_KIND(FibreLawValue, "fibre law");
TRILITH_KIND(HingeLawValue, "hinge law");
TRILITH_KIND(SectionValue, "section");
#undef TRILITH_KIND

/// InputError for a property that a body has only while it is in the model.
void require_readable(const BodyHandle& b, std::string_view property);
/// Throws InputError if `property` is a stress and the body has no elements: its value 0 would look like a result.
void require_stress(const BodyHandle& b, std::string_view property);

/// The model whose method is called: argument 1. InputError if it is not a model, or closed.
ScriptModel& this_model(lua_State* L);
/// The model if it is in the plane, or in space; otherwise InputError, which names the method.
PlaneModel& this_plane(lua_State* L);
SpaceModel& this_space(lua_State* L);

/// Cast to a model in the plane or in space; nullptr for the other kind.
inline PlaneModel* as_plane(ScriptModel& m) {
  return m.dim() == 2 ? static_cast<PlaneModel*>(&m) : nullptr;
}
inline const PlaneModel* as_plane(const ScriptModel& m) {
  return m.dim() == 2 ? static_cast<const PlaneModel*>(&m) : nullptr;
}
inline SpaceModel* as_space(ScriptModel& m) {
  return m.dim() == 3 ? static_cast<SpaceModel*>(&m) : nullptr;
}
/// The model for a feature of the plane; InputError, which names it, if the model is in space.
PlaneModel& require_plane(ScriptModel& m, const std::string& what);

/// `h`, if it belongs to `model`. InputError, beginning with `owner` unless that is "", if it belongs to another model
/// or its model has been closed.
template <class H>
const H& require_own(const H& h, const ScriptModel& model, const std::string& owner) {
  const std::string begin = owner.empty() ? "" : owner + ": ";
  if (!h.open())
    throw InputError(fmt::format("{}a {} of a closed model is given; give one of this model", begin, Kind<H>::name));
  if (&h.model() != &model) throw InputError(fmt::format("{}{} belongs to another model", begin, Kind<H>::title(h)));
  return h;
}
/// Row of the body, bearing or seat at `index`: a handle of `model`, or a name. InputError as require_own, and for an
/// unknown name.
template <class H>
int row_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
inline PlaneModel& ModelBox::plane() const {
  return require_plane(get(), "this");
}
inline PlaneModel& Row::plane() const {
  return require_plane(model(), "this");
}
/// Dimension of the model of a handle.
inline int dimension_of(const ModelBox& m) {
  return m.get().dim();
}
inline int dimension_of(const BodyHandle& b) {
  return b.model().dim();
}
inline int dimension_of(const BearingHandle& b) {
  return b.model().dim();
}
inline int dimension_of(const StoreyHandle& s) {
  return s.model().dim();
}

/// A handle for C++: of a body, bearing, seat or storey of `model`.
template <class H>
H row_of(ScriptModel& model, int index) {
  H h;
  h.owner = Owner(model.shared_from_this());
  h.index = index;
  return h;
}

/// Pushes the model of the row or set at `index` (the model itself for a model), nil for other values.
void push_model_of(lua_State* L, int index);
/// Pushes the model's own table for the library; InputError if there is none.
void push_own_table(lua_State* L, int model_index);
/// Pushes the handle of a body, bearing or seat, the same one each time. `model_index`: index of the model's userdata.
void push_body(lua_State* L, int model_index, int body);
void push_bearing(lua_State* L, int model_index, int bearing);
void push_seat(lua_State* L, int model_index, int seat);
void push_storey(lua_State* L, int model_index, int storey);
void push_history(lua_State* L, int model_index, int history);
void push_set(lua_State* L, int model_index, std::vector<int> bodies);

/// Bodies at `index`: a body, a set, a name, a group's name, or a list of these. InputError if it does not belong to
/// the model; `owner` begins the message.
std::vector<int> bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
/// As above for a change of bodies: InputError too for an empty result, such as an empty set.
std::vector<int> some_bodies_at(lua_State* L, int index, const ScriptModel& model, const std::string& owner);
/// The name of the body under a key, given as a body or by name; "" with a problem noted if it is missing or wrong.
std::string body_name(Keys& keys, std::string_view key, const ScriptModel& model);

/// True if `name` matches `pattern`, in which '*' matches any text and '?' any letter. The run time is at most
/// proportional to the product of their lengths.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace trilith::script
