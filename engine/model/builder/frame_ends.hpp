// Finds the ends of a frame's members that are surface.
#pragma once

#include "model/builder/frame.hpp"

namespace trilith {

/// Whether an end of a member (side 0: start, 1: end) is a face. It is not if one convex piece at its joint covers it
/// completely at the start: another member's beam or the joint's block. The rule is the same in space.
bool end_is_face(const FrameSpec& spec, const FramePlan& plan, int member, int side);

}  // namespace trilith
