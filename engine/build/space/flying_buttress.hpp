// Flying buttresses: half an arch between a pier and the head of a wall.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// The intrados is a circular arc from its springing, at the inner edge of the pier, to its head on the face of the
/// wall. Joints are radial; the joint at the wall is vertical. The extrados is a circle too, or the straight line of a
/// coping that rises to the wall. The origin is the springing, and the wall is to the right.
///
///                      .-'|  |
///        coping    .-'   _|  |
///              .-'   .-'  |  |
///     ____ .-'   .'   rise|  | wall
///    |     \  .'          |  |
///    |      \:....span....|  |
///    | pier |
struct FlyingButtress {
  std::string name = {};
  int voussoirs = 9;       ///< 1 to 10000
  double span = 4;         ///< from the pier to the wall [m]
  double rise = 2;         ///< of the intrados, from the pier to the wall [m]
  double radius = 0;       ///< of the intrados [m]; 0: horizontal at the head, with `rise` at most `span`
  double thickness = 0.4;  ///< of the ring along its joints, or with a coping vertically at the wall [m]
  double slope = 0;        ///< of the coping against the horizontal [rad], below pi/2; 0: no coping, constant ring
                           ///< thickness
  int sub_edges = 1;       ///< straight edges of the intrados per voussoir, and of the extrados without coping, 1 to
                           ///< 1000
  Vec2 springing = Vec2::Zero();  ///< springing of the intrados [m]
  double pier_width = 0;          ///< [m]; 0: 1.5 times the thickness
  double pier_height = 0;         ///< below the springing [m]; 0: no pier
  double wall_width = 0;          ///< [m]; 0: no wall
  double wall_height = 0;         ///< above the head of the intrados [m]; it begins at the springing. 0: the thickness
};

/// Parts "v1" (at the pier) to "vn" (at the wall), group "voussoirs"; "pier", group "piers"; "wall", group "walls".
/// Neighbouring voussoirs share the two corners of their joint to the bit. Joints are evenly spaced along the intrados.
/// Throws InputError for numbers out of range, and for a circle that does not contain both ends or falls towards the
/// wall. It also throws for a coping that meets the intrados or ends below the pier.
std::vector<Part> build_flying_buttress(const FlyingButtress& flyer);

}  // namespace trilith
