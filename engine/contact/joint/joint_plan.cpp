#include "contact/joint/joint_plan.hpp"

#include <algorithm>
#include <cmath>

#include "contact/space/solid_pressure.hpp"
#include "geometry/plane/outline_moments.hpp"

namespace trilith {
namespace {

/// Patches smaller than this share of the joint are omitted.
constexpr double least_patch = 1e-9;
/// Gaps smaller than this share of the joint's width are rounding errors and are not filled.
constexpr double least_gap = 1e-12;
/// Among sides whose lengths agree within this share, the first counts as the longest.
constexpr double same_length = 1e-6;

/// Direction of the longest side; the first of equally long ones.
Vec2 longest_side(std::span<const Vec2> corners) {
  Vec2 best = Vec2::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[i + 1 < corners.size() ? i + 1 : 0] - corners[i];
    if (side.norm() > best.norm() * (1 + same_length)) best = side;
  }
  return best.normalized();
}

/// Stores in `kept` the part to the left of the line through `from` along `along`.
void keep_left(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& along, std::vector<Vec2>& kept) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double at_p = cross(along, Vec2(p - from)), at_q = cross(along, Vec2(q - from));
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
}

/// The part of a convex polygon in a rectangle: clipped by its four sides, one after the other. Reuses its buffers.
class CellPart {
 public:
  const std::vector<Vec2>& of(const std::vector<Vec2>& polygon, const Vec2& low, const Vec2& high) {
    keep_left(polygon, low, Vec2::UnitX(), other_);
    keep_left(other_, Vec2(high.x(), low.y()), Vec2::UnitY(), cut_);
    keep_left(cut_, high, -Vec2::UnitX(), other_);
    keep_left(other_, Vec2(low.x(), high.y()), -Vec2::UnitY(), cut_);
    return cut_;
  }

 private:
  std::vector<Vec2> cut_, other_;
};

/// The linear function over a patch with the integral and the first moments of the positive part of `standing`.
LinearOverlap laid_on(const LinearOverlap& standing, const JointPatch& patch, std::span<const Vec2> corners) {
  const FaceIntegrals pressed = integrals_in_contact(corners, standing.at, standing.slope);
  const Vec2 moment = pressed.first_moment - pressed.first * patch.middle;
  const double determinant = patch.xx * patch.yy - patch.xy * patch.xy;
  LinearOverlap laid;
  laid.slope =
      Vec2(patch.yy * moment.x() - patch.xy * moment.y(), patch.xx * moment.y() - patch.xy * moment.x()) / determinant;
  laid.at = pressed.first / patch.area - laid.slope.dot(patch.middle);
  return laid;
}

/// Computes the derived quantities of a patch from its corners.
void complete(JointPlan& plan, JointPatch& patch, const OutlineMoments& m) {
  patch.middle = m.middle, patch.area = m.area;
  patch.xx = m.xx, patch.xy = m.xy, patch.yy = m.yy;
  const std::array<Vec2, patch_points> arm = m.arms();
  for (std::size_t q = 0; q < patch_points; ++q)
    patch.point_x[q] = m.middle.x() + arm[q].x(), patch.point_y[q] = m.middle.y() + arm[q].y();
  const std::span<const Vec2> corners = plan.corners(patch);
  patch.filled = std::any_of(corners.begin(), corners.end(),
                             [&](const Vec2& p) { return plan.standing(p) < -least_gap * plan.width; });
  patch.laid = patch.filled ? laid_on(plan.standing, patch, corners) : plan.standing;
  plan.filled = plan.filled || patch.filled;
  if (patch.filled)
    for (const Vec2& p : corners) plan.most_laid = std::max(plan.most_laid, patch.laid(p));
  plan.laid.add(over_all(patch, patch.laid), 1);
}

/// Position of the joint's plane in the axes of a body, with which it moves.
JointSeat seat_in(const BodyMotion& body, const Vec3& origin, const UnitQuaternion& axes) {
  const UnitQuaternion back = inverse(body.rotation);
  return {Turn3(back).apply(origin - body.place), back * axes};
}

}  // namespace

/// A grid over the bounding box of the outline. Each cell that contains a part of the outline is a patch, with its own
/// area, centroid and second moments.
///
///      +----+----+----+----+
///      |    |    |    |    |
///      +----+----+----+----+
///      |    |  . | .  |    |
///      +----+----+----+----+
///
/// Four points at one radius of gyration along its principal axes represent it, which gives its axial and bending
/// stiffness exactly.
void divide_joint(JointPlan& plan) {
  plan.corner.clear(), plan.patch.clear();
  const OutlineMoments all(plan.outline);
  plan.whole = {}, plan.laid = {};
  plan.whole.area = all.area, plan.whole.middle = all.middle;
  plan.whole.xx = all.xx, plan.whole.xy = all.xy, plan.whole.yy = all.yy;
  plan.width = std::sqrt(all.area);
  plan.filled = false, plan.most_laid = 0;
  const double trace = (all.xx + all.yy) / all.area;
  plan.radius = std::sqrt(trace);
  plan.friction_arm = mean_distance(trace, (all.xx * all.yy - all.xy * all.xy) / (all.area * all.area));
  Vec2 low = plan.outline[0], high = low;
  for (const Vec2& p : plan.outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vec2 cell = (high - low) / patches_along;
  CellPart part;
  for (int j = 0; j < patches_along; ++j)
    for (int i = 0; i < patches_along; ++i) {
      const Vec2 from = low + cell.cwiseProduct(Vec2(i, j)), to = low + cell.cwiseProduct(Vec2(i + 1, j + 1));
      const std::vector<Vec2>& polygon = part.of(plan.outline, from, to);
      const OutlineMoments moments(polygon);
      if (polygon.size() < 3 || !(moments.area > least_patch * all.area)) continue;
      JointPatch patch;
      patch.first = static_cast<int>(plan.corner.size()), patch.count = static_cast<int>(polygon.size());
      plan.corner.insert(plan.corner.end(), polygon.begin(), polygon.end());
      complete(plan, patch, moments);
      plan.patch.push_back(patch);
    }
  plan.patches = static_cast<int>(plan.patch.size());
}

void leave_out_patches(JointPlan& plan) {
  // An empty list in braces would empty the vectors, but not release their memory.
  plan.corner = std::vector<Vec2>(), plan.patch = std::vector<JointPatch>();
}

void divide(JointMemory& joint) {
  if (joint.plan->patch.empty()) {
    const auto plan = std::make_shared<JointPlan>(*joint.plan);
    divide_joint(*plan);
    joint.plan = plan;
  }
  joint.patch.resize(joint.plan->patch.size());
}

/// The axes of a joint: origin at the centroid of the shared polygon, x along its larger principal axis (the longest
/// side if there is none), z along the normal out of a.
JointPlan plan_joint(const FaceOverlap3& faces, const BodyMotion& a, const BodyMotion& b) {
  const std::span<const Vec2> shared(faces.shared.corner.data(), static_cast<std::size_t>(faces.shared.count));
  const OutlineMoments moments(shared);
  const Vec2 x = moments.has_axis() ? moments.axis() : longest_side(shared), y(-x.y(), x.x());
  const MeanPlane& plane = faces.plane;
  JointPlan plan;
  for (const Vec2& p : shared) plan.outline.emplace_back(x.dot(p - moments.middle), y.dot(p - moments.middle));
  plan.standing = {plane.overlap_at(moments.middle), Vec2(x.dot(plane.slope), y.dot(plane.slope))};
  Eigen::Matrix3d axes;
  axes.col(0) = x.x() * plane.x + x.y() * plane.y, axes.col(2) = plane.normal;
  axes.col(1) = cross(Vec3(axes.col(2)), Vec3(axes.col(0)));
  const UnitQuaternion turn = rotation_of(axes);
  const Vec3 origin = plane.at(moments.middle);
  plan.in_a = seat_in(a, origin, turn), plan.in_b = seat_in(b, origin, turn);
  plan.face_a = faces.face_a, plan.face_b = faces.face_b;
  divide_joint(plan);
  return plan;
}

}  // namespace trilith
