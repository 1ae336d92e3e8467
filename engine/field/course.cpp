#include "field/course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {

double FieldCourse::at(double clock) const {
  if (time.empty()) return value.front();
  double t = clock - start;
  if (period > 0) t -= period * std::floor((t - time.front()) / period);
  if (t <= time.front()) return value.front();
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  if (next == time.size() && !(period > 0)) return value.back();
  const bool wraps = next == time.size();
  const double t1 = wraps ? time.front() + period : time[next], v1 = wraps ? value.front() : value[next];
  return value[next - 1] + (t - time[next - 1]) / (t1 - time[next - 1]) * (v1 - value[next - 1]);
}

void check_course(const FieldCourse& course, const std::string& owner) {
  for (std::size_t i = 0; i < course.value.size(); ++i) {
    const double t = course.time.empty() ? 0 : course.time[i];
    if (!std::isfinite(t) || !std::isfinite(course.value[i]))
      throw InputError(fmt::format("{}: point {} is not finite", owner, i + 1));
    if (i > 0 && !(t > course.time[i - 1]))
      throw InputError(fmt::format("{}: point {} is at {:g} s, must be later than {:g} s, the point before", owner,
                                   i + 1, t, course.time[i - 1]));
  }
  if (course.value.empty()) throw InputError(owner + ": there is no value; give a number or { {time, value}, ... }");
  if (course.period == 0) return;
  const double span = course.time.empty() ? 0 : course.time.back() - course.time.front();
  if (!(course.period > span && std::isfinite(course.period)))
    throw InputError(
        fmt::format("{}: period is {:g} s, must be longer than {:g} s, the time from the first point to the "
                    "last one",
                    owner, course.period, span));
}

}  // namespace trilith
