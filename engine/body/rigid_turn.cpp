#include "body/rigid_turn.hpp"

#include <Eigen/Cholesky>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {
namespace {

/// A turn of the body about its own axis k: the rotation, and its momentum in its own axes, which turns back.
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

}  // namespace

// In the body's own axes the tensor of inertia is the diagonal J, so that turning there, multiplying and turning back
// is all: L = R J R^T w, and w = R J^-1 R^T L.
Vec3 momentum_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin) {
  const Turn3 turn(rotation);
  return turn.apply(inertia.cwiseProduct(turn.undo(spin)));
}

Vec3 spin_of(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& momentum) {
  const Turn3 turn(rotation);
  return turn.apply(turn.undo(momentum).cwiseQuotient(inertia));
}

// Comes in: spin w, moment M, which axes of the world are free. Goes out: the spin after `span`.
//
// Free about all axes: L grows by span M, and w follows from it exactly. Held about some, L is no longer the body's own
// to keep, as supports take part of it; there Euler's equation in the axes of the world, R J R^T w' = M - w x L, is
// solved for the free components alone, the rows and columns of the held ones being those of w' = 0.
Vec3 spin_ahead(const Vec3& inertia, const UnitQuaternion& rotation, const Vec3& spin, const Vec3& moment, double span,
                const std::array<bool, 3>& free) {
  if (free[0] && free[1] && free[2])
    return spin_of(inertia, rotation, momentum_of(inertia, rotation, spin) + span * moment);
  if (!free[0] && !free[1] && !free[2]) return Vec3::Zero();
  const Turn3 turn(rotation);
  Eigen::Matrix3d axes, left;
  axes << turn.x(), turn.y(), turn.z();
  left = axes * inertia.asDiagonal() * axes.transpose();
  Vec3 right = moment - cross(spin, Vec3(left * spin));
  for (int k = 0; k < 3; ++k) {
    if (free[static_cast<std::size_t>(k)]) continue;
    left.row(k).setZero(), left.col(k).setZero();
    left(k, k) = 1, right[k] = 0;
  }
  const Vec3 more = left.ldlt().solve(right);
  Vec3 next = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (free[static_cast<std::size_t>(k)]) next[k] = spin[k] + span * more[k];
  return next;
}

// Five turns, the same read backwards: that is what keeps the energy near its own for ever.
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
