#include "draw/results/solid_cracks.hpp"

#include <algorithm>
#include <cmath>

#include "draw/results/crack_mark.hpp"

namespace trilith::draw {
namespace {

/// Initial gap within which dry faces touch, as a share of the joint's size.
constexpr double touching_share = 1e-3;

bool did_touch(const SolidJoint& joint) {
  return std::all_of(joint.gap.begin(), joint.gap.end(),
                     [&](double gap) { return std::abs(gap) <= touching_share * joint.size; });
}

/// Adds the part of a side of a crack within a face (Cyrus and Beck, 1978).
void add_within(const PieceFace& face, const Vec3& from, const Vec3& to, CrackMark mark, double slack,
                const ViewAxes& view, std::vector<SceneCrack>& out) {
  double begin = 0, end = 1;
  const std::size_t count = face.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 side = face.corners[(i + 1) % count] - face.corners[i];
    const Vec3 inward = cross(face.normal, side).normalized();
    const double a = inward.dot(from - face.corners[i]) + slack, b = inward.dot(to - face.corners[i]) + slack;
    if (a < 0 && b < 0) return;
    if (a < 0) begin = std::max(begin, a / (a - b));
    if (b < 0) end = std::min(end, a / (a - b));
  }
  if ((end - begin) * (to - from).norm() <= slack) return;
  const auto place = [&](double share) { return view.flat(from + share * (to - from)); };
  out.push_back({place(begin), place(end), mark});
}

}  // namespace

std::vector<SolidCrack> solid_cracks(const std::vector<SolidJoint>& joints, const results::Placement& at,
                                     const PairBonds& bonds, const std::vector<bool>& left_out) {
  std::vector<SolidCrack> out;
  for (const SolidJoint& joint : joints) {
    const int a = joint.a.body, b = joint.b.body;
    if (left_out[static_cast<std::size_t>(a)] || left_out[static_cast<std::size_t>(b)]) continue;
    const SolidJointMotion motion = motion_of(joint, at);
    const double most = std::max(motion.opening, motion.slip);
    if (most > joint.size) continue;
    const std::pair<int, int> pair = std::minmax(a, b);
    const bool is_open = did_touch(joint) && most > least_crack && !bonds.held.contains(pair);
    if (!is_open && !bonds.lost.contains(pair)) continue;
    const CrackMark mark = crack_mark(motion.opening, motion.slip);
    for (const SolidJoint::Side& side : {joint.a, joint.b}) out.push_back({side.body, corners_of(side, at), mark});
  }
  return out;
}

void add_cracks_on(const PieceFace& face, const SolidCrack& crack, double slack, const ViewAxes& view,
                   std::vector<SceneCrack>& out) {
  const std::size_t count = crack.outline.size();
  std::vector<Vec3> through;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 &p = crack.outline[i], &q = crack.outline[(i + 1) % count];
    const double from = face.normal.dot(p - face.corners[0]), to = face.normal.dot(q - face.corners[0]);
    if (std::max(std::abs(from), std::abs(to)) <= slack) add_within(face, p, q, crack.mark, slack, view, out);
    if (from * to < 0 && std::max(std::abs(from), std::abs(to)) > slack)
      through.push_back(p + from / (from - to) * (q - p));
  }
  if (face.kind == FaceKind::section && through.size() == 2)
    add_within(face, through[0], through[1], crack.mark, slack, view, out);
}

}  // namespace trilith::draw
