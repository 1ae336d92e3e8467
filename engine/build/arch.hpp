// Circular arches of equal voussoirs with radial joints, and the abutments they spring from.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "build/part.hpp"

namespace trilith {

/// A circular arch.
struct Arch {
  std::string name = {};
  int voussoirs = 15;                        ///< 1 to 10000
  double radius = 1;                         ///< of the line midway between intrados and extrados, m
  double thickness = 0.15;                   ///< m, below twice the radius
  double half_angle = std::numbers::pi / 2;  ///< from the crown to a springing, rad: above 0, at most pi/2 (semicircle)
  int sub_edges = 1;            ///< straight edges per voussoir and side, 1 to 1000; 1: straight-sided voussoirs
  Vec2 centre = Vec2::Zero();   ///< of the circle, m
  bool abutments = true;        ///< with a block behind each springing
  double abutment_depth = 0;    ///< of these, away from the arch, m; 0: the thickness
  double abutment_margin = -1;  ///< by which they reach beyond intrados and extrados in the plane of the springing
                                ///< joint, m, below the inner radius; negative: half the thickness or half
                                ///< the inner radius, whichever is less
};

/// Parts "v1" (left) to "vn" (right), group "voussoirs", and "left" and "right", group "abutments". Neighbouring
/// voussoirs share the two corners of their joint to the bit; the arch is its own mirror image to the bit where its
/// centre is at x = 0. All corners lie on the two circles: with k sub-edges a voussoir has the area of the curved one
/// times sin(d)/d, d = 2 half_angle/(n k), so 1 - d^2/6. Face k of a voussoir's outline: 0 .. k-1 intrados from left to
/// right, k right joint, k+1 .. 2k extrados from right to left, 2k+1 left joint. Without a margin an abutment shares
/// the corners of the springing joint to the bit, with one its face is one straight edge through them (to rounding).
/// Throws InputError for numbers out of range.
std::vector<Part> build_arch(const Arch& arch);

}  // namespace trilith
