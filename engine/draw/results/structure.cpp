#include "draw/results/structure.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "draw/results/results_picture.hpp"
#include "results/file/placement.hpp"

namespace trilith::draw {
namespace {

/// Share of the size of the structure by which its box is enlarged.
constexpr double enlarged = 1.0 / 3;

bool is_free_body(const results::BodyRow& body) {
  return role_of(body.support) == BodyRole::free;
}

/// AABB of a body's outline; of a body without one, its first node.
SpaceBox box_of_body(const results::BodyRow& body, const results::Placement& at) {
  SpaceBox box{at.node(body.first_node), at.node(body.first_node)};
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    const Vec3 p = at.vertex(v);
    box.low = box.low.cwiseMin(p), box.high = box.high.cwiseMax(p);
  }
  return box;
}

/// Mean displacement of the supports [m].
Vec3 ground_displacement(const results::Header& header, const results::Placement& start,
                         const results::Placement& now) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const results::BodyRow& body : header.bodies)
    if (!is_free_body(body)) sum += now.node(body.first_node) - start.node(body.first_node), ++count;
  return count == 0 ? sum : Vec3(sum / count);
}

}  // namespace

std::vector<bool> debris(const results::Header& header, const results::Frame& frame) {
  const results::Frame first = results::start_frame(header);
  const results::Placement start(header, first), now(header, frame);
  std::optional<SpaceBox> home;
  for (const results::BodyRow& body : header.bodies)
    if (is_free_body(body)) home = joined(home, box_of_body(body, start));
  std::vector<bool> out(header.bodies.size());
  if (!home) return out;
  const Vec3 around = Vec3::Constant(enlarged * (home->high - home->low).maxCoeff());
  const Vec3 moved = ground_displacement(header, start, now);
  const Vec3 low = home->low - around + moved, high = home->high + around + moved;
  std::size_t free = 0, gone = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!is_free_body(header.bodies[i])) continue;
    const SpaceBox box = box_of_body(header.bodies[i], now);
    const Vec3 middle = 0.5 * (box.low + box.high);
    const auto inside = [&](int k) { return middle[k] >= low[k] && middle[k] <= high[k]; };
    out[i] = !(inside(0) && inside(1) && (header.dim == 2 || inside(2)));
    ++free, gone += out[i] ? 1 : 0;
  }
  if (2 * gone > free) out.assign(out.size(), false);
  return out;
}

std::vector<bool> displaced(const results::Header& header, const results::Frame& frame) {
  const results::Frame first = results::start_frame(header);
  const results::Placement start(header, first), now(header, frame);
  const Vec3 ground = ground_displacement(header, start, now);
  std::vector<bool> out(header.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const results::BodyRow& body = header.bodies[i];
    if (!is_free_body(body)) continue;
    const SpaceBox box = box_of_body(body, start);
    const Vec3 way = now.node(body.first_node) - start.node(body.first_node) - ground;
    out[i] = way.norm() > (box.high - box.low).norm();
  }
  return out;
}

}  // namespace trilith::draw
