#include "results/study/study_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/normal_distribution.hpp"
#include "base/portable.hpp"

namespace trilith::results {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return unknown;
  const double mean = mean_of(values);
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double dispersion_of(std::vector<double> values) {
  for (double& v : values) {
    if (!(v > 0)) return unknown;
    v = portable::log(v);
  }
  return deviation_of(values);
}

/// Quantile of sorted values.
double sorted_quantile(const std::vector<double>& values, double p) {
  if (values.empty()) return unknown;
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), values.size() - 1);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace

Confidence wilson_interval(int hits, int count, double confidence) {
  if (count <= 0) return {0, 1};
  const double z = normal_quantile(0.5 + 0.5 * confidence), n = count, share = hits / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {hits == 0 ? 0 : std::max(0.0, middle - half), hits == count ? 1 : std::min(1.0, middle + half)};
}

double quantile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  return sorted_quantile(values, p);
}

Spread spread_of(const std::vector<double>& values) {
  std::vector<double> known;
  std::copy_if(values.begin(), values.end(), std::back_inserter(known), [](double v) { return std::isfinite(v); });
  if (known.empty()) return {0, unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown};
  std::sort(known.begin(), known.end());
  Spread s;
  s.count = static_cast<int>(known.size());
  s.mean = mean_of(known), s.low = known.front(), s.high = known.back();
  s.median = sorted_quantile(known, 0.5), s.lower = sorted_quantile(known, 0.16),
  s.upper = sorted_quantile(known, 0.84);
  s.deviation = deviation_of(known), s.dispersion = dispersion_of(known);
  return s;
}

}  // namespace trilith::results
