// Natural frequencies and shapes of a model as it stands.
#include "step/mode_damping.hpp"
#include "step/stable_step.hpp"

#include <algorithm>

#include "bindings.hpp"
#include "run/recorded_modes.hpp"
#include "table_fields.hpp"

namespace trilith::script {
namespace {

/// "   1          15.036       0.0665        83.10         0.00       2.13"
std::string modes_text(const std::vector<Mode>& found, const std::vector<ModeDamping>& damping,
                       const std::array<double, 2>& all) {
  std::string text = "mode   frequency [Hz]   period [s]   mass x [%]   mass y [%]   damping [%]";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mode& mode = found[i];
    const double f = mode.frequency();
    const auto share = [&](int k) { return all[k] > 0 ? 100 * mode.mass[k] / all[k] : 0; };
    text += fmt::format("\n{:4}   {:14.5g}   {:10}   {:10.2f}   {:10.2f}   {:11.3g}", i + 1, f,
                        f > 0 ? fmt::format("{:.5g}", 1 / f) : "-", share(0), share(1), 100 * damping[i].total());
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

/// Why modes do not swing, where some do not.
std::string unsteady_text(const PlaneModel& m, const std::vector<Mode>& found) {
  const auto still = std::count_if(found.begin(), found.end(), [](const Mode& mode) { return !(mode.square > 0); });
  if (still == 0) return "";
  const std::string which = still == 1 ? "one mode does not swing" : fmt::format("{} modes do not swing", still);
  if (m.time() == 0)
    return fmt::format(
        "\n{}: nothing presses yet that is held by its weight alone, so that it can part, slide and turn freely; let "
        "it "
        "come to rest first, m:consolidate()",
        which);
  return fmt::format("\n{}: something is free to move as it stands (in the air, on an edge, or sliding)", which);
}

/// Pushes what m:modes gives; `records`: it goes to the results file.
int push_modes(lua_State* L, PlaneModel& m, int count, bool records) {
  const Simulation<2>& sim = m.evaluated();
  const std::vector<Mode> found = modes(sim.model(), sim.state(), count);
  const std::vector<ModeDamping> damping = mode_damping(sim.model(), sim.state(), found);
  const std::array<double, 2> all = free_mass(sim.model(), sim.state());
  if (records) m.record_modes(recorded_modes(sim.state(), found, damping), host(L));
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
    set_number(L, "damping", damping[i].total());
    push_shape(L, sim.model(), mode);
    lua_setfield(L, -2, "shape");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  set_text(L, "text", modes_text(found, damping, all) + unsteady_text(m, found));
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

/// m:modes{ count = }: a list, lowest first.
int find_modes(lua_State* L) {
  PlaneModel& m = this_plane(L);
  return push_modes(L, m, read_count(L, "modes"), true);
}

/// core.quiet_modes(model, count): the same, for no file.
int quiet_modes(lua_State* L) {
  return push_modes(L, this_plane(L), static_cast<int>(lua_tointeger(L, 2)), false);
}

std::string damping_text(const Simulation<2>& sim, const std::vector<Mode>& found,
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
  if (!sim.model().bands.empty())
    text += fmt::format("; without bands the longest stable step is {:.4g} s",
                        unbanded_step(sim.model(), sim.state(), sim.work()).dt);
  return text;
}

/// m:damping{ count = }: ratios to critical damping by frequency, and what gives them.
int find_damping(lua_State* L) {
  PlaneModel& m = this_plane(L);
  const int count = read_count(L, "damping");
  const Simulation<2>& sim = m.evaluated();
  const std::vector<Mode> found = modes(sim.model(), sim.state(), count);
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
  set_number(L, "unbanded_step", unbanded_step(sim.model(), sim.state(), sim.work()).dt);
  luaL_setmetatable(L, "trilith.findings");
  return 1;
}

const std::array modes_method_list{
    Method{"damping", guarded<find_damping>, "damping{count=}: ratios to critical damping by frequency, and from what",
           2},
    Method{"modes", guarded<find_modes>, "modes{count=}: natural frequencies and shapes as it stands", 2},
};

}  // namespace

void open_modes(lua_State* L) {
  set_function(L, "quiet_modes", guarded<quiet_modes>);
}

std::span<const Method> modes_methods() {
  return modes_method_list;
}

}  // namespace trilith::script
