// Result of all geometry builders: outlines with names and groups, from which the caller makes bodies.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// One part of a structure. The outline is simple and counter-clockwise [m], in the coordinates of the structure.
struct Part {
  std::string name;
  Polygon outline;
  std::vector<std::string> groups;
};

/// Parts, and the changes to their description, one line each.
struct BuiltParts {
  std::vector<Part> parts;
  std::vector<std::string> notes = {};
};

/// "wall.c3.u2" from "wall" and "c3.u2"; only "c3.u2" if the owner has no name.
std::string part_name(std::string_view owner, std::string_view piece);

/// "arch 'A'" from "arch" and "A"; only "arch" without a name. Messages of a builder begin with it.
std::string builder_title(std::string_view kind, std::string_view name);

/// Throws InputError unless low <= value <= high. `what` names the number with its owner.
int require_count(int value, int low, int high, std::string_view what);

}  // namespace trilith
