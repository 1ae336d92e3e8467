// The skin of a frame in space. It is attached to the nodes: each node moves a rigid convex solid, the profile of the
// member over half of the beam on either side. Two such solids meet at the middle of a beam. There they separate by the
// third power of the beam's length times the change of curvature, so that a girder of a few beams has a smooth
// underside. A force on the skin is one force and one moment on one node, with exactly its work.
#pragma once

#include <vector>

#include "geometry/space/convex_solid.hpp"
#include "model/builder/frame_rows.hpp"

namespace trilith {

/// All blocks and sections of skin in their initial positions.
std::vector<Polyhedron> skin_solids(const SpaceFrameSpec& frame, const FramePlanOf<3>& plan);

/// A convex solid that moves with a node.
struct SkinPiece {
  int node;           ///< index within the frame
  ConvexSolid solid;  ///< in the axes of the node; faces inside the skin of the frame are marked as inner cuts
};

/// All pieces: blocks of joints, then member by member. `rotation` [node]: from the axes of the nodes to world axes.
std::vector<SkinPiece> skin_pieces(const SpaceFrameBody& body, const std::vector<UnitQuaternion>& rotation);

}  // namespace trilith
