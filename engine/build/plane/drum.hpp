// Regular prisms, drums of columns, and columns of drums.
//
//        ____         n sides about a vertical axis, the first corner at `phase` from x. Drums may taper: their sides
//       /    \        are then trapezoids with parallel horizontal edges, so that they are plane.
//      |\____/|
//      |      |       n = 6, oblique view from above
//       \____/
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// A vertical regular prism.
struct RegularPrism {
  std::string name = {};
  int sides = 6;           ///< 3 to 1000; above max_face_corners it is divided into pieces
  double radius = 0;       ///< of the circle through its corners [m], above 0
  double height = 0;       ///< [m], above 0
  double phase = 0;        ///< angle of the first corner from x, counter-clockwise [rad]
  Vec3 at = Vec3::Zero();  ///< middle of its foot [m]
  SolidTurn turn = {};     ///< about `at`
  std::vector<std::string> groups = {};
};

/// Volume: sides/2 sin(2 pi/sides) radius^2 height. Throws InputError for numbers out of range.
SolidPart build_prism(const RegularPrism& prism);

/// The circle of a polygonal drum to which its radius refers.
enum class DrumRadius {
  corners,  ///< the circle through its corners
  sides,    ///< the inscribed circle, which the sides touch
  area      ///< the circle of equal area: weight and stress are right for a round drum
};

/// A round drum of a column, with straight sides.
struct Drum {
  std::string name = {};
  int sides = 16;                    ///< 3 to 1000; above max_face_corners it is divided into pieces
  double radius = 0;                 ///< of the foot [m], above 0
  double top_radius = 0;             ///< [m]; 0: as the foot
  DrumRadius of = DrumRadius::area;  ///< meaning of the radii
  double height = 0;                 ///< [m], above 0
  double phase = 0;                  ///< angle of the first corner from x [rad]
  Vec3 at = Vec3::Zero();            ///< middle of its foot [m]
  SolidTurn turn = {};               ///< about `at`
  std::vector<std::string> groups = {};
};

/// Throws InputError for numbers out of range.
SolidPart build_cylinder_drum(const Drum& drum);

/// A square block under or on the drums of a column.
struct ColumnBlock {
  double width = 0;   ///< [m]; 0: none
  double height = 0;  ///< [m], above 0 where there is one
};

/// A column of drums.
struct Column {
  std::string name = {};
  int drums = 1;                     ///< of equal height, 1 to 10000; used if `heights` is empty
  double height = 0;                 ///< of all drums together [m], above 0; used if `heights` is empty
  std::vector<double> heights = {};  ///< of each drum from below [m], above 0
  int sides = 16;                    ///< 3 to 1000
  double radius = 0;                 ///< of the lowest foot [m], above 0
  double top_radius = 0;             ///< of the uppermost top [m]; 0: as the foot. It varies linearly with height
  DrumRadius of = DrumRadius::area;  ///< meaning of the radii
  double phase = 0;                  ///< angle of the first corner of all drums from x [rad]
  ColumnBlock base = {};             ///< under the drums, sides along x and y
  ColumnBlock capital = {};          ///< on the drums
  Vec3 at = Vec3::Zero();            ///< middle of the foot of the column, base included [m]
};

/// Parts from below: "base", "d1", "d2", ..., "capital", each in the column's group and "base", "drums" or "capital".
/// Tops and feet share their corners to the bit. Throws InputError for numbers out of range.
std::vector<SolidPart> build_column(const Column& column);

}  // namespace trilith
