// How a joint was laid: the area that two faces shared as the mortar set, cut into patches, and its place in each of
// the two bodies.
//
//       y                          The axes lie along the principal axes of the shared polygon, the origin in its
//       middle,
//    ___|_________                 the normal from a to b. A grid of 4 by 4 over its extent cuts it; each patch is a
//   |__|__|__|__|/                 convex polygon, so that areas, moments and what is pressed of it are exact.
//   |__|__|__|_/_ x
//   |__|__|__|/                    Four places of each, at c +- sqrt(l1) e1 +- sqrt(l2) e2 with a quarter of the area
//                                  (l, e: principal second moments of unit area, and axes), have its area, middle and
//                                  second moments: of a rectangle they are the points of Gauss.
//
// Where the faces stood apart mortar fills the gap. A patch's bond then begins with the linear pressure that has the
// resultant and the moments of what the faces pressed before. That may pull at one side, where nothing did: strength is
// asked with what is gained since, and with no pull of then.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/rotation_3d.hpp"
#include "contact/joint/joint_memory.hpp"
#include "geometry/space/face_overlap_3d.hpp"
#include "law/contact/step_increment.hpp"

namespace trilith {

/// A body in space as its joints need it.
struct BodyMotion {
  Vec3 place;                          ///< of its node [m]
  UnitQuaternion rotation;             ///< from its axes to the world's
  Vec3 velocity, spin;                 ///< [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< after an implicit step, of which velocities are those of the end

  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - place)); }
};

/// Origin and axes of a joint, in the axes of a body.
struct JointSeat {
  Vec3 place = Vec3::Zero();  ///< [m]
  UnitQuaternion axes;

  /// Calls f with every number in turn.
  template <class Self, class F>
  static void fields(Self& s, F&& f) {
    for (const int k : {0, 1, 2}) f(s.place[k]);
    f(s.axes.w), f(s.axes.x), f(s.axes.y), f(s.axes.z);
  }
};

/// What normal stresses add up to, over the stiffness; moments about the joint's origin.
struct PatchStress {
  double force = 0;            ///< [m3]
  Vec2 moment = Vec2::Zero();  ///< [m4]
  double energy = 0;           ///< [m4]
  double area = 0;             ///< that carries shear [m2]

  void add(const PatchStress& o, double times) {
    force += times * o.force, moment += times * o.moment, energy += times * o.energy, area += times * o.area;
  }
};

/// One patch. All about the joint's origin, second moments about the patch's middle.
struct JointPatch {
  int first = 0, count = 0;  ///< its corners in JointPlan::corner, counter-clockwise
  Vec2 middle = Vec2::Zero();
  double area = 0;                    ///< [m2]
  double xx = 0, xy = 0, yy = 0;      ///< [m4]
  PatchNumbers point_x{}, point_y{};  ///< its four places
  LinearOverlap laid;                 ///< what its bond feels as the mortar sets
  bool filled = false;                ///< ... which is not the overlap of the faces
};

/// Of an overlap that is linear over all of a patch.
inline PatchStress over_all(const JointPatch& p, const LinearOverlap& f) {
  const double mean = f(p.middle);
  const Vec2 own(p.xx * f.slope.x() + p.xy * f.slope.y(), p.xy * f.slope.x() + p.yy * f.slope.y());
  const double force = p.area * mean;
  return {force, force * p.middle + own, 0.5 * (force * mean + f.slope.dot(own)), p.area};
}

struct JointPlan {
  JointSeat in_a, in_b;          ///< one place in the world as the mortar sets
  LinearOverlap standing;        ///< overlap of the faces as the mortar sets
  int face_a = -1, face_b = -1;  ///< which face of a solid that deforms each seat goes with; -1: all of the body
  std::vector<Vec2> outline;     ///< the shared polygon, counter-clockwise [m]
  // What follows from that:
  std::vector<Vec2> corner;
  std::vector<JointPatch> patch;
  JointPatch whole;         ///< all of them: area, middle and second moments
  PatchStress laid;         ///< what the bonds feel as the mortar sets, all over the joint
  double width = 0;         ///< root of the area [m]
  double radius = 0;        ///< of gyration about the origin [m]
  double friction_arm = 0;  ///< mean distance of the area from the origin [m]
  bool filled = false;      ///< some patch is
  double most_laid = 0;     ///< of all patches that are filled, the most that a bond feels as the mortar sets [m]

  /// What the strength of the bond at a corner of the outline is asked with as the mortar sets, or less [m].
  [[nodiscard]] double least_at(const Vec2& p) const { return filled ? 0 : standing(p); }
  /// What the bond at a corner of the outline is pressed by as the mortar sets, or more [m].
  [[nodiscard]] double most_at(const Vec2& p) const { return filled ? std::max(standing(p), most_laid) : standing(p); }
  [[nodiscard]] std::span<const Vec2> corners(const JointPatch& p) const {
    return std::span<const Vec2>(corner).subspan(static_cast<std::size_t>(p.first), static_cast<std::size_t>(p.count));
  }
};

/// The plan of a joint of two faces where they stand now.
JointPlan plan_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b);

/// Fills in what follows from seats, standing overlap and outline, which must be a convex polygon.
void divide_joint(JointPlan& plan);

}  // namespace trilith
