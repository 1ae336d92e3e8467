// Converts a plane frame to space: x stays, the plane's y becomes z, and its beams extend over their thickness about y
// = 0.
#pragma once

#include "model/builder/frame.hpp"

namespace trilith {

/// Parameters of the conversion to space.
struct FrameExtrusion {
  double thickness = 1;  ///< width of its skin [m]
  bool held = true;      ///< it stays in its plane, so missing transverse data may have any value
};

/// In-plane bending, axial stiffness, mass and plasticity keep their numbers; fibres keep the number of layers.
/// Transverse bending and torsion follow the section's shape. If the shape is unknown and the frame is held, both equal
/// the in-plane bending stiffness, and a hinge has equal strength. A joint that is held along both axes is also held
/// across, and one whose rotation is held does not rotate. A block of a joint has its given thickness.
SpaceFrameSpec extruded_frame(const FrameSpec& flat, const FrameExtrusion& extrusion);

}  // namespace trilith
