#include "bindings/laws/section_curves.hpp"

#include <algorithm>
#include <cmath>

#include "base/quantity_text.hpp"
#include "bindings/core/table_fields.hpp"
#include "draw/chart/chart.hpp"
#include "element/section/section_analysis.hpp"

namespace trilith::script {
namespace {

constexpr int usual_steps = 200, usual_forces = 31;

/// The fibres of the section in argument 1.
FibreSection fibres_of(lua_State* L, const char* call) {
  const auto& section = handle<SectionValue>(L, 1);
  if (section.fibres) return make_fibres(*section.fibres);
  throw InputError(
      fmt::format("section:{}: {} has no fibres and so no strength; give it laws by "
                  "trilith.fibre_section{{ shape = trilith.rectangle_section{{...}}, law = ... }}",
                  call, section.text));
}

SectionLimits read_limits(Keys& keys) {
  SectionLimits limits;
  limits.compression = keys.number("compression", "1", limits.compression);
  limits.tension = keys.number("tension", "1", limits.tension);
  for (const auto& [name, value] : {std::pair("compression", limits.compression), {"tension", limits.tension}})
    if (!(value > 0 && value <= 1))
      keys.problem(fmt::format("'{}' is {:g}, must be a strain above 0 and at most 1, such as 0.0035", name, value));
  return limits;
}

/// The force under `key`, or a list of forces [N]; 0 if it is missing.
std::vector<double> read_forces(Keys& keys, const char* key) {
  lua_State* L = keys.lua();
  std::vector<double> forces;
  const int type = keys.push(key);
  if (type == LUA_TNUMBER) forces.push_back(lua_tonumber(L, -1));
  if (type == LUA_TTABLE)
    for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, -1)); ++i) {
      if (lua_rawgeti(L, -1, i) == LUA_TNUMBER) forces.push_back(lua_tonumber(L, -1));
      lua_pop(L, 1);
    }
  const auto given = type == LUA_TTABLE ? static_cast<std::size_t>(lua_rawlen(L, -1)) : forces.size();
  lua_pop(L, 1);
  if (type == LUA_TNIL) return {0};
  const bool finite = std::ranges::all_of(forces, [](double f) { return std::isfinite(f); });
  if (forces.empty() || forces.size() != given || !finite)
    keys.wrong(key, "a normal force in N, tension above 0, or a list of them such as { 0, -500e3 }");
  return forces;
}

int read_steps(Keys& keys, int preset, int least) {
  const int steps = keys.count("points", preset);
  if (steps < least || steps > 10000)
    keys.problem(fmt::format("'points' is {}, must be from {} to 10000", steps, least));
  return std::clamp(steps, least, 10000);
}

/// Curvature under `curvature`, or the longest one within the limits.
double read_curvature(Keys& keys, const FibreSection& section, const SectionLimits& limits) {
  const std::optional<double> given = keys.maybe_number("curvature", "1/m");
  if (given && (*given == 0 || !std::isfinite(*given)))
    keys.problem("'curvature' is 0, must be the largest curvature in 1/m; below 0 the top is in tension");
  return given.value_or(longest_curvature(section, limits));
}

template <class Row, class Value>
void set_list(lua_State* L, const char* key, const std::vector<Row>& rows, const Value& value) {
  lua_createtable(L, static_cast<int>(rows.size()), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lua_pushnumber(L, value(rows[i]));
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(L, -2, key);
}

MomentCurvature checked_curve(const FibreSection& section, double normal, double curvature, int steps,
                              const SectionLimits& limits, const char* call) {
  MomentCurvature curve = moment_curvature(section, normal, curvature, steps, limits);
  if (curve.points.empty())
    throw InputError(
        fmt::format("section:{}: the section does not carry a normal force of {} within strains of {:g} "
                    "in compression and {:g} in tension; section:interaction() gives the range",
                    call, quantity_text(normal, "N"), limits.compression, limits.tension));
  return curve;
}

/// section:moment_curvature{ normal =, curvature =, points =, compression =, tension = }
int push_moment_curvature(lua_State* L) {
  const FibreSection section = fibres_of(L, "moment_curvature");
  Keys keys(L, 2, "section:moment_curvature");
  const SectionLimits limits = read_limits(keys);
  const double normal = keys.number("normal", "N", 0), curvature = read_curvature(keys, section, limits);
  const int steps = read_steps(keys, usual_steps, 2);
  keys.finish();
  const MomentCurvature curve = checked_curve(section, normal, curvature, steps, limits, "moment_curvature");
  lua_newtable(L);
  set_list(L, "curvature", curve.points, [](const SectionPoint& p) { return p.curvature; });
  set_list(L, "moment", curve.points, [](const SectionPoint& p) { return p.moment; });
  set_list(L, "axial", curve.points, [](const SectionPoint& p) { return p.axial; });
  if (curve.yield) {
    set_number(L, "yield_curvature", curve.yield->curvature);
    set_number(L, "yield_moment", curve.yield->moment);
  }
  set_number(L, "peak_moment", curve.largest->moment);
  set_number(L, "peak_curvature", curve.largest->curvature);
  set_text(L, "limit", curve.end);
  return 1;
}

/// section:interaction{ points =, compression =, tension = }
int push_interaction(lua_State* L) {
  const FibreSection section = fibres_of(L, "interaction");
  Keys keys(L, 2, "section:interaction");
  const SectionLimits limits = read_limits(keys);
  const int points = read_steps(keys, usual_forces, 3);
  keys.finish();
  const std::vector<InteractionPoint> curve = interaction(section, points, limits);
  lua_newtable(L);
  set_list(L, "normal", curve, [](const InteractionPoint& p) { return p.normal; });
  set_list(L, "sagging", curve, [](const InteractionPoint& p) { return p.sagging; });
  set_list(L, "hogging", curve, [](const InteractionPoint& p) { return p.hogging; });
  return 1;
}

draw::Chart curve_chart(const FibreSection& section, const std::vector<double>& forces, double curvature, int steps,
                        const SectionLimits& limits, const UnitSystem& units) {
  draw::Chart chart;
  chart.x = {"curvature", "1/m"};
  draw::ChartPanel panel{{"moment", "N*m"}, {}};
  draw::ChartSeries yield{"first yield", {}, {}};
  yield.points = true, yield.joined = false;
  for (const double normal : forces) {
    const MomentCurvature curve = checked_curve(section, normal, curvature, steps, limits, "plot");
    draw::ChartSeries line{"N = " + quantity_text(normal, "N", units), {}, {}};
    for (const SectionPoint& p : curve.points) line.x.push_back(p.curvature), line.y.push_back(p.moment);
    panel.series.push_back(std::move(line));
    if (curve.yield) yield.x.push_back(curve.yield->curvature), yield.y.push_back(curve.yield->moment);
  }
  if (!yield.x.empty()) panel.series.push_back(std::move(yield));
  chart.panels = {std::move(panel)};
  return chart;
}

draw::Chart interaction_chart(const FibreSection& section, int points, const SectionLimits& limits) {
  draw::Chart chart;
  chart.x = {"moment", "N*m"};
  draw::ChartSeries line{"", {}, {}};
  const std::vector<InteractionPoint> curve = interaction(section, points, limits);
  for (const InteractionPoint& p : curve) line.x.push_back(p.sagging), line.y.push_back(p.normal);
  for (auto p = curve.rbegin(); p != curve.rend(); ++p) line.x.push_back(p->hogging), line.y.push_back(p->normal);
  line.x.push_back(line.x.front()), line.y.push_back(line.y.front());
  chart.panels = {{{"normal force, tension above 0", "N"}, {std::move(line)}}};
  return chart;
}

/// section:plot{ file =, of =, normal =, curvature =, points =, compression =, tension = }
int plot_section(lua_State* L) {
  const FibreSection section = fibres_of(L, "plot");
  Keys keys(L, 2, "section:plot");
  const std::string file = keys.text("file");
  const bool curves = keys.choice("of", {"moment_curvature", "interaction"}, 0) == 0;
  const SectionLimits limits = read_limits(keys);
  if (!curves)
    for (const char* key : {"normal", "curvature"})
      keys.refuse(key, fmt::format("'{}' is for of = \"moment_curvature\"; the interaction covers all forces", key));
  const std::vector<double> forces = curves ? read_forces(keys, "normal") : std::vector<double>{};
  const double curvature = curves ? read_curvature(keys, section, limits) : 0;
  const int points = read_steps(keys, curves ? usual_steps : usual_forces, 3);
  keys.finish();
  draw::picture_format(file);
  draw::Chart chart = curves ? curve_chart(section, forces, curvature, points, limits, host(L).units)
                             : interaction_chart(section, points, limits);
  chart.units = host(L).units;
  chart.title = chart.units.message(handle<SectionValue>(L, 1).text);
  const std::filesystem::path path = host(L).room.writable(file, "section:plot");
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  draw::draw_chart(chart, path);
  return 0;
}

const std::array section_curve_methods{Method{"interaction", guarded<push_interaction>},
                                       Method{"moment_curvature", guarded<push_moment_curvature>},
                                       Method{"plot", guarded<plot_section>}};

}  // namespace

std::span<const Method> section_methods() {
  return section_curve_methods;
}

}  // namespace trilith::script
