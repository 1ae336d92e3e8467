// View direction of a model in space, and the plane of the picture.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "base/space.hpp"

namespace trilith::draw {

/// Direction from the model to the eye, at infinite distance: pictures are orthographic, so that lengths along one
/// direction have the same scale everywhere. Azimuth from the x axis, anticlockwise seen from above; elevation above
/// the x-y plane. Both in degrees.
struct ViewDirection {
  double azimuth = -45, elevation = 35.26438968275465;
};

/// front (x to the right), back, left, right, top (x to the right, y upwards) and iso, with equally foreshortened axes.
const std::vector<std::string>& view_names();

/// A name of view_names(), or "AZIMUTH,ELEVATION" in degrees, the elevation from -90 to 90. Throws InputError.
ViewDirection view_direction(std::string_view text);

/// Unit vectors of the picture in the world: to the right, upwards, and towards the eye.
struct ViewAxes {
  Vec3 right, up, toward;
  explicit ViewAxes(const ViewDirection& from);
  [[nodiscard]] Vec2 flat(const Vec3& p) const { return {right.dot(p), up.dot(p)}; }
};

}  // namespace trilith::draw
