// Flying buttresses: half an arch that leans from a pier against the head of a wall.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// The intrados is an arc of a circle from its springing, at the inner edge of the pier, to its head on the face of the
/// wall. Joints are radial, the one at the wall is upright. The extrados is a circle too, or the straight line of a
/// coping that rises to the wall. The origin is the springing, the wall is to the right.
///
///                      .-'|  |
///        coping    .-'   _|  |
///              .-'   .-'  |  |
///     ____ .-'   .'   rise|  | wall
///    |     \  .'          |  |
///    |      \:....span....|  |
///    | pier |
///
struct FlyingButtress {
  std::string name = {};
  int voussoirs = 9;       ///< 1 to 10000
  double span = 4;         ///< from the pier to the wall, m
  double rise = 2;         ///< of the intrados, from the pier to the wall, m
  double radius = 0;       ///< of the intrados, m; 0: it is level at the head, for which `rise` is at most `span`
  double thickness = 0.4;  ///< of the ring along its joints, or with a coping upright at the wall, m
  double slope = 0;        ///< of the coping against the horizontal, rad, below pi/2; 0: none, the ring is even
  int sub_edges = 1;       ///< straight edges of the intrados per voussoir, and of an even ring's extrados, 1 to 1000
  Vec2 springing = Vec2::Zero();  ///< where the intrados springs from, m
  double pier_width = 0;          ///< m; 0: 1.5 times the thickness
  double pier_height = 0;         ///< below the springing, m; 0: no pier
  double wall_width = 0;          ///< m; 0: no wall
  double wall_height = 0;         ///< above the head's intrados, from the springing up, m; 0: the thickness
};

/// Parts "v1" (at the pier) to "vn" (at the wall), group "voussoirs"; "pier", group "piers"; "wall", group "walls".
/// Neighbouring voussoirs share the two corners of their joint to the bit. Joints are evenly spaced along the intrados.
/// Throws InputError for numbers out of range, for a circle that does not go through both ends or falls towards the
/// wall, and for a coping that meets the intrados or does not come out over the pier.
std::vector<Part> build_flying_buttress(const FlyingButtress& flyer);

}  // namespace trilith
