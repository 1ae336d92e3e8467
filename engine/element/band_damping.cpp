#include "element/band_damping.hpp"

#include <fmt/format.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

/// Largest spacing of relaxation times; one branch is enough for a band up to `narrow` [decades].
constexpr double apart = 0.7, narrow = 0.4;
/// Fitted frequencies for each branch.
constexpr int points_each = 12;
/// Limit of the stiffening above the band; beyond it the beam would differ too much from the requested one.
constexpr double most_stiffening = 3;

double decades_of(const BandDamping& band) {
  return portable::log(band.to / band.from) / portable::log(10);
}

/// The frequency at `share` of the band, on a logarithmic scale [Hz].
double at_share(const BandDamping& band, double share) {
  return band.from * portable::pow(band.to / band.from, share);
}

}  // namespace

void BandDamping::check() const {
  if (!(to > from))
    throw InputError(
        fmt::format("band_damping: the band is from {:g} to {:g} Hz, its end must be above its beginning", from, to));
  if (decades_of(*this) > apart * (DampingBranches::most - 1))
    throw InputError(fmt::format("band_damping: the band from {:g} to {:g} Hz is wider than {:g} decades", from, to,
                                 apart * (DampingBranches::most - 1)));
}

/// Contribution of the branches without relaxation: 1 + sum of shares.
double DampingBranches::stiffening() const {
  double sum = 1;
  for (int j = 0; j < count; ++j) sum += share[j];
  return sum;
}

/// Real and imaginary part of the stiffness over its static value. Branch j with share a_j and relaxation time t_j
/// gives
///
///     a_j (x^2 + i x) / (1 + x^2),   x = w t_j.
double DampingBranches::loss(double w) const {
  double sum = 0;
  for (int j = 0; j < count; ++j) sum += share[j] * w * time[j] / (1 + w * time[j] * w * time[j]);
  return sum;
}

double DampingBranches::stiffness(double w) const {
  double sum = 1;
  for (int j = 0; j < count; ++j) sum += share[j] * w * time[j] * w * time[j] / (1 + w * time[j] * w * time[j]);
  return sum;
}

/// Least squares over frequencies that are evenly spaced in the logarithm.
DampingBranches damping_branches(const BandDamping& band) {
  check_parameters(band);
  band.check();
  const double decades = decades_of(band);
  DampingBranches out;
  out.band = band;
  out.count = decades <= narrow ? 1 : std::min(DampingBranches::most, 1 + static_cast<int>(std::ceil(decades / apart)));
  for (int j = 0; j < out.count; ++j) {
    const double share = out.count == 1 ? 0.5 : static_cast<double>(j) / (out.count - 1);
    out.time[j] = 1 / (2 * M_PI * at_share(band, share));
  }
  const int points = points_each * out.count;
  Eigen::MatrixXd rows(points, out.count);
  // A ratio zeta over the whole band means loss = 2 zeta stiffness: one equation for each frequency, linear in the
  // shares.
  for (int i = 0; i < points; ++i) {
    const double w = 2 * M_PI * at_share(band, static_cast<double>(i) / (points - 1));
    for (int j = 0; j < out.count; ++j) {
      const double x = w * out.time[j];
      rows(i, j) = (x - 2 * band.ratio * x * x) / (1 + x * x);
    }
  }
  const Eigen::VectorXd share = rows.colPivHouseholderQr().solve(Eigen::VectorXd::Constant(points, 2 * band.ratio));
  for (int j = 0; j < out.count; ++j) {
    // A branch with a negative share would add energy; at the spacing above no share is negative.
    out.share[j] = std::max(0.0, share[j]);
  }
  if (out.stiffening() > most_stiffening)
    throw InputError(
        fmt::format("band_damping: with {:g} from {:g} to {:g} Hz a member would be {:.2g} times as stiff above "
                    "the band, more than {:g}; give a smaller ratio or a narrower band",
                    band.ratio, band.from, band.to, out.stiffening(), most_stiffening));
  return out;
}

int band_row(const std::optional<BandDamping>& band, std::vector<DampingBranches>& bands) {
  if (!band) return -1;
  const auto same = [&](const DampingBranches& b) {
    return b.band.ratio == band->ratio && b.band.from == band->from && b.band.to == band->to;
  };
  const auto at = std::find_if(bands.begin(), bands.end(), same);
  if (at != bands.end()) return static_cast<int>(at - bands.begin());
  bands.push_back(damping_branches(*band));
  return static_cast<int>(bands.size()) - 1;
}

/// h' = S' - h/tau with constant S' over the step: after dt, h becomes h exp(-dt/tau) + dS (1 - exp(-dt/tau)) tau/dt.
BranchStep::BranchStep(const DampingBranches& branches, double dt) {
  for (int j = 0; j < branches.count; ++j) {
    const double x = dt / branches.time[j];
    kept[j] = portable::exp(-x);
    taken[j] = x < 1e-4 ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : (1 - kept[j]) / x;
    sum += branches.share[j] * taken[j];
  }
}

namespace {

/// Each branch keeps the relaxed part of its force and adds its share of the change of stress over the step.
template <std::size_t N>
std::array<double, N> relaxed(const DampingBranches& branches, const BranchStep& step,
                              const std::array<double, N>& stress, std::span<const double> before,
                              std::span<double> after) {
  std::array<double, N> out{};
  for (std::size_t k = 0; k < N; ++k) {
    const double change = stress[k] - before[k];
    after[k] = stress[k];
    for (int j = 0; j < branches.count; ++j) {
      const std::size_t at = N * (1 + static_cast<std::size_t>(j)) + k;
      after[at] = step.kept[j] * before[at] + step.taken[j] * change;
      out[k] += branches.share[j] * after[at];
    }
  }
  return out;
}

}  // namespace

BeamStress relax(const DampingBranches& branches, const BranchStep& step, const BeamStress& stress,
                 std::span<const double> before, std::span<double> after) {
  return relaxed(branches, step, stress, before, after);
}
std::array<double, 6> relax(const DampingBranches& branches, const BranchStep& step,
                            const std::array<double, 6>& stress, std::span<const double> before,
                            std::span<double> after) {
  return relaxed(branches, step, stress, before, after);
}

}  // namespace trilith
