// Makes ground motions: from files, samples, a velocity or a ramp. Their methods are in motion_handle.cpp.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/loads/motion_value.hpp"
#include "load/motion_plain.hpp"
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
  std::vector<fs::path> folders{host.folder(), host.folder() / "records"};
  folders.insert(folders.end(), host.records.begin(), host.records.end());
  for (const fs::path& folder : folders)
    if (std::error_code ignored; fs::is_regular_file(folder / name, ignored)) return folder / name;
  std::string places;
  for (const fs::path& folder : folders) places += fmt::format("{}{}", places.empty() ? "" : ", ", folder.string());
  throw InputError(
      fmt::format("motion: there is no file '{}' in {}{}", name, places, name_hint(name, files_in(folders))));
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

/// Rejects keys of other kinds of motions, which would be ignored.
void refuse_other_ways(Keys& keys, const char* way, std::initializer_list<std::pair<const char*, const char*>> others) {
  for (const auto& [key, why] : others)
    keys.refuse(key, fmt::format("'{}' cannot be given with '{}': {}", key, way, why));
}

constexpr const char* of_records = "it is for records; a steady motion takes only velocity and duration";

/// motion{ velocity =, duration = }: the ground moves at constant speed, then stops.
void make_steady(lua_State* L, Keys& keys) {
  refuse_other_ways(keys, "velocity",
                    {{"acceleration", "velocity is a steady motion instead of samples, which begin with v0"},
                     {"file", "velocity is a steady motion instead of a file; motion:start_velocity is for that"},
                     {"dt", of_records},
                     {"v0", of_records},
                     {"u0", of_records},
                     {"unit", of_records},
                     {"column", of_records},
                     {"skip", of_records},
                     {"decimal", of_records},
                     {"allow_drift", of_records}});
  const double velocity = keys.number("velocity", "m/s"), duration = keys.number("duration", "s");
  if (!(duration > 0)) keys.problem(fmt::format("'duration' is {:g} s, must be above 0", duration));
  keys.finish();
  const std::array<double, 2> still{0, 0};
  MotionSource source;
  source.title = fmt::format("steady {:g} m/s for {:g} s", velocity, duration);
  push_motion(L, GroundMotion(still, duration, {velocity, 0}, source), true);
}

/// `column` is a number or a name.
std::string column_of(Keys& keys) {
  const int type = keys.push("column");
  lua_pop(keys.lua(), 1);
  if (type == LUA_TNIL) return "";
  return type == LUA_TNUMBER ? fmt::format("{}", keys.count("column", 1)) : keys.text("column");
}

std::optional<int> skipped_lines(Keys& keys) {
  const auto skip = keys.maybe_number("skip", "1");
  if (!skip) return std::nullopt;
  if (*skip >= 0 && *skip <= 1e6 && *skip == std::floor(*skip)) return static_cast<int>(*skip);
  keys.problem(fmt::format("'skip' is {:g}, must be a whole number of lines, 0 or above", *skip));
  return std::nullopt;
}

constexpr std::array form_keys{"unit", "dt", "column", "skip", "decimal"};

/// Form of a file of plain columns; none if the table has no such keys.
std::optional<PlainForm> read_form(Keys& keys) {
  bool any = false;
  for (const char* const key : form_keys) any = keys.has(key) || any;
  if (!any) return std::nullopt;
  PlainForm form{keys.text("unit"), keys.maybe_number("dt", "s"), column_of(keys), skipped_lines(keys)};
  const std::string decimal = keys.text("decimal", "");
  if (!decimal.empty() && decimal != "," && decimal != ".")
    keys.problem(fmt::format("'decimal' is \"{}\", must be \".\" or \",\"", decimal));
  form.decimal = decimal.empty() ? '\0' : decimal[0];
  return form;
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
  if (!file.empty())
    refuse_other_ways(keys, "file",
                      {{"acceleration", "keep one, the file or the samples"},
                       {"v0", "a file begins as its header says, or with motion:start_velocity"},
                       {"u0", "a file begins as its header says"},
                       {"duration", "a file lasts as long as its samples"}});
  if (!file.empty()) {
    const std::optional<PlainForm> form = read_form(keys);
    keys.finish();
    const fs::path record = find_record(host(L), file);
    push_motion(L, form ? read_plain_motion(record, *form) : read_motion(record), allow_drift);
    return 1;
  }
  const std::vector<double> samples = read_samples(keys);
  if (!keys.has("acceleration"))
    keys.missing("acceleration", "a list of numbers in m/s2, or a file, or a velocity and a duration");
  refuse_other_ways(keys, "acceleration", {{"duration", "samples last as long as their number times dt"}});
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

}  // namespace

void open_motions(lua_State* L) {
  register_kind<MotionValue>(L);
  set_function(L, "motion", guarded<make_motion>);
  set_function(L, "ramp", guarded<make_ramp>);
}

}  // namespace trilith::script
