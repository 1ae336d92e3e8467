#include "law/material/mohr_coulomb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/portable.hpp"
#include "law/material/principal_return.hpp"

namespace trilith {
namespace {

/// In-plane principal values, the larger first, zz last; and the direction of the first as cosine and sine of its
/// double angle.
struct Principal {
  Eigen::Vector3d value;
  double c2, s2;
  explicit Principal(const Stress& s) {
    const double half = 0.5 * (s.xx - s.yy), radius = portable::hypot(half, s.xy), middle = 0.5 * (s.xx + s.yy);
    value = {middle + radius, middle - radius, s.zz};
    c2 = radius > 0 ? half / radius : 1;
    s2 = radius > 0 ? s.xy / radius : 0;
  }
};

/// (1 + sin) s_i - (1 - sin) s_j <= 2 cohesion cos, with flow by the dilation angle.
YieldPlane shear_plane(const MohrCoulomb& law, int i, int j) {
  const auto [sine, cosine] = portable::sine_cosine(law.friction);
  const double flow = portable::sin(law.dilation);
  YieldPlane p{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 2 * law.cohesion * cosine};
  p.normal[i] = 1 + sine, p.normal[j] = -(1 - sine);
  p.flow[i] = 1 + flow, p.flow[j] = -(1 - flow);
  return p;
}

YieldPlane cut_off_plane(double tension, int i) {
  YieldPlane p{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), tension};
  p.normal[i] = p.flow[i] = 1;
  return p;
}

/// Yield planes for all pairs of principal stresses; the planes that the trial state probably violates come first. In
/// plane stress there is no out-of-plane cut-off, because that stress is 0.
std::vector<YieldPlane> planes_at(const MohrCoulomb& law, Plane plane, const Eigen::Vector3d& trial) {
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return trial[i] > trial[j]; });
  const auto [most, middle, least] = order;
  std::vector<YieldPlane> planes{shear_plane(law, most, least), shear_plane(law, most, middle),
                                 shear_plane(law, middle, least)};
  for (const int i : order)
    if (i != 2 || plane == Plane::strain) planes.push_back(cut_off_plane(law.tension, i));
  planes.push_back(shear_plane(law, middle, most));
  planes.push_back(shear_plane(law, least, middle));
  planes.push_back(shear_plane(law, least, most));
  return planes;
}

Eigen::Matrix3d principal_stiffness(const MohrCoulomb& law, Plane plane) {
  if (plane == Plane::stress) {
    Eigen::Matrix3d d = elastic_matrix(law.young, law.poisson, plane);
    d(2, 2) = 0;  // the stress is always 0
    return d;
  }
  const double shear = law.young / (2 * (1 + law.poisson)), lambda = 2 * shear * law.poisson / (1 - 2 * law.poisson);
  return 2 * shear * Eigen::Matrix3d::Identity() + lambda * Eigen::Matrix3d::Ones();
}

/// All principal stresses at the apex of the surface, if no set of planes gives a solution. The plastic strain is the
/// elastic compliance times the difference between trial stress and apex.
Eigen::Vector3d plastic_to_tip(const MohrCoulomb& law, Plane plane, const Eigen::Vector3d& trial) {
  const double tip = law.friction > 0 ? std::min(law.tension, law.cohesion / portable::tan(law.friction)) : law.tension;
  Eigen::Vector3d over = trial - Eigen::Vector3d::Constant(tip);
  if (plane == Plane::stress) over[2] = 0;
  const double p = law.poisson;
  Eigen::Matrix3d compliance;
  compliance << 1, -p, -p, -p, 1, -p, -p, -p, 1;
  return compliance * over / law.young;
}

/// Rotates the growth of principal plastic strains back into the axes.
PointResponse flown(const MohrCoulomb& law, Plane plane, const PlaneVector& strain, const PlasticMemory& before,
                    const Principal& axes, const Eigen::Vector3d& plastic) {
  // Rotation by the double angle: the first principal axis has (c2, s2); xy is engineering.
  const double middle = 0.5 * (plastic[0] + plastic[1]), half = 0.5 * (plastic[0] - plastic[1]);
  const double x = middle + half * axes.c2, y = middle - half * axes.c2, xy = 2 * half * axes.s2;
  PointResponse out;
  out.memory = {before.xx + x, before.yy + y, before.zz + plastic[2], before.xy + xy,
                before.measure + std::sqrt(2.0 / 3 * plastic.squaredNorm())};
  const PlaneVector elastic = strain - PlaneVector(out.memory.xx, out.memory.yy, out.memory.xy);
  out.stress = elastic_stress(law.young, law.poisson, plane, elastic, out.memory.zz);
  const Stress& s = out.stress;
  out.stored = 0.5 * (s.in_plane().dot(elastic) - s.zz * out.memory.zz);
  out.dissipated = std::max(0.0, s.xx * x + s.yy * y + s.zz * plastic[2] + s.xy * xy);
  return out;
}

}  // namespace

void MohrCoulomb::check() const {
  // Flow with more dilation than friction would create energy.
  if (dilation > friction)
    throw InputError(fmt::format("mohr_coulomb: dilation_angle is {:g} rad, must be at most friction_angle, {:g} rad",
                                 dilation, friction));
  if (cohesion == 0 && friction == 0)
    throw InputError("mohr_coulomb: cohesion and friction are both 0, which leaves no strength; give one of them");
}

double MohrCoulomb::excess(const Stress& stress) const {
  const Eigen::Vector3d s = Principal(stress).value;
  const double most = s.maxCoeff(), least = s.minCoeff();
  const auto [sine, cosine] = portable::sine_cosine(friction);
  return std::max(most - least + (most + least) * sine - 2 * cohesion * cosine, most - tension);
}

/// Trial stress, its principal values, return to the planes, and rotation back to the trial's axes. With isotropic
/// elasticity these are also the principal axes of the result.
PointResponse MohrCoulomb::respond(Plane plane, const PlaneVector& strain, const PlasticMemory& before) const {
  const PlaneVector elastic = strain - PlaneVector(before.xx, before.yy, before.xy);
  const Stress trial = elastic_stress(young, poisson, plane, elastic, before.zz);
  const Principal axes(trial);
  if (excess(trial) <= 1e-12 * axes.value.cwiseAbs().maxCoeff())
    return flown(*this, plane, strain, before, axes, Eigen::Vector3d::Zero());
  const std::vector<YieldPlane> planes = planes_at(*this, plane, axes.value);
  const PrincipalReturn r = return_to_planes(axes.value, principal_stiffness(*this, plane), planes, cohesion);
  return flown(*this, plane, strain, before, axes, r.found ? r.plastic : plastic_to_tip(*this, plane, axes.value));
}

}  // namespace trilith
