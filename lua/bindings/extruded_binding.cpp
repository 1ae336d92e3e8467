// m:extruded{...}: a model of the plane taken into space.
#include "extruded_model.hpp"
#include "handles.hpp"
#include "keys.hpp"
#include "model_binding.hpp"

namespace trilith::script {

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
  return 1;
}

}  // namespace trilith::script
