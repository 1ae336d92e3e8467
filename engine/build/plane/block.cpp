#include "build/plane/block.hpp"

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {

Part build_block(const Block& block) {
  const std::string owner = builder_title("block", block.name);
  check_keys(block, owner);
  const double w = block.width, h = block.height, x = block.at.x(), y = block.at.y();
  const bool centred = block.anchor == BlockAnchor::centre;
  const double left = centred ? -w / 2 : 0, right = centred ? w / 2 : w;
  const double low = centred ? -h / 2 : 0, high = centred ? h / 2 : h;
  const auto [s, c] = portable::sine_cosine(block.angle);
  Part part{block.name, {}, block.groups};
  for (const Vec2& p : {Vec2(left, low), Vec2(right, low), Vec2(right, high), Vec2(left, high)})
    part.outline.emplace_back(x + (c * p.x() - s * p.y()), y + (s * p.x() + c * p.y()));
  return part;
}

std::vector<Part> Block::parts() const {
  return {build_block(*this)};
}

BuiltParts PolygonShape::parts() const {
  PolygonPart made = build_polygon(name, outline);
  return {{std::move(made.part)}, std::move(made.notes)};
}

PolygonPart build_polygon(const std::string& name, Polygon points, std::vector<std::string> groups) {
  CheckedPolygon checked = check_polygon(std::move(points), builder_title("polygon", name));
  return {{name, std::move(checked.outline), std::move(groups)}, std::move(checked.notes)};
}

}  // namespace trilith
