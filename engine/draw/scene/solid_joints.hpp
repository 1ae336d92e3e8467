// Where faces of solids lay on each other at the start, and how far they have come apart since.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "results/file/placement.hpp"

namespace trilith::draw {

/// The polygon that two faces shared at the start, as each of its bodies carries it.
struct SolidJoint {
  struct Side {
    int body = 0;
    std::array<int, 3> corner{};  ///< rows of Header::vertices: three corners of its face, anticlockwise from outside
    std::vector<Vec2> share;      ///< of each corner of the polygon: ways along the sides from the first to the others
  };
  Side a, b;
  std::vector<double> gap;  ///< between the faces at each corner, at the start [m]
  double size = 0;          ///< longest distance between two corners [m]
};

/// Joints of all pairs of bodies, one of them free, whose convex faces look at each other at the start, no farther
/// apart than a twentieth of what they share is wide: a filled joint of mortar, at most. Spheres have none.
std::vector<SolidJoint> solid_joints(const results::Header& header);

/// Where a body has taken the corners of its joint [m, world].
std::vector<Vec3> corners_of(const SolidJoint::Side& side, const results::Placement& at);

/// Since the start, across the face of the first body and along it.
struct SolidJointMotion {
  double opening = 0;  ///< of the corner farthest apart [m]
  double slip = 0;     ///< of the middle [m]
};
SolidJointMotion motion_of(const SolidJoint& joint, const results::Placement& at);

}  // namespace trilith::draw
