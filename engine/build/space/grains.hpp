// Spheres, clumps of spheres, and random packings of grains in a box.
#pragma once

#include <string>
#include <vector>

#include "build/space/solid_part.hpp"

namespace trilith {

/// Keys of a sphere in a list of scripts.
struct SphereKeys {
  static constexpr auto keys() {
    using K = KeysOf<Sphere>;
    return std::tuple(K::Vector{&Sphere::centre, "at", "centre", must_be_given},
                      K::Number{&Sphere::radius, "radius", "m", "radius", above_zero, must_be_given});
  }
};

/// One sphere as a body.
struct Ball {
  std::string name = {};
  double radius = 0;       ///< [m], above 0
  Vec3 at = Vec3::Zero();  ///< its centre [m]

  static constexpr std::string_view kind = "sphere";
  static constexpr std::string_view sentence = "a sphere";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Ball>;
    return std::tuple(K::Number{&Ball::radius, "radius", "m", "radius", above_zero, must_be_given},
                      K::Vector{&Ball::at, "at", "centre"});
  }
  /// Throws InputError for a radius not above 0, and numbers that are not finite.
  [[nodiscard]] SolidParts parts() const;
};

/// A body of overlapping or touching spheres. A capsule is a row of them.
struct Clump {
  std::string name = {};
  std::vector<Sphere> spheres = {};  ///< about its own origin [m]
  Vec3 at = Vec3::Zero();            ///< position of that origin [m]
  SolidTurn turn = {};               ///< about it

  static constexpr std::string_view kind = "clump";
  static constexpr std::string_view sentence =
      "overlapping or touching spheres as one body. Its mass is the mass of their union. Each sphere has its own "
      "contacts";
  static constexpr bool is_single = true;
  static constexpr auto keys() {
    using K = KeysOf<Clump>;
    return std::tuple(
        K::List<Sphere, SphereKeys>{&Clump::spheres, "spheres", "spheres: sphere",
                                    "{ { at = {x, y, z}, radius = }, ... }, relative to its own origin", must_be_given},
        K::Vector{&Clump::at, "at", "position of that origin"},
        K::OwnTable<SolidTurn, TurnKeys>{&Clump::turn, "turn", turn_wanted,
                                         "rotation about it: { axis = {x, y, z}, angle = }"});
  }
  /// build_clump.
  [[nodiscard]] SolidParts parts() const;
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

  static constexpr std::string_view kind = "pour";
  static constexpr std::string_view sentence =
      "spheres, or clumps of one shape, at random in a box without contact, ready to fall";
  static constexpr bool is_single = false;
  static constexpr bool falls = true;  ///< its parts may start without support
  static constexpr auto keys() {
    using K = KeysOf<Pour>;
    return std::tuple(
        K::Vector{&Pour::low, "low", "corner of the box", must_be_given},
        K::Vector{&Pour::high, "high", "opposite corner", must_be_given},
        K::Count{&Pour::count, "count", "number of bodies", 1, 200000},
        K::NumberOrRange{&Pour::least, &Pour::most, "radius", "m", "radius of all, or { least, greatest } [m]",
                         above_zero},
        K::Choice<Grading, 2>{&Pour::grading, "grading", "uniform distribution of the radii", {"number", "mass"}},
        K::List<Sphere, SphereKeys>{
            &Pour::shape, "clump", "clump: sphere",
            "{ { at = {x, y, z}, radius = }, ... }: a shape, scaled to the size of a sphere of the radius"},
        K::Number{&Pour::share, "share", "1", "share of clumps among the bodies, with a shape", {0, 1}},
        K::Count{&Pour::seed, "seed", "seed of the random numbers"});
  }
  /// build_pour.
  [[nodiscard]] SolidParts parts() const;
};

/// Grains "g1", "g2", ... from the bottom up, in group "grains" and the pour's name, clumps also in "clumps". They are
/// placed on a lattice whose cells fit the largest grain, each moved at random within its cell. Throws InputError for a
/// box that is too small, with the number of grains that fit.
std::vector<SolidPart> build_pour(const Pour& pour);

}  // namespace trilith
