// Which ends of a frame's members are surface.
#pragma once

#include "model/builder/frame.hpp"

namespace trilith {

/// Whether an end of a member (side 0: where it begins, 1: where it ends) is a face: unless one convex piece of what
/// meets at its joint covers it whole at the start, the beam of another member there or the joint's block. As in space.
bool end_is_face(const FrameSpec& spec, const FramePlan& plan, int member, int side);

}  // namespace trilith
