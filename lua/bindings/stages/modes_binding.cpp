// Natural frequencies and mode shapes of a model in its present state.
#include "integrate/explicit/stable_step.hpp"
#include "modal/mode_damping.hpp"

#include <algorithm>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "run/record/recorded_modes.hpp"

namespace trilith::script {
namespace {

constexpr std::array axis_names{"x", "y", "z"};

/// Applies `of` to a model in the plane or in space.
template <class Of>
int of_either(ScriptModel& m, Of&& of) {
  if (PlaneModel* plane = as_plane(m)) return of(*plane);
  return of(*as_space(m));
}

/// "   1          15.036       0.0665        83.10         0.00       2.13"
template <int D>
std::string modes_text(const std::vector<NaturalMode<D>>& found, const std::vector<ModeDamping>& damping,
                       const std::array<double, D>& all) {
  std::string text = "mode   frequency [Hz]   period [s]";
  for (std::size_t k = 0; k < all.size(); ++k) text += fmt::format("   mass {} [%]", axis_names[k]);
  text += "   damping [%]";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const NaturalMode<D>& mode = found[i];
    const double f = mode.frequency();
    text += fmt::format("\n{:4}   {:14.5g}   {:10}", i + 1, f, f > 0 ? fmt::format("{:.5g}", 1 / f) : "-");
    for (std::size_t k = 0; k < all.size(); ++k)
      text += fmt::format("   {:10.2f}", all[k] > 0 ? 100 * mode.mass[k] / all[k] : 0);
    text += fmt::format("   {:11.3g}", 100 * damping[i].total());
    if (mode.square < 0) text += "   unstable";
  }
  return text;
}

void set_turn(lua_State* L, double turn) {
  set_number(L, "rotation", turn);
}
void set_turn(lua_State* L, const Vec3& turn) {
  set_number(L, "rotation_x", turn.x());
  set_number(L, "rotation_y", turn.y());
  set_number(L, "rotation_z", turn.z());
}

/// Pushes { name = {x =, y =, rotation =} }, in space { x =, y =, z =, rotation_x =, rotation_y =, rotation_z = } by
/// body, scaled to a largest nodal displacement of 1.
template <int D>
void push_shape(lua_State* L, const Model<D>& model, const NaturalMode<D>& mode) {
  double most = 0;
  for (const auto& v : mode.displacement) most = std::max(most, v.norm());
  const double scale = most > 0 ? 1 / most : 1;
  lua_createtable(L, 0, static_cast<int>(model.bodies.size()));
  for (const Body& body : model.bodies) {
    Vec<D> mean = Vec<D>::Zero();
    Spin<D> turn = nothing<Spin<D>>();
    double mass = 0;
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      mean += model.mass[n] * mode.displacement[n], turn += model.mass[n] * mode.rotation[n];
      mass += model.mass[n];
    }
    lua_createtable(L, 0, Space<D>::dofs);
    for (int k = 0; k < D; ++k) set_number(L, axis_names[static_cast<std::size_t>(k)], scale * mean[k] / mass);
    set_turn(L, Spin<D>(scale * turn / mass));
    lua_setfield(L, -2, body.name.c_str());
  }
}

/// { count = }, or nothing.
int read_count(lua_State* L, const char* owner) {
  lua_settop(L, 2);
  if (lua_isnil(L, 2)) {
    lua_newtable(L);
    lua_replace(L, 2);
  }
  Keys keys(L, 2, owner);
  const int count = keys.count("count", 10);
  keys.finish();
  return count;
}

/// Reason for which some modes do not vibrate.
template <int D>
std::string unsteady_text(const SimulatedModel<D>& m, const std::vector<NaturalMode<D>>& found) {
  const auto still = std::count_if(found.begin(), found.end(), [](const auto& mode) { return !(mode.square > 0); });
  if (still == 0) return "";
  const std::string which =
      still == 1 ? "one mode does not oscillate" : fmt::format("{} modes do not oscillate", still);
  if (m.time() == 0)
    return fmt::format(
        "\n{}: no contact carries weight yet, so bodies can separate, slide and rotate freely; bring the model to rest "
        "first, m:consolidate()",
        which);
  return fmt::format("\n{}: a body is free to move in the present state (in the air, on an edge, or sliding)", which);
}

/// Pushes the result of m:modes; `records`: write it to the results file.
template <int D>
int push_modes(lua_State* L, SimulatedModel<D>& m, int count, bool records) {
  const Simulation<D>& sim = m.evaluated();
  const std::vector<NaturalMode<D>> found = modes(sim.model(), sim.state(), count);
  const std::vector<ModeDamping> damping = mode_damping(sim.model(), sim.state(), found);
  const std::array<double, D> all = free_mass(sim.model(), sim.state());
  if (records) m.record_modes(recorded_modes(sim.state(), found, damping), host(L));
  lua_createtable(L, static_cast<int>(found.size()), 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const NaturalMode<D>& mode = found[i];
    lua_createtable(L, 0, 5 + 2 * D);
    set_number(L, "frequency", mode.frequency());
    if (mode.square > 0) set_number(L, "period", 1 / mode.frequency());
    set_number(L, "square", mode.square);
    for (std::size_t k = 0; k < all.size(); ++k) {
      set_number(L, fmt::format("mass_{}", axis_names[k]).c_str(), mode.mass[k]);
      set_number(L, fmt::format("factor_{}", axis_names[k]).c_str(), mode.factor[k]);
    }
    set_number(L, "damping", damping[i].total());
    push_shape(L, sim.model(), mode);
    lua_setfield(L, -2, "shape");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  set_text(L, "text", modes_text<D>(found, damping, all) + unsteady_text(m, found));
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

/// m:modes{ count = }: a list, lowest first.
int find_modes(lua_State* L) {
  ScriptModel& m = this_model(L);
  const int count = read_count(L, "modes");
  return of_either(m, [&](auto& model) { return push_modes(L, model, count, true); });
}

/// core.quiet_modes(model, count): as m:modes, without a file.
int quiet_modes(lua_State* L) {
  const int count = static_cast<int>(lua_tointeger(L, 2));
  return of_either(this_model(L), [&](auto& model) { return push_modes(L, model, count, false); });
}

/// The longest stable step without band damping [s].
template <int D>
double unbanded_length(const Simulation<D>& sim) {
  return unbanded_step(sim.model(), sim.state(), sim.work()).dt;
}

template <int D>
std::string damping_text(const Simulation<D>& sim, const std::vector<NaturalMode<D>>& found,
                         const std::vector<ModeDamping>& damping) {
  std::string text = "frequency [Hz]   damping [%]   contacts   bearings   elements      bands       mass";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ModeDamping& d = damping[i];
    text +=
        fmt::format("\n{:14.5g}   {:11.3g}   {:8.3g}   {:8.3g}   {:8.3g}   {:8.3g}   {:8.3g}", found[i].frequency(),
                    100 * d.total(), 100 * d.contacts, 100 * d.bearings, 100 * d.elements, 100 * d.bands, 100 * d.mass);
  }
  const double step = stable_step(sim.model(), sim.state(), sim.work()).dt;
  text += fmt::format("\nlongest stable step {:.4g} s", step);
  for (const DampingBranches& b : sim.model().bands)
    text += fmt::format("\nband of {:g} % from {:g} to {:g} Hz: {} branches, stiffer by up to {:.2g} %",
                        100 * b.band.ratio, b.band.from, b.band.to, b.count, 100 * (b.stiffening() - 1));
  if (const double unbanded = unbanded_length(sim); !sim.model().bands.empty())
    text += fmt::format("; without bands the longest stable step is {:.4g} s", unbanded);
  return text;
}

/// m:damping{ count = }: damping ratios by frequency, and their sources.
template <int D>
int push_damping(lua_State* L, SimulatedModel<D>& m, int count) {
  const Simulation<D>& sim = m.evaluated();
  const std::vector<NaturalMode<D>> found = modes(sim.model(), sim.state(), count);
  const std::vector<ModeDamping> damping = mode_damping(sim.model(), sim.state(), found);
  lua_createtable(L, static_cast<int>(found.size()), 3);
  for (std::size_t i = 0; i < found.size(); ++i) {
    lua_createtable(L, 0, 7);
    set_number(L, "frequency", found[i].frequency());
    set_number(L, "ratio", damping[i].total());
    set_number(L, "contacts", damping[i].contacts);
    set_number(L, "bearings", damping[i].bearings);
    set_number(L, "elements", damping[i].elements);
    set_number(L, "bands", damping[i].bands);
    set_number(L, "mass", damping[i].mass);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  set_text(L, "text", damping_text(sim, found, damping));
  set_number(L, "step", stable_step(sim.model(), sim.state(), sim.work()).dt);
  set_number(L, "unbanded_step", unbanded_length(sim));
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

int find_damping(lua_State* L) {
  ScriptModel& m = this_model(L);
  const int count = read_count(L, "damping");
  return of_either(m, [&](auto& model) { return push_damping(L, model, count); });
}

const std::array modes_method_list{
    Method{"damping", guarded<find_damping>},
    Method{"modes", guarded<find_modes>},
};

}  // namespace

void open_modes(lua_State* L) {
  set_function(L, "quiet_modes", guarded<quiet_modes>);
}

std::span<const Method> modes_methods() {
  return modes_method_list;
}

}  // namespace trilith::script
