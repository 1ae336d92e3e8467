// Invariants of the parts of every builder, for the builders' tests.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "build/plane/part.hpp"
#include "geometry/plane/convex_parts.hpp"
#include "geometry/plane/overlap.hpp"

namespace trilith::testing {

inline std::vector<Polygon> pieces_of(const Part& part) {
  std::vector<Polygon> pieces;
  for (const ConvexPiece& piece : convex_parts(part.outline)) {
    Polygon corners;
    for (int i : piece.corners) corners.push_back(part.outline[static_cast<std::size_t>(i)]);
    pieces.push_back(std::move(corners));
  }
  return pieces;
}

/// Largest overlap area of two parts [m2].
inline double largest_overlap(const std::vector<Part>& parts) {
  std::vector<std::vector<Polygon>> pieces;
  for (const Part& part : parts) pieces.push_back(pieces_of(part));
  OverlapBuffer buffer;
  double largest = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j)
      for (const Polygon& a : pieces[i])
        for (const Polygon& b : pieces[j]) largest = std::max(largest, convex_overlap(a, b, buffer).area);
  return largest;
}

/// Checks for simple counter-clockwise outlines without defects, unique names, at least one group, no overlap.
inline void check_sound(const std::vector<Part>& parts) {
  std::set<std::string> names;
  for (const Part& part : parts) {
    const CheckedPolygon checked = check_polygon(part.outline, part.name);
    CHECK(checked.notes.empty());
    CHECK(checked.outline == part.outline);
    CHECK_FALSE(part.groups.empty());
    CHECK(names.insert(part.name).second);
  }
  CHECK(largest_overlap(parts) < 1e-12);
}

/// Checks that every corner of a unit is a corner or a joint of its neighbours: coordinates within about `width` [m]
/// have the same bits.
inline void check_one_grid(const std::vector<Part>& parts, double width) {
  std::map<long, double> x, y;
  for (const Part& part : parts)
    for (const Vec2& p : part.outline) {
      CHECK(x.emplace(std::lround(p.x() / width), p.x()).first->second == p.x());
      CHECK(y.emplace(std::lround(p.y() / width), p.y()).first->second == p.y());
    }
}

inline double total_area(const std::vector<Part>& parts) {
  double area = 0;
  for (const Part& part : parts) area += signed_area(part.outline);
  return area;
}

inline const Part& named(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  REQUIRE(found != parts.end());
  return *found;
}

inline int count_in_group(const std::vector<Part>& parts, const std::string& group) {
  return static_cast<int>(std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return std::count(part.groups.begin(), part.groups.end(), group) > 0;
  }));
}

/// The one-line error message of a builder, or "accepted".
template <class Build>
std::string refusal_of(Build build) {
  try {
    build();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline bool mentions(const std::string& message, std::string_view part) {
  return message.find(part) != std::string::npos && message.find('\n') == std::string::npos;
}

}  // namespace trilith::testing
