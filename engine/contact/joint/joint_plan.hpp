// Geometry of a joint when it set: the area shared by two faces, divided into patches, and its position in each of the
// two bodies.
//
//         y
//      ___|_________
//     |__|__|__|__|/
//     |__|__|__|_/_ x
//     |__|__|__|/
//
// The axes are the principal axes of the shared polygon, the origin is its centroid, the normal points from a to b. A
// grid of 4 by 4 over its extent cuts it. Each patch is a convex polygon, so areas, moments and pressed parts are
// exact. Each patch has four points at c +- sqrt(l1) e1 +- sqrt(l2) e2 with a quarter of the area (l, e: principal
// second moments per unit area, and axes). They have the patch's area, centroid and second moments; for a rectangle
// they are the Gauss points.
//
// Where the faces were apart mortar fills the gap. The bond of such a patch begins with a linear pressure that has the
// resultant and the moments of the previous contact pressure. It may be tensile on one side, where there was no
// tension. So the strength is checked with the overlap gained from setting, and without that initial tension.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/rotation_3d.hpp"
#include "contact/joint/joint_memory.hpp"
#include "geometry/space/face_overlap_3d.hpp"
#include "law/contact/step_increment.hpp"

namespace trilith {

/// Motion of a body in space as its joints use it.
struct BodyMotion {
  Vec3 place;                          ///< of its node [m]
  UnitQuaternion rotation;             ///< from body axes to world axes
  Vec3 velocity, spin;                 ///< [m/s], [rad/s]
  const StepBehind* behind = nullptr;  ///< after an implicit step, whose velocities are at its end; else nullptr

  [[nodiscard]] Vec3 velocity_at(const Vec3& x) const { return velocity + cross(spin, Vec3(x - place)); }
};

/// Origin and axes of a joint, in the axes of a body.
struct JointSeat {
  Vec3 place = Vec3::Zero();  ///< [m]
  UnitQuaternion axes;

  /// Calls f with each number in turn.
  template <class Self, class F>
  static void fields(Self& s, F&& f) {
    for (const int k : {0, 1, 2}) f(s.place[k]);
    f(s.axes.w), f(s.axes.x), f(s.axes.y), f(s.axes.z);
  }
};

/// Resultants of normal stresses, over the stiffness; moments about the joint's origin.
struct PatchStress {
  double force = 0;            ///< [m3]
  Vec2 moment = Vec2::Zero();  ///< [m4]
  double energy = 0;           ///< [m4]
  double area = 0;             ///< that carries shear [m2]

  void add(const PatchStress& o, double times) {
    force += times * o.force, moment += times * o.moment, energy += times * o.energy, area += times * o.area;
  }
};

/// One patch. Positions and moments refer to the joint's origin, second moments to the patch's centroid.
struct JointPatch {
  int first = 0, count = 0;  ///< its corners in JointPlan::corner, counter-clockwise
  Vec2 middle = Vec2::Zero();
  double area = 0;                    ///< [m2]
  double xx = 0, xy = 0, yy = 0;      ///< [m4]
  PatchNumbers point_x{}, point_y{};  ///< its four points
  LinearOverlap laid;                 ///< overlap acting on its bond at setting
  bool filled = false;                ///< this differs from the overlap of the faces
};

/// For an overlap that is linear over the whole patch.
inline PatchStress over_all(const JointPatch& p, const LinearOverlap& f) {
  const double mean = f(p.middle);
  const Vec2 own(p.xx * f.slope.x() + p.xy * f.slope.y(), p.xy * f.slope.x() + p.yy * f.slope.y());
  const double force = p.area * mean;
  return {force, force * p.middle + own, 0.5 * (force * mean + f.slope.dot(own)), p.area};
}

/// Geometry of a joint. The patches and their corners exist only while the joint is divided.
struct JointPlan {
  JointSeat in_a, in_b;          ///< the same position in the world at setting
  LinearOverlap standing;        ///< overlap of the faces at setting
  int face_a = -1, face_b = -1;  ///< faces of deforming solids that the seats follow; -1: the whole body
  std::vector<Vec2> outline;     ///< the shared polygon, counter-clockwise [m]
  // Derived quantities:
  int patches = 0;                ///< number of patches of the divided joint
  std::vector<Vec2> corner;       ///< of all patches; empty until the joint is divided
  std::vector<JointPatch> patch;  ///< empty until the joint is divided
  JointPatch whole;               ///< of all patches: area, centroid and second moments
  PatchStress laid;               ///< resultants of the bonds at setting, over the whole joint
  double width = 0;               ///< square root of the area [m]
  double radius = 0;              ///< radius of gyration about the origin [m]
  double friction_arm = 0;        ///< mean distance of the area from the origin [m]
  bool filled = false;            ///< true if any patch is filled
  double most_laid = 0;           ///< largest overlap acting on the bond of a filled patch at setting [m]

  /// Lower bound of the overlap that the bond's strength is checked with at a corner of the outline at setting [m].
  [[nodiscard]] double least_at(const Vec2& p) const { return filled ? 0 : standing(p); }
  /// Upper bound of the overlap acting on the bond at a corner of the outline at setting [m].
  [[nodiscard]] double most_at(const Vec2& p) const { return filled ? std::max(standing(p), most_laid) : standing(p); }
  [[nodiscard]] std::span<const Vec2> corners(const JointPatch& p) const {
    return std::span<const Vec2>(corner).subspan(static_cast<std::size_t>(p.first), static_cast<std::size_t>(p.count));
  }
};

/// Plans a joint of two faces in their present position, and divides it into patches.
JointPlan plan_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b);

/// Computes the derived quantities from seats, initial overlap and outline, which must be a convex polygon.
void divide_joint(JointPlan& plan);

/// Removes the patches, which an intact joint does not need.
void leave_out_patches(JointPlan& plan);

/// Divides the plan of a joint if it is not divided, and gives each patch a history.
void divide(JointMemory& joint);

}  // namespace trilith
