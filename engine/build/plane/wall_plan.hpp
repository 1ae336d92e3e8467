// The checked plan of a wall: levels, and the rectangles without units.
#pragma once

#include <string>
#include <vector>

#include "build/plane/bond_pattern.hpp"
#include "build/plane/wall.hpp"

namespace trilith {

enum class FieldKind { opening, lintel, sill };

/// A rectangle of a storey without units: empty, or one block.
struct WallField {
  double from, to;  ///< m from the wall's left end
  int first, last;  ///< courses
  FieldKind kind;
  int number;  ///< index among the fields of its kind in the storey, from 1
};

/// "opening", "lintel" or "sill".
constexpr const char* name_of(FieldKind kind) {
  constexpr const char* names[] = {"opening", "lintel", "sill"};
  return names[static_cast<int>(kind)];
}

/// A stretch of a storey's length with openings, from the wall's left end [m].
struct WallStrip {
  double from, to;
};

struct StoreyPlan {
  std::vector<double> line;       ///< heights of the course lines above the wall's foot [m]: one more than courses
  double top;                     ///< of the slab, or of the last course without a slab, above the wall's foot [m]
  std::vector<WallField> fields;  ///< openings, then lintels and sills
  std::vector<WallStrip> strips;  ///< from left to right, separate from each other

  [[nodiscard]] int courses() const { return static_cast<int>(line.size()) - 1; }
  [[nodiscard]] bool has_slab() const { return top > line.back(); }
};

struct WallPlan {
  std::string owner;  ///< begins messages
  double length;      ///< [m]
  BondUnits units;
  double course_height;  ///< [m]
  const BondPattern* bond;
  double least_length;  ///< [m]
  std::vector<StoreyPlan> storeys;
  std::vector<std::string> notes;
};

/// Makes all checks that need no units; throws InputError as build_wall does.
WallPlan plan_wall(const Wall& wall);

}  // namespace trilith
