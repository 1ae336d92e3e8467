#include "element/rigid/rigid_turn.hpp"

#include <Eigen/LU>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {
namespace {

/// Rotation of the body about its axis k: updates the orientation, and rotates its momentum in body axes backwards.
void turn_about(int k, const Vec3& inertia, double dt, UnitQuaternion& rotation, Vec3& own) {
  const double angle = dt * own[k] / inertia[k];
  const auto half = portable::sine_cosine(0.5 * angle);
  UnitQuaternion q{half.cosine, 0, 0, 0};
  (k == 0 ? q.x : k == 1 ? q.y : q.z) = half.sine;
  rotation = rotation * q;
  const double c = half.cosine * half.cosine - half.sine * half.sine, s = 2 * half.sine * half.cosine;
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const double a = own[i], b = own[j];
  own[i] = c * a + s * b, own[j] = c * b - s * a;
}

/// Iterations for the spin of a partly held body: each squares the error, which is initially the rotation of a step.
constexpr int most_corrections = 12;

Eigen::Matrix3d tensor_of(const Vec3& inertia, const UnitQuaternion& rotation) {
  const Turn3 turn(rotation);
  Eigen::Matrix3d axes;
  axes << turn.x(), turn.y(), turn.z();
  return axes * inertia.asDiagonal() * axes.transpose();
}

/// The matrix of v x.
Eigen::Matrix3d crossing(const Vec3& v) {
  Eigen::Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

/// Solves the rows and columns of the free axes; 0 on the others.
Vec3 solve_free(Eigen::Matrix3d left, Vec3 right, const std::array<bool, 3>& free) {
  for (int k = 0; k < 3; ++k) {
    if (free[static_cast<std::size_t>(k)]) continue;
    left.row(k).setZero(), left.col(k).setZero();
    left(k, k) = 1, right[k] = 0;
  }
  return left.inverse() * right;
}

}  // namespace

// In body axes the inertia tensor is the diagonal J: L = R J R^T w and w = R J^-1 R^T L.
Vec3 momentum_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin) {
  const Turn3 turn(rotation);
  return turn.apply(inertia.cwiseProduct(turn.undo(spin)));
}

Vec3 spin_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum) {
  const Turn3 turn(rotation);
  return turn.apply(turn.undo(momentum).cwiseQuotient(inertia));
}

Vec3 spin_rate_by(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& moment,
                  const std::array<bool, 3>& free) {
  return solve_free(tensor_of(inertia, rotation), moment, free);
}

// Free about all axes: L changes by span M, and w follows exactly. If some axes are held, L is not conserved, because
// supports take a part. Euler's equation in world axes, I = R J R^T, then holds on the free axes alone, with the mean
// spin u = (w + w') / 2:
//
//   I (w' - w) / span + u x I u = M.
//
// Its product with u, which is 0 on held axes, is (w' I w' - w I w) / (2 span) = M u: the work of the moment alone. The
// subsequent rotation about w' leaves w' I w' unchanged. So without moments the energy is conserved to rounding.
Vec3 spin_ahead(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin, const Vec3& moment, double span,
                const std::array<bool, 3>& free, const Vec3& held) {
  if (free[0] && free[1] && free[2])
    return spin_of(inertia, rotation, momentum_of(inertia, rotation, spin) + span * moment);
  if (!free[0] && !free[1] && !free[2]) return held;
  const Eigen::Matrix3d tensor = tensor_of(inertia, rotation);
  Vec3 next = held;
  for (int k = 0; k < 3; ++k)
    if (free[static_cast<std::size_t>(k)]) next[k] = spin[k];
  for (int i = 0; i < most_corrections; ++i) {
    const Vec3 mean = 0.5 * (spin + next), momentum = tensor * mean;
    const Vec3 left = span * (moment - cross(mean, momentum)) - tensor * (next - spin);
    const Eigen::Matrix3d tangent = tensor + 0.5 * span * (crossing(mean) * tensor - crossing(momentum));
    const Vec3 by = solve_free(tangent, left, free);
    next += by;
    if (!(by.squaredNorm() > 1e-30 * next.squaredNorm())) break;
  }
  return next;
}

// Five rotations in a symmetric order, which keeps the energy error bounded.
UnitQuaternion turned_freely(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum, double dt) {
  UnitQuaternion out = rotation;
  Vec3 own = Turn3(rotation).undo(momentum);
  turn_about(0, inertia, 0.5 * dt, out, own);
  turn_about(1, inertia, 0.5 * dt, out, own);
  turn_about(2, inertia, dt, out, own);
  turn_about(1, inertia, 0.5 * dt, out, own);
  turn_about(0, inertia, 0.5 * dt, out, own);
  return renormalised(out);
}

}  // namespace trilith
