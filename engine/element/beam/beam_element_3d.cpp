#include "element/beam/beam_element_3d.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// Angle over sine, and (1 - cosine angle / sine) / sine^2, of an angle given by both. Below a sine of 0.05 the
/// quotients lose digits, so their series in the squared sine is used; its next terms are below 1e-16.
std::array<double, 2> angle_over_sine(double sine, double cosine) {
  if (cosine > 0 && sine < 0.05) {
    const double s = sine * sine;
    return {1 + s * (1.0 / 6 + s * (3.0 / 40 + s * (5.0 / 112 + s * (35.0 / 1152 + s * (63.0 / 2816))))),
            1.0 / 3 + s * (2.0 / 15 + s * (8.0 / 105 + s * (16.0 / 315 + s * (128.0 / 3465 + s * (256.0 / 9009)))))};
  }
  const double factor = portable::atan2(sine, cosine) / sine;
  return {factor, (1 - factor * cosine) / (sine * sine)};
}

/// v, normal to `axis`, rotated by the shortest rotation that moves `axis` to `along`.
Vec3 transported(const Vec3& v, const Vec3& axis, const Vec3& along) {
  return v - along.dot(v) / (1 + along.dot(axis)) * (axis + along);
}

Section plane_section(const Section3& s, std::size_t about) {
  return {s.area, s.second_moment[about], s.shear_area[about], 0, 0};
}

}  // namespace

BeamStiffness3 beam_stiffness_in_space(const BeamMaterial3& material, const Section3& section, double length,
                                       const std::array<bool, 2>& pinned) {
  BeamStiffness3 k;
  k.axial = material.young * section.area / length;
  k.torsion = material.shear * section.torsion / length;
  for (const std::size_t about : {0, 1})
    k.bend[about] = beam_stiffness(BeamMaterial{material.young, material.shears ? material.shear : 0.0},
                                   plane_section(section, about), length, pinned);
  return k;
}

/// theta = f (0, e_3, -e_2) in the axes of the section, where f is the angle between e and t_1 over its sine.
BeamNow3::Bend BeamNow3::bend_of(const Turn3& axes) const {
  Bend b;
  b.chord = axes.undo(along_);
  const auto [factor, fall] = angle_over_sine(portable::hypot(b.chord.y(), b.chord.z()), b.chord.x());
  b.factor = factor, b.slope = -fall;
  b.angle = {factor * b.chord.z(), -factor * b.chord.y()};
  b.lever = (axes.x() + along_) / (1 + b.chord.x());
  return b;
}

/// `spin`: spin of the section relative to the chord; in the section's axes e rotates backwards by it.
std::array<double, 2> BeamNow3::bend_rate(const Bend& bend, const Turn3& axes, const Vec3& spin) const {
  const Vec3 rate = axes.undo(cross(along_, spin));
  const double grown = bend.slope * rate.x();
  return {bend.factor * rate.z() + grown * bend.chord.z(), -bend.factor * rate.y() - grown * bend.chord.y()};
}

/// The transpose of bend_rate: the gradient with respect to e in the section's axes, then its moment about the section.
Vec3 BeamNow3::bend_moment(const Bend& bend, const Turn3& axes, const std::array<double, 2>& moment) const {
  const Vec3 gradient(bend.slope * (moment[0] * bend.chord.z() - moment[1] * bend.chord.y()), -bend.factor * moment[1],
                      bend.factor * moment[0]);
  return cross(axes.apply(gradient), along_);
}

/// Input: positions, axes and their rates. Output: strains and their rates, in axes midway between the sections.
BeamNow3::BeamNow3(const BeamEnd3& from, const BeamEnd3& to, double length_0) : axes_{from.axes, to.axes} {
  const Vec3 chord = to.place - from.place, speed = to.velocity - from.velocity;
  length_ = chord.norm();
  along_ = chord / length_;
  bend_ = {bend_of(from.axes), bend_of(to.axes)};
  const Vec3 y0 = transported(from.axes.y(), from.axes.x(), along_), z0 = cross(along_, y0),
             y1 = transported(to.axes.y(), to.axes.x(), along_);
  const double twist = portable::atan2(y1.dot(z0), y1.dot(y0));
  const Vec3 spin = cross(along_, speed) / length_;
  const std::array<Vec3, 2> relative{Vec3(from.spin - spin), Vec3(to.spin - spin)};
  const double twist_rate = bend_[1].lever.dot(relative[1]) - bend_[0].lever.dot(relative[0]);
  const auto half = portable::sine_cosine(0.5 * twist);
  cosine_ = half.cosine, sine_ = half.sine;
  // u = (l^2 - L^2) / (l + L) keeps the digits of l - L where the stretch is small.
  strain_[0] = (chord.squaredNorm() - length_0 * length_0) / (length_ + length_0);
  rate_[0] = along_.dot(speed);
  strain_[5] = twist, rate_[5] = twist_rate;
  for (const std::size_t end : {0, 1}) {
    const double s = end == 0 ? sine_ : -sine_, turning = (end == 0 ? 0.5 : -0.5) * twist_rate;
    const auto& own = bend_[end].angle;
    const std::array<double, 2> grows = bend_rate(bend_[end], axes_[end], relative[end]);
    const std::size_t k = 1 + 2 * end;
    strain_[k] = cosine_ * own[0] + s * own[1], strain_[k + 1] = cosine_ * own[1] - s * own[0];
    rate_[k] = cosine_ * grows[0] + s * grows[1] + turning * strain_[k + 1];
    rate_[k + 1] = cosine_ * grows[1] - s * grows[0] - turning * strain_[k];
  }
}

/// The actions have the power of the stress for any rates. Moments are transposed through the steps of the constructor,
/// and a couple that rotates the chord is a pair of forces at its ends.
BeamAction3 BeamNow3::action(const BeamStress3& stress) const {
  double torque = stress[5];
  for (const std::size_t end : {0, 1}) {
    const std::size_t k = 1 + 2 * end;
    torque += (end == 0 ? 0.5 : -0.5) * (stress[k] * strain_[k + 1] - stress[k + 1] * strain_[k]);
  }
  std::array<Vec3, 2> gradient;
  for (const std::size_t end : {0, 1}) {
    const double s = end == 0 ? sine_ : -sine_;
    const std::size_t k = 1 + 2 * end;
    gradient[end] = bend_moment(bend_[end], axes_[end],
                                {cosine_ * stress[k] - s * stress[k + 1], s * stress[k] + cosine_ * stress[k + 1]}) +
                    (end == 0 ? -torque : torque) * bend_[end].lever;
  }
  BeamAction3 out;
  out.force = stress[0] * along_ - cross(Vec3(gradient[0] + gradient[1]), along_) / length_;
  out.moment = {-gradient[0], -gradient[1]};
  return out;
}

namespace {

/// The bends of a beam in one of its planes, as a plane beam has them.
BeamStrain in_plane(const BeamStrain3& d, std::size_t about) {
  return {d[0], d[1 + about], d[3 + about]};
}

}  // namespace

BeamStress3 linear_stress(const BeamStiffness3& k, const BeamStrain3& d) {
  BeamStress3 s;
  s[0] = k.axial * d[0], s[5] = k.torsion * d[5];
  for (const std::size_t about : {0, 1}) {
    const BeamStress m = linear_stress(k.bend[about], in_plane(d, about));
    s[1 + about] = m[1], s[3 + about] = m[2];
  }
  return s;
}

BeamStress3 stress_of(const BeamStiffness3& k, const BeamStrain3& d) {
  BeamStress3 s = linear_stress(k, d);
  const BeamStrain y = in_plane(d, 0), z = in_plane(d, 1);
  s[0] = k.axial * (bowed_stretch(k.bend[0], y) + bowed_stretch(k.bend[1], z) - d[0]);
  for (const std::size_t about : {0, 1}) {
    const BeamStrain& t = about == 0 ? y : z;
    const auto& bow = k.bend[about].bow;
    s[1 + about] += s[0] * (2 * bow[0] * t[1] + bow[1] * t[2]);
    s[3 + about] += s[0] * (2 * bow[2] * t[2] + bow[1] * t[1]);
  }
  return s;
}

double stored_in(const BeamStiffness3& k, const BeamStrain3& d) {
  const double stretch = bowed_stretch(k.bend[0], in_plane(d, 0)) + bowed_stretch(k.bend[1], in_plane(d, 1)) - d[0];
  double sum = k.axial * stretch * stretch + k.torsion * d[5] * d[5];
  for (const std::size_t about : {0, 1}) {
    const auto& bend = k.bend[about].bend;
    const double a = d[1 + about], b = d[3 + about];
    sum += bend[0] * a * a + 2 * bend[1] * a * b + bend[2] * b * b;
  }
  return 0.5 * sum;
}

/// The largest eigenvalue of J' K J, scaled by 1 / sqrt(m), with J the strain rates due to the motion of both nodes in
/// the undeformed state. Columns: x, y, z, rotations about x, y, z of end 0, then of end 1.
double beam_frequency2(const BeamStiffness3& stiffness, double length, double mass, const Vec3& inertia,
                       const std::array<Vec3, 2>& arm) {
  Eigen::Matrix<double, 6, 12> shape = Eigen::Matrix<double, 6, 12>::Zero();
  for (const int end : {0, 1}) {
    const double sign = end == 0 ? -1 : 1;
    const int c = 6 * end;
    shape(0, c) = sign, shape(5, c + 3) = sign;
    for (const int row : {1, 3}) shape(row, c + 2) = sign / length, shape(row + 1, c + 1) = -sign / length;
    shape(1 + 2 * end, c + 4) = 1, shape(2 + 2 * end, c + 5) = 1;
    const Vec3& a = arm[static_cast<std::size_t>(end)];
    if (a != Vec3(0, 0, 0)) {
      // A rotation w moves the end by w x a.
      for (int k = 0; k < 3; ++k) shape.col(c + 3 + k) += shape.middleCols<3>(c) * cross(Vec3::Unit(k), a);
      const Eigen::Matrix3d tensor = inertia_at(mass, a) + Eigen::Matrix3d(inertia.asDiagonal());
      const Eigen::Matrix3d root = tensor.llt().matrixL();
      shape.middleCols<3>(c + 3) = (shape.middleCols<3>(c + 3) * root.transpose().inverse()).eval();
      shape.middleCols<3>(c) /= std::sqrt(mass);
      continue;
    }
    for (int k = 0; k < 6; ++k) shape.col(c + k) /= std::sqrt(k < 3 ? mass : inertia[k - 3]);
  }
  Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 6; ++i) {
    BeamStrain3 one{};
    one[static_cast<std::size_t>(i)] = 1;
    const BeamStress3 s = linear_stress(stiffness, one);
    for (int j = 0; j < 6; ++j) k(j, i) = s[static_cast<std::size_t>(j)];
  }
  const Eigen::Matrix<double, 12, 12> scaled = shape.transpose() * k * shape;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[11];
}

Eigen::Matrix3d inertia_at(double mass, const Vec3& arm) {
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

}  // namespace trilith
