// Barrel vaults: a plane arch profile extended along y in courses of stones with a bond.
//
//          ___________________
//        /____/_________/____/|     Courses run along y, one for each voussoir of the arch. Every second one begins
//       /_________/_________/ |     with half a stone.
//      |                    | /
#pragma once

#include <string>
#include <vector>

#include "build/plane/arch.hpp"
#include "build/space/solid_part.hpp"

namespace trilith {

/// A barrel vault. Its stones are prisms with plane faces: the ends lie in planes of constant y, and each side contains
/// an edge of the arch's outline and the direction y.
struct BarrelVault {
  std::string name = {};
  Arch arch = {};           ///< its profile, y becomes z; its name is not used. Pointed and segmental arches too
  double stone_length = 0;  ///< along y [m], above 0
  int stones = 1;           ///< whole stones in a course, 1 to 10000
  bool bond = true;         ///< false: continuous joints, so that the rings are independent
  bool half_first = false;  ///< the first course, not the second, begins with half a stone
  double from = 0;          ///< y of its start [m]
  SolidTurn turn = {};      ///< about the origin, before translation
  Vec3 at = Vec3::Zero();   ///< translation [m]

  static constexpr std::string_view kind = "vault";
  static constexpr std::string_view sentence =
      "a barrel vault of stones in bond: the arch of model:arch, extended along y";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<BarrelVault>;
    return std::tuple(K::Within<Arch, ProfileKeys>{&BarrelVault::arch},
                      K::Number{&BarrelVault::stone_length, "stone_length", "m", "length of a stone along y",
                                above_zero, must_be_given},
                      K::Count{&BarrelVault::stones, "stones", "number of whole stones in a course", 1, 10000},
                      K::Flag{&BarrelVault::bond, "bond", "joints shift from course to course"},
                      K::Flag{&BarrelVault::half_first, "half_first", "the first course begins with half a stone"},
                      K::Number{&BarrelVault::from, "from", "m", "y of the start"},
                      K::Vector{&BarrelVault::at, "at", "translation"});
  }
  /// build_barrel_vault.
  [[nodiscard]] SolidParts parts() const;
};

/// Parts course by course from the left, along y. Stone "c2.s1" (first of the second course) is in groups "voussoirs",
/// "course 2", "key" (middle course of an odd number) and the vault's name. Parts "left" and "right" in "abutments"
/// extend over the length of the vault, if the arch has abutments. Stones that meet share the coordinates of their
/// faces to the bit. Throws InputError as build_arch does, and for numbers out of range.
std::vector<SolidPart> build_barrel_vault(const BarrelVault& vault);

}  // namespace trilith
