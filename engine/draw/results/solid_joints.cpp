#include "draw/results/solid_joints.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "draw/results/results_picture.hpp"
#include "geometry/hierarchical_hash_grid.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith::draw {
namespace {

constexpr double widest_gap = 0.05;    // share of the square root of the shared area
constexpr double least_shared = 1e-4;  // share of the smaller face
constexpr double least_cosine = 0.999;

/// A convex face in its initial position.
struct StartFace {
  int body = 0;
  std::vector<int> vertex;
  std::vector<Vec3> corners;
  Vec3 normal = Vec3::Zero();
  double area = 0;
};

/// None for a face that is not convex, has no area or too many corners.
std::optional<StartFace> start_face(const results::Header& header, const results::Placement& at, int body, int row) {
  StartFace face;
  face.body = body;
  for (std::int32_t i = header.face_first[row]; i < header.face_first[row + 1]; ++i) {
    face.vertex.push_back(header.face_vertex[i]);
    face.corners.push_back(at.vertex(header.face_vertex[i]));
  }
  const std::size_t count = face.corners.size();
  if (count > static_cast<std::size_t>(max_face_corners)) return std::nullopt;
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < count; ++i)
    sum += cross(Vec3(face.corners[i] - face.corners[0]), Vec3(face.corners[i + 1] - face.corners[0]));
  face.area = 0.5 * sum.norm();
  if (!(face.area > 0)) return std::nullopt;
  face.normal = sum.normalized();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 in = face.corners[(i + 1) % count] - face.corners[i];
    const Vec3 out = face.corners[(i + 2) % count] - face.corners[(i + 1) % count];
    if (face.normal.dot(cross(in, out)) < -1e-9 * face.area) return std::nullopt;
  }
  return face;
}

/// The three corners of a face with the widest spread from the first, anticlockwise.
std::array<std::size_t, 3> widest_corners(const StartFace& face) {
  const auto farthest = [&](const auto& measure) {
    std::size_t best = 1;
    for (std::size_t i = 2; i < face.corners.size(); ++i)
      if (measure(i) > measure(best)) best = i;
    return best;
  };
  const auto arm = [&](std::size_t i) { return Vec3(face.corners[i] - face.corners[0]); };
  const std::size_t second = farthest([&](std::size_t i) { return arm(i).norm(); });
  const std::size_t third = farthest([&](std::size_t i) { return cross(arm(second), arm(i)).norm(); });
  const bool turns = face.normal.dot(cross(arm(second), arm(third))) > 0;
  return {0, turns ? second : third, turns ? third : second};
}

/// Attaches the points to the face's body, each projected onto the face's plane.
SolidJoint::Side carried(const StartFace& face, const std::vector<Vec3>& points) {
  SolidJoint::Side out;
  out.body = face.body;
  const std::array<std::size_t, 3> at = widest_corners(face);
  for (std::size_t k = 0; k < 3; ++k) out.corner[k] = face.vertex[at[k]];
  const Vec3 u = face.corners[at[1]] - face.corners[at[0]], v = face.corners[at[2]] - face.corners[at[0]];
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), whole = uu * vv - uv * uv;
  for (const Vec3& p : points) {
    const Vec3 arm = p - face.corners[at[0]];
    const double along_u = u.dot(arm), along_v = v.dot(arm);
    out.share.emplace_back((vv * along_u - uv * along_v) / whole, (uu * along_v - uv * along_u) / whole);
  }
  return out;
}

/// None if the two faces do not lie on each other.
std::optional<SolidJoint> joint_between(const StartFace& a, const StartFace& b) {
  if (a.normal.dot(b.normal) > -least_cosine) return std::nullopt;
  FaceOverlap3 faces;
  if (!face_overlap({a.corners, a.normal}, {b.corners, b.normal}, faces)) return std::nullopt;
  const double area = integrals_over_all(faces).area;
  if (area < least_shared * std::min(a.area, b.area)) return std::nullopt;
  SolidJoint joint;
  std::vector<Vec3> points;
  for (int i = 0; i < faces.shared.count; ++i) {
    const Vec2& p = faces.shared.corner[static_cast<std::size_t>(i)];
    points.push_back(faces.plane.at(p));
    joint.gap.push_back(-faces.plane.overlap_at(p));
    if (std::abs(joint.gap.back()) > widest_gap * std::sqrt(area)) return std::nullopt;
    for (const Vec3& q : points) joint.size = std::max(joint.size, (points.back() - q).norm());
  }
  joint.a = carried(a, points), joint.b = carried(b, points);
  return joint;
}

bool is_held(const results::BodyRow& body) {
  return role_of(body.support) != BodyRole::free;
}

FatBox<3> box_of_faces(const std::vector<StartFace>& faces) {
  Vec3 low = faces[0].corners[0], high = low;
  for (const StartFace& face : faces)
    for (const Vec3& p : face.corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Vec3 around = Vec3::Constant(0.5 * widest_gap * (high - low).maxCoeff());
  low -= around, high += around;
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

}  // namespace

std::vector<SolidJoint> solid_joints(const results::Header& header) {
  const results::Frame start = results::start_frame(header);
  const results::Placement at(header, start);
  const int count = static_cast<int>(header.bodies.size());
  std::vector<std::vector<StartFace>> faces(header.bodies.size());
  HierarchicalHashGrid<3> boxes;
  boxes.reset(count);
  std::vector<SolidJoint> joints;
  for (int b = 0; b < count; ++b) {
    const results::BodyRow& body = header.bodies[static_cast<std::size_t>(b)];
    std::vector<StartFace>& own = faces[static_cast<std::size_t>(b)];
    for (int f = body.first_face; f < body.first_face + body.face_count; ++f)
      if (std::optional<StartFace> face = start_face(header, at, b, f)) own.push_back(std::move(*face));
    if (own.empty()) continue;
    const FatBox<3> box = box_of_faces(own);
    std::vector<int> others;
    boxes.for_meeting(box, [&](int other) {
      if (!is_held(body) || !is_held(header.bodies[static_cast<std::size_t>(other)])) others.push_back(other);
    });
    std::sort(others.begin(), others.end());
    for (const int other : others)
      for (const StartFace& theirs : faces[static_cast<std::size_t>(other)])
        for (const StartFace& ours : own)
          if (std::optional<SolidJoint> joint = joint_between(theirs, ours)) joints.push_back(std::move(*joint));
    boxes.put(b, box);
  }
  return joints;
}

std::vector<Vec3> corners_of(const SolidJoint::Side& side, const results::Placement& at) {
  const Vec3 from = at.vertex(side.corner[0]), u = at.vertex(side.corner[1]) - from,
             v = at.vertex(side.corner[2]) - from;
  std::vector<Vec3> out;
  for (const Vec2& share : side.share) out.emplace_back(from + share.x() * u + share.y() * v);
  return out;
}

SolidJointMotion motion_of(const SolidJoint& joint, const results::Placement& at) {
  const std::vector<Vec3> a = corners_of(joint.a, at), b = corners_of(joint.b, at);
  const Vec3 from = at.vertex(joint.a.corner[0]);
  const Vec3 normal =
      cross(Vec3(at.vertex(joint.a.corner[1]) - from), Vec3(at.vertex(joint.a.corner[2]) - from)).normalized();
  SolidJointMotion out{-joint.size, 0};
  Vec3 apart = Vec3::Zero();
  for (std::size_t i = 0; i < a.size(); ++i) {
    out.opening = std::max(out.opening, normal.dot(b[i] - a[i]) - joint.gap[i]);
    apart += (b[i] - a[i]) / static_cast<double>(a.size());
  }
  out.slip = (apart - normal.dot(apart) * normal).norm();
  return out;
}

}  // namespace trilith::draw
