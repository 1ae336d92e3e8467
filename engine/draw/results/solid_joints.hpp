// Polygons that faces of bodies in space shared at the start, and their separation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "results/file/placement.hpp"

namespace trilith::draw {

/// The polygon that two faces shared at the start, attached to each of the bodies.
struct SolidJoint {
  struct Side {
    int body = 0;
    std::array<int, 3> corner{};  ///< rows of Header::vertices: three corners of its face, anticlockwise from outside
    std::vector<Vec2> share;      ///< of each corner of the polygon: coordinates along the sides from the first corner
                                  ///< to the others
  };
  Side a, b;
  std::vector<double> gap;  ///< between the faces at each corner, at the start [m]
  double size = 0;          ///< longest distance between two corners [m]
};

/// Joints of all pairs of bodies, one of them free, with opposed convex faces at the start. Their distance is at most 5
/// % of the width of the shared area, as for a filled mortar joint. Spheres have none.
std::vector<SolidJoint> solid_joints(const results::Header& header);

/// Present position of the corners of a joint on a body [m, world].
std::vector<Vec3> corners_of(const SolidJoint::Side& side, const results::Placement& at);

/// Displacement from the start, across the face of the first body and along it.
struct SolidJointMotion {
  double opening = 0;  ///< at the corner with the largest opening [m]
  double slip = 0;     ///< at the middle [m]
};
SolidJointMotion motion_of(const SolidJoint& joint, const results::Placement& at);

}  // namespace trilith::draw
