// Barrel vaults: an arch of the plane as a vault of stones along y, course over course in bond.
//
//          ___________________
//        /____/_________/____/|     Courses run along y, one for each voussoir of the arch. Every second one begins
//       /_________/_________/ |     with half a stone.
//      |                    | /
//
#pragma once

#include <string>
#include <vector>

#include "build/plane/arch.hpp"
#include "build/space/solid_part.hpp"

namespace trilith {

/// A barrel vault. Its stones have plane faces because they are prisms: the ends lie in planes of constant y, and each
/// side goes through an edge of the arch's outline and y.
struct BarrelVault {
  std::string name = {};
  Arch arch = {};           ///< its profile, x stays and y becomes z; its name is not used. Pointed and segmental too
  double stone_length = 0;  ///< along y, m, above 0
  int stones = 1;           ///< whole stones in a course, 1 to 10000
  bool bond = true;         ///< false: joint behind joint, rings that stand for themselves
  bool half_first = false;  ///< the first course, not the second, begins with half a stone
  double from = 0;          ///< y where it begins, m
  SolidTurn turn = {};      ///< about the origin, before it is moved
  Vec3 at = Vec3::Zero();   ///< by which it is moved, m
};

/// Course by course from the left, along y: "c2.s1" for the first stone of the second course, in groups "voussoirs",
/// "course 2", "key" (of the middle course of an odd number) and the vault's name; "left" and "right" in "abutments",
/// as long as the vault, where the arch has them. Stones that meet share the coordinates of their faces to the bit.
/// Throws InputError as build_arch does, and for numbers out of range.
std::vector<SolidPart> build_barrel_vault(const BarrelVault& vault);

}  // namespace trilith
