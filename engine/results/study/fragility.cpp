#include "results/study/fragility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/normal_distribution.hpp"
#include "base/portable.hpp"

namespace trilith::results {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// ln of the bounds; -inf for a lower bound of 0.
struct LogBounds {
  double low, high;
};

/// Log-likelihood, its gradient and its Hessian in (a, b).
struct Likelihood {
  double value = 0, da = 0, db = 0, aa = 0, ab = 0, bb = 0;
};

/// P(high) - P(low), on the side of the distribution without cancellation.
double share_between(double low, double high) {
  return low > 0 ? normal_share(-low) - normal_share(-high) : normal_share(high) - normal_share(low);
}

/// Input: eta = a + b u at both bounds u. Output: the sums of l = ln(Phi(eta_h) - Phi(eta_l)), of its first derivatives
///     l_a = (phi_h - phi_l) / D,  l_b = (phi_h u_h - phi_l u_l) / D,  D = Phi(eta_h) - Phi(eta_l),
/// and of its second ones, with phi' = -eta phi:
///     l_ij = (-eta_h phi_h w_ij,h + eta_l phi_l w_ij,l) / D - l_i l_j,   w = 1, u, u^2.
/// Infinite bounds contribute nothing.
Likelihood likelihood(const std::vector<LogBounds>& bounds, double a, double b) {
  Likelihood sum;
  for (const LogBounds& one : bounds) {
    const bool below = std::isfinite(one.low), above = std::isfinite(one.high);
    const double ul = below ? one.low : 0, uh = above ? one.high : 0;
    const double el = below ? a + b * ul : -40, eh = above ? a + b * uh : 40;
    const double share = std::max(share_between(el, eh), 1e-300);
    const double pl = below ? normal_density(el) / share : 0, ph = above ? normal_density(eh) / share : 0;
    const double da = ph - pl, db = ph * uh - pl * ul;
    sum.value += portable::log(share);
    sum.da += da, sum.db += db;
    sum.aa += -eh * ph + el * pl - da * da;
    sum.ab += -eh * ph * uh + el * pl * ul - da * db;
    sum.bb += -eh * ph * uh * uh + el * pl * ul * ul - db * db;
  }
  return sum;
}

std::vector<LogBounds> logs_of(const std::vector<CapacityBounds>& bounds) {
  std::vector<LogBounds> logs;
  for (const CapacityBounds& one : bounds) {
    if (!(one.low >= 0 && one.low < one.high))
      throw InputError(
          fmt::format("fragility: a capacity between {:g} and {:g}; the first must not be below 0, the "
                      "second above it",
                      one.low, one.high));
    logs.push_back(
        {one.low > 0 ? portable::log(one.low) : -forever, std::isfinite(one.high) ? portable::log(one.high) : forever});
  }
  // A bound from 0 to infinity contains no information.
  std::erase_if(logs, [](const LogBounds& l) { return !std::isfinite(l.low) && !std::isfinite(l.high); });
  return logs;
}

/// Throws if no maximum exists, with the reason. It exists if the intervals have no common point: otherwise a curve
/// with a jump at this point has likelihood 1.
void require_maximum(const std::vector<LogBounds>& logs) {
  double most_low = -forever, least_high = forever;
  for (const LogBounds& l : logs) most_low = std::max(most_low, l.low), least_high = std::min(least_high, l.high);
  if (logs.empty()) throw InputError("fragility: no case has a result; give cases that ran to their end");
  if (!std::isfinite(least_high))
    throw InputError(
        fmt::format("fragility: the condition is met in none of {} cases; use higher intensities", logs.size()));
  if (!std::isfinite(most_low))
    throw InputError(
        fmt::format("fragility: the condition is met in all {} cases; use lower intensities", logs.size()));
  if (most_low <= least_high)
    throw InputError(
        fmt::format("fragility: a curve that jumps between {:g} and {:g} agrees with every case, so the dispersion "
                    "cannot be found; give intensities in between, or more cases",
                    portable::exp(most_low), portable::exp(least_high)));
}

/// Initial curve: centred on the finite bounds, with their spread.
Fragility first_guess(const std::vector<LogBounds>& logs) {
  double sum = 0, squares = 0, n = 0;
  for (const LogBounds& l : logs)
    for (const double u : {l.low, l.high})
      if (std::isfinite(u)) sum += u, squares += u * u, n += 1;
  const double mean = sum / n, width = std::sqrt(std::max(squares / n - mean * mean, 1e-6));
  Fragility f;
  f.b = 1 / width, f.a = -mean / width;
  return f;
}

}  // namespace

double Fragility::probability(double x) const {
  return x > 0 ? normal_share(a + b * portable::log(x)) : 0;
}

Confidence Fragility::band(double x, double confidence) const {
  if (!(x > 0)) return {0, 0};
  const double u = portable::log(x), z = normal_quantile(0.5 + 0.5 * confidence);
  const double error = std::sqrt(std::max(0.0, var_a + 2 * u * cov_ab + u * u * var_b));
  return {normal_share(a + b * u - z * error), normal_share(a + b * u + z * error)};
}

Confidence Fragility::median_interval(double confidence) const {
  // ln median = -a / b: its derivatives are -1 / b and a / b^2.
  const double sa = -1 / b, sb = a / (b * b), z = normal_quantile(0.5 + 0.5 * confidence);
  const double error = std::sqrt(std::max(0.0, sa * sa * var_a + 2 * sa * sb * cov_ab + sb * sb * var_b));
  return {median * portable::exp(-z * error), median * portable::exp(z * error)};
}

Fragility fit_fragility(const std::vector<CapacityBounds>& bounds) {
  const std::vector<LogBounds> logs = logs_of(bounds);
  require_maximum(logs);
  Fragility f = first_guess(logs);
  f.count = static_cast<int>(logs.size());
  Likelihood now = likelihood(logs, f.a, f.b);
  for (int i = 0; i < 200; ++i) {
    const double det = now.aa * now.bb - now.ab * now.ab;
    const double step_a = -(now.bb * now.da - now.ab * now.db) / det;
    const double step_b = -(now.aa * now.db - now.ab * now.da) / det;
    double part = 1;
    Likelihood next = likelihood(logs, f.a + step_a, f.b + step_b);
    for (int k = 0; k < 60 && !(next.value >= now.value); ++k) {
      part /= 2;
      next = likelihood(logs, f.a + part * step_a, f.b + part * step_b);
    }
    f.a += part * step_a, f.b += part * step_b;
    now = next;
    if (std::abs(step_a) < 1e-12 * (1 + std::abs(f.a)) && std::abs(step_b) < 1e-12 * (1 + std::abs(f.b))) break;
  }
  if (!(f.b > 1e-6))
    throw InputError("fragility: the condition is not met more often at higher intensities; check the table");
  const double det = now.aa * now.bb - now.ab * now.ab;
  f.var_a = -now.bb / det, f.var_b = -now.aa / det, f.cov_ab = now.ab / det;
  f.log_likelihood = now.value;
  f.dispersion = 1 / f.b, f.median = portable::exp(-f.a / f.b);
  return f;
}

}  // namespace trilith::results
