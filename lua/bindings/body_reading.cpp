#include "body_reading.hpp"

#include <algorithm>

namespace trilith::script {
namespace {

/// Densest element (osmium) [kg/m3], rounded up; 150 lbf/ft3 taken for a density would be 23563.
constexpr double largest_density = 23000;

Support support_at(Keys& keys, std::string_view key, const std::string& text) {
  if (text != "fixed" && text != "free")
    keys.problem(fmt::format("'{}' is '{}', must be \"fixed\" or \"free\"", key, text));
  return text == "fixed" ? Support::fixed : Support::free;
}

void read_support(Keys& keys, std::array<Support, 3>& support) {
  lua_State* L = keys.lua();
  const int type = keys.push("support");
  if (type == LUA_TSTRING) {
    support.fill(support_at(keys, "support", lua_tostring(L, -1)));
  } else if (type == LUA_TTABLE) {
    Keys own(L, -1, "support");
    const std::array names{"x", "y", "rotation"};
    for (std::size_t i = 0; i < names.size(); ++i) support[i] = support_at(own, names[i], own.text(names[i], "free"));
    try {
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
  } else if (type != LUA_TNIL) {
    keys.wrong("support", "\"fixed\", \"free\" or { x = , y = , rotation = }");
  }
  lua_pop(L, 1);
}

}  // namespace

void check_density(Keys& keys, double density) {
  if (density > largest_density)
    keys.problem(fmt::format(
        "'density' is {:g} kg/m3, more than any metal's; a weight by volume (pcf, kcf, N/m3) is given as unit_weight",
        density));
}

BodyOptions read_body_options(Keys& keys, bool several) {
  BodyOptions o;
  BodySpec& s = o.spec;
  s.material = keys.text("material", "");
  s.groups = keys.names("groups");
  s.density = keys.maybe_number("density", "kg/m3");
  if (s.density) check_density(keys, *s.density);
  if (const auto weight = keys.maybe_number("unit_weight", "N/m3")) {
    if (s.density) keys.problem("both density and unit_weight are given; keep one");
    s.density = *weight / standard_gravity;
  }
  s.mass = keys.maybe_number("mass", "kg");
  s.weight = keys.maybe_number("weight", "N");
  s.inertia = keys.maybe_number("inertia", "kg m2");
  s.thickness = keys.maybe_number("body_thickness", "m");
  read_support(keys, s.support);
  s.velocity = keys.point("velocity", Vec2::Zero());
  s.spin = keys.number("spin", "rad/s", 0);
  s.load = keys.point("load", Vec2::Zero());
  s.floating = keys.flag("floating", false);
  if (several) o.fixed = keys.names("fixed");
  return o;
}

void add_part(ScriptModel& model, const Polygon& outline, const std::string& name,
              const std::vector<std::string>& groups, const BodyOptions& options) {
  BodySpec spec = options.spec;
  spec.name = name;
  spec.outline = outline;
  spec.groups.insert(spec.groups.begin(), groups.begin(), groups.end());
  const auto fixed = [&](const std::string& n) {
    return std::find(options.fixed.begin(), options.fixed.end(), n) != options.fixed.end();
  };
  if (fixed(name) || std::any_of(groups.begin(), groups.end(), fixed)) spec.support.fill(Support::fixed);
  model.builder.add_body(std::move(spec));
}

}  // namespace trilith::script
