#include "profile_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace trilith::program {
namespace {

std::string duration(double seconds) {
  if (seconds >= 1) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return seconds >= 1e-6 ? fmt::format("{:.3g} µs", 1e6 * seconds) : fmt::format("{:.0f} ns", 1e9 * seconds);
}

std::string row(std::string_view name, double seconds, double all, double count, std::string_view each) {
  return fmt::format("  {:<36} {:>6.1f} %  {:>9}  {:>9} {}\n", name, all > 0 ? 100 * seconds / all : 0,
                     duration(seconds), duration(count > 0 ? seconds / count : 0), each);
}

std::string laws_text(const script::Profile& p, double steps) {
  std::string text;
  for (std::size_t i = 0; i < p.times.law.size(); ++i)
    if (p.times.law[i] > 0)
      text += row(fmt::format("  law {}", i < p.laws.size() ? p.laws[i] : std::to_string(i)), p.times.law[i],
                  p.times.all, steps, "a step");
  return text;
}

}  // namespace

std::string profile_text(const script::Profile& p) {
  const StepTimes& t = p.times;
  const auto steps = static_cast<double>(t.steps);
  if (t.steps == 0) return "no step was taken, so there is no profile\n";
  std::string text =
      fmt::format("profile of {} steps in {}, {} a step\n", t.steps, duration(t.all), duration(t.all / steps));
  double known = 0;
  for (std::size_t i = 0; i < step_parts; ++i) {
    known += t.part[i];
    if (t.part[i] > 0) text += row(step_part_names[i], t.part[i], t.all, steps, "a step");
    if (static_cast<StepPart>(i) == StepPart::faces) text += laws_text(p, steps);
  }
  text += row("the loop, and this measurement", std::max(0.0, t.all - known), t.all, steps, "a step");
  std::vector<script::CallbackTime> calls = p.callbacks;
  std::stable_sort(calls.begin(), calls.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  for (const script::CallbackTime& c : calls)
    if (c.calls > 0)
      text += row(fmt::format("Lua: {} ({} calls)", c.what, c.calls), c.seconds, t.all, static_cast<double>(c.calls),
                  "a call");
  return text;
}

}  // namespace trilith::program
