// Two boxes held together by mortar with a prescribed relative motion: response of their joint.
#pragma once

#include "contact/joint/intact_joint.hpp"
#include "contact/joint/joint.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith::testing {

/// Position of the upper box on the lower one as the mortar sets.
struct LaidBox {
  double overlap = 0;         ///< in the middle [m]
  Vec3 tilt = Vec3::Zero();   ///< [rad]
  Vec3 shear = Vec3::Zero();  ///< carried by friction [N]
};

/// A box on another, with the joint at the origin of the world at z = 0; the upper box moves.
class HeldJoint {
 public:
  /// `x`, `y`: sides of the joint [m]; `overlap`: penetration as the mortar sets [m].
  HeldJoint(const ContactLaw& law, double x = 1, double y = 1, double overlap = 0, double step = 1e-3)
      : HeldJoint(law, x, y, LaidBox{overlap}, step) {}
  HeldJoint(const ContactLaw& law, double x, double y, const LaidBox& laid, double step = 1e-3)
      : law_(law), dt_(step), start_(0, 0, 0.5 - laid.overlap), turn_(laid.tilt) {
    const ConvexSolid box = convex_solid(box_solid(Vec3(-x / 2, -y / 2, -0.5), Vec3(x / 2, y / 2, 0.5)), "box");
    a_ = {Vec3(0, 0, -0.5), {}, Vec3::Zero(), Vec3::Zero()},
    b_ = {start_, rotation_by(laid.tilt), Vec3::Zero(), Vec3::Zero()};
    b_.place = Turn3(b_.rotation).apply(start_);
    PlacedSolid below, above;
    place(box, Turn3(UnitQuaternion{}), a_.place, below), place(box, Turn3(b_.rotation), b_.place, above);
    FaceOverlap3 faces;
    const bool meet = meeting_faces(below, above, 1e-2, 1e-3, faces);
    memory_.shear.elastic = memory_.shear.total = laid.shear;
    if (meet) joint_ = set_joint(faces, a_, b_, memory_, law);
    stored_at_first = stored();
    to(Vec3::Zero(), laid.tilt);
  }

  /// Moves to a position and rotation about the middle of the joint in one step.
  const SolidResponse& to(const Vec3& shift, const Vec3& turn = Vec3::Zero()) {
    const Vec3 spin = (turn - turn_) / dt_, rate = (shift - shift_) / dt_;
    shift_ = shift, turn_ = turn;
    b_.rotation = rotation_by(turn);
    b_.place = Turn3(b_.rotation).apply(start_) + shift;
    b_.spin = spin, b_.velocity = rate + cross(spin, Vec3(b_.place - shift));
    const Vec3 force = last.force, moment = moment_;
    const JointResponse r = respond_joint(a_, b_, memory_, joint_, {law_, 1, dt_}, next_);
    last = r.contact, ended = r.ends, memory_ = r.contact.memory;
    std::swap(joint_, next_);
    moment_ = last.moment + cross(Vec3(last.centre - shift), last.force);
    put_in -= 0.5 * dt_ * ((force + last.force).dot(rate) + (moment + moment_).dot(spin));
    fracture += last.lost_fracture, friction += last.lost_friction, damping += last.lost_damping;
    return last;
  }
  /// Moves in equal steps.
  const SolidResponse& glide(const Vec3& shift, const Vec3& turn, int steps) {
    const Vec3 from = shift_, turned = turn_;
    for (int i = 1; i <= steps; ++i)
      to(from + (i / static_cast<double>(steps)) * (shift - from),
         turned + (i / static_cast<double>(steps)) * (turn - turned));
    return last;
  }
  /// From now on the joint is evaluated by its patches, whether intact or not.
  void by_patches() {
    if (joint_.sound) spread_shear(joint_);
  }
  [[nodiscard]] double stored() const { return joint_energy(joint_, {law_}); }
  [[nodiscard]] const JointMemory& joint() const { return joint_; }

  SolidResponse last;
  bool ended = false;
  double put_in = 0, fracture = 0, friction = 0, damping = 0, stored_at_first = 0;

 private:
  ContactLaw law_;
  double dt_;
  Vec3 start_, shift_ = Vec3::Zero(), turn_ = Vec3::Zero(), moment_ = Vec3::Zero();
  BodyMotion a_, b_;
  SolidMemory memory_;
  JointMemory joint_, next_;
};

inline Bonded brittle_mortar(double kn, double ks, double mu, double cohesion, double tension, double by_point = 0) {
  Bonded law;
  law.kn = kn, law.ks = ks, law.mu = mu, law.cohesion = cohesion, law.tension = tension, law.loss_by_point = by_point;
  return law;
}

inline Cohesive soft_mortar(double kn, double ks, double mu, double cohesion, double tension, double mode_1,
                            double mode_2) {
  Cohesive law;
  law.kn = kn, law.ks = ks, law.mu = mu, law.cohesion = cohesion, law.tension = tension;
  law.energy_tension = mode_1, law.energy_shear = mode_2;
  return law;
}

}  // namespace trilith::testing
