// Readings of the members of beams and frames: section forces, plastic hinges and fibres, in the plane and in space.
#include <type_traits>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/model/frame_binding.hpp"
#include "readings/member_forces.hpp"

namespace trilith::script {
namespace {

/// Argument 2: the name of a member, or nothing.
std::optional<std::string> name_asked(lua_State* L, const char* call) {
  if (lua_type(L, 2) == LUA_TSTRING) return text_at(L, 2);
  if (lua_isnoneornil(L, 2)) return std::nullopt;
  throw InputError(fmt::format("{}: takes the name of a member; this is {}", call, what_is(L, 2)));
}

/// The member for body:forces and the others (`call`): the only one, or the one with the given name.
template <int D>
int member_of(const Model<D>& model, int body, const std::optional<std::string>& name, const char* call) {
  std::vector<std::string> known;
  int only = -1;
  for (int i = 0; i < static_cast<int>(model.members.size()); ++i) {
    if (model.members[i].body != body) continue;
    if (name && model.members[i].name == *name) return i;
    only = i;
    known.push_back(model.members[i].name);
  }
  const std::string& owner = model.bodies[body].name;
  if (known.empty())
    throw InputError(fmt::format("{}: body '{}' is {}, which has no members; use a beam or frame", call, owner,
                                 name_of(model.bodies[body].kind)));
  if (name)
    throw InputError(fmt::format("{}: body '{}' has no member '{}'{}", call, owner, *name, name_hint(*name, known)));
  if (known.size() > 1)
    throw InputError(fmt::format("{}: body '{}' has {} members; name one, such as {} \"{}\"", call, owner, known.size(),
                                 call, known.front()));
  return only;
}

void set_place(lua_State* L, const Vec2& place) {
  set_number(L, "x", place.x()), set_number(L, "y", place.y());
}
void set_place(lua_State* L, const Vec3& place) {
  set_number(L, "x", place.x()), set_number(L, "y", place.y()), set_number(L, "z", place.z());
}
/// About y and z of the section.
void set_both(lua_State* L, const char* about_y, const char* about_z, const std::array<double, 2>& value) {
  set_number(L, about_y, value[0]), set_number(L, about_z, value[1]);
}

// Fields of a row of each reading, in the table on top of the stack.

void set_fields(lua_State* L, const SectionForces& row) {
  set_number(L, "shear", row.shear);
  set_number(L, "moment", row.moment);
}
void set_fields(lua_State* L, const SectionForces3& row) {
  set_both(L, "shear_y", "shear_z", row.shear);
  set_number(L, "torque", row.torque);
  set_both(L, "moment_y", "moment_z", row.moment);
}

void set_fields(lua_State* L, const HingeReading& row) {
  set_number(L, "rotation", row.rotation);
  set_number(L, "moment", row.moment);
}
void set_fields(lua_State* L, const HingeReading3& row) {
  set_both(L, "rotation_y", "rotation_z", row.rotation);
  set_both(L, "moment_y", "moment_z", row.moment);
}

void set_fields(lua_State* L, const FibreReading& row) {
  set_number(L, "curvature", row.curvature);
  set_number(L, "moment", row.moment);
}
void set_fields(lua_State* L, const FibreReading3& row) {
  set_both(L, "curvature_y", "curvature_z", row.curvature);
  set_both(L, "moment_y", "moment_z", row.moment);
}

void set_fields(lua_State* L, const FibreReading::Fibre& fibre) {
  set_number(L, "height", fibre.height);
}
void set_fields(lua_State* L, const FibreReading3::Fibre& fibre) {
  set_number(L, "up", fibre.up), set_number(L, "across", fibre.across);
}

/// Pushes a list of tables, one for each row, which `set` fills.
template <class Row, class Set>
void push_rows(lua_State* L, const std::vector<Row>& rows, const Set& set) {
  lua_createtable(L, static_cast<int>(rows.size()), 0);
  lua_Integer i = 0;
  for (const Row& row : rows) {
    lua_newtable(L);
    set(row);
    lua_rawseti(L, -2, ++i);
  }
}

template <int D>
void push_forces(lua_State* L, const Model<D>& model, const State<D>& state, int member) {
  push_rows(L, member_forces(model, state, member), [L](const auto& row) {
    set_number(L, "along", row.along);
    set_place(L, row.place);
    set_number(L, "normal", row.normal);
    set_fields(L, row);
  });
}

template <int D>
void push_hinges(lua_State* L, const Model<D>& model, const State<D>& state, int member) {
  const auto hinges = member_hinges(model, state, member);
  const Member& of = model.members[member];
  if (hinges.empty())
    throw InputError(fmt::format("hinges: member '{}' has no hinges; give it some by hinge = trilith.end_hinge{{{}}}",
                                 of.name, D == 2 ? "sagging =" : "sagging =, across ="));
  push_rows(L, hinges, [&, L](const auto& row) {
    set_text(L, "joint", of.joint[row.end]);
    set_text(L, "state", hinge_state_text(row.status));
    set_number(L, "stretch", row.stretch);
    set_number(L, "normal", row.normal);
    set_number(L, "given_off", row.dissipated);
    set_place(L, row.place);
    set_fields(L, row);
  });
}

template <int D>
void push_fibres(lua_State* L, const Model<D>& model, const State<D>& state, int member) {
  const auto sections = member_fibres(model, state, member);
  if (sections.empty()) throw InputError(no_fibres_text(model.members[member].name));
  push_rows(L, sections, [L](const auto& row) {
    set_number(L, "along", row.along);
    set_number(L, "axial", row.axial);
    set_number(L, "normal", row.normal);
    set_fields(L, row);
    push_rows(L, row.fibres, [L](const auto& fibre) {
      set_fields(L, fibre);
      set_number(L, "area", fibre.area);
      set_number(L, "strain", fibre.strain);
      set_number(L, "stress", fibre.stress);
    });
    lua_setfield(L, -2, "fibres");
  });
}

/// Calls push(L, model, state, member) with the member of the body in argument 1 that argument 2 names. The name is
/// required if there are several.
template <class Push>
int push_reading(lua_State* L, const char* call, const Push& push) {
  const auto& b = handle<BodyHandle>(L, 1);
  const std::optional<std::string> name = name_asked(L, call);
  const auto read = [&](const auto& m) {
    const auto* const run = m.if_built();
    if (run == nullptr)
      throw InputError(fmt::format("{}: nothing has run yet; read it during a stage or after it", call));
    push(L, run->model(), run->state(), member_of(run->model(), b.index, name, call));
    return 1;
  };
  if (const SpaceModel* space = as_space(b.model())) return read(*space);
  return read(b.plane());
}

}  // namespace

/// body:forces "member": a list of { along, x, y, normal, shear, moment }, two for each beam; in space { along, x, y,
/// z, normal, shear_y, shear_z, torque, moment_y, moment_z }.
int push_member_forces(lua_State* L) {
  return push_reading(L, "forces", [](auto&&... of) { push_forces(of...); });
}

/// body:hinges "member": a list of { joint, state, rotation, stretch, moment, normal, given_off, x, y }; in space with
/// z, and rotation_y, rotation_z, moment_y and moment_z.
int push_member_hinges(lua_State* L) {
  return push_reading(L, "hinges", [](auto&&... of) { push_hinges(of...); });
}

/// body:fibres "member": a list of { along, axial, curvature, normal, moment, fibres = { { height, area, strain, stress
/// } } }; in space with curvature_y, curvature_z, moment_y, moment_z, and up and across instead of height.
int push_member_fibres(lua_State* L) {
  return push_reading(L, "fibres", [](auto&&... of) { push_fibres(of...); });
}

}  // namespace trilith::script
