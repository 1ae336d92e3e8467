#include "model/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "geometry/hierarchical_hash_grid.hpp"
#include "geometry/plane/overlap.hpp"
#include "geometry/plane/polygon.hpp"
#include "geometry/space/separation_3d.hpp"
#include "geometry/space/sphere_distance.hpp"
#include "model/check/held_up.hpp"
#include "model/check/small_gaps.hpp"

namespace trilith {
namespace {

std::vector<Vec2> piece_outline(const Model<2>& model, int piece) {
  std::vector<Vec2> outline;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const int skin = model.corner_skin[c];
    outline.emplace_back(model.start_position[model.skin_node[skin]] +
                         Turn(model.start_rotation[model.skin_turn[skin]]).apply(model.skin_place[skin]));
  }
  return outline;
}

template <int D>
bool may_touch(const Model<D>& model, int p, int q) {
  const Body &a = model.bodies[model.piece_body[p]], &b = model.bodies[model.piece_body[q]];
  return model.law_of[a.surface * model.surfaces + b.surface] >= 0;
}

/// Calls visit(piece, piece, separation) for pieces of two bodies whose boxes are within `reach` of each other. Sweep
/// and prune: sorted by the lower edge of the boxes along x, so that only neighbours are compared.
template <class Visit>
void for_near_pieces(const Model<2>& model, double reach, Visit&& visit) {
  const auto count = static_cast<std::size_t>(model.pieces());
  std::vector<std::vector<Vec2>> outline(count);
  std::vector<Box2> box(count);
  for (std::size_t p = 0; p < count; ++p) {
    outline[p] = piece_outline(model, static_cast<int>(p));
    box[p] = bounding_box(outline[p]);
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::pair(box[i].low.x(), i) < std::pair(box[j].low.x(), j); });
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count && box[order[j]].low.x() <= box[order[i]].high.x() + reach; ++j) {
      const int p = std::min(order[i], order[j]), q = std::max(order[i], order[j]);
      if (model.piece_body[p] == model.piece_body[q]) continue;
      if (box[p].low.y() > box[q].high.y() + reach || box[q].low.y() > box[p].high.y() + reach) continue;
      visit(p, q, penetration(outline[p], outline[q]).separation);
    }
}

/// For solids: the separating axis is computed where boxes overlap.
template <class Visit>
void for_near_pieces(const Model<3>& model, double reach, Visit&& visit) {
  std::vector<PlacedSolid> placed(static_cast<std::size_t>(model.pieces()));
  HierarchicalHashGrid<3> boxes;
  boxes.reset(model.pieces());
  for (int p = 0; p < model.pieces(); ++p) {
    const int node = model.node_of_piece(p);
    place(model.piece_solid[p], turn_of(model.start_rotation[node]), model.start_position[node], placed[p]);
    FatBox<3> box;
    box.low.fill(unbounded), box.high.fill(-unbounded);
    const double beside = 0.5 * reach + model.piece_solid[p].radius;
    for (const Vec3& x : placed[p].corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const double at = x[static_cast<Eigen::Index>(k)];
        box.low[k] = std::min(box.low[k], at - beside), box.high[k] = std::max(box.high[k], at + beside);
      }
    boxes.put(p, box);
  }
  for (int p = 0; p < model.pieces(); ++p) {
    std::vector<int> near;
    boxes.for_meeting(boxes.box(p), [&](int q) {
      if (q > p && model.piece_body[p] != model.piece_body[q]) near.push_back(q);
    });
    std::sort(near.begin(), near.end());
    for (const int q : near) {
      const bool sphere = model.piece_solid[p].is_sphere() || model.piece_solid[q].is_sphere();
      visit(p, q, sphere ? sphere_distance(placed[p], placed[q]) : separation(placed[p], placed[q]).distance);
    }
  }
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

template <int D>
void check_overlaps(const Model<D>& model, double allowed, std::vector<std::string>& faults,
                    std::vector<std::string>& notes, const Newcomers& among) {
  struct DeepPair {
    double share, depth;
    int body_a, body_b;
  };
  std::vector<DeepPair> found;
  for_near_pieces(model, 0, [&](int p, int q, double separation) {
    if (separation >= 0 || !may_touch(model, p, q)) return;
    if (!among.concerns(model.piece_body[p], model.piece_body[q])) return;
    const auto [a, b] = std::minmax(model.piece_body[p], model.piece_body[q]);
    // Relative to the smaller body's size; below 1e-12 it is rounding.
    const double share = -separation / (2 * std::min(model.body_radius[a], model.body_radius[b]));
    if (share >= 1e-12) found.push_back({share, -separation, a, b});
  });
  // Keeps the deepest pieces of each two bodies, then sorts the deepest first.
  const auto bodies = [](const DeepPair& o) { return std::pair(o.body_a, o.body_b); };
  std::stable_sort(found.begin(), found.end(), [&](const DeepPair& l, const DeepPair& r) {
    return bodies(l) != bodies(r) ? bodies(l) < bodies(r) : l.share > r.share;
  });
  found.erase(std::unique(found.begin(), found.end(),
                          [&](const DeepPair& l, const DeepPair& r) { return bodies(l) == bodies(r); }),
              found.end());
  std::stable_sort(found.begin(), found.end(), [](const DeepPair& l, const DeepPair& r) { return l.share > r.share; });
  for (const DeepPair& o : found) {
    const std::string what = fmt::format("bodies '{}' and '{}' overlap by {:.4g} m {}", model.bodies[o.body_a].name,
                                         model.bodies[o.body_b].name, o.depth,
                                         among.back == nullptr ? "at the start" : "at their new position");
    if (o.share > allowed)
      faults.push_back(fmt::format(
          "{} ({:.2g} of the smaller one's size, at most {:g} is allowed); move one of them, or raise overlap_allowed",
          what, o.share, allowed));
    else if (&o == &found.front())
      notes.push_back(what + "; within the allowed overlap");
  }
}

namespace {

/// Two bodies with a small gap between them [m].
struct SmallGap {
  double width;
  int body_a, body_b;
};

/// Bodies that touch or are linked form a set (union-find); index `bodies` represents everything fixed or driven.
struct Footing {
  std::vector<int> parent;
  std::vector<SmallGap> gaps;  ///< not yet part of the sets; the narrowest first

  void join(int a, int b) { parent[root_of(parent, a)] = root_of(parent, b); }
  bool is_held(int body) { return root_of(parent, body) == root_of(parent, static_cast<int>(parent.size()) - 1); }
};

// Shares of a body's radius: up to the first it touches, up to the second there is a small gap.
constexpr double touching_gap = 1e-4, small_gap = 0.02;

template <int D>
Footing footing_of(const Model<D>& model, const Newcomers& among) {
  const auto bodies = static_cast<int>(model.bodies.size());
  Footing found;
  found.parent.resize(static_cast<std::size_t>(bodies + 1));
  std::iota(found.parent.begin(), found.parent.end(), 0);
  double size = 0;
  for (const double r : model.body_radius) size = std::max(size, r);
  for (int b = 0; b < bodies; ++b) {
    if (!among.is_there(b)) continue;
    for (int n = model.bodies[b].first_node; n < model.bodies[b].first_node + model.bodies[b].nodes; ++n) {
      const auto& support = model.support[n];
      if (std::any_of(support.begin(), support.begin() + D, [](Support s) { return s != Support::free; }))
        found.join(b, bodies);
    }
  }
  for (const Bearing<D>& link : model.bearings) found.join(link.body_a, link.body_b);
  for_near_pieces(model, 1e-3 * size, [&](int p, int q, double separation) {
    const int a = model.piece_body[p], b = model.piece_body[q];
    const double radius = std::min(model.body_radius[a], model.body_radius[b]);
    if (separation >= small_gap * radius || !may_touch(model, p, q) || !among.is_there(a) || !among.is_there(b)) return;
    if (separation < touching_gap * radius)
      found.join(a, b);
    else
      found.gaps.push_back({separation, a, b});
  });
  std::stable_sort(found.gaps.begin(), found.gaps.end(),
                   [](const SmallGap& l, const SmallGap& r) { return l.width < r.width; });
  return found;
}

/// Joins bodies across small gaps. Adds a note on the narrowest gap if some bodies are supported across gaps only;
/// bodies before `first_body` are not checked.
template <int D>
void join_across_gaps(const Model<D>& model, const std::vector<std::uint8_t>& floating, Footing& footing,
                      std::vector<std::string>& notes, int first_body) {
  std::vector<SmallGap> needed;
  for (const SmallGap& gap : footing.gaps) {
    if (root_of(footing.parent, gap.body_a) == root_of(footing.parent, gap.body_b)) continue;
    footing.join(gap.body_a, gap.body_b);
    const bool is_new = std::max(gap.body_a, gap.body_b) >= first_body;
    if (is_new && floating[gap.body_a] == 0 && floating[gap.body_b] == 0) needed.push_back(gap);
  }
  std::erase_if(needed, [&](const SmallGap& gap) { return !footing.is_held(gap.body_a); });
  if (needed.empty()) return;
  const SmallGap& first = needed.front();
  const std::string more = needed.size() == 1 ? "" : fmt::format(" (and {} more gaps like it)", needed.size() - 1);
  notes.push_back(
      fmt::format("bodies '{}' and '{}' are {:.3g} m apart, and nothing else supports one of them: it falls that far "
                  "first{}; close the gap, or give floating = true if that is intended",
                  model.bodies[first.body_a].name, model.bodies[first.body_b].name, first.width, more));
}

}  // namespace

/// Small gaps count as touching.
template <int D>
std::vector<std::uint8_t> held_up_bodies(const Model<D>& model, const Newcomers& among) {
  Footing footing = footing_of(model, among);
  for (const SmallGap& gap : footing.gaps) footing.join(gap.body_a, gap.body_b);
  std::vector<std::uint8_t> out(model.bodies.size(), 0);
  for (std::size_t b = 0; b < out.size(); ++b) out[b] = footing.is_held(static_cast<int>(b)) ? 1 : 0;
  return out;
}

/// A body outside of the set of everything fixed or driven would fall. Small gaps count as touching, with a note.
template <int D>
void check_held_up_and_gaps(const Model<D>& model, const std::vector<std::uint8_t>& floating,
                            std::vector<std::string>& faults, std::vector<std::string>& notes, const Newcomers& among) {
  if (model.gravity.field.isZero()) return;
  const auto bodies = static_cast<int>(model.bodies.size());
  Footing footing = footing_of(model, among);
  join_across_gaps(model, floating, footing, notes, among.first);
  for (int b = among.first; b < bodies; ++b)
    if (floating[b] == 0 && !footing.is_held(b))
      faults.push_back(
          fmt::format("body '{}' has no support: no contact or bearing connects it to a fixed or driven body; place it "
                      "on another body, give a contact law for its material, or give floating = true",
                      model.bodies[b].name));
}

template std::vector<std::uint8_t> held_up_bodies(const Model<2>&, const Newcomers&);
template std::vector<std::uint8_t> held_up_bodies(const Model<3>&, const Newcomers&);
template <int D>
void check_held_up(const Model<D>& model, const std::vector<std::uint8_t>& floating, std::vector<std::string>& faults,
                   const Newcomers& among) {
  std::vector<std::string> notes;
  check_held_up_and_gaps(model, floating, faults, notes, among);
}

template void check_overlaps(const Model<3>&, double, std::vector<std::string>&, std::vector<std::string>&,
                             const Newcomers&);
template void check_held_up(const Model<3>&, const std::vector<std::uint8_t>&, std::vector<std::string>&,
                            const Newcomers&);
template void check_held_up_and_gaps(const Model<3>&, const std::vector<std::uint8_t>&, std::vector<std::string>&,
                                     std::vector<std::string>&, const Newcomers&);
template void check_overlaps(const Model<2>&, double, std::vector<std::string>&, std::vector<std::string>&,
                             const Newcomers&);
template void check_held_up(const Model<2>&, const std::vector<std::uint8_t>&, std::vector<std::string>&,
                            const Newcomers&);
template void check_held_up_and_gaps(const Model<2>&, const std::vector<std::uint8_t>&, std::vector<std::string>&,
                                     std::vector<std::string>&, const Newcomers&);

}  // namespace trilith
