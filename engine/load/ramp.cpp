#include "load/ramp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Scales a shape of the acceleration so that it ends at `distance`.
GroundMotion to_distance(std::span<const double> shape, double step, double distance, const std::string& title) {
  // The unit motion ends at 1 up to rounding, which the last factor removes.
  const GroundMotion raw(shape, step, {}, {});
  std::vector<double> acceleration(shape.begin(), shape.end());
  const double factor = distance / raw.samples().back().displacement;
  for (double& a : acceleration) a *= factor;
  MotionSource source;
  source.title = title;
  return {acceleration, step, {}, source};
}

void check_distance(double distance, const char* owner) {
  require_finite(distance, fmt::format("{}: the distance", owner));
  if (distance == 0) throw InputError(fmt::format("{}: the distance is 0, so nothing would move", owner));
}

}  // namespace

GroundMotion ramp_motion(double distance, double duration) {
  check_distance(distance, "ramp");
  require_positive(duration, "ramp: the duration", "s");
  // Acceleration over one half and deceleration over the other, without a jump of the acceleration.
  constexpr std::array<double, 5> shape{0, 1, 0, -1, 0};
  return to_distance(shape, duration / 4, distance, fmt::format("ramp by {:g} within {:g} s", distance, duration));
}

/// Without a jump in velocity, which would be an impact. Of 100 intervals, 2 `half` reach the speed and two stop. In
/// distance they count as half as many.
GroundMotion even_motion(double distance, double speed, double ramp) {
  check_distance(distance, "push");
  require_positive(speed, "push: the speed", "m/s");
  constexpr std::size_t intervals = 100, most = 10;
  const double time = std::abs(distance) / speed, wanted = std::ceil(0.5 * intervals * ramp / time);
  const auto half = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(most)));
  std::array<double, intervals + 1> shape{};
  for (std::size_t i = 1; i < 2 * half; ++i)
    shape[i] = 1 - std::abs(static_cast<double>(i) - static_cast<double>(half)) / static_cast<double>(half);
  shape[intervals - 1] = -static_cast<double>(half);
  return to_distance(shape, time / static_cast<double>(intervals - 1 - half), distance,
                     fmt::format("by {:g} m at {:g} m/s", distance, speed));
}

/// 20 of 100 intervals accelerate, by an acceleration a that rises and falls over ten each. The speed is v = 10 a dt.
/// The distance is 80 v dt, of which each end contributes ten intervals.
GroundMotion gentle_motion(double distance, double acceleration, double duration) {
  check_distance(distance, "push");
  require_positive(acceleration, "push: the acceleration", "m/s2");
  constexpr std::size_t intervals = 100, half = 10;
  std::array<double, intervals + 1> shape{};
  for (std::size_t i = 0; i <= 2 * half; ++i) {
    const double share = 1 - std::abs(static_cast<double>(i) - half) / half;
    shape[i] = share, shape[intervals - i] = -share;
  }
  const double step =
      std::max(std::sqrt(std::abs(distance) / (acceleration * half * (intervals - 2 * half))), duration / intervals);
  return to_distance(shape, step, distance, fmt::format("by {:g} m within {:g} s", distance, step * intervals));
}

double gentle_speed(const GroundMotion& motion) {
  return std::abs(motion.at(0.5 * motion.duration()).velocity);
}

GroundMotion stopping_motion(double displacement, double velocity, double duration) {
  require_positive(duration, "stop: the duration", "s");
  const double step = duration / 2;
  // A triangle whose area is the velocity to remove.
  const std::array<double, 3> acceleration{0, -velocity / step, 0};
  MotionSource source;
  source.title = fmt::format("to rest from {:g} m/s within {:g} s", velocity, duration);
  return {acceleration, step, {velocity, displacement}, source};
}

}  // namespace trilith
