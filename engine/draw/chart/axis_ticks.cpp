#include "draw/chart/axis_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/quantity_text.hpp"

namespace trilith::draw {
namespace {

/// A step of 1, 2 or 5 (by `rank` modulo 3) times a power of ten, as numerator / denominator, so that its multiples are
/// the nearest doubles (3 / 10, not 3 * 0.1).
struct Step {
  int rank = 0;
  double numerator = 1, denominator = 1;

  explicit Step(int r) : rank(r) {
    const int power = static_cast<int>(std::floor(r / 3.0));
    const double digit = std::array{1.0, 2.0, 5.0}[static_cast<std::size_t>(r - 3 * power)];
    numerator = power >= 0 ? digit * std::pow(10.0, power) : digit;
    denominator = power >= 0 ? 1 : std::pow(10.0, -power);
  }
  double size() const { return numerator / denominator; }
  double multiple(double count) const { return count * numerator / denominator; }
};

/// Ranks start at the step just below `value`.
int rank_below(double value) {
  int rank = 3 * static_cast<int>(std::floor(std::log10(value)));
  while (Step(rank).size() > value) --rank;
  while (Step(rank + 1).size() <= value) ++rank;
  return rank;
}

/// Rounding must not remove a tick at the end of the axis.
constexpr double slack = 1e-9;

std::vector<double> multiples(const Step& step, double low, double high) {
  const double first = std::ceil(low / step.size() - slack), last = std::floor(high / step.size() + slack);
  std::vector<double> out;
  for (double n = first; n <= last; n += 1) out.push_back(step.multiple(n) + 0.0);  // + 0.0: no negative zero
  return out;
}

std::string log_tick_text(double tick) {
  if (tick >= 0.000999 && tick < 9999.5) return fmt::format("{:g}", tick);
  const int power = static_cast<int>(std::floor(std::log10(tick) + slack));
  const double lead = tick / std::pow(10.0, power);
  const std::string ten = "10" + superscript(power);
  return std::abs(lead - 1) < 1e-6 ? ten : fmt::format("{:g}·{}", lead, ten);
}

/// Decimals after the point that show `value` to within a millionth of `step`.
int decimals_of(double value, double step) {
  for (int n = 0; n < 12; ++n)
    if (std::abs(value - std::round(value * std::pow(10, n)) / std::pow(10, n)) < 1e-6 * step) return n;
  return 12;
}

}  // namespace

/// The finest step with at most `most` ticks; if that leaves fewer than 3, the next finer one.
std::vector<double> linear_ticks(double low, double high, int most) {
  assert(std::isfinite(low) && std::isfinite(high) && most >= 2);
  assert(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)));
  std::vector<double> finer;
  for (int rank = rank_below((high - low) / (2 * most));; ++rank) {
    std::vector<double> ticks = multiples(Step(rank), low, high);
    const auto count = static_cast<int>(ticks.size());
    if (count <= most) return count >= 3 || finer.empty() ? ticks : finer;
    finer = std::move(ticks);
  }
}

/// Whole powers of ten, every n-th of many; below about two decades 1, 2 and 5 times them; over still shorter ranges as
/// on a linear axis.
std::vector<double> log_ticks(double low, double high, int most) {
  assert(low > 0 && low < high && std::isfinite(high) && most >= 2);
  const int first = static_cast<int>(std::ceil(std::log10(low) - slack));
  const int last = static_cast<int>(std::floor(std::log10(high) + slack));
  std::vector<double> ticks;
  const int every = std::max(1, (last - first) / most + 1);
  for (int power = first; power <= last; ++power)
    if (power % every == 0) ticks.push_back(power >= 0 ? std::pow(10.0, power) : 1 / std::pow(10.0, -power));
  if (ticks.size() >= 3 || (ticks.size() == 2 && high / low > 50)) return ticks;
  ticks.clear();
  for (int rank = 3 * (first - 1); rank <= 3 * (last + 1); ++rank) {
    const double tick = Step(rank).size();
    if (tick >= low * (1 - slack) && tick <= high * (1 + slack)) ticks.push_back(tick);
  }
  return ticks.size() >= 2 ? ticks : linear_ticks(low, high, most);
}

std::vector<double> log_minor_ticks(double low, double high) {
  assert(low > 0 && low < high && std::isfinite(high));
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::floor(std::log10(high)));
  if (last - first > 8) return ticks;
  for (int power = first; power <= last; ++power)
    for (int digit = 2; digit <= 9; ++digit) {
      const double tick = digit * std::pow(10.0, power);
      if (tick >= low && tick <= high) ticks.push_back(tick);
    }
  return ticks;
}

double nice_at_most(double value) {
  assert(std::isfinite(value) && value > 0);
  return Step(rank_below(value * (1 + slack))).size();
}

std::vector<std::string> tick_texts(const std::vector<double>& ticks) {
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  int decimals = 0;
  for (const double tick : ticks) decimals = std::max(decimals, decimals_of(tick, step));
  std::vector<std::string> out;
  for (const double tick : ticks) out.push_back(with_minus(fmt::format("{:.{}f}", tick, decimals)));
  return out;
}

std::vector<std::string> log_tick_texts(const std::vector<double>& ticks) {
  std::vector<std::string> out;
  for (const double tick : ticks) out.push_back(log_tick_text(tick));
  return out;
}

}  // namespace trilith::draw
