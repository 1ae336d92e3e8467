// Loads at points of bodies, in the plane and in space.
#include <algorithm>
#include <array>

#include "bindings/core/bindings.hpp"
#include "bindings/loads/load_reading.hpp"
#include "model/loads.hpp"

namespace trilith::script {
namespace {

/// `at`: a point, or the name of a place or of a joint. Returns the points, one for each body; none for the whole body.
template <class M, class Point>
auto read_places(Keys& keys, M& m, const std::vector<int>& bodies, const char* wanted, Point&& point_of) {
  lua_State* L = keys.lua();
  const int type = keys.push("at");
  const std::string name = type == LUA_TSTRING ? text_at(L, -1) : "";
  const auto point = type == LUA_TTABLE ? point_of(L, -1) : decltype(point_of(L, -1))();
  if (type != LUA_TNIL && type != LUA_TSTRING && !point) keys.wrong("at", wanted);
  lua_pop(L, 1);
  if (point && bodies.size() > 1) keys.problem("'at' is a point of one body; several are given: name a place instead");
  std::vector<std::remove_const_t<decltype(point)>> places(bodies.size(), point);
  for (std::size_t i = 0; i < bodies.size() && type == LUA_TSTRING; ++i)
    places[i] = named_place(m, bodies[i], name, keys.owner());
  return places;
}

/// A load on a fixed body is reported once: the body may be freed later.
template <int D>
void tell_held(lua_State* L, SimulatedModel<D>& m, const std::vector<int>& bodies, const std::string& name) {
  const Model<D>& model = m.simulation().model();
  const auto is_held = [&](int body) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
      for (const Support s : model.support[static_cast<std::size_t>(n)])
        if (s == Support::free) return false;
    return true;
  };
  const auto held = std::find_if(bodies.begin(), bodies.end(), is_held);
  if (held != bodies.end())
    tell_note(L, m,
              fmt::format("load '{}': body '{}' is held or driven in all directions, so the load has no effect before "
                          "one of them is free",
                          name, model.bodies[static_cast<std::size_t>(*held)].name));
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
  spec.follows = keys.flag("follow", false);
  spec.curve = read_load_curve(keys, m.time());
  keys.know({"at"});
  keys.finish();
  const auto places = read_places(keys, m, bodies, "{x, y, z}, \"centroid\" or the name of a joint", vector_at);
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "load");
  std::vector<PointLoad<3>> loads;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    spec.at = places[i];
    for (PointLoad<3>& load : make_solid_loads(m.simulation().model(), bodies[i], spec))
      loads.push_back(std::move(load));
  }
  tell_held(L, m, bodies, spec.name);
  m.change([loads](Model<3>& changed) { changed.loads.add(loads); });
  return push_load_name(L, spec.name);
}

/// m:point_load{ body =, force =, moment =, at =, follow =, load_curve =, name = }: returns its name.
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
  const auto places = read_places(keys, m, bodies, "{x, y} or the name of a place or a joint", point_at);
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "load");
  std::vector<PointLoad<2>> loads;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    spec.at = places[i];
    for (PointLoad<2>& load : make_point_load(model, bodies[i], spec)) loads.push_back(std::move(load));
  }
  tell_held(L, m, bodies, spec.name);
  m.change([loads](Model<2>& changed) { changed.loads.add(loads); });
  return push_load_name(L, spec.name);
}

const std::array load_method_list{
    Method{"point_load", guarded<point_load>},
};

}  // namespace

std::span<const Method> load_methods() {
  return load_method_list;
}

}  // namespace trilith::script
