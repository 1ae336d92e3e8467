#include "model/check/piece_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "geometry/hierarchical_hash_grid.hpp"
#include "geometry/space/convex_solid.hpp"
#include "geometry/space/separation_3d.hpp"

namespace trilith {
namespace {

/// Places the solids at their positions; `solids` must outlive the result.
std::vector<PlacedSolid> standing(const std::vector<ConvexSolid>& solids) {
  std::vector<PlacedSolid> placed(solids.size());
  for (std::size_t p = 0; p < solids.size(); ++p) place(solids[p], turn_of(UnitQuaternion{}), Vec3::Zero(), placed[p]);
  return placed;
}

FatBox<3> box_around(const std::vector<Vec3>& corners) {
  Vec3 low = corners[0], high = low;
  for (const Vec3& x : corners) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

}  // namespace

void refuse_overlapping_pieces(const std::vector<Polyhedron>& pieces, double allowed, const std::string& owner) {
  if (pieces.size() < 2) return;
  std::vector<ConvexSolid> solids;
  for (const Polyhedron& piece : pieces) solids.push_back(convex_solid(piece, owner));
  const std::vector<PlacedSolid> placed = standing(solids);
  double most = allowed, depth = 0;
  int first = -1, second = -1;
  HierarchicalHashGrid<3> boxes;
  boxes.reset(static_cast<int>(pieces.size()));
  for (int q = 0; q < static_cast<int>(pieces.size()); ++q) {
    const auto b = static_cast<std::size_t>(q);
    const FatBox<3> box = box_around(pieces[b].corners);
    std::vector<int> near;
    boxes.for_meeting(box, [&](int p) { near.push_back(p); });
    std::sort(near.begin(), near.end());
    for (const int p : near) {
      const auto a = static_cast<std::size_t>(p);
      const double within = -separation(placed[a], placed[b], 0).distance;
      const double share = within / std::min(solids[a].size, solids[b].size);
      if (share > most) most = share, depth = within, first = p, second = q;
    }
    boxes.put(q, box);
  }
  if (first < 0) return;
  throw InputError(
      fmt::format("{}: its pieces {} and {} overlap by {:.4g} m ({:.2g} of the smaller one's size, at most {:g} is "
                  "allowed), so their common part would count twice. Move one of them, or make them separate bodies",
                  owner, first + 1, second + 1, depth, most, allowed));
}

}  // namespace trilith
