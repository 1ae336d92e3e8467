// Domes of rings and sectors, closed by a key or open at the top.
//
//            key, or open          Corners lie on two spheres about the centre, at equal steps of colatitude (the angle
//           _____|_____            from the vertical) and of angle about the vertical axis.
//         /_|__|___|__|_\          A stone has eight corners.
//        /__|__|___|__|__\         Its sides lie in planes through the axis. Its beds, intrados and extrados are each
//       |___|__|___|__|___|        bounded by two parallel chords between the same two sectors. So all six
//                                  faces are plane to rounding, and stones above each other share their beds.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Closure of a dome.
enum class DomeTop {
  key,    ///< a stone with as many sides as there are sectors
  oculus  ///< open
};

/// A dome of stones with plane faces. All rings have their joints in the same planes: with shifted joints, the chords
/// of adjacent beds would cross.
struct Dome {
  std::string name = {};
  double radius = 1;                        ///< midway between the two spheres [m]
  double thickness = 0.1;                   ///< between them [m], below twice the radius
  int rings = 8;                            ///< 1 to 1000
  int sectors = 16;                         ///< 3 to 1000
  double springing = std::numbers::pi / 2;  ///< colatitude of the lowest bed [rad], at most pi/2 (a half sphere)
  double crown = std::numbers::pi / 18;     ///< colatitude of the uppermost bed [rad], above 0, below the springing
  DomeTop top = DomeTop::key;               ///< part within the uppermost bed
  double phase = 0;                         ///< angle of the first joint from x [rad]
  Vec3 centre = Vec3::Zero();               ///< of the spheres [m]

  static constexpr std::string_view kind = "dome";
  static constexpr std::string_view sentence = "a dome of rings and sectors of stones with plane faces";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Dome>;
    return std::tuple(
        K::Number{&Dome::radius, "radius", "m", "radius of the middle surface", above_zero},
        K::Number{&Dome::thickness, "thickness", "m", "thickness", above_zero},
        K::Count{&Dome::rings, "rings", "number of rings", 1, 1000},
        K::Count{&Dome::sectors, "sectors", "number of sectors", 3, 1000},
        K::Number{&Dome::springing,
                  "springing",
                  "rad",
                  "angle of the lowest bed from the vertical; default a hemisphere",
                  above_zero,
                  {"pi/2"}},
        K::Number{
            &Dome::crown, "crown", "rad", "angle of the uppermost bed, 10 degrees by default", above_zero, {"pi/18"}},
        K::Choice<DomeTop, 2>{&Dome::top, "top", "closure", {"key", "oculus"}},
        K::Number{&Dome::phase, "phase", "rad", "angle of the first joint, from x"},
        K::Vector{&Dome::centre, "centre", "centre of the sphere"});
  }
  /// build_dome.
  [[nodiscard]] SolidParts parts() const;
};

/// "r2.s5" (second ring from below, fifth sector) in groups "voussoirs", "ring 2", "sector 5" and the dome's name, then
/// "key" in "key". Stones that meet share corners to the bit. Throws InputError for numbers out of range.
std::vector<SolidPart> build_dome(const Dome& dome);

}  // namespace trilith
