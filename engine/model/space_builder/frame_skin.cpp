#include "model/space_builder/frame_skin.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation_3d.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {
namespace {

/// A section of a member's skin.
struct SkinStretch {
  int node;           ///< index within the frame
  double from, to;    ///< along the member [m]
  bool begins, ends;  ///< at a tip of the member, where its face is part of the surface
};

/// From the middle of one beam to the middle of the next. The skin next to a pinned joint moves with the next node,
/// because the joint's rotation is not the member's.
std::vector<SkinStretch> skin_stretches(const SpaceFrameSpec& frame, const FramePlanOf<3>& plan, std::size_t member) {
  const SpaceMember& m = frame.members[member];
  const double beam = length_of(frame, m) / m.divisions;
  std::vector<SkinStretch> out;
  for (int i = 0; i <= m.divisions; ++i)
    out.push_back({plan.stations[member][i].node, std::max(i - 0.5, 0.0) * beam,
                   std::min(i + 0.5, static_cast<double>(m.divisions)) * beam, false, false});
  if (m.pinned[0]) out[1].from = 0, out.erase(out.begin());
  if (m.pinned[1]) out[out.size() - 2].to = out.back().to, out.pop_back();
  out.front().begins = plan.is_tip[member][0], out.back().ends = plan.is_tip[member][1];
  return out;
}

/// The profile of a member over a section of it, in its initial position.
std::vector<Polyhedron> solids_of(const SpaceFrameSpec& frame, std::size_t member, const SkinStretch& stretch) {
  const SpaceMember& m = frame.members[member];
  const Turn3 axes = turn_of(member_axes(frame, m));
  const Vec3 start = end_of(frame, m, 0) + stretch.from * axes.x();
  std::vector<Polyhedron> out;
  for (const std::vector<Vec2>& part : m.section.profile) {
    std::vector<Vec3> polygon;
    for (const Vec2& p : part) polygon.emplace_back(start + p.x() * axes.z() + p.y() * axes.y());
    out.push_back(extrusion(polygon, Vec3((stretch.to - stretch.from) * axes.x())));
  }
  return out;
}

/// The solids of all other members at a joint, and the joint's block.
std::vector<ConvexSolid> solids_beside(const SpaceFrameBody& body, std::size_t member, int joint) {
  std::vector<ConvexSolid> out;
  const SpaceJoint& at = body.frame.joints[static_cast<std::size_t>(joint)];
  if (at.has_block()) out.push_back(convex_solid(at.block, "a joint", 1e-8));
  for (std::size_t m = 0; m < body.frame.members.size(); ++m) {
    const SpaceMember& other = body.frame.members[m];
    if (m == member || (other.from != joint && other.to != joint)) continue;
    const std::vector<SkinStretch> stretches = skin_stretches(body.frame, body.plan, m);
    for (const Polyhedron& solid : solids_of(body.frame, m, other.from == joint ? stretches.front() : stretches.back()))
      out.push_back(convex_solid(solid, "a member", 1e-8));
  }
  return out;
}

/// Whether one of these solids contains all corners of a face.
bool is_covered(const Polyhedron& solid, int face, const std::vector<ConvexSolid>& by) {
  const auto holds = [&](const ConvexSolid& c, const Vec3& x) {
    for (int f = 0; f < c.shape.faces.count(); ++f) {
      const Vec3& on = c.shape.corners[static_cast<std::size_t>(c.shape.faces[f][0])];
      if (c.normals[static_cast<std::size_t>(f)].dot(x - on) > 1e-6 * c.size) return false;
    }
    return true;
  };
  return std::any_of(by.begin(), by.end(), [&](const ConvexSolid& c) {
    return std::ranges::all_of(solid.faces[face],
                               [&](int k) { return holds(c, solid.corners[static_cast<std::size_t>(k)]); });
  });
}

/// Surface at the ends of a member's section of skin: none where the next section continues; at a joint a face that no
/// solid of another member covers completely.
class StretchEnds {
 public:
  StretchEnds(const SpaceFrameBody& body, std::size_t m, const SkinStretch& stretch)
      : along_(turn_of(member_axes(body.frame, body.frame.members[m])).x()) {
    const SpaceMember& member = body.frame.members[m];
    at_joint_ = {!(stretch.from > 0), stretch.to > (1 - 1e-9) * length_of(body.frame, member)};
    if (at_joint_[0] && !stretch.begins) beside_[0] = solids_beside(body, m, member.from);
    if (at_joint_[1] && !stretch.ends) beside_[1] = solids_beside(body, m, member.to);
  }
  [[nodiscard]] bool is_surface(const Polyhedron& solid, int face, const Vec3& normal) const {
    const double way = normal.dot(along_);
    if (std::abs(way) <= 0.5) return true;
    const std::size_t end = way > 0 ? 1 : 0;
    return at_joint_[end] && !is_covered(solid, face, beside_[end]);
  }

 private:
  Vec3 along_;
  std::array<bool, 2> at_joint_;
  std::array<std::vector<ConvexSolid>, 2> beside_;
};

/// The convex solids of one section of skin in the axes of its node.
std::vector<ConvexSolid> stretch_pieces(const SpaceFrameBody& body, std::size_t m, const SkinStretch& stretch,
                                        const Vec3& place, const UnitQuaternion& rotation) {
  const UnitQuaternion back = inverse(rotation);
  const Turn3 turn = turn_of(rotation);
  const StretchEnds ends(body, m, stretch);
  const std::vector<Polyhedron> solids = solids_of(body.frame, m, stretch);
  std::vector<ConvexSolid> pieces;
  for (const Polyhedron& solid : solids)
    pieces.push_back(convex_solid(placed(placed(solid, {}, -place), back, Vec3::Zero()), body.name, 1e-8));
  mark_inner_faces(pieces);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    ConvexSolid& piece = pieces[p];
    const int faces = piece.shape.faces.count();
    if (piece.surface.empty()) piece.surface.assign(static_cast<std::size_t>(faces), 1);
    for (int f = 0; f < faces; ++f) {
      const auto row = static_cast<std::size_t>(f);
      if (!ends.is_surface(solids[p], f, turn.apply(piece.normals[row]))) piece.surface[row] = 0;
    }
  }
  return pieces;
}

/// The block of a joint in the axes of its node.
ConvexSolid block_piece(const SpaceFrameBody& body, std::size_t joint, const UnitQuaternion& rotation) {
  const SpaceJoint& at = body.frame.joints[joint];
  return convex_solid(placed(placed(at.block, {}, -at.place), inverse(rotation), Vec3::Zero()), body.name, 1e-8);
}

}  // namespace

std::vector<Polyhedron> skin_solids(const SpaceFrameSpec& frame, const FramePlanOf<3>& plan) {
  std::vector<Polyhedron> out;
  for (const SpaceJoint& joint : frame.joints)
    if (joint.has_block()) out.push_back(joint.block);
  for (std::size_t m = 0; m < frame.members.size(); ++m)
    for (const SkinStretch& stretch : skin_stretches(frame, plan, m))
      for (const Polyhedron& solid : solids_of(frame, m, stretch)) out.push_back(solid);
  return out;
}

std::vector<SkinPiece> skin_pieces(const SpaceFrameBody& body, const std::vector<UnitQuaternion>& rotation) {
  std::vector<SkinPiece> out;
  for (std::size_t j = 0; j < body.frame.joints.size(); ++j)
    if (body.frame.joints[j].has_block()) out.push_back({static_cast<int>(j), block_piece(body, j, rotation[j])});
  for (std::size_t m = 0; m < body.frame.members.size(); ++m)
    for (const SkinStretch& stretch : skin_stretches(body.frame, body.plan, m)) {
      const auto n = static_cast<std::size_t>(stretch.node);
      for (ConvexSolid& piece : stretch_pieces(body, m, stretch, body.plan.node[n], rotation[n]))
        out.push_back({stretch.node, std::move(piece)});
    }
  return out;
}

}  // namespace trilith
