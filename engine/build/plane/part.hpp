// What every geometry builder returns: plain outlines with names and groups, to be made bodies of by the caller.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// One piece of a structure. The outline is simple and counter-clockwise, m, in the structure's own coordinates.
struct Part {
  std::string name;
  Polygon outline;
  std::vector<std::string> groups;
};

/// "wall.c3.u2" from "wall" and "c3.u2"; just "c3.u2" where the owner has no name.
std::string part_name(std::string_view owner, std::string_view piece);

/// "arch 'A'" from "arch" and "A", just "arch" where there is no name: how a builder's messages begin.
std::string builder_title(std::string_view kind, std::string_view name);

/// Throws InputError unless low <= value <= high. `what` names the number with its owner.
int require_count(int value, int low, int high, std::string_view what);

}  // namespace trilith
