// Points of bonds in space: the corners of an intact joint or of its patches, or the four points of each patch.
#pragma once

#include "assembly/contact/solid_joints.hpp"
#include "contact/joint/intact_joint.hpp"
#include "integrate/explicit/bond_places.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Motion of the seats of a joint. After an implicit step it contains the mean rates over the step, also for the
/// overlap.
inline JointMotion bond_motion(const Model<3>& model, const State<3>& state, const Work<3>& work, const NearPair& p,
                               const JointMemory& joint, double dt) {
  const JointPlan& plan = *joint.plan;
  const BodyMotion a = body_motion(model, state, work, p.piece_a, plan.face_a),
                   b = body_motion(model, state, work, p.piece_b, plan.face_b);
  JointMotion motion(plan, a, b);
  if (a.behind == nullptr || b.behind == nullptr || !(dt > 0)) return motion;
  const auto begin = [](const BodyMotion& body) {
    return BodyMotion{body.behind->place_before, body.behind->rotation_before, Vec3::Zero(), Vec3::Zero()};
  };
  const JointMotion first(plan, begin(a), begin(b));
  motion.over_step(first, dt);
  motion.rate = motion.moved.plus(first.moved, -1);
  motion.rate.at /= dt, motion.rate.slope /= dt;
  return motion;
}

/// The bonds of one joint, with the state of its memory and the given motion.
template <class K, class F>
class JointBonds {
 public:
  JointBonds(const K& law, const JointMemory& joint, const JointMotion& motion, PlacedBond bond, F& f)
      : law_(law), joint_(joint), plan_(*joint.plan), motion_(motion), bond_(bond), f_(f) {}

  void each() {
    if (joint_.sound) return each_corner();
    for (std::size_t k = 0; k < plan_.patch.size(); ++k)
      if (joint_.bonded(static_cast<int>(k))) each_of(k);
  }

 private:
  void each_corner() {
    bond_.share = 1 / static_cast<double>(plan_.outline.size());
    for (const Vec2& p : plan_.outline) {
      const Vec2 shear = law_.ks > 0 ? Vec2(intact_shear_at(plan_, joint_.elastic, p - plan_.whole.middle) / law_.ks)
                                     : Vec2(Vec2::Zero());
      const double overlap = joint_.moved(p) + plan_.least_at(p);
      place(p, 1, overlap, overlap, shear);
    }
  }

  void each_of(std::size_t k) {
    const JointPatch& patch = plan_.patch[k];
    const PatchMemory& m = joint_.patch[k];
    bond_.share = patch.area / (patch_points * plan_.whole.area);
    const PatchOverlaps o(plan_, patch, joint_.moved.raised(opened_by(law_, m.slip) - m.crushed));
    const double per = law_.ks * 0.25 * m.active;
    for (std::size_t i = 0; i < patch_points; ++i) {
      if (!(m.damage[i] < 1)) continue;
      const Vec2 p(patch.point_x[i], patch.point_y[i]);
      const Vec2 shear = per > 0 ? Vec2(m.elastic_x[i] / per, m.elastic_y[i] / per) : Vec2(Vec2::Zero());
      double asked = o.asked(patch, p), mean = asked;
      Vec2 at = p;
      if constexpr (!K::softens) {  // the limit of a brittle bond is checked at the corners of its patch
        for (const Vec2& corner : plan_.corners(patch))
          if (o.asked(patch, corner) < asked) asked = o.asked(patch, corner), at = corner;
      }
      place(at, K::softens ? 1 - m.damage[i] : 1, asked, mean, shear);
    }
  }

  /// `overlap`: overlap at the point [m]; `mean`: overlap that the shear strength depends on [m]; `shear`: elastic slip
  /// [m].
  void place(const Vec2& p, double strength, double overlap, double mean, const Vec2& shear) {
    bond_.curve = tension_curve(law_, strength);
    bond_.at = -overlap, bond_.rate = -motion_.rate(p), f_(bond_);
    bond_.curve = shear_curve(law_, strength, std::max(mean, 0.0), std::max(-mean, 0.0));
    if (!(bond_.curve.top > 0)) return;
    const Vec2 slip = motion_.mean_slip + motion_.mean_spin * Vec2(-p.y(), p.x());
    bond_.rate = slip.norm();
    // Component along the slip rate: a point that slips back passes no peak.
    bond_.at = bond_.rate > 0 ? shear.dot(slip) / bond_.rate : shear.norm();
    f_(bond_);
  }

  const K& law_;
  const JointMemory& joint_;
  const JointPlan& plan_;
  const JointMotion& motion_;
  PlacedBond bond_;
  F& f_;
};

template <class F>
void each_bond(const Model<3>& model, const State<3>& state, const Work<3>& work, bool after, double dt, F&& f) {
  const SolidHistory& history = after ? work.contacts : contacts_before(state, work);
  if (history.joint_of.empty()) return;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const JointMemory* joint = history.joint_at(row);
    if (joint == nullptr || joint->empty() || joint->bonds == 0) continue;
    const NearPair& p = work.pairs[row];
    PlacedBond bond;
    bond.row = static_cast<int>(row);
    bond.size = joint->plan->whole.area;
    bond.body_a = model.piece_body[p.piece_a], bond.body_b = model.piece_body[p.piece_b];
    const JointMotion motion = bond_motion(model, state, work, p, *joint, after ? 0 : dt);
    with_kernel({model.laws[p.law], model.thickness, dt}, [&]<class K>(const K& law) {
      if constexpr (K::bonds) JointBonds<K, F>(law, *joint, motion, bond, f).each();
    });
  }
}

}  // namespace trilith
