#include "element/beam/beam_inertia_3d.hpp"

namespace trilith {
namespace {

/// The matrix [w]: v -> w x v.
Eigen::Matrix3d turning(const Vec3& w) {
  Eigen::Matrix3d out;
  out << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return out;
}

/// Rows of A; b of a pinned end is that in a cubic without moment there.
Eigen::Matrix4d without_moments_across(double length, const std::array<bool, 2>& pinned) {
  Eigen::Matrix4d out = Eigen::Matrix4d::Identity();
  const Eigen::RowVector4d chord(-1 / length, 0, 1 / length, 0);
  for (const int end : {0, 1}) {
    if (!pinned[static_cast<std::size_t>(end)]) continue;
    const bool both = pinned[static_cast<std::size_t>(1 - end)];
    const int own = 1 + 2 * end, other = 3 - 2 * end;
    out.row(own) = both ? chord : Eigen::RowVector4d(1.5 * chord);
    if (!both) out(own, other) = -0.5;
  }
  return out;
}

/// Momenta of the velocities f of both ends along the chord.
Eigen::Vector2d momentum_along(double mass, const Eigen::Vector2d& f) {
  return mass / 6 * Eigen::Vector2d(2 * f[0] + f[1], f[0] + 2 * f[1]);
}

}  // namespace

BeamInertia3 beam_inertia_in_space(double mass, double length, const std::array<bool, 2>& pinned) {
  const double l = length;
  Eigen::Matrix4d across;
  across << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l,
      -3 * l * l, -22 * l, 4 * l * l;
  const Eigen::Matrix4d condensed = without_moments_across(l, pinned);
  return {mass, mass / 420 * (condensed.transpose() * across * condensed)};
}

/// Columns of A by the motion: P = 1 - e e' for v, and w x e = -[e] w.
BeamMatrix3 mass_in_space(const BeamInertia3& inertia, const Vec3& along) {
  const Eigen::Matrix3d e = along * along.transpose();
  const std::array<Eigen::Matrix3d, 2> shape{Eigen::Matrix3d::Identity() - e, -turning(along)};
  BeamMatrix3 out;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      out.block<3, 3>(3 * i, 3 * j) = inertia.across(i, j) * (shape[static_cast<std::size_t>(i % 2)].transpose() *
                                                              shape[static_cast<std::size_t>(j % 2)]);
  for (const int i : {0, 1})
    for (const int j : {0, 1}) out.block<3, 3>(6 * i, 6 * j) += inertia.mass / (i == j ? 3 : 6) * e;
  return out;
}

/// With the longitudinal momenta r and the transverse ones Q = m A, both normal to e:
///   dT/dv = r e + Q_a,   dT/dw = e x Q_b,   dT/de = sum of r v - f Q_a + Q_b x w,   e' = (v_1 - v_0) across / l.
BeamVector3 inertia_forces(const BeamInertia3& inertia, const BeamMotion3& motion) {
  using Vectors = Eigen::Matrix<double, 3, 4>;
  const Vec3& e = motion.along;
  const auto part = [](const BeamVector3& v, int i) { return Vec3(v.segment<3>(3 * i)); };
  const auto across = [&](const Vec3& v) { return Vec3(v - e.dot(v) * e); };
  const Vec3 turned = across(part(motion.rate, 2) - part(motion.rate, 0)) / motion.length;  // e'
  Eigen::Vector2d speed, speed_rate;
  Vectors a, a_rate;
  for (const int i : {0, 1}) {
    const Vec3 v = part(motion.rate, 2 * i), w = part(motion.rate, 2 * i + 1), rise = part(motion.rise, 2 * i);
    speed[i] = e.dot(v), speed_rate[i] = e.dot(rise) + turned.dot(v);
    a.col(2 * i) = v - speed[i] * e, a_rate.col(2 * i) = rise - speed_rate[i] * e - speed[i] * turned;
    a.col(2 * i + 1) = cross(w, e);
    a_rate.col(2 * i + 1) = cross(part(motion.rise, 2 * i + 1), e) + cross(w, turned);
  }
  const Eigen::Vector2d r = momentum_along(inertia.mass, speed), r_rate = momentum_along(inertia.mass, speed_rate);
  const Vectors q = a * inertia.across, q_rate = a_rate * inertia.across;
  Vec3 by_chord = Vec3::Zero();
  BeamVector3 out;
  for (const int i : {0, 1}) {
    const Vec3 v = part(motion.rate, 2 * i), w = part(motion.rate, 2 * i + 1);
    const Vec3 across_i = q.col(2 * i), slope_i = q.col(2 * i + 1);
    by_chord += r[i] * v - speed[i] * across_i + cross(slope_i, w);
    out.segment<3>(6 * i) = r_rate[i] * e + r[i] * turned + q_rate.col(2 * i);
    out.segment<3>(6 * i + 3) =
        cross(turned, slope_i) + cross(e, Vec3(q_rate.col(2 * i + 1))) - cross(w, cross(e, slope_i));
  }
  const Vec3 gain = across(by_chord) / motion.length;
  out.segment<3>(6) -= gain, out.segment<3>(0) += gain;
  return out;
}

}  // namespace trilith
