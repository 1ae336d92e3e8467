// Spheres, clumps of spheres, and many of them at random in a box.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Spheres that overlap or touch, as one body. A capsule is a row of them.
struct Clump {
  std::string name = {};
  std::vector<Sphere> spheres = {};  ///< about its own origin, m
  Vec3 at = Vec3::Zero();            ///< where that origin stands, m
  SolidTurn turn = {};               ///< about it
};

/// Throws InputError: no sphere, more than 1000, a radius that is not above 0, one that touches none of the others, one
/// that lies within another, numbers that are not finite.
SolidPart build_clump(const Clump& clump);

/// By what the radii of grains are spread evenly.
enum class Grading {
  number,  ///< as many of each radius
  mass     ///< as much volume of each radius: many small ones
};

/// Grains at random in a box, none touching another, ready to fall.
struct Pour {
  std::string name = {};
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< the box they begin in, m
  int count = 100;                               ///< 1 to 200000
  double least = 0, most = 0;                    ///< radii, m
  Grading grading = Grading::number;
  std::vector<Sphere> shape = {};  ///< what clumps among them are like, in any unit: they are made as large as their
                                   ///< radius, that of the ball around them, says
  double share = 1;                ///< of clumps among the grains, where there is a shape
  int seed = 1;                    ///< the same number gives the same bits everywhere
};

/// Grains "g1", "g2", ... from the bottom up, in group "grains" and the pour's name, clumps in "clumps" too. They stand
/// on a lattice as wide as the largest of them needs, each moved at random within its cell. Throws InputError for a box
/// that is too small, and says for how many it has room.
std::vector<SolidPart> build_pour(const Pour& pour);

}  // namespace trilith
