// Methods and properties of ground motions.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/core/table_fields.hpp"
#include "bindings/loads/motion_value.hpp"
#include "bindings/loads/small_peak.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_process.hpp"
#include "load/relative_motion.hpp"
#include "load/response_spectrum.hpp"

namespace trilith::script {
namespace {

const MotionValue& this_motion(lua_State* L) {
  return handle<MotionValue>(L, 1);
}

double number_argument(lua_State* L, int index, const char* what) {
  if (lua_type(L, index) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, index)))
    throw InputError(fmt::format("{}: takes one finite number; this is {}", what, what_is(L, index)));
  return lua_tonumber(L, index);
}

/// Peaks in this range [m/s2] hardly move a structure, but are usual ones in g.
constexpr double least_peak_in_g = 0.05, most_peak_in_g = 0.6;

/// A note on a peak acceleration that is probably meant in g.
void tell_small_peak(lua_State* L, const char* owner, double pga) {
  RunObserver* const observer = host(L).observer;
  if (observer == nullptr || !(pga >= least_peak_in_g) || !(pga <= most_peak_in_g)) return;
  observer->note(fmt::format("{}: 'pga' is {:g} m/s2, which is {:.2g} g; if {:g} g is meant, give pga = {:g}*9.80665",
                             owner, pga, pga / standard_gravity, pga, pga));
}

int scale(lua_State* L) {
  const MotionValue& m = this_motion(L);
  Keys keys(L, 2, "scale");
  const auto pga = keys.maybe_number("pga", "m/s2"), factor = keys.maybe_number("factor", "1"),
             sa = keys.maybe_number("sa", "m/s2");
  if (pga.has_value() + factor.has_value() + sa.has_value() != 1)
    keys.problem("give either pga (in m/s2), factor, or sa (in m/s2) with its period");
  if (pga && !(*pga >= 0)) keys.problem(fmt::format("'pga' is {:g} m/s2, must not be below 0", *pga));
  const double period = sa ? keys.number("period", "s") : 0, damping = keys.number("damping_ratio", "1", 0.05);
  if (!sa && (keys.has("period") || keys.has("damping_ratio")))
    keys.problem("'period' and 'damping_ratio' are for sa; give it too");
  keys.finish();
  if (pga) tell_small_peak(L, "scale", *pga);
  if (sa && *sa != 0)
    push_motion(L, m.motion->scaled(factor_to_spectrum(*m.motion, {period, *sa}, damping)), m.steady);
  else
    push_motion(L, pga ? m.motion->scaled_to_peak(*pga) : m.motion->scaled(factor.value_or(0)), m.steady);
  return 1;
}

/// { {T, Sa}, ... }
std::vector<SpectrumPoint> read_spectrum(Keys& keys) {
  lua_State* L = keys.lua();
  std::vector<SpectrumPoint> points;
  if (keys.push("spectrum") != LUA_TTABLE) keys.wrong("spectrum", "a list of points { period, acceleration }");
  const auto count = lua_istable(L, -1) ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, -1, i);
    const bool pair =
        lua_type(L, -1) == LUA_TTABLE && lua_rawgeti(L, -1, 1) == LUA_TNUMBER && lua_rawgeti(L, -2, 2) == LUA_TNUMBER;
    if (!pair)
      throw InputError(fmt::format("match: point {} of 'spectrum' must be two numbers, period and acceleration", i));
    points.push_back({lua_tonumber(L, -2), lua_tonumber(L, -1)});
    lua_pop(L, 3);
  }
  lua_pop(L, 1);
  return points;
}

/// motion:match{ spectrum =, from =, to =, damping_ratio = }
int match(lua_State* L) {
  const MotionValue& m = this_motion(L);
  Keys keys(L, 2, "match");
  std::vector<SpectrumPoint> points = read_spectrum(keys);
  const double from = keys.number("from", "s", 0), to = keys.number("to", "s", 1e9),
               damping = keys.number("damping_ratio", "1", 0.05);
  if (!(from >= 0)) keys.problem(fmt::format("'from' is {:g} s, must not be below 0", from));
  if (!(to > 0)) keys.problem(fmt::format("'to' is {:g} s, must be above 0", to));
  keys.finish();
  std::erase_if(points, [&](const SpectrumPoint& p) { return p.period < from || p.period > to; });
  if (points.empty()) throw InputError("match: no point of the spectrum lies between 'from' and 'to'");
  push_motion(L, m.motion->scaled(factor_to_spectrum(*m.motion, points, damping)), m.steady);
  return 1;
}
int baseline(lua_State* L) {
  const double degree = number_argument(L, 2, "baseline");
  if (degree != std::floor(degree)) throw InputError(fmt::format("baseline: degree is {:g}, must be whole", degree));
  push_motion(L, baseline_corrected(*this_motion(L).motion, static_cast<int>(std::clamp(degree, -1.0, 99.0))),
              this_motion(L).steady);
  return 1;
}
int filter(lua_State* L) {
  const MotionValue& m = this_motion(L);
  Keys keys(L, 2, "filter");
  const FilterBand band{keys.number("low", "Hz", 0), keys.number("high", "Hz", 0), keys.count("order", 4),
                        keys.number("pad", "s", 0)};
  if (!(band.low >= 0)) keys.problem(fmt::format("'low' is {:g} Hz, must not be below 0; 0 keeps low ones", band.low));
  if (!(band.high >= 0))
    keys.problem(fmt::format("'high' is {:g} Hz, must not be below 0; 0 keeps high ones", band.high));
  keys.finish();
  push_motion(L, filtered(*m.motion, band), m.steady);
  return 1;
}
int resample(lua_State* L) {
  push_motion(L, resampled(*this_motion(L).motion, number_argument(L, 2, "resample")), this_motion(L).steady);
  return 1;
}
/// motion:rotate(other, angle): both components, rotated.
int rotate(lua_State* L) {
  const MotionValue &a = this_motion(L), &b = handle<MotionValue>(L, 2);
  const bool steady = a.steady || b.steady;
  auto [first, second] = rotated(*a.motion, *b.motion, number_argument(L, 3, "rotate"));
  push_motion(L, std::move(first), steady);
  push_motion(L, std::move(second), steady);
  return 2;
}
/// motion:passage{ distance =, velocity = }: delayed by the travel time of a wave.
int passage(lua_State* L) {
  const MotionValue& m = this_motion(L);
  Keys keys(L, 2, "passage");
  const double distance = keys.number("distance", "m"), velocity = keys.number("velocity", "m/s");
  if (!(velocity > 0)) keys.problem(fmt::format("'velocity' is {:g} m/s, must be above 0", velocity));
  keys.finish();
  push_motion(L, m.motion->delayed(distance / velocity), m.steady);
  return 1;
}
/// motion:difference(other): largest relative displacement and velocity of two motions.
int difference(lua_State* L) {
  const RelativePeaks peaks = relative_peaks(*this_motion(L).motion, *handle<MotionValue>(L, 2).motion);
  lua_createtable(L, 0, 4);
  set_number(L, "displacement", peaks.displacement.value);
  set_number(L, "displacement_time", peaks.displacement.time);
  set_number(L, "velocity", peaks.velocity.value);
  set_number(L, "velocity_time", peaks.velocity.time);
  return 1;
}
/// motion:sa(period, damping)
int sa(lua_State* L) {
  const double period = number_argument(L, 2, "sa");
  const double damping = lua_isnoneornil(L, 3) ? 0.05 : number_argument(L, 3, "sa: damping");
  lua_pushnumber(L, oscillator_peak(*this_motion(L).motion, period, damping).pseudo_acceleration);
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
    MotionProperty{"description", "", "description in one line", nullptr,
                   [](lua_State* L, const MotionValue& m) { lua_pushstring(L, m.motion->description().c_str()); }},
};

const std::array motion_methods{
    Method{"scale", guarded<scale>},
    Method{"match", guarded<match>},
    Method{"baseline", guarded<baseline>},
    Method{"filter", guarded<filter>},
    Method{"resample", guarded<resample>},
    Method{"rotate", guarded<rotate>},
    Method{"passage", guarded<passage>},
    Method{"difference", guarded<difference>},
    Method{"sa", guarded<sa>},
    Method{"scale_as", guarded<scale_as>},
    Method{"time_scale", guarded<time_scale>},
    Method{"delay", guarded<delay>},
    Method{"reverse", guarded<reverse>},
    Method{"start_velocity", guarded<start_velocity>},
    Method{"at", guarded<motion_at>},
};

}  // namespace

void push_motion(lua_State* L, GroundMotion motion, bool steady) {
  push_handle(L, MotionValue{std::make_shared<const GroundMotion>(std::move(motion)), steady});
}

int note_small_peak(lua_State* L) {
  tell_small_peak(L, luaL_checkstring(L, 1), luaL_checknumber(L, 2));
  return 0;
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
