#include "build/plane/ground.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace trilith {

PolygonPart build_ground_profile(const GroundProfile& profile) {
  const std::string owner = builder_title("ground profile", profile.name);
  const std::vector<Vec2>& surface = profile.surface;
  require_finite(profile.base_level, owner + ": base level");
  if (surface.size() < 2)
    throw InputError(fmt::format("{}: surface has {} point{}, needs at least 2", owner, surface.size(),
                                 surface.size() == 1 ? "" : "s"));
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::string what =
        fmt::format("{}: surface point {} ({:g}, {:g})", owner, i + 1, surface[i].x(), surface[i].y());
    if (!surface[i].allFinite()) throw InputError(what + " is not finite");
    if (surface[i].y() <= profile.base_level)
      throw InputError(fmt::format("{} is not above the base level {:g} m; lower the base", what, profile.base_level));
    if (i > 0 && surface[i].x() < surface[i - 1].x())
      throw InputError(what + " lies left of the previous point; give the points from left to right");
  }
  Polygon outline{{surface.front().x(), profile.base_level}, {surface.back().x(), profile.base_level}};
  outline.insert(outline.end(), surface.rbegin(), surface.rend());
  CheckedPolygon checked = check_polygon(std::move(outline), owner);
  return {{profile.name, std::move(checked.outline), {"ground"}}, std::move(checked.notes)};
}

std::vector<Vec2> stepped_surface(const std::vector<GroundStep>& steps, double end) {
  if (steps.empty()) throw InputError("stepped ground: has no steps, needs at least 1");
  require_finite(end, "stepped ground: end");
  std::vector<Vec2> surface;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string what = fmt::format("stepped ground, step {}", i + 1);
    const double from = require_finite(steps[i].from, what + ": from"),
                 level = require_finite(steps[i].level, what + ": level");
    const double to = i + 1 < steps.size() ? steps[i + 1].from : end;
    if (!(to > from))
      throw InputError(fmt::format(
          "{}: reaches from {:g} m to {:g} m, must have a length; give the steps from left to right", what, from, to));
    if (!surface.empty() && surface.back().y() == level)
      surface.pop_back();
    else
      surface.emplace_back(from, level);
    surface.emplace_back(to, level);
  }
  return surface;
}

BuiltParts GroundProfile::parts() const {
  GroundProfile ground = *this;
  if (!steps.empty()) ground.surface = stepped_surface(steps, to.value_or(0));
  PolygonPart made = build_ground_profile(ground);
  return {{std::move(made.part)}, std::move(made.notes)};
}

}  // namespace trilith
