// Flying buttresses: half an arch between a pier and the head of a wall.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
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

  static constexpr std::string_view kind = "flying_buttress";
  static constexpr std::string_view sentence =
      "a flying buttress: half an arch that leans from a pier against the head of a wall";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<FlyingButtress>;
    using F = FlyingButtress;
    return std::tuple(
        K::Count{&F::voussoirs, "voussoirs", "number of voussoirs", 1, 10000},
        K::Number{&F::span, "span", "m", "distance from the pier to the wall", above_zero},
        K::Number{&F::rise, "rise", "m", "rise of the intrados", above_zero},
        K::Number{&F::radius, "radius", "m", "radius of the intrados", not_below_zero, {"level at the head"}},
        K::Number{&F::thickness, "thickness", "m", "thickness of the ring; with a coping vertical at the wall",
                  above_zero},
        K::Number{&F::slope, "slope", "rad", "slope of a straight coping that rises to the wall; 0: none",
                  not_below_zero},
        K::Count{&F::sub_edges, "sub_edges", "number of edges of each curved side", 1, 1000},
        K::Point{&F::springing, "springing", "springing of the intrados, at the edge of the pier"},
        K::Number{&F::pier_width, "pier_width", "m", "width of the pier", not_below_zero, {"1.5 times the thickness"}},
        K::Number{&F::pier_height, "pier_height", "m", "height of the pier below the springing; 0: no pier",
                  not_below_zero},
        K::Number{&F::wall_width, "wall_width", "m", "width of the supporting wall; 0: none", not_below_zero},
        K::Number{&F::wall_height,
                  "wall_height",
                  "m",
                  "height of the wall above the head of the intrados",
                  not_below_zero,
                  {"the thickness"}});
  }
  /// build_flying_buttress.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Parts "v1" (at the pier) to "vn" (at the wall), group "voussoirs"; "pier", group "piers"; "wall", group "walls".
/// Neighbouring voussoirs share the two corners of their joint to the bit. Joints are evenly spaced along the intrados.
/// Throws InputError for numbers out of range, and for a circle that does not contain both ends or falls towards the
/// wall. It also throws for a coping that meets the intrados or ends below the pier.
std::vector<Part> build_flying_buttress(const FlyingButtress& flyer);

}  // namespace trilith
