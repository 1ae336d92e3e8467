// Regular prisms, drums of columns, and columns of drums.
//
//        ____         n sides about an upright axis, the first corner at `phase` from x. Drums may taper: their sides
//       /    \        are then trapezoids, whose level edges are parallel, so that they are plane.
//      |\____/|
//      |      |       n = 6, seen from above at a slant
//       \____/
//
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// An upright regular prism.
struct RegularPrism {
  std::string name = {};
  int sides = 6;           ///< 3 to 1000; above max_face_corners it comes in pieces
  double radius = 0;       ///< of the circle through its corners, m, above 0
  double height = 0;       ///< m, above 0
  double phase = 0;        ///< angle of the first corner from x, counter-clockwise, rad
  Vec3 at = Vec3::Zero();  ///< middle of its foot, m
  SolidTurn turn = {};     ///< about `at`
  std::vector<std::string> groups = {};
};

/// Volume: sides/2 sin(2 pi/sides) radius^2 height. Throws InputError for numbers out of range.
SolidPart build_prism(const RegularPrism& prism);

/// What of a drum of n sides has the radius that is given.
enum class DrumRadius {
  corners,  ///< the circle through its corners
  sides,    ///< the circle within, which its sides touch
  area      ///< the circle of the same area: weight and stress are those of a round drum
};

/// A drum of a column: round, made of straight sides.
struct Drum {
  std::string name = {};
  int sides = 16;                    ///< 3 to 1000; above max_face_corners it comes in pieces
  double radius = 0;                 ///< of the foot, m, above 0
  double top_radius = 0;             ///< m; 0: as the foot
  DrumRadius of = DrumRadius::area;  ///< what the radii are of
  double height = 0;                 ///< m, above 0
  double phase = 0;                  ///< angle of the first corner from x, rad
  Vec3 at = Vec3::Zero();            ///< middle of its foot, m
  SolidTurn turn = {};               ///< about `at`
  std::vector<std::string> groups = {};
};

/// Throws InputError for numbers out of range.
SolidPart build_cylinder_drum(const Drum& drum);

/// A square block under or on the drums of a column.
struct ColumnBlock {
  double width = 0;   ///< m; 0: none
  double height = 0;  ///< m, above 0 where there is one
};

/// A column of drums.
struct Column {
  std::string name = {};
  int drums = 1;                     ///< of equal height, 1 to 10000; used where `heights` has none
  double height = 0;                 ///< of all of them, m, above 0; used where `heights` has none
  std::vector<double> heights = {};  ///< of each drum from below, m, above 0
  int sides = 16;                    ///< 3 to 1000
  double radius = 0;                 ///< of the lowest foot, m, above 0
  double top_radius = 0;             ///< of the uppermost top, m; 0: as the foot. Between, it goes with height
  DrumRadius of = DrumRadius::area;  ///< what the radii are of
  double phase = 0;                  ///< angle of the first corner of all drums from x, rad
  ColumnBlock base = {};             ///< under the drums, sides along x and y
  ColumnBlock capital = {};          ///< on the drums
  Vec3 at = Vec3::Zero();            ///< middle of the foot of the column, with its base, m
};

/// From below: "base", "d1", "d2", ..., "capital", each in the column's group and "base", "drums" or "capital". Tops
/// and feet share their corners to the bit. Throws InputError for numbers out of range.
std::vector<SolidPart> build_column(const Column& column);

}  // namespace trilith
