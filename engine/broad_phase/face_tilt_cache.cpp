#include "broad_phase/face_tilt_cache.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "law/contact/face_overlap.hpp"

namespace trilith {
namespace {

/// Vectors along the surface edges of a piece, as Work is placed [m]; returns their number.
int list_surface(const Model<2>& model, const Work<2>& work, int piece, std::array<Vec2, max_piece_corners>& ways) {
  const int first = model.piece_first[piece], edges = model.corners_of(piece);
  int count = 0;
  for (int e = 0; e < edges; ++e) {
    if (model.edge_is_face[first + e] == 0) continue;
    const SkinMotion<2>&from = work.skin[model.corner_skin[first + e]],
          &to = work.skin[model.corner_skin[first + (e + 1 < edges ? e + 1 : 0)]];
    ways[static_cast<std::size_t>(count++)] = {to.x - from.x, to.y - from.y};
  }
  return count;
}

/// The least tangent of the angle by which two edges fail to be antiparallel, among angles below 90 degrees.
double least_tangent(const Model<2>& model, const Work<2>& work, const NearPair& pair) {
  std::array<Vec2, max_piece_corners> of_a, of_b;
  const int na = list_surface(model, work, pair.piece_a, of_a), nb = list_surface(model, work, pair.piece_b, of_b);
  double least = unbounded;
  for (int i = 0; i < na; ++i)
    for (int j = 0; j < nb; ++j) {
      const Vec2 &a = of_a[static_cast<std::size_t>(i)], &b = of_b[static_cast<std::size_t>(j)];
      const double cosine = a.dot(b), sine = std::abs(cross(a, b));
      if (cosine < 0 && sine < -cosine * least) least = sine / -cosine;
    }
  return least;
}

}  // namespace

void remember_tilt(const Model<2>& model, const State<2>& state, const Work<2>& work, NearPair& pair) {
  constexpr double right_angle = 1.5707963267948966;
  // Far above the rounding of positions, rotations and the range's ends, which are stored as floats.
  constexpr double slack = 1e-6;
  pair.tilted_from = 1, pair.tilted_to = 0;
  const auto is_rigid = [&](int piece) { return work.body[model.piece_body[piece]].layout == SkinLayout::one_node; };
  if (!is_rigid(pair.piece_a) || !is_rigid(pair.piece_b)) return;
  const double tangent = least_tangent(model, work, pair), turned = turned_against(model, state, work, pair);
  const double angle = tangent < unbounded ? portable::atan2(tangent, 1) : right_angle;
  const double left = angle - face_pair_max_tilt - slack * (1 + std::abs(turned));
  if (!(left > 0)) return;
  pair.tilted_from = static_cast<float>(turned - left), pair.tilted_to = static_cast<float>(turned + left);
}

}  // namespace trilith
