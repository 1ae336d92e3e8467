// Natural frequencies and shapes of a model as it stands.
#include "step/modes.hpp"

#include <algorithm>

#include "bindings.hpp"
#include "table_fields.hpp"

namespace trilith::script {
namespace {

/// "  1    15.0359 Hz   0.0665 s    mass x  83.1 %   y   0.0 %"
std::string modes_text(const std::vector<Mode>& found, const std::array<double, 2>& all) {
  std::string text = "mode   frequency [Hz]   period [s]   mass x [%]   mass y [%]";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mode& mode = found[i];
    const double f = mode.frequency();
    const auto share = [&](int k) { return all[k] > 0 ? 100 * mode.mass[k] / all[k] : 0; };
    text += fmt::format("\n{:4}   {:14.5g}   {:10}   {:10.2f}   {:10.2f}", i + 1, f,
                        f > 0 ? fmt::format("{:.5g}", 1 / f) : "-", share(0), share(1));
    if (mode.square < 0) text += "   unstable";
  }
  return text;
}

/// Pushes { name = {x =, y =, rotation =} }: of bodies, where the largest displacement of any node is 1.
void push_shape(lua_State* L, const Model<2>& model, const Mode& mode) {
  double most = 0;
  for (const Vec2& v : mode.displacement) most = std::max(most, v.norm());
  const double scale = most > 0 ? 1 / most : 1;
  lua_createtable(L, 0, static_cast<int>(model.bodies.size()));
  for (const Body& body : model.bodies) {
    Vec2 mean = Vec2::Zero();
    double mass = 0, turn = 0;
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      mean += model.mass[n] * mode.displacement[n], turn += model.mass[n] * mode.rotation[n];
      mass += model.mass[n];
    }
    lua_createtable(L, 0, 3);
    set_number(L, "x", scale * mean.x() / mass);
    set_number(L, "y", scale * mean.y() / mass);
    set_number(L, "rotation", scale * turn / mass);
    lua_setfield(L, -2, body.name.c_str());
  }
}

/// m:modes{ count = }: a list, lowest first.
int find_modes(lua_State* L) {
  ScriptModel& m = handle<ModelBox>(L, 1).get();
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, "modes");
  const int count = keys.count("count", 10);
  keys.finish();
  const Simulation& sim = m.evaluated();
  const std::vector<Mode> found = modes(sim.model(), sim.state(), count);
  const std::array<double, 2> all = free_mass(sim.model());
  lua_createtable(L, static_cast<int>(found.size()), 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mode& mode = found[i];
    lua_createtable(L, 0, 8);
    set_number(L, "frequency", mode.frequency());
    if (mode.square > 0) set_number(L, "period", 1 / mode.frequency());
    set_number(L, "square", mode.square);
    set_number(L, "mass_x", mode.mass[0]);
    set_number(L, "mass_y", mode.mass[1]);
    set_number(L, "factor_x", mode.factor[0]);
    set_number(L, "factor_y", mode.factor[1]);
    push_shape(L, sim.model(), mode);
    lua_setfield(L, -2, "shape");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  set_text(L, "text", modes_text(found, all));
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

const std::array modes_method_list{
    Method{"modes", guarded<find_modes>, "modes{count=}: natural frequencies and shapes as it stands"},
};

}  // namespace

std::span<const Method> modes_methods() {
  return modes_method_list;
}

}  // namespace trilith::script
