#include "build/plane/block.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {

Part build_block(const Block& block) {
  const std::string owner = builder_title("block", block.name);
  const double w = require_positive(block.width, owner + ": width", "m");
  const double h = require_positive(block.height, owner + ": height", "m");
  const double x = require_finite(block.at.x(), owner + ": x"), y = require_finite(block.at.y(), owner + ": y");
  const double angle = require_finite(block.angle, owner + ": angle");
  const bool centred = block.anchor == BlockAnchor::centre;
  const double left = centred ? -w / 2 : 0, right = centred ? w / 2 : w;
  const double low = centred ? -h / 2 : 0, high = centred ? h / 2 : h;
  const auto [s, c] = portable::sine_cosine(angle);
  Part part{block.name, {}, block.groups};
  for (const Vec2& p : {Vec2(left, low), Vec2(right, low), Vec2(right, high), Vec2(left, high)})
    part.outline.emplace_back(x + (c * p.x() - s * p.y()), y + (s * p.x() + c * p.y()));
  return part;
}

PolygonPart build_polygon(const std::string& name, Polygon points, std::vector<std::string> groups) {
  CheckedPolygon checked = check_polygon(std::move(points), builder_title("polygon", name));
  return {{name, std::move(checked.outline), std::move(groups)}, std::move(checked.notes)};
}

}  // namespace trilith
