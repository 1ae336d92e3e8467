// Cross vaults (groin vaults): two barrels of one profile that intersect along the diagonals of a square bay.
//
//      ____________________
//     |\        |        /|     Plan view. North and south webs belong to the barrel along y, east and west webs to the
//     |  \______|______/  |     barrel along x; at each point the higher barrel is built. Stones of a course end in the
//     |  | \ ___|___ / |  |     diagonal planes. The two stones of one course that meet there form a groin stone of two
//     |__|__|_ key _|__|__|     pieces; they share their face in the diagonal plane, because both barrels have the same
//     |  |  |_______|  |  |     profile. In the middle four of them form the key.
//     |  | /    |    \ |  |
//     |  /------|------\  |
//     |/________|________\|
#pragma once

#include <string>
#include <vector>

#include "build/plane/arch.hpp"
#include "build/space/solid_part.hpp"

namespace trilith {

/// A cross vault over a square bay about the origin. All faces are plane: faces of prisms, or cuts by one plane.
struct CrossVault {
  std::string name = {};
  Arch arch = {};           ///< profile of both barrels; its name, centre's x (which is 0) and abutments are not used
  double half_bay = 0;      ///< from the middle to each end of the webs [m], at least to the arch's outer edge; 0: to
                            ///< that edge
  double stone_length = 0;  ///< along each web, measured from its end [m], above 0
  bool bond = true;         ///< every second course begins with half a stone
  Vec3 at = Vec3::Zero();   ///< of the middle of the bay [m]
  double angle = 0;         ///< of the bay about z, counter-clockwise [rad]

  static constexpr std::string_view kind = "cross_vault";
  static constexpr std::string_view sentence = "two barrels that meet along the diagonals of a square bay";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<CrossVault>;
    return std::tuple(K::Within<Arch, ProfileKeys>{&CrossVault::arch},
                      K::Number{&CrossVault::half_bay,
                                "half_bay",
                                "m",
                                "distance from the middle to each end",
                                not_below_zero,
                                {"to the arch's edge"}},
                      K::Number{&CrossVault::stone_length, "stone_length", "m", "length of a stone along each web",
                                above_zero, must_be_given},
                      K::Flag{&CrossVault::bond, "bond", "joints shift from course to course"},
                      K::Vector{&CrossVault::at, "at", "middle of the bay"},
                      K::Number{&CrossVault::angle, "angle", "rad", "rotation about z"});
  }
  /// build_cross_vault.
  [[nodiscard]] SolidParts parts() const;
};

/// Parts:
///   - "north.c2.s1" (second course from the west, for webs rotated to the north; first stone from its end): groups
///     "voussoirs", "north", "course 2".
///   - "groin1.c2" (north-west, then counter-clockwise; second course from the springing): "groins", "groin 1",
///     "course 2".
///   - "key": "key", for an odd number of voussoirs.
/// All parts are in the vault's group. Throws InputError as build_arch does, and for numbers out of range.
std::vector<SolidPart> build_cross_vault(const CrossVault& vault);

}  // namespace trilith
