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

  static constexpr std::string_view kind = "prism";
  static constexpr std::string_view sentence = "an upright regular prism";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<RegularPrism>;
    return std::tuple(K::Count{&RegularPrism::sides, "sides", "number of sides", 3, 1000},
                      K::Number{&RegularPrism::radius, "radius", "m", "radius of the circle through the corners",
                                above_zero, must_be_given},
                      K::Number{&RegularPrism::height, "height", "m", "height", above_zero, must_be_given},
                      K::Number{&RegularPrism::phase, "phase", "rad", "angle of the first corner, from x"},
                      K::Vector{&RegularPrism::at, "at", "middle of the foot"},
                      K::OwnTable<SolidTurn, TurnKeys>{&RegularPrism::turn, "turn", turn_wanted,
                                                       "rotation about `at`: { axis = , angle = }"});
  }
  /// build_prism.
  [[nodiscard]] SolidParts parts() const;
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

  static constexpr auto keys() {
    using K = KeysOf<ColumnBlock>;
    return std::tuple(K::Number{&ColumnBlock::width, "width", "m", "along both sides", not_below_zero, must_be_given},
                      K::Number{&ColumnBlock::height, "height", "m", "height", not_below_zero, must_be_given});
  }
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

  static constexpr std::string_view kind = "column";
  static constexpr std::string_view sentence = "a column of drums, with base and capital";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Column>;
    constexpr std::string_view block = "{ width =, height = }";
    return std::tuple(
        K::Count{&Column::drums, "drums", "number of drums", 1, 10000},
        K::Number{&Column::height, "height", "m", "height of all drums", above_zero, must_be_given},
        K::Count{&Column::sides, "sides", "number of sides of a drum", 3, 1000},
        K::Number{&Column::radius, "radius", "m", "radius at the foot", above_zero, must_be_given},
        K::Number{&Column::top_radius, "top_radius", "m", "radius at the top", not_below_zero, {"as the foot"}},
        K::Choice<DrumRadius, 3>{&Column::of,
                                 "of",
                                 "circle of the radii: through the corners, within the sides, or of equal area",
                                 {"corners", "sides", "area"}},
        K::Number{&Column::phase, "phase", "rad", "angle of the first corners, from x"},
        K::OwnTable<ColumnBlock>{&Column::base, "base", block, "{ width = , height = } under the drums"},
        K::OwnTable<ColumnBlock>{&Column::capital, "capital", block, "{ width = , height = } on the drums"},
        K::Vector{&Column::at, "at", "middle of the foot"});
  }
  /// build_column.
  [[nodiscard]] SolidParts parts() const;
};

/// Parts from below: "base", "d1", "d2", ..., "capital", each in the column's group and "base", "drums" or "capital".
/// Tops and feet share their corners to the bit. Throws InputError for numbers out of range.
std::vector<SolidPart> build_column(const Column& column);

}  // namespace trilith
