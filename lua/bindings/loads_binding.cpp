// Loads at points of bodies, in the plane and in space.
#include <array>

#include "bindings.hpp"
#include "load_reading.hpp"
#include "world/loads.hpp"

namespace trilith::script {
namespace {

/// `at` = {x, y} or the name of a place; the points, one for each body.
std::vector<std::optional<Vec2>> read_places(Keys& keys, const Model<2>& model, const std::vector<int>& bodies) {
  lua_State* L = keys.lua();
  std::vector<std::optional<Vec2>> places(bodies.size());
  const int type = keys.push("at");
  const std::string name = type == LUA_TSTRING ? text_at(L, -1) : "";
  const auto point = type == LUA_TTABLE ? point_at(L, -1) : std::nullopt;
  if (type != LUA_TNIL && type != LUA_TSTRING && !point) keys.wrong("at", "{x, y} or the name of a place");
  lua_pop(L, 1);
  if (point && bodies.size() > 1) keys.problem("'at' is a point of one body; several are given: name a place instead");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    places[i] = type == LUA_TSTRING ? named_place(model, bodies[i], name) : point;
    if (type == LUA_TSTRING && !places[i])
      keys.problem(fmt::format("'at' is '{}', must be {{x, y}} or one of {}", name, place_names));
  }
  return places;
}

int solid_point_load(lua_State* L, SpaceModel& m) {
  Keys keys(L, 2, "point_load");
  SolidLoadSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  spec.force = keys.vector("force", Vec3::Zero());
  spec.moment = keys.vector("moment", Vec3::Zero());
  if (spec.force.isZero() && spec.moment.isZero()) keys.problem("gives neither a force nor a moment");
  if (keys.has("at")) spec.at = keys.vector("at");
  if (spec.at && bodies.size() > 1) keys.problem("'at' is a point of one body; several are given: leave it out");
  spec.follows = keys.flag("follow", false);
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "load");
  std::vector<PointLoad<3>> loads;
  for (const int body : bodies) loads.push_back(make_solid_load(m.simulation().model(), body, spec));
  m.change([loads](Model<3>& changed) {
    changed.point_loads.insert(changed.point_loads.end(), loads.begin(), loads.end());
  });
  return push_load_name(L, spec.name);
}

/// m:point_load{ body =, force =, moment =, at =, follow =, course =, name = }: its name.
int point_load(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return solid_point_load(L, *space);
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "point_load");
  PointLoadSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  spec.force = keys.point("force", Vec2::Zero());
  spec.moment = keys.number("moment", "N m", 0);
  if (spec.force.isZero() && spec.moment == 0) keys.problem("gives neither a force nor a moment");
  spec.follows = keys.flag("follow", false);
  spec.curve = read_load_curve(keys, m.time());
  keys.know({"at"});
  keys.finish();
  const Model<2>& model = m.simulation().model();
  const auto places = read_places(keys, model, bodies);
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "load");
  std::vector<PointLoad<2>> loads;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    spec.at = places[i];
    for (PointLoad<2>& load : make_point_load(model, bodies[i], spec)) loads.push_back(std::move(load));
  }
  m.change([loads](Model<2>& changed) {
    changed.point_loads.insert(changed.point_loads.end(), loads.begin(), loads.end());
  });
  return push_load_name(L, spec.name);
}

const std::array load_method_list{
    Method{
        "point_load", guarded<point_load>,
        "point_load{body=, force={x, y}, moment=, at=, follow=, course=, name=}: a force from now on; gives its name"},
};

}  // namespace

std::span<const Method> load_methods() {
  return load_method_list;
}

}  // namespace trilith::script
