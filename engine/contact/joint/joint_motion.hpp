// Relative position and motion of the two seats of a joint.
//
//        b  ____________
//             ^ n   b's seat
//         .............. mean plane
//           ____________
//        a        a's seat
//
// The axes and the origin O are midway between those in both seats. Input: poses and motions of both bodies. Output:
// the overlap gained from setting, linear over the plane, its rate, and the slip of b. With O midway, n . (v_b -
// v_a)(O) is exactly the rate of n . (O_b - O_a), so a stress that depends on the overlap conserves energy.
//
// For relative rotations up to a few hundredths, beyond which no bond remains.
#pragma once

#include "contact/joint/joint_plan.hpp"

namespace trilith {

struct JointMotion {
  Vec3 origin, x, y, normal;  ///< [m]; unit vectors
  LinearOverlap moved, rate;  ///< overlap gained [m]; its rate [m/s]
  Vec2 aside;                 ///< in-plane displacement of b's seat relative to a's [m]
  Vec3 turn;                  ///< rotation of b's seat relative to a's, along the axes [rad]
  Vec2 slip;                  ///< velocity of b relative to a at the origin [m/s]
  double spin;                ///< the same about the normal [rad/s]
  Vec2 mean_slip;             ///< over the step: equal to `slip` except after an implicit step [m/s]
  double mean_spin;           ///< the same for `spin` [rad/s]

  JointMotion(const JointPlan& plan, const BodyMotion& a, const BodyMotion& b);
  /// Sets mean rates from the seats' position at the beginning of an implicit step of length dt [s].
  void over_step(const JointMotion& begin, double dt);

  [[nodiscard]] Vec3 in_world(const Vec2& p) const { return p.x() * x + p.y() * y; }
};

inline JointMotion::JointMotion(const JointPlan& plan, const BodyMotion& a, const BodyMotion& b) {
  const Turn3 of_a(a.rotation * plan.in_a.axes), of_b(b.rotation * plan.in_b.axes);
  const Vec3 at_a = a.place + Turn3(a.rotation).apply(plan.in_a.place),
             at_b = b.place + Turn3(b.rotation).apply(plan.in_b.place), between = at_b - at_a;
  origin = 0.5 * (at_a + at_b);
  normal = Vec3(of_a.z() + of_b.z()).normalized();
  const Vec3 along = of_a.x() + of_b.x();
  x = Vec3(along - normal.dot(along) * normal).normalized();
  y = cross(normal, x);
  const Vec3 turned = 0.5 * (cross(of_a.x(), of_b.x()) + cross(of_a.y(), of_b.y()) + cross(of_a.z(), of_b.z()));
  turn = {x.dot(turned), y.dot(turned), normal.dot(turned)};
  moved = {-normal.dot(between), Vec2(turn.y(), -turn.x())};
  aside = {x.dot(between), y.dot(between)};
  const Vec3 velocity = b.velocity_at(origin) - a.velocity_at(origin), spinning = b.spin - a.spin;
  rate = {-normal.dot(velocity), Vec2(spinning.dot(y), -spinning.dot(x))};
  slip = {x.dot(velocity), y.dot(velocity)};
  spin = normal.dot(spinning);
  mean_slip = slip, mean_spin = spin;
}

inline void JointMotion::over_step(const JointMotion& begin, double dt) {
  mean_slip = Vec2::Zero(), mean_spin = 0;
  if (dt > 0) mean_slip = (aside - begin.aside) / dt, mean_spin = (turn.z() - begin.turn.z()) / dt;
}

}  // namespace trilith
