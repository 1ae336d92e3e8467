// m:extruded{...}: a plane model converted to a model in space.
#include "bindings/core/bindings.hpp"
#include "bindings/core/handles.hpp"
#include "bindings/core/keys.hpp"
#include "bindings/model/extruded_model.hpp"
#include "bindings/model/model_binding.hpp"

namespace trilith::script {
namespace {

/// Changes made after a model was built are not converted, which is reported.
void tell_left_behind(lua_State* L, const PlaneModel& plane, ScriptModel& deep) {
  const Simulation<2>* flat = plane.if_built();
  if (flat == nullptr || (flat->state().time == 0 && !flat->model().loaded())) return;
  tell_note(L, deep,
            fmt::format("extruded: {} is copied in its initial state, at 0 s; its motion of {:.4g} s, its loads, and "
                        "later removals, supports and changes are not copied",
                        plane.title(), flat->state().time));
}

}  // namespace

int make_extruded(lua_State* L) {
  lua_settop(L, 2);
  const ScriptModel& m = handle<ModelBox>(L, 1).get();
  const PlaneModel* plane = as_plane(m);
  if (plane == nullptr) throw InputError(fmt::format("extruded: {} is in space already", m.title()));
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, "extruded");
  const std::string name = keys.text("name", m.name);
  PlaneExtrusion extrusion;
  extrusion.held = keys.flag("held", extrusion.held);
  keys.finish();
  push_handle(L, ModelBox{extruded_model(*plane, name, extrusion)}, 1);
  lua_newtable(L);
  lua_setiuservalue(L, -2, 1);
  tell_left_behind(L, *plane, handle<ModelBox>(L, -1).get());
  return 1;
}

}  // namespace trilith::script
