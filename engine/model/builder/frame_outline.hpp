// The outline of a frame in the plane: along the skin of its members, and around the blocks of its joints.
#pragma once

#include <vector>

#include "model/builder/frame.hpp"

namespace trilith {

/// A point of the outline: the edge of a member's section at one of its stations, or a corner of a joint's block.
struct OutlinePoint {
  int member, station, side;  ///< side 0: right of its direction (bottom), 1: left (top)
  int joint = -1;             ///< alternatively: `side` is a corner of this joint's block
};

/// Counter-clockwise around the frame. A member that closes a ring ends where the ring does.
std::vector<OutlinePoint> frame_outline(const FrameSpec& spec, const FramePlan& plan);

/// Position of the section's bottom (side 0) or top (side 1) relative to its station [m].
Vec2 section_edge(const FrameSpec& spec, const FramePlan& plan, int member, int side);

/// Position of a point of the outline at the start [m].
Vec2 place_of(const FrameSpec& spec, const FramePlan& plan, const OutlinePoint& point);

}  // namespace trilith
