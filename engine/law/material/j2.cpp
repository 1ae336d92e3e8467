#include "law/material/j2.hpp"

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

double mises(const Stress& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3, x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  return std::sqrt(1.5 * (x * x + y * y + z * z + 2 * s.xy * s.xy));
}

/// Adds `flow` (xy engineering) to the plastic strain and `measure` to the equivalent plastic strain.
PointResponse flown(const J2& law, Plane plane, const PlaneVector& strain, const PlasticMemory& before,
                    const std::array<double, 4>& flow, double measure) {
  PointResponse out;
  out.memory = {before.xx + flow[0], before.yy + flow[1], before.zz + flow[2], before.xy + flow[3],
                before.measure + measure};
  const PlaneVector elastic = strain - PlaneVector(out.memory.xx, out.memory.yy, out.memory.xy);
  out.stress = elastic_stress(law.young, law.poisson, plane, elastic, out.memory.zz);
  const Stress& s = out.stress;
  out.stored = 0.5 * (s.in_plane().dot(elastic) - s.zz * out.memory.zz);
  out.dissipated = std::max(0.0, s.xx * flow[0] + s.yy * flow[1] + s.zz * flow[2] + s.xy * flow[3]);
  return out;
}

/// Radial return: the deviator shrinks along its direction.
PointResponse return_in_strain(const J2& law, const PlaneVector& strain, const PlasticMemory& before,
                               const Stress& trial) {
  const double shear = law.young / (2 * (1 + law.poisson)), size = mises(trial);
  const double measure = law.excess(trial, before.measure) / (3 * shear + law.hardening);
  const double mean = (trial.xx + trial.yy + trial.zz) / 3, share = 1.5 * measure / size;
  return flown(law, Plane::strain, strain, before,
               {share * (trial.xx - mean), share * (trial.yy - mean), share * (trial.zz - mean), 2 * share * trial.xy},
               measure);
}

/// Plane stress. With a = (sxx + syy)/sqrt(2), b = (syy - sxx)/sqrt(2) and sxy the elastic and the plastic matrix are
/// diagonal, so each component shrinks by its own factor of the multiplier g. Plastic strain = g P s, f = s'Ps/2 -
/// k^2/3.
struct PlaneStressReturn {
  double a, b, c;           ///< trial values
  double slope_a, slope_b;  ///< E / (3 (1 - nu)), 2 G
  double yield, hardening, measure;

  struct At {
    double size2, slope;  ///< s'Ps = 2/3 of the squared Mises stress, and its derivative with respect to g
  };
  [[nodiscard]] At at(double g) const {
    const double fa = 1 / (1 + slope_a * g), fb = 1 / (1 + slope_b * g);
    const double pa = a * a * fa * fa / 3, pb = (b * b + 2 * c * c) * fb * fb;
    return {pa + pb, -2 * (pa * slope_a * fa + pb * slope_b * fb)};
  }
  /// Mises stress minus the yield stress; decreases with g.
  [[nodiscard]] double excess(double g, double& slope) const {
    const At p = at(g);
    const double size = std::sqrt(1.5 * p.size2), rate = 0.75 * p.slope / size;
    // de = g sqrt(2/3 s'Ps) = 2/3 g size
    slope = rate - hardening * 2 / 3 * (size + g * rate);
    return size - yield - hardening * (measure + 2.0 / 3 * g * size);
  }
  /// Newton's method within a bracket: the excess is convex and decreasing, so iterates approach from the left.
  [[nodiscard]] double solve() const {
    double g = 0, slope = 0;
    for (int i = 0; i < 60; ++i) {
      const double f = excess(g, slope);
      const double step = -f / slope;
      g = std::max(g + step, 0.0);
      if (std::abs(step) <= 1e-15 * g) break;
    }
    return g;
  }
};

PointResponse return_in_stress(const J2& law, const PlaneVector& strain, const PlasticMemory& before,
                               const Stress& trial) {
  const double half = std::sqrt(0.5), shear = law.young / (2 * (1 + law.poisson));
  const PlaneStressReturn r{half * (trial.xx + trial.yy),
                            half * (trial.yy - trial.xx),
                            trial.xy,
                            law.young / (3 * (1 - law.poisson)),
                            2 * shear,
                            law.yield,
                            law.hardening,
                            before.measure};
  // The plastic strain is g P s; its out-of-plane part conserves the volume.
  const double g = r.solve();
  const double fa = 1 / (1 + r.slope_a * g), fb = 1 / (1 + r.slope_b * g);
  const double a = r.a * fa, b = r.b * fb, xy = r.c * fb, xx = half * (a - b), yy = half * (a + b);
  const double x = g * (2 * xx - yy) / 3, y = g * (2 * yy - xx) / 3;
  return flown(law, Plane::stress, strain, before, {x, y, -x - y, 2 * g * xy}, 2.0 / 3 * g * mises({xx, yy, 0, xy}));
}

}  // namespace

double J2::excess(const Stress& stress, double measure) const {
  return mises(stress) - yield - hardening * measure;
}

PointResponse J2::respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const {
  const PointResponse elastic = flown(*this, plane, strain, before, {0, 0, 0, 0}, 0);
  if (excess(elastic.stress, before.measure) <= 1e-12 * yield) return elastic;
  return plane == Plane::strain ? return_in_strain(*this, strain, before, elastic.stress)
                                : return_in_stress(*this, strain, before, elastic.stress);
}

}  // namespace trilith
