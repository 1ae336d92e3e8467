// Spheres, clumps of spheres, and random packings of grains in a box.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// A body of overlapping or touching spheres. A capsule is a row of them.
struct Clump {
  std::string name = {};
  std::vector<Sphere> spheres = {};  ///< about its own origin [m]
  Vec3 at = Vec3::Zero();            ///< position of that origin [m]
  SolidTurn turn = {};               ///< about it
};

/// Throws InputError for no sphere or more than 1000, a radius not above 0, a sphere that touches no other, a sphere
/// within another, and numbers that are not finite.
SolidPart build_clump(const Clump& clump);

/// Distribution of the radii of grains.
enum class Grading {
  number,  ///< uniform by number
  mass     ///< uniform by volume: many small grains
};

/// Random grains in a box without contact, ready to fall.
struct Pour {
  std::string name = {};
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< initial box [m]
  int count = 100;                               ///< 1 to 200000
  double least = 0, most = 0;                    ///< radii [m]
  Grading grading = Grading::number;
  std::vector<Sphere> shape = {};  ///< shape of clumps, in any unit: each is scaled so that the sphere around it has
                                   ///< the radius of the grain
  double share = 1;                ///< share of clumps among the grains, if there is a shape
  int seed = 1;                    ///< the same number gives the same bits everywhere
};

/// Grains "g1", "g2", ... from the bottom up, in group "grains" and the pour's name, clumps also in "clumps". They are
/// placed on a lattice whose cells fit the largest grain, each moved at random within its cell. Throws InputError for a
/// box that is too small, with the number of grains that fit.
std::vector<SolidPart> build_pour(const Pour& pour);

}  // namespace trilith
