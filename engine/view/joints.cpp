#include "view/joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/space.hpp"

namespace trilith::view {
namespace {

std::vector<Vec2> start_outline(const results::Header& header, int body) {
  const results::BodyRow& row = header.bodies[static_cast<std::size_t>(body)];
  std::vector<Vec2> out;
  for (int v = row.first_vertex; v < row.first_vertex + row.vertex_count; ++v) {
    const int node = header.vertex_node[v];
    const Vec2 at(header.node_position[2 * node], header.node_position[2 * node + 1]);
    out.push_back(at + Turn(header.node_rotation[node]).apply({header.vertices[2 * v], header.vertices[2 * v + 1]}));
  }
  return out;
}

struct Edge {
  Vec2 from, along;  // along: unit
  double length;
};

Edge edge_of(const std::vector<Vec2>& outline, std::size_t i) {
  const Vec2 way = outline[(i + 1) % outline.size()] - outline[i];
  const double length = way.norm();
  return {outline[i], length > 0 ? Vec2(way / length) : Vec2(1, 0), length};
}

}  // namespace

std::vector<EdgePart> joint_of(const results::Header& header, int a, int b) {
  constexpr double near_share = 0.05, parallel = 0.05, least_share = 0.01;
  const std::vector<Vec2> outline_a = start_outline(header, a), outline_b = start_outline(header, b);
  std::vector<EdgePart> parts;
  for (std::size_t i = 0; i < outline_a.size(); ++i)
    for (std::size_t k = 0; k < outline_b.size(); ++k) {
      const Edge ea = edge_of(outline_a, i), eb = edge_of(outline_b, k);
      const Vec2 normal(-ea.along.y(), ea.along.x());
      if (ea.along.dot(eb.along) > 0 || std::abs(normal.dot(eb.along)) > parallel) continue;
      const Vec2 first = eb.from - ea.from, last = first + eb.length * eb.along;
      if (std::abs(normal.dot(0.5 * (first + last))) > near_share * std::min(ea.length, eb.length)) continue;
      const double from = std::max(0.0, ea.along.dot(last)), to = std::min(ea.length, ea.along.dot(first));
      if (to - from > least_share * std::min(ea.length, eb.length))
        parts.push_back({a, static_cast<int>(i), from / ea.length, to / ea.length});
    }
  return parts;
}

}  // namespace trilith::view
