#include "element/beam/beam_element.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

#include "base/portable.hpp"

namespace trilith {

/// K from `near`, the moment of an end due to its own bend, and `far`, due to the other end's. If the other end is
/// pinned the stiffness is near - far^2 / near. `bow`: the terms of L q with theta_0^2, theta_0 theta_1 and theta_1^2.
BeamStiffness beam_stiffness(const BeamMaterial& material, const Section& section, double length,
                             const std::array<bool, 2>& pinned) {
  const double bending = material.young * section.second_moment;
  const double phi = material.shear > 0 ? 12 * bending / (material.shear * section.shear_area * length * length) : 0.0;
  const double near = (4 + phi) * bending / ((1 + phi) * length), far = (2 - phi) * bending / ((1 + phi) * length);
  BeamStiffness k;
  k.axial = material.young * section.area / length;
  if (pinned[0] && pinned[1]) return k;
  const double both = length / 15, one = length / 10;
  k.bow = {pinned[0]   ? 0
           : pinned[1] ? one
                       : both,
           pinned[0] || pinned[1] ? 0 : -length / 30,
           pinned[1]   ? 0
           : pinned[0] ? one
                       : both};
  const double alone = near - far * far / near;  // for an end whose other end is pinned: 3 EI / L without shear
  k.bend = {pinned[0]   ? 0
            : pinned[1] ? alone
                        : near,
            pinned[0] || pinned[1] ? 0 : far,
            pinned[1]   ? 0
            : pinned[0] ? alone
                        : near};
  return k;
}

namespace {

/// The angle reduced to within half a turn.
double within_half_turn(double angle) {
  return std::abs(angle) <= M_PI ? angle : std::remainder(angle, 2 * M_PI);
}

}  // namespace

/// theta_i = rotation_i - (present angle of the chord - angle_0); the spin of the chord is n . (v_1 - v_0) / l.
BeamNow::BeamNow(const BeamEnd& from, const BeamEnd& to, double length_0, double angle_0) {
  const Vec2 chord = to.place - from.place, speed = to.velocity - from.velocity;
  length = portable::hypot(chord.x(), chord.y());
  along = chord / length;
  const double turned = portable::atan2(chord.y(), chord.x()) - angle_0, spin = cross(along, speed) / length;
  // Rotations include full turns, the chord's angle does not, so the bend is reduced to within half a turn. The stretch
  // is computed as u = (l^2 - L^2) / (l + L), which keeps the digits of l - L where it is small.
  strain = {(chord.squaredNorm() - length_0 * length_0) / (length + length_0), within_half_turn(from.rotation - turned),
            within_half_turn(to.rotation - turned)};
  rate = {along.dot(speed), from.spin - spin, to.spin - spin};
}

/// The largest eigenvalue of J' K J, with J = d(u, theta_0, theta_1) / d(motion of both nodes), scaled by 1 / sqrt(m).
double beam_frequency2(const BeamStiffness& stiffness, double length, const std::array<Vec2, 2>& arm,
                       const std::array<double, 2>& mass, const std::array<double, 2>& inertia) {
  // Rows: stretch, bends; columns: x, y, rotation of either node, in the beam's axes.
  Eigen::Matrix<double, 3, 6> shape;
  const double per = 1 / length;
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? -1 : 1;
    const Vec2& r = arm[side];
    const double lift = sign * r.x() * per;                   // rotation of the chord for a unit rotation of the node
    shape.middleCols<3>(3 * side) << sign, 0, -sign * r.y(),  //
        0, -sign * per, (side == 0 ? 1 : 0) - lift,           //
        0, -sign * per, (side == 1 ? 1 : 0) - lift;
    for (int k = 0; k < 3; ++k) shape.col(3 * side + k) /= std::sqrt(k < 2 ? mass[side] : inertia[side]);
  }
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  k(0, 0) = stiffness.axial;
  k(1, 1) = stiffness.bend[0], k(1, 2) = k(2, 1) = stiffness.bend[1], k(2, 2) = stiffness.bend[2];
  const Eigen::Matrix<double, 6, 6> scaled = shape.transpose() * k * shape;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[5];
}

}  // namespace trilith
