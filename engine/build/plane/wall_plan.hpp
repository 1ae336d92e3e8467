// What a wall's description comes to once it is checked: levels, and the rectangles that are no units.
#pragma once

#include <string>
#include <vector>

#include "build/plane/bond_pattern.hpp"
#include "build/plane/wall.hpp"

namespace trilith {

enum class FieldKind { opening, lintel, sill };

/// A rectangle of a storey that is not laid with units: empty, or one block.
struct WallField {
  double from, to;  ///< m from the wall's left end
  int first, last;  ///< courses
  FieldKind kind;
  int number;  ///< among those of its kind in the storey, from 1
};

/// "opening", "lintel" or "sill".
constexpr const char* name_of(FieldKind kind) {
  constexpr const char* names[] = {"opening", "lintel", "sill"};
  return names[static_cast<int>(kind)];
}

/// A stretch of a storey's length that has openings, m from the wall's left end.
struct WallStrip {
  double from, to;
};

struct StoreyPlan {
  std::vector<double> line;       ///< heights of the course lines above the wall's foot, m: one more than courses
  double top;                     ///< of the slab, or of the last course where there is none, m above the wall's foot
  std::vector<WallField> fields;  ///< openings, then lintels and sills
  std::vector<WallStrip> strips;  ///< from left to right, apart from each other

  [[nodiscard]] int courses() const { return static_cast<int>(line.size()) - 1; }
  [[nodiscard]] bool has_slab() const { return top > line.back(); }
};

struct WallPlan {
  std::string owner;  ///< begins messages
  double length;      ///< m
  BondUnits units;
  double course_height;  ///< m
  const BondPattern* bond;
  double least_length;  ///< m
  std::vector<StoreyPlan> storeys;
  std::vector<std::string> notes;
};

/// Checks everything that can be checked before units are laid; throws InputError as build_wall does.
WallPlan plan_wall(const Wall& wall);

}  // namespace trilith
