#include "element/beam/beam_inertia.hpp"

namespace trilith {
namespace {

/// Rotation from world axes to the beam's axes.
BeamMatrix axes_of(const Vec2& along) {
  BeamMatrix t = BeamMatrix::Zero();
  for (const int end : {0, 3}) {
    t(end, end) = t(end + 1, end + 1) = along.x();
    t(end, end + 1) = along.y(), t(end + 1, end) = -along.y();
    t(end + 2, end + 2) = 1;
  }
  return t;
}

/// The velocities of the ends rotated by +90 degrees: their rate of change in rotating axes.
BeamVector left_of_ends(const BeamVector& y) {
  BeamVector out = BeamVector::Zero();
  for (const int end : {0, 3}) out[end] = -y[end + 1], out[end + 1] = y[end];
  return out;
}

/// The rotation of a pinned end of a cubic without moment there, from the motion of the ends.
BeamMatrix without_moments(double length, const std::array<bool, 2>& pinned) {
  BeamMatrix out = BeamMatrix::Identity();
  BeamVector chord = BeamVector::Zero();
  chord[1] = -1 / length, chord[4] = 1 / length;
  for (const int end : {0, 1}) {
    if (!pinned[end]) continue;
    const int own = 3 * end + 2, other = 5 - 3 * end;
    out.row(own) = pinned[1 - end] ? chord.transpose() : BeamVector(1.5 * chord).transpose();
    if (!pinned[1 - end]) out(own, other) = -0.5;
  }
  return out;
}

}  // namespace

BeamInertia beam_inertia(double mass, double length, const Section& section, const std::array<bool, 2>& pinned) {
  const double l = length, own = section.second_moment / section.area;
  Eigen::Matrix4d across, turn;
  across << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l,
      -3 * l * l, -22 * l, 4 * l * l;
  turn << 36, 3 * l, -36, 3 * l, 3 * l, 4 * l * l, -3 * l, -l * l, -36, -3 * l, 36, -3 * l, 3 * l, -l * l, -3 * l,
      4 * l * l;
  const Eigen::Matrix4d bending = mass / 420 * across + mass * own / (30 * l * l) * turn;
  constexpr std::array at{1, 2, 4, 5};
  BeamMatrix m = BeamMatrix::Zero();
  m(0, 0) = m(3, 3) = mass / 3, m(0, 3) = m(3, 0) = mass / 6;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) m(at[i], at[j]) = bending(i, j);
  const BeamMatrix condensed = without_moments(l, pinned);
  BeamInertia out;
  out.consistent = condensed.transpose() * m * condensed;
  return out;
}

BeamMatrix turned(const BeamMatrix& m, const Vec2& along) {
  const BeamMatrix axes = axes_of(along);
  return axes.transpose() * m * axes;
}

BeamVector inertia_forces(const BeamMatrix& m, const BeamMotion& motion) {
  const BeamMatrix axes = axes_of(motion.along);
  const Vec2 across = left_of(motion.along);
  const Vec2 apart = motion.rate.segment<2>(3) - motion.rate.segment<2>(0);
  const double turning = across.dot(apart) / motion.length;  // of the chord [rad/s]
  const BeamVector y = axes * motion.rate, momentum = m * y, left = left_of_ends(y);
  // d/dt of the momenta, which are given in rotating axes.
  const BeamVector rise = axes * motion.rise - turning * left;
  BeamVector force = axes.transpose() * (m * rise + turning * left_of_ends(momentum));
  // Minus the energy's derivative by the chord's rotation: dT/dbeta = -(m y) . left(y), where beta depends on the ends.
  const double gain = -momentum.dot(left);
  force.segment<2>(3) -= gain / motion.length * across;
  force.segment<2>(0) += gain / motion.length * across;
  return force;
}

}  // namespace trilith
