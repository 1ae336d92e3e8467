// Faces of bodies chosen by their side: side = "left" ..., "all", or in the plane from =, to =.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bindings/core/keys.hpp"
#include "load/list.hpp"
#include "model/model.hpp"

namespace trilith::script {

/// Direction to a side by name, in the plane and in space.
struct FaceSide {
  std::string_view name;
  std::array<double, 2> plane;
  std::array<double, 3> space;
};
inline constexpr std::array face_sides{FaceSide{"left", {-1, 0}, {-1, 0, 0}}, FaceSide{"right", {1, 0}, {1, 0, 0}},
                                       FaceSide{"top", {0, 1}, {0, 0, 1}},    FaceSide{"bottom", {0, -1}, {0, 0, -1}},
                                       FaceSide{"front", {0, 0}, {0, -1, 0}}, FaceSide{"back", {0, 0}, {0, 1, 0}}};

/// A choice of faces.
struct SideFaces {
  std::string side;
  std::optional<Vec2> from, to;
};

/// Reads side, and in the plane from and to. `needed` begins the message where none is given.
template <int D>
SideFaces read_sides(Keys& keys, const std::string& needed);

/// These faces of a body at the start. `owner` begins messages.
std::vector<WetFace<2>> faces_of(const Model<2>& model, int body, const SideFaces& choice, const std::string& owner);
std::vector<WetFace<3>> faces_of(const Model<3>& model, int body, const SideFaces& choice, const std::string& owner);

}  // namespace trilith::script
