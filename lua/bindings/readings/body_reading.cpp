#include "bindings/readings/body_reading.hpp"

#include <algorithm>

#include "bindings/geometry/part_reading.hpp"
#include "bindings/readings/crack_reading.hpp"

namespace trilith::script {
namespace {

/// Densest element (osmium) [kg/m3], rounded up; 150 lbf/ft3 mistaken for a density would be 23563.
constexpr double largest_density = 23000;

Support support_at(Keys& keys, std::string_view key, const std::string& text) {
  if (text != "fixed" && text != "free")
    keys.problem(fmt::format("'{}' is '{}', must be \"fixed\" or \"free\"", key, text));
  return text == "fixed" ? Support::fixed : Support::free;
}

/// hold = { { from = {x, y}, to = {x, y}, x = "fixed", y = "fixed" }, ... }: nodes of a deformable body in a box.
void read_holds(Keys& keys, std::vector<NodeSupport>& holds) {
  read_list(keys, "hold", "hold", [&](Keys& own) {
    NodeSupport hold;
    hold.low = own.point("from"), hold.high = own.point("to");
    hold.support = {support_at(own, "x", own.text("x", "fixed")), support_at(own, "y", own.text("y", "fixed"))};
    holds.push_back(hold);
  });
}

/// Options of a body from `keys`; `preset` for missing ones.
BodySpec read_spec(Keys& keys, const BodySpec& preset) {
  BodySpec s = preset;
  const bool is_frame = preset.kind == BodyKind::frame;  // form, width and inertia of a frame belong to its members
  if (!is_frame) {
    const BodyForm form = read_body_form(keys, {preset.kind, preset.divisions});
    s.kind = form.kind, s.divisions = form.divisions;
    if (const auto inertia = keys.maybe_number("inertia", "kg m2")) s.inertia = inertia;
    if (const auto thickness = keys.maybe_number("body_thickness", "m")) {
      if (!(*thickness > 0)) keys.problem(fmt::format("'body_thickness' is {:g} m, must be above 0", *thickness));
      s.thickness = thickness;
    }
    read_cracks(keys, s.cracks);
  }
  read_holds(keys, s.supports);
  s.material = keys.text("material", preset.material);
  const std::vector<std::string> groups = keys.names("groups");
  s.groups.insert(s.groups.end(), groups.begin(), groups.end());
  std::optional<double> density = keys.maybe_number("density", "kg/m3");
  if (density) check_density(keys, *density);
  if (const auto weight = keys.maybe_number("unit_weight", "N/m3")) {
    if (density) keys.problem("both density and unit_weight are given; keep one");
    check_unit_weight(keys, *weight);
    density = *weight / standard_gravity;
  }
  const auto mass = keys.maybe_number("mass", "kg"), weight = keys.maybe_number("weight", "N");
  if (density || mass || weight || keys.has("material")) s.density = density, s.mass = mass, s.weight = weight;
  if (keys.has("support")) read_support(keys, "support", s.support);
  s.velocity = keys.point("velocity", preset.velocity);
  s.spin = keys.number("spin", "rad/s", preset.spin);
  s.load = keys.point("load", preset.load);
  s.floating = keys.flag("floating", preset.floating);
  return s;
}

/// Reads the tables under by_group, sorted by name, because a Lua table has no order.
void read_by_group(Keys& keys, BodyOptions& o) {
  lua_State* L = keys.lua();
  const int type = keys.push("by_group");
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("by_group", "a table such as { slabs = { weight = 1e4 } }");
  if (type != LUA_TTABLE) {
    lua_pop(L, 1);
    return;
  }
  for (const std::string& name : names_in_table(keys, "by_group: its keys must be names of groups or parts")) {
    lua_pushlstring(L, name.data(), name.size());
    lua_rawget(L, -2);
    try {
      Keys own(L, -1, fmt::format("by_group: {}", name));
      o.by_group.emplace_back(name, read_spec(own, o.spec));
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Options of this part.
const BodySpec& spec_of(const Part& part, const BodyOptions& options) {
  std::vector<std::string> own{part.name};
  own.insert(own.end(), part.groups.begin(), part.groups.end());
  for (const std::string& name : own)
    for (const auto& [entry, spec] : options.by_group)
      if (entry == name) return spec;
  return options.spec;
}

}  // namespace

void read_support(Keys& keys, std::string_view key, std::array<Support, 3>& support) {
  lua_State* L = keys.lua();
  const int type = keys.push(key);
  if (type == LUA_TSTRING) {
    support.fill(support_at(keys, key, text_at(L, -1)));
  } else if (type == LUA_TTABLE) {
    Keys own(L, -1, std::string(key));
    const std::array names{"x", "y", "rotation"};
    own.refuse("r", "'r' is written in full: rotation = \"fixed\"");
    for (std::size_t i = 0; i < names.size(); ++i) support[i] = support_at(own, names[i], own.text(names[i], "free"));
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong(key, "\"fixed\", \"free\" or { x = , y = , rotation = }");
  }
  lua_pop(L, 1);
}

void check_density(Keys& keys, double density) {
  if (density > largest_density)
    keys.problem(fmt::format(
        "'density' is {:g} kg/m3, more than any metal's; a weight by volume (pcf, kcf, N/m3) is given as unit_weight",
        density));
}

void check_unit_weight(Keys& keys, double weight) {
  if (!(weight > 0) || weight > largest_density * standard_gravity)
    keys.problem(
        fmt::format("'unit_weight' is {:g} N/m3, must be above 0 and not above {:g} N/m3, any metal's; stone "
                    "has some 25000",
                    weight, largest_density * standard_gravity));
}

BodyForm read_body_form(Keys& keys, const BodyForm& preset) {
  lua_State* L = keys.lua();
  constexpr const char* wanted = "\"rigid\", \"quad\" or { mesh = {nx, ny} }";
  BodyForm form = preset;
  const int type = keys.push("body");
  if (type == LUA_TSTRING) {
    const std::string text = text_at(L, -1);
    form = {text == "quad" ? BodyKind::quad : BodyKind::rigid, {1, 1}};
    if (text != "rigid" && text != "quad") keys.problem(fmt::format("'body' is '{}', must be {}", text, wanted));
  } else if (type == LUA_TTABLE) {
    Keys own(L, -1, "body");
    form = {BodyKind::mesh, {1, 1}};
    read_divisions(own, form.divisions, "two whole numbers {nx, ny}, divisions along the first and second side");
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("body", wanted);
  }
  lua_pop(L, 1);
  return form;
}

BodyOptions read_body_options(Keys& keys, bool several, const BodyForm& preset) {
  BodyOptions o;
  BodySpec start;
  start.kind = preset.kind, start.divisions = preset.divisions;
  o.spec = read_spec(keys, start);
  if (!several) return o;
  o.fixed = keys.names("fixed");
  read_by_group(keys, o);
  // One plane may cross many parts; only the parts that it meets have it.
  o.spec.cracks.where_met = true;
  for (auto& [group, spec] : o.by_group) spec.cracks.where_met = true;
  return o;
}

void add_part(PlaneModel& model, const Part& part, const BodyOptions& options) {
  BodySpec spec = spec_of(part, options);
  spec.name = part.name;
  spec.outline = part.outline;
  spec.groups.insert(spec.groups.begin(), part.groups.begin(), part.groups.end());
  const auto fixed = [&](const std::string& n) { return contains(options.fixed, n); };
  if (fixed(part.name) || std::any_of(part.groups.begin(), part.groups.end(), fixed)) {
    spec.support.fill(Support::fixed);
    spec.cracks = {};
  }
  model.builder.add_body(std::move(spec));
}

}  // namespace trilith::script
