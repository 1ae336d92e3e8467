// Ground motions as values.
#include <algorithm>
#include <cmath>

#include "bindings.hpp"
#include "load/motion_check.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_read.hpp"
#include "load/ramp.hpp"

namespace trilith::script {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::path& folder : folders)
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (entry.path().extension() == ".csv" || entry.path().extension() == ".at2" ||
          entry.path().extension() == ".AT2")
        names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_record(const Host& host, const std::string& name) {
  if (fs::path(name).is_absolute()) return name;
  std::vector<fs::path> folders{host.folder()};
  folders.insert(folders.end(), host.records.begin(), host.records.end());
  for (const fs::path& folder : folders)
    if (std::error_code ignored; fs::is_regular_file(folder / name, ignored)) return folder / name;
  std::string places;
  for (const fs::path& folder : folders) places += fmt::format("{}{}", places.empty() ? "" : ", ", folder.string());
  throw InputError(
      fmt::format("motion: there is no file '{}' in {}{}", name, places, name_hint(name, files_in(folders))));
}

void push_motion(lua_State* L, GroundMotion motion, bool steady) {
  push_handle(L, MotionValue{std::make_shared<const GroundMotion>(std::move(motion)), steady});
}

std::vector<double> read_samples(Keys& keys) {
  lua_State* L = keys.lua();
  std::vector<double> samples;
  const int type = keys.push("acceleration");
  if (type != LUA_TNIL && type != LUA_TTABLE) keys.wrong("acceleration", "a list of numbers in m/s2");
  if (type == LUA_TTABLE) {
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
      if (lua_rawgeti(L, -1, i) != LUA_TNUMBER)
        keys.problem(fmt::format("sample {} of 'acceleration' is {}, must be a number in m/s2", i, what_is(L, -1)));
      samples.push_back(lua_tonumber(L, -1));
      lua_pop(L, 1);
    }
  }
  lua_pop(L, 1);
  return samples;
}

/// motion{ velocity =, duration = }: the ground moves on steadily, then stands.
void make_steady(lua_State* L, Keys& keys) {
  const double velocity = keys.number("velocity", "m/s"), duration = keys.number("duration", "s");
  if (!(duration > 0)) keys.problem(fmt::format("'duration' is {:g} s, must be above 0", duration));
  keys.finish();
  const std::array<double, 2> still{0, 0};
  MotionSource source;
  source.title = fmt::format("steady {:g} m/s for {:g} s", velocity, duration);
  push_motion(L, GroundMotion(still, duration, {velocity, 0}, source), true);
}

int make_motion(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) {
    push_motion(L, read_motion(find_record(host(L), lua_tostring(L, 1))), false);
    return 1;
  }
  Keys keys(L, 1, "motion");
  if (keys.has("velocity")) {
    make_steady(L, keys);
    return 1;
  }
  std::string file = keys.text("file", "");
  const bool allow_drift = keys.flag("allow_drift", false);
  if (!file.empty()) {
    keys.finish();
    push_motion(L, read_motion(find_record(host(L), file)), allow_drift);
    return 1;
  }
  const std::vector<double> samples = read_samples(keys);
  if (!keys.has("acceleration"))
    keys.missing("acceleration", "a list of numbers in m/s2, or a file, or a velocity and a duration");
  const double dt = keys.number("dt", "s");
  const MotionStart start{keys.number("v0", "m/s", 0), keys.number("u0", "m", 0)};
  MotionSource source;
  source.title = keys.text("name", "samples of the script");
  keys.finish();
  push_motion(L, GroundMotion(samples, dt, start, source), allow_drift);
  return 1;
}

/// ramp{ by =, duration = }: from rest to rest.
int make_ramp(lua_State* L) {
  Keys keys(L, 1, "ramp");
  const double by = keys.number("by", "m or rad"), duration = keys.number("duration", "s");
  keys.finish();
  push_motion(L, ramp_motion(by, duration), true);
  return 1;
}

const MotionValue& this_motion(lua_State* L) {
  return handle<MotionValue>(L, 1);
}

double number_argument(lua_State* L, int index, const char* what) {
  if (lua_type(L, index) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, index)))
    throw InputError(fmt::format("{}: takes one finite number; this is {}", what, what_is(L, index)));
  return lua_tonumber(L, index);
}

int scale(lua_State* L) {
  const MotionValue& m = this_motion(L);
  Keys keys(L, 2, "scale");
  const auto pga = keys.maybe_number("pga", "m/s2"), factor = keys.maybe_number("factor", "1");
  if (pga.has_value() == factor.has_value()) keys.problem("give either pga (in m/s2) or factor");
  keys.finish();
  push_motion(L, pga ? m.motion->scaled_to_peak(*pga) : m.motion->scaled(*factor), m.steady);
  return 1;
}
int scale_as(lua_State* L) {
  const MotionValue& m = this_motion(L);
  push_motion(L, m.motion->scaled_as(*handle<MotionValue>(L, 2).motion), m.steady);
  return 1;
}
int time_scale(lua_State* L) {
  push_motion(L, this_motion(L).motion->time_scaled(number_argument(L, 2, "time_scale")), this_motion(L).steady);
  return 1;
}
int delay(lua_State* L) {
  push_motion(L, this_motion(L).motion->delayed(number_argument(L, 2, "delay")), this_motion(L).steady);
  return 1;
}
int reverse(lua_State* L) {
  push_motion(L, this_motion(L).motion->reversed(), this_motion(L).steady);
  return 1;
}
int start_velocity(lua_State* L) {
  push_motion(L, this_motion(L).motion->with_start_velocity(number_argument(L, 2, "start_velocity")),
              this_motion(L).steady);
  return 1;
}
/// motion:at(t): acceleration, velocity, displacement.
int motion_at(lua_State* L) {
  const MotionAt at = this_motion(L).motion->at(number_argument(L, 2, "at"));
  lua_pushnumber(L, at.acceleration);
  lua_pushnumber(L, at.velocity);
  lua_pushnumber(L, at.displacement);
  return 3;
}

using MotionProperty = Property<MotionValue>;
const std::array motion_properties{
    MotionProperty{"pga", "m/s2", "largest acceleration",
                   [](const MotionValue& m) { return std::abs(motion_peaks(*m.motion).acceleration.value); }},
    MotionProperty{"pgv", "m/s", "largest velocity",
                   [](const MotionValue& m) { return std::abs(motion_peaks(*m.motion).velocity.value); }},
    MotionProperty{"pgd", "m", "largest displacement",
                   [](const MotionValue& m) { return std::abs(motion_peaks(*m.motion).displacement.value); }},
    MotionProperty{"duration", "s", "from the first sample to the last",
                   [](const MotionValue& m) { return m.motion->duration(); }},
    MotionProperty{"end_time", "s", "time of the last sample, delay included",
                   [](const MotionValue& m) { return m.motion->end_time(); }},
    MotionProperty{"dt", "s", "step of the samples", [](const MotionValue& m) { return m.motion->step(); }},
    MotionProperty{"npts", "1", "number of samples",
                   [](const MotionValue& m) { return static_cast<double>(m.motion->samples().size()); }},
    MotionProperty{"description", "", "what it is, in one line", nullptr,
                   [](lua_State* L, const MotionValue& m) { lua_pushstring(L, m.motion->description().c_str()); }},
};

const std::array motion_methods{
    Method{"scale", guarded<scale>, "scale{pga=} or scale{factor=}"},
    Method{"scale_as", guarded<scale_as>, "scale_as(other): by the factor the other was scaled by"},
    Method{"time_scale", guarded<time_scale>, "time_scale(factor): time axis times factor, accelerations kept"},
    Method{"delay", guarded<delay>, "delay(t): the same later"},
    Method{"reverse", guarded<reverse>, "reverse(): the other way"},
    Method{"start_velocity", guarded<start_velocity>, "start_velocity(v): the same accelerations from velocity v"},
    Method{"at", guarded<motion_at>, "at(t): acceleration, velocity, displacement"},
};

}  // namespace

void open_motions(lua_State* L) {
  register_kind<MotionValue>(L);
  set_function(L, "motion", guarded<make_motion>);
  set_function(L, "ramp", guarded<make_ramp>);
}

std::span<const Property<MotionValue>> Kind<MotionValue>::properties() {
  return motion_properties;
}
std::span<const Method> Kind<MotionValue>::methods() {
  return motion_methods;
}
std::string Kind<MotionValue>::title(const MotionValue& m) {
  return fmt::format("motion '{}'", m.motion->description());
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<MotionValue>::metamethods() {
  return {};
}
bool Kind<MotionValue>::read_item(lua_State*, const MotionValue&) {
  return false;
}

}  // namespace trilith::script
