// The checked plan of a building: footprints, junctions, levels, openings.
#pragma once

#include <string>
#include <vector>

#include "build/space/building.hpp"

namespace trilith {

/// A stretch along x or y [m].
struct Stretch {
  double low = 0, high = 0;
};

inline bool overlaps(const Stretch& a, const Stretch& b, double same) {
  return a.low < b.high - same && b.low < a.high - same;
}

/// The parts of a stretch between others that share at most their ends with each other.
std::vector<Stretch> between(const Stretch& whole, std::vector<Stretch> others, double same);

/// A box of a wall without units: an opening or a lintel.
struct WallVoid {
  Stretch along;
  int first = 0, end = 0;  ///< courses of the storey
  bool lintel = false;
};

/// A pocket of floor beams in a wall.
struct BeamPocket {
  Stretch along;
  int first = 0, end = 0;      ///< courses of the storey
  std::vector<Stretch> beams;  ///< parts of the thickness; two if a beam ends at either face
  int beam = 0;                ///< index of the first of them
};

/// A floor beam.
struct PlannedBeam {
  int axis = 0;  ///< 0: along x, 1: along y
  Stretch along, across;
  int first = 0, end = 0;  ///< courses of the storey
};

struct PlannedWall {
  std::string name;
  int axis = 0;          ///< 0: along x, 1: along y
  bool forward = false;  ///< its line begins at the low end
  Stretch along;         ///< including its ends in the thickness of other walls
  Stretch across;        ///< its two faces
  const LeafBond* bond = nullptr;
  std::vector<Stretch> junctions;                ///< thicknesses of the walls across it
  std::vector<std::vector<WallVoid>> voids;      ///< [storey]
  std::vector<std::vector<BeamPocket>> pockets;  ///< [storey], sorted along the wall
};

struct PlannedStorey {
  std::vector<double> line;  ///< heights of course lines [m]: one more than courses
  double top = 0;            ///< of the slab, or of the last course where there is none
  std::vector<PlannedBeam> beams;
  [[nodiscard]] int courses() const { return static_cast<int>(line.size()) - 1; }
};

struct BuildingPlan {
  std::string owner;                                   ///< begins messages
  double unit = 0, header = 0, course = 0, least = 0;  ///< [m]
  std::vector<PlannedWall> walls;
  std::vector<PlannedStorey> storeys;
  Polygon floor;   ///< outline of slabs
  Vec2 low, high;  ///< of all walls
  std::vector<std::string> notes;
};

/// Begin of messages about one wall.
std::string title_of(const BuildingPlan& plan, const PlannedWall& wall);

/// Makes all checks except for short pieces; throws InputError as build_building does.
BuildingPlan plan_building(const Building& building, const std::string& owner);

}  // namespace trilith
