#include "element/beam/hinge_flow_3d.hpp"

namespace trilith {
namespace {

/// A hinge that loses its capacity within a step keeps this share of its moment until the next step.
constexpr double least_kept = 1e-9;

double power(double base, double exponent) {
  if (exponent == 1) return base;
  if (exponent == 0) return 1;
  return base > 0 ? portable::pow(base, exponent) : 0;
}

/// b of the support function.
double dual_of(double contour) {
  return contour == 2 ? 2 : contour / (contour - 1);
}

/// d D / d reach [1/rad].
double kept_slope(const SpaceHinge& hinge, double reach) {
  const HingeLaw& law = *hinge.law;
  if (reach <= law.cap() || !(law.softening > 0) || law.kept(reach) <= law.residual) return 0;
  if (hinge.worn * law.kept(reach) <= least_kept) return 0;
  return -hinge.worn * (1 - law.residual) / law.softening;
}

/// Support function of the surface with the widths `width` in direction n.
struct Support {
  double h;                     ///< [N m]
  Eigen::Vector2d point;        ///< sigma
  Eigen::Vector2d point_turn;   ///< derivative by the angle of n
  Eigen::Vector2d point_width;  ///< derivative by the reach, at which widths grow by `growth`
  double h_width;
};

/// With u_i = W_i |n_i| / h:  sigma_i = W_i u_i^(b - 1), d log sigma_i = b d log W_i + (b - 1)(d log |n_i| - d log h).
Support support_of(const Eigen::Vector2d& width, const Eigen::Vector2d& growth, const Eigen::Vector2d& n, double b) {
  Support s;
  const Eigen::Vector2d reach = width.cwiseProduct(n.cwiseAbs());
  const double most = reach.maxCoeff();
  s.h = b == 2 ? most * std::sqrt((reach / most).squaredNorm())
               : most * power(power(reach[0] / most, b) + power(reach[1] / most, b), 1 / b);
  const Eigen::Vector2d turn(-n[1], n[0]);
  Eigen::Vector2d less;  // W_i^2 u_i^(b - 2) / h
  double grown = 0;      // d log h
  for (const int i : {0, 1}) {
    const double u = reach[i] / s.h, low = power(u, b - 2);
    s.point[i] = std::copysign(width[i] * u * low, n[i]);
    less[i] = width[i] * width[i] * low / s.h;
    grown += low * u * u * growth[i] / width[i];
  }
  const double turned = s.point.dot(turn) / s.h;
  for (const int i : {0, 1}) {
    s.point_turn[i] = (b - 1) * (less[i] * turn[i] - s.point[i] * turned);
    s.point_width[i] = s.point[i] * (b * growth[i] / width[i] - (b - 1) * grown);
  }
  s.h_width = s.h * grown;
  return s;
}

}  // namespace

Eigen::Vector2d SpaceHinge::back(const Eigen::Vector2d& p) const {
  const double size = portable::hypot(p[0], p[1]), cap = law->cap();
  return law->moving() * (size > cap ? cap / size : 1.0) * p;
}

Eigen::Vector2d SpaceHinge::width(const Eigen::Vector2d& way, double far) const {
  const double grown = law->isotropic * law->hardening * std::min(far, law->cap());
  return {law->across / scale + scale * grown, law->yield(way[1] < 0 ? -1 : 1) + grown};
}

double SpaceHinge::kept(double far) const {
  return std::max(least_kept, worn * law->kept(far));
}

double gauge(const SpaceHinge& hinge, const Eigen::Vector2d& moment, double share) {
  const double kept = hinge.kept(hinge.reach);
  const Eigen::Vector2d from = moment - kept * hinge.back(hinge.from);
  const Eigen::Vector2d over = from.cwiseAbs().cwiseQuotient(kept * hinge.width(from, hinge.reach));
  const double a = hinge.law->contour, most = over.maxCoeff();
  if (!(most > 0)) return 0;
  const double size = a == 2 ? over.norm() : most * power(power(over[0] / most, a) + power(over[1] / most, a), 1 / a);
  return share > 0 ? size / share : unbounded;
}

Eigen::Vector2d normal_at(const SpaceHinge& hinge, const Eigen::Vector2d& moment) {
  const Eigen::Vector2d from = moment - hinge.kept(hinge.reach) * hinge.back(hinge.from);
  const Eigen::Vector2d width = hinge.width(from, hinge.reach);
  const Eigen::Vector2d over = from.cwiseAbs().cwiseQuotient(width);
  const double most = over.maxCoeff(), a = hinge.law->contour;
  if (!(most > 0)) return Eigen::Vector2d::UnitY();
  Eigen::Vector2d n;
  for (const int i : {0, 1}) n[i] = std::copysign(power(over[i] / most, a - 1) / width[i], from[i]);
  return n.normalized();
}

/// If the reach grows with p, D and the widths change too.
SpaceFlow flow_along(const SpaceHinge& hinge, const Eigen::Vector2d& way, double length, double share) {
  SpaceFlow f;
  f.way = way, f.length = length, f.p = hinge.from + length * way;
  if (hinge.gone) return f;
  const Eigen::Vector2d turn(-way[1], way[0]);
  f.p_by << way, length * turn;
  const HingeLaw& law = *hinge.law;
  const double size = portable::hypot(f.p[0], f.p[1]), reach = std::max(hinge.reach, size), cap = law.cap();
  Eigen::RowVector2d reach_by = Eigen::RowVector2d::Zero();
  if (size > hinge.reach) reach_by = f.p.transpose() * f.p_by / size;
  const double grows = reach < cap ? law.isotropic * law.hardening : 0;
  const Eigen::Vector2d growth(hinge.scale * grows, grows);
  const Support s = support_of(hinge.width(way, reach), growth, way, dual_of(law.contour));
  const double kept = hinge.kept(reach);
  const Eigen::Vector2d back = hinge.back(f.p);
  Eigen::Matrix2d back_by = law.moving() * (size > cap ? cap / size : 1.0) * f.p_by;
  if (size > cap) back_by -= back / (size * size) * (f.p.transpose() * f.p_by);
  Eigen::Matrix2d point_by = s.point_width * reach_by;
  point_by.col(1) += s.point_turn;
  f.outward = kept * s.point;
  f.most = kept * back + share * f.outward;
  const Eigen::RowVector2d kept_by = kept_slope(hinge, reach) * reach_by;
  f.most_by = (back + share * s.point) * kept_by + kept * (back_by + share * point_by);
  f.work = kept * s.h * length;
  Eigen::RowVector2d h_by = s.h_width * reach_by;
  h_by[1] += s.point.dot(turn);
  f.work_by = length * (s.h * kept_by + kept * h_by);
  f.work_by[0] += kept * s.h;
  return f;
}

}  // namespace trilith
