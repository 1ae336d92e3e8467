// A frame of the plane taken into space: x stays, the plane's y is z, its beams reach over their thickness about y = 0.
#pragma once

#include "model/builder/frame.hpp"
#include "model/space_builder/space_frame.hpp"

namespace trilith {

/// How a frame of the plane is taken into space.
struct FrameExtrusion {
  double thickness = 1;  ///< over which its skin reaches [m]
  bool held = true;      ///< it stays in its plane, so that what it lacks across may be anything
};

/// Bending in the plane, stretch, mass and plasticity are those of the plane: the same numbers, with fibres in as many
/// layers. Bending across and torsion are those of the section's shape; where that is not known and the frame is held,
/// they are as stiff as bending in the plane, and a hinge is as strong across. A joint that is held along both axes is
/// held across too, and one whose rotation is held does not turn. A joint that is a block is one as thick as it says.
SpaceFrameSpec extruded_frame(const FrameSpec& flat, const FrameExtrusion& extrusion);

}  // namespace trilith
