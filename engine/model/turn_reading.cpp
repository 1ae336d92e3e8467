#include "model/turn_reading.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"

namespace trilith {
namespace {

/// Tolerance between a driven rotation with full turns and the actual rotation [rad]: half a turn off is another count.
constexpr double counted_well = 1;

/// The rotation vector with the sign of the quaternion, length 0 to 2 pi.
Vec3 signed_turn(const UnitQuaternion& q) {
  const Vec3 axis(q.x, q.y, q.z);
  const double s = axis.norm();
  return s > 0 ? Vec3(2 * portable::atan2(s, q.w) / s * axis) : Vec3(Vec3::Zero());
}

/// The rotation vector along the axis of `least`, with full turns added, that is nearest to another one.
Vec3 nearest_count(const Vec3& least, const Vec3& to) {
  const double size = least.norm();
  // A whole number of turns: any axis is valid, so the axis of the other vector is used.
  const Vec3 axis = size > 1e-9 ? Vec3(least / size) : to.norm() > 0 ? to.normalized() : Vec3::Zero();
  return least + 2 * M_PI * std::round((axis.dot(to) - axis.dot(least)) / (2 * M_PI)) * axis;
}

double place_of(const Drive& drive, double time) {
  return drive.origin + drive.motion->displacement(time - drive.start);
}

/// The drive that rotates a node now, or rotated it last before it was fixed.
const Drive* drive_of_turn(const Model<3>& model, int node, int dof) {
  if (const int now = model.drive_of[node][static_cast<std::size_t>(dof)]; now >= 0) return &model.drives[now];
  const auto last = std::find_if(model.drives.rbegin(), model.drives.rend(),
                                 [&](const Drive& d) { return d.node == node && d.dof == dof; });
  return last == model.drives.rend() ? nullptr : &*last;
}

/// The rotation integrated by drives; empty where some rotation is free, or none was ever driven.
std::optional<Vec3> driven_turn(const Model<3>& model, const State<3>& state, int node) {
  Vec3 turn = Vec3::Zero();
  bool any = false;
  for (int k = 0; k < 3 && !model.drives.empty(); ++k) {
    if (model.support[node][static_cast<std::size_t>(3 + k)] == Support::free) return {};
    const Drive* const drive = drive_of_turn(model, node, 3 + k);
    if (drive == nullptr) continue;
    turn[k] = place_of(*drive, state.time), any = true;
  }
  if (!any) return {};
  return turn;
}

}  // namespace

Vec3 turn_reading(const Model<3>& model, const State<3>& state, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const UnitQuaternion turned = body_pose(model, state, body).turned;
  if (!b.nodes_turn()) return angle_of(turned);  // of a fit, whose sign has no meaning
  const Vec3 by_sign = signed_turn(turned);
  if (!b.is_rigid()) return by_sign;
  const auto driven = driven_turn(model, state, b.first_node);
  if (!driven) return by_sign;
  const Vec3 counted = nearest_count(angle_of(turned), *driven);
  return (counted - *driven).norm() < counted_well ? counted : by_sign;
}

double drive_origin(const Model<2>& model, const State<2>& state, int body, int dof) {
  const auto node = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
  return dof == 2 ? state.rotation[node] : state.position[node][dof];
}
double drive_origin(const Model<3>& model, const State<3>& state, int body, int dof) {
  if (dof >= 3) return turn_reading(model, state, body)[dof - 3];
  return state.position[static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node)][dof];
}

}  // namespace trilith
