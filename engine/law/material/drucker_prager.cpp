#include "law/material/drucker_prager.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// The cone that matches Mohr-Coulomb with the friction angle `angle` in plane strain: its slope eta, and xi for the
/// cohesion (3 tan and 3, over sqrt(9 + 12 tan^2)).
struct Cone {
  double slope, share;
  explicit Cone(double angle) {
    const auto [s, c] = portable::sine_cosine(angle);
    const double size = std::sqrt(9 * c * c + 12 * s * s);
    slope = 3 * s / size, share = 3 * c / size;
  }
};

struct Deviator {
  double mean, xx, yy, zz, xy, size;  ///< size: sqrt(J2)
  explicit Deviator(const Stress& s) : mean((s.xx + s.yy + s.zz) / 3) {
    xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean, xy = s.xy;
    size = std::sqrt(0.5 * (xx * xx + yy * yy + zz * zz) + xy * xy);
  }
};

/// Mean stress and sqrt(J2) after the return.
struct Returned {
  double mean, size;
};

double top_of(const DruckerPrager& law, const Cone& cone) {
  return cone.slope > 0 ? std::min(law.tension, cone.share * law.cohesion / cone.slope) : law.tension;
}

/// In the plane of the mean stress p (tension to the right) and sqrt(J2), the trial state returns to one of three
/// parts:
///
///     sqrt(J2) |`-._    1          1  cone: sqrt(J2) falls by G g, p by K flow g
///              |    `-._     2     2  the edge of cone and cut-off, or the apex
///              |        `-|        3  cut-off: p alone falls
///              |          |   3
///              +----------+---- p
///                        top
Returned return_to_cone(const DruckerPrager& law, const Deviator& trial) {
  const double shear = law.young / (2 * (1 + law.poisson)), bulk = law.young / (3 * (1 - 2 * law.poisson));
  const Cone cone(law.friction);
  const double eta = cone.slope, flow = Cone(law.dilation).slope, top = top_of(law, cone);
  const double limit = cone.share * law.cohesion;
  const double excess = trial.size + eta * trial.mean - limit;
  if (excess > 0) {
    const double g = excess / (shear + bulk * eta * flow), mean = trial.mean - bulk * flow * g;
    const double size = trial.size - shear * g;
    if (mean <= top && size >= 0) return {mean, size};
  }
  if (trial.size + eta * top <= limit) return {std::min(trial.mean, top), trial.size};
  return {top, std::max(0.0, limit - eta * top)};
}

/// With the given out-of-plane strain, in plane strain and plane stress.
PointResponse respond_in_space(const DruckerPrager& law, const PlaneVector& strain, double across,
                               const PlasticMemory& before) {
  const double shear = law.young / (2 * (1 + law.poisson)), lambda = 2 * shear * law.poisson / (1 - 2 * law.poisson);
  const double bulk = lambda + 2 * shear / 3;
  const double x = strain[0] - before.xx, y = strain[1] - before.yy, z = across - before.zz, xy = strain[2] - before.xy;
  const double volume = lambda * (x + y + z);
  const Stress trial{volume + 2 * shear * x, volume + 2 * shear * y, volume + 2 * shear * z, shear * xy};
  const Deviator d(trial);
  PointResponse out{trial, before, 0, 0};
  std::array<double, 4> grown{};
  if (law.excess(trial) > 1e-13 * (std::abs(d.mean) + d.size)) {
    const Returned r = return_to_cone(law, d);
    const double share = d.size > 0 ? r.size / d.size : 0, gone = 1 - share;
    // The plastic strain is the stress reduction divided by the stiffness: a third of the volume strain on each axis,
    // the deviator by 2 G.
    const double swell = (d.mean - r.mean) / bulk / 3;
    grown = {swell + gone * d.xx / (2 * shear), swell + gone * d.yy / (2 * shear), swell + gone * d.zz / (2 * shear),
             gone * d.xy / shear};
    out.stress = {r.mean + share * d.xx, r.mean + share * d.yy, r.mean + share * d.zz, share * d.xy};
    const double norm2 = grown[0] * grown[0] + grown[1] * grown[1] + grown[2] * grown[2] + 0.5 * grown[3] * grown[3];
    out.memory = {before.xx + grown[0], before.yy + grown[1], before.zz + grown[2], before.xy + grown[3],
                  before.measure + std::sqrt(2.0 / 3 * norm2)};
  }
  const Stress& s = out.stress;
  out.stored = 0.5 * (s.xx * (x - grown[0]) + s.yy * (y - grown[1]) + s.zz * (z - grown[2]) + s.xy * (xy - grown[3]));
  out.dissipated = std::max(0.0, s.xx * grown[0] + s.yy * grown[1] + s.zz * grown[2] + s.xy * grown[3]);
  return out;
}

/// The out-of-plane strain with zero out-of-plane stress. The stress increases with it, so a bracket is bisected or
/// cut.
PointResponse respond_without_stress_across(const DruckerPrager& law, const PlaneVector& strain,
                                            const PlasticMemory& before) {
  const double x = strain[0] - before.xx, y = strain[1] - before.yy, xy = strain[2] - before.xy;
  const double size = std::abs(x) + std::abs(y) + std::abs(xy);
  // Elastic: zero out-of-plane stress.
  const double guess = before.zz - law.poisson / (1 - law.poisson) * (x + y);
  PointResponse out = respond_in_space(law, strain, guess, before);
  const double enough = 1e-13 * law.young * size;
  if (std::abs(out.stress.zz) <= enough) return out;
  double low = guess, high = guess, f_low = out.stress.zz, f_high = out.stress.zz;
  for (double reach = size; f_low > 0 && reach < 1e3 * size; reach *= 2)
    low = guess - reach, f_low = respond_in_space(law, strain, low, before).stress.zz;
  for (double reach = size; f_high < 0 && reach < 1e3 * size; reach *= 2)
    high = guess + reach, f_high = respond_in_space(law, strain, high, before).stress.zz;
  for (int i = 0; i < 100; ++i) {
    // False position, and every third time bisection, so that the bracket shrinks from both sides.
    const bool halve = i % 3 == 2 || !(f_high > f_low);
    const double at = halve ? 0.5 * (low + high) : low - f_low * (high - low) / (f_high - f_low);
    out = respond_in_space(law, strain, at, before);
    if (std::abs(out.stress.zz) <= enough || high - low <= 1e-16 * size) break;
    (out.stress.zz > 0 ? high : low) = at;
    (out.stress.zz > 0 ? f_high : f_low) = out.stress.zz;
  }
  return out;
}

}  // namespace

void DruckerPrager::check() const {
  if (dilation > friction)
    throw InputError(fmt::format("drucker_prager: dilation_angle is {:g} rad, must be at most friction_angle, {:g} rad",
                                 dilation, friction));
  if (cohesion == 0 && friction == 0)
    throw InputError("drucker_prager: cohesion and friction are both 0, which leaves no strength; give one of them");
}

double DruckerPrager::excess(const Stress& stress) const {
  const Deviator d(stress);
  const Cone cone(friction);
  return std::max(d.size + cone.slope * d.mean - cone.share * cohesion, d.mean - tension);
}

PointResponse DruckerPrager::respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const {
  if (plane == Plane::strain) return respond_in_space(*this, strain, 0, before);
  PointResponse out = respond_without_stress_across(*this, strain, before);
  out.stress.zz = 0;
  return out;
}

}  // namespace trilith
