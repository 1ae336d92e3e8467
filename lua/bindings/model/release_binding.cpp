// Changes of loads, pushes and supports: directions are fixed and freed, a load's share changes, and any of them is
// released without an impact.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/loads/load_reading.hpp"
#include "edit/release.hpp"
#include "model/loads.hpp"
#include "model/pushes.hpp"

namespace trilith::script {
namespace {

void require_load(ScriptModel& m, const std::string& name, const char* owner) {
  const std::vector<std::string> names = names_of_loads(m);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("{}: there is no load '{}'{}", owner, name, name_hint(name, names)));
}

/// Water has a level and no share.
void refuse_water(ScriptModel& m, const std::string& name, const char* owner) {
  const auto has = [&](const auto& model) {
    bool found = false;
    model.loads.for_each([&]<class L>(const L& load) { found = found || (has_level<L> && load.name == name); });
    return found;
  };
  SpaceModel* space = as_space(m);
  if (space != nullptr ? has(space->simulation().model()) : has(as_plane(m)->simulation().model()))
    throw InputError(fmt::format(
        "{}: '{}' is water, which has a level and no share; use m:set_level, or m:remove(\"{}\")", owner, name, name));
}

/// Names of the pushes alone.
std::vector<std::string> names_of_pushes(ScriptModel& m) {
  const auto of = [](const auto& model) {
    std::vector<std::string> names;
    for (const auto& push : model.pushes) names.push_back(push.name);
    return names;
  };
  if (SpaceModel* space = as_space(m)) return of(space->simulation().model());
  return of(as_plane(m)->simulation().model());
}

void require_push(ScriptModel& m, const std::string& name) {
  const std::vector<std::string> names = names_of_pushes(m);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("release: there is no push '{}'{}", name, name_hint(name, names)));
}

double read_span(Keys& keys, const char* key, double preset) {
  const double span = keys.number(key, "s", preset);
  if (!(span >= 0 && std::isfinite(span))) keys.problem(fmt::format("'{}' is {:g} s, must not be below 0", key, span));
  return span;
}

/// Applies a change at the step border.
void change_share(ScriptModel& m, const std::string& name, double share, double duration) {
  const auto change = [name, share, duration, box = &m](auto& model) {
    change_loads(model, name, box->time(), share, duration);
  };
  if (SpaceModel* space = as_space(m))
    space->change(change);
  else
    as_plane(m)->change(change);
}

/// m:set_load{ name =, factor =, duration = }: its new share, reached smoothly.
int set_load(lua_State* L) {
  ScriptModel& m = this_model(L);
  Keys keys(L, 2, "set_load");
  const std::string name = keys.text("name");
  const double share = keys.number("factor", "1"), duration = read_span(keys, "duration", 0);
  keys.finish();
  require_load(m, name, "set_load");
  refuse_water(m, name, "set_load");
  change_share(m, name, share, duration);
  return 0;
}

/// Directions of a body's supports that x, y, z and rotation free; all if none is given. In space `rotation` means
/// every rotation.
template <int D>
std::array<bool, Space<D>::dofs> read_directions(Keys& keys) {
  std::array<bool, Space<D>::dofs> on{};
  on[0] = keys.flag("x", false), on[1] = keys.flag("y", false);
  if constexpr (D == 3) on[2] = keys.flag("z", false);
  std::fill(on.begin() + D, on.end(), keys.flag("rotation", false));
  if (std::find(on.begin(), on.end(), true) == on.end()) on.fill(true);
  return on;
}

template <std::size_t dofs>
std::string directions_text(const std::array<bool, dofs>& on) {
  constexpr std::array names{"x", "y", "z"};
  constexpr std::size_t along = dofs == 3 ? 2 : 3;
  std::string text;
  for (std::size_t k = 0; k < along; ++k)
    if (on[k]) text += fmt::format("{}{}", text.empty() ? "" : ", ", names[k]);
  if (on[along]) text += fmt::format("{}rotation", text.empty() ? "" : ", ");
  return text;
}

/// `place`: place in the script, for a message at the step border, where only the line of the run is known.
template <int D>
[[noreturn]] void refuse_free(const Model<D>& model, const std::vector<int>& bodies,
                              const std::array<bool, Space<D>::dofs>& on, const std::string& owner,
                              const std::string& place) {
  const std::string which = bodies.size() == 1 ? fmt::format("body '{}' is", model.bodies[bodies.front()].name)
                                               : fmt::format("the {} bodies are", bodies.size());
  throw InputError(fmt::format("{}: {}{} free already in {}, so there is nothing to release", owner, place, which,
                               directions_text(on)));
}

template <int D>
void release_bodies(SimulatedModel<D>& m, const std::vector<int>& bodies, const std::array<bool, Space<D>::dofs>& on,
                    double fade, const std::string& place) {
  const bool waits = m.running() && !m.paused();
  m.change_supports([bodies, on, fade, box = &m, place = waits ? place : ""](Model<D>& model) {
    int freed = 0;
    for (const int body : bodies) freed += release_supports(model, box->if_built()->state(), body, on, fade);
    if (freed > 0) {
      box->simulation().drop_step();
      return;
    }
    refuse_free(model, bodies, on, "release", place);
  });
}

template <int D>
void release_pushed(SimulatedModel<D>& m, const std::string& push, double fade) {
  m.evaluated();
  m.change([push, fade, box = &m](Model<D>& model) {
    const Simulation<D>& s = *box->if_built();
    release_push(model, s.state(), s.work(), push, fade);
  });
}

/// m:release{ body =, x =, y =, rotation =, fade = } or { load =, fade = } or { push =, fade = }; z too in space.
template <int D>
int release_of(lua_State* L, SimulatedModel<D>& m) {
  Keys keys(L, 2, "release");
  const bool of_load = keys.has("load"), of_push = keys.has("push"), of_body = keys.has("body");
  const std::string load = keys.text("load", ""), push = keys.text("push", "");
  const double fade = read_span(keys, "fade", 1);
  const auto on = read_directions<D>(keys);
  if (static_cast<int>(of_load) + static_cast<int>(of_push) + static_cast<int>(of_body) != 1)
    keys.problem("give one of body, load (its name) and push (its name)");
  const std::vector<int> bodies = of_body ? read_loaded_bodies(keys, m) : std::vector<int>{};
  keys.know({"body"});
  keys.finish();
  m.simulation();
  if (of_load) {
    require_load(m, load, "release");
    refuse_water(m, load, "release");
    change_share(m, load, 0, fade);
  } else if (of_push) {
    require_push(m, push);
    release_pushed(m, push, fade);
  } else {
    release_bodies(m, bodies, on, fade, user_place(L));
  }
  return 0;
}

int release(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return release_of<3>(L, *space);
  return release_of<2>(L, this_plane(L));
}

/// Degrees of freedom in a text such as "xy"; all if it is not given. In the plane x, y and r, in space x, y, z and r,
/// which means every rotation.
std::array<bool, 6> directions_at(lua_State* L, int index, const char* owner, int dim) {
  std::array<bool, 6> on{};
  if (lua_isnoneornil(L, index)) {
    on.fill(true);
    return on;
  }
  const std::string_view letters = dim == 2 ? "xyr" : "xyzr";
  const std::string text = lua_type(L, index) == LUA_TSTRING ? text_at(L, index) : "?";
  for (const char c : text) {
    const std::size_t k = letters.find(c);
    if (k != std::string_view::npos)
      std::fill(on.begin() + static_cast<std::ptrdiff_t>(k), c == 'r' ? on.end() : on.begin() + k + 1, true);
    else if (c != ' ' && c != ',')
      throw InputError(fmt::format("{}: directions are {}, must be a text of {}, as in \"xy\"", owner,
                                   what_is(L, index), dim == 2 ? "x, y and r" : "x, y, z and r"));
  }
  if (std::none_of(on.begin(), on.end(), [](bool k) { return k; }))
    throw InputError(
        fmt::format("{}: directions are {}, which names no direction; give some of {}, as in \"xy\", or leave "
                    "them out for all",
                    owner, what_is(L, index), dim == 2 ? "x, y and r" : "x, y, z and r"));
  return on;
}

/// True if any node of a body is fixed or driven along one of these directions; elements have no rotations.
template <int D>
bool is_held_in(const Model<D>& model, int body, const std::array<bool, Space<D>::dofs>& on) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const std::size_t directions = b.nodes_turn() ? on.size() : D;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    for (std::size_t k = 0; k < directions; ++k)
      if (on[k] && model.support[static_cast<std::size_t>(n)][k] != Support::free) return true;
  return false;
}

/// `place`: as in refuse_free. A body that is completely free already is rejected, because a name or a direction is
/// wrong then.
template <int D>
void change_supports(SimulatedModel<D>& m, const std::vector<int>& bodies, const std::array<bool, 6>& asked,
                     Support support, const std::string& place) {
  std::array<bool, Space<D>::dofs> on{};
  std::copy_n(asked.begin(), on.size(), on.begin());
  m.change_supports([bodies, on, support, place = m.running() && !m.paused() ? place : ""](Model<D>& model) {
    const auto is_held = [&](int body) { return is_held_in(model, body, on); };
    if (support == Support::free && std::none_of(bodies.begin(), bodies.end(), is_held))
      refuse_free(model, bodies, on, "free", place);
    for (const int body : bodies)
      for (int k = 0; k < Space<D>::dofs; ++k)
        if (on[static_cast<std::size_t>(k)]) set_support(model, body, k, support);
  });
}

/// Nodes of elements do not rotate, so fixing or freeing only rotations has no effect.
template <int D>
void refuse_turns_of_elements(SimulatedModel<D>& m, const std::vector<int>& bodies, const std::array<bool, 6>& on,
                              const std::string& owner) {
  const bool turn = std::any_of(on.begin() + D, on.begin() + Space<D>::dofs, [](bool k) { return k; });
  const bool place = std::all_of(on.begin(), on.begin() + D, [](bool k) { return k; });
  if (!turn || place) return;
  const Model<D>& model = m.simulation().model();
  for (const int body : bodies) {
    if (body >= static_cast<int>(model.bodies.size()) || model.bodies[static_cast<std::size_t>(body)].nodes_turn())
      continue;
    const bool fixes = owner == "fix";
    throw InputError(fmt::format("{}: body '{}' is made of elements, whose nodes have no rotation to {}; {} {}{}",
                                 owner, model.bodies[static_cast<std::size_t>(body)].name, fixes ? "hold" : "free",
                                 owner, D == 2 ? "x and y" : "x, y and z", fixes ? ", or hold some of its nodes" : ""));
  }
}

int set_supports(lua_State* L, const char* owner, Support support) {
  ScriptModel& m = this_model(L);
  const std::vector<int> bodies = some_bodies_at(L, 2, m, owner);
  const std::array<bool, 6> on = directions_at(L, 3, owner, m.dim());
  const auto change = [&](auto& model) {
    refuse_turns_of_elements(model, bodies, on, owner);
    change_supports(model, bodies, on, support, user_place(L));
  };
  if (SpaceModel* space = as_space(m))
    change(*space);
  else
    change(require_plane(m, owner));
  return 0;
}
int fix(lua_State* L) {
  return set_supports(L, "fix", Support::fixed);
}
int free_bodies(lua_State* L) {
  return set_supports(L, "free", Support::free);
}

const std::array release_method_list{
    Method{"fix", guarded<fix>},
    Method{"free", guarded<free_bodies>},
    Method{"set_load", guarded<set_load>},
    Method{"release", guarded<release>},
};

}  // namespace

std::span<const Method> release_methods() {
  return release_method_list;
}

}  // namespace trilith::script
