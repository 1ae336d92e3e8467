#include "detect/solid_pairs.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace trilith {
namespace {

using SolidBox = Eigen::AlignedBox3d;

SolidBox box_around(const PlacedSolid& solid, double widen) {
  SolidBox box;
  for (const Vec3& x : solid.corners) box.extend(x);
  return {box.min() - Vec3::Constant(widen), box.max() + Vec3::Constant(widen)};
}

/// A twentieth of the median thickness (smallest side of the box in its own axes) of the pieces that move.
double solid_margin(const Model<3>& model) {
  std::vector<double> thickness;
  for (std::size_t p = 0; p < model.piece_solid.size(); ++p) {
    if (!model.body_moves(model.piece_body[p])) continue;
    SolidBox box;
    for (const Vec3& x : model.piece_solid[p].shape.corners) box.extend(x);
    thickness.push_back(box.sizes().minCoeff());
  }
  if (thickness.empty()) return 1;
  const auto middle = thickness.begin() + static_cast<std::ptrdiff_t>(thickness.size() / 2);
  std::nth_element(thickness.begin(), middle, thickness.end());
  return 0.05 * *middle;
}

/// Along x from the lowest start on; each box is compared with those that begin before it ends.
template <class Visit>
void for_meeting_boxes(const std::vector<SolidBox>& boxes, Visit&& visit) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return boxes[i].min().x() < boxes[j].min().x() || (boxes[i].min().x() == boxes[j].min().x() && i < j);
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t l = k + 1; l < order.size() && boxes[order[l]].min().x() <= boxes[order[k]].max().x(); ++l)
      if (boxes[order[k]].intersects(boxes[order[l]]))
        visit(static_cast<int>(std::min(order[k], order[l])), static_cast<int>(std::max(order[k], order[l])));
}

}  // namespace

bool pairs_outdated(const Work<3>& work) {
  return !work.valid || work.travel > 0.5 * work.margin * (1 - 1e-9);
}

void find_pairs(const Model<3>& model, const State<3>& state, Work<3>& work) {
  work.margin = solid_margin(model);
  work.travel = work.look_again = work.clear_path = 0;
  std::vector<SolidBox> boxes;
  for (const PlacedSolid& solid : work.solids.placed) boxes.push_back(box_around(solid, 0.5 * work.margin));
  work.pairs.clear();
  for_meeting_boxes(boxes, [&](int p, int q) {
    const int body_p = model.piece_body[p], body_q = model.piece_body[q];
    if (body_p == body_q || state.left[body_p] != 0 || state.left[body_q] != 0) return;
    if (!model.body_moves(body_p) && !model.body_moves(body_q)) return;
    const int law = model.law_of[model.bodies[body_p].surface * model.surfaces + model.bodies[body_q].surface];
    if (law >= 0) work.pairs.push_back({p, q, law, 0, 0, 0, 0, 0, 1.0, false});
  });
  std::sort(work.pairs.begin(), work.pairs.end(), [](const NearPair& a, const NearPair& b) {
    return a.piece_a != b.piece_a ? a.piece_a < b.piece_a : a.piece_b < b.piece_b;
  });
  work.asleep_until.assign(work.pairs.size(), -1.0);
  work.valid = true;
}

}  // namespace trilith
