#include "broad_phase/swept_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "broad_phase/grid.hpp"
#include "broad_phase/pairs.hpp"

namespace trilith {
namespace {

/// Pieces that move farther than this in a step [m] have diverged and meet nothing.
constexpr double beyond_all = 1e30;

/// Motion of a body: the velocities of all its points are within `spread` of `velocity`.
struct Pace {
  Vec2 velocity;      ///< [m/s]
  double spread = 0;  ///< [m/s]
  double bend = 0;    ///< largest acceleration of a point due to rotation [m/s2]
  [[nodiscard]] double against(const Pace& other) const {
    return (velocity - other.velocity).norm() + spread + other.spread;
  }
};

struct Range {
  Vec2 low = Vec2::Constant(unbounded), high = Vec2::Constant(-unbounded);
  void add(const Vec2& v) { low = low.cwiseMin(v), high = high.cwiseMax(v); }
  [[nodiscard]] Vec2 middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double half() const { return 0.5 * (high - low).norm(); }
};

/// For a rigid body: the velocity of its node, and |spin| times its radius around it. For others: the centre and half
/// diagonal of the box around the velocities of its nodes or section corners.
std::vector<Pace> paces(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  std::vector<Pace> out(work.body.size());
  for (std::size_t b = 0; b < out.size(); ++b) {
    const BodyRow& body = work.body[b];
    const double spin = state.spin[body.node], radius = model.body_radius[b];
    out[b] = {state.velocity[body.node], std::abs(spin) * radius, spin * spin * radius};
    if (body.layout == SkinLayout::one_node) continue;
    Range range;
    double bend = 0;
    if (body.layout == SkinLayout::node_each)
      for (int n = body.node; n < body.node + body.nodes; ++n) range.add(state.velocity[n]);
    else
      for (int s = body.skin; s < body.skin + body.skins; ++s) {
        const double turning = state.spin[model.skin_turn[s]];
        range.add({work.skin[s].u, work.skin[s].v});
        bend = std::max(bend, turning * turning * model.skin_place[s].norm());
      }
    out[b] = {range.middle(), range.half(), bend};
  }
  return out;
}

/// Median of component `k` of the bodies' velocities [m/s]; one flying body among many does not affect it.
double median(const std::vector<Pace>& paces, int k) {
  std::vector<double> speeds;
  for (const Pace& p : paces) speeds.push_back(p.velocity[k]);
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle;
}

/// The box swept by a piece relative to the common velocity `common` [m/s].
Box swept_box(const Model<2>& model, const Work<2>& work, int piece, const Vec2& common, const Pace& pace, double dt) {
  Range range;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const SkinMotion<2>& s = work.skin[model.corner_skin[c]];
    const Vec2 at(s.x, s.y);
    range.add(at);
    range.add(at + dt * (Vec2(s.u, s.v) - common));
  }
  // The path of a rotating point deviates from a straight line by at most a t^2 / 2, and never by more than twice its
  // length.
  const double widen = std::min(0.5 * pace.bend * dt * dt, 2 * pace.spread * std::abs(dt));
  return {range.low.x() - widen, range.low.y() - widen, range.high.x() + widen, range.high.y() + widen};
}

/// Data of a sweep that is independent of the pair.
struct Sweep {
  const Model<2>& model;
  const State<2>& state;
  std::vector<Pace> pace;  ///< [body]
  Range all;               ///< velocities of all points of all bodies [m/s]
  double time, share;      ///< [s], [1]
  /// Common velocity of most bodies, which is not relative motion [m/s]. So ground motion alone makes no pair.
  Vec2 common = Vec2::Zero();
  double fastest = 0;  ///< relative to `common` [m/s]

  Sweep(const Model<2>& m, const State<2>& s, const Work<2>& work, double dt, double of)
      : model(m), state(s), pace(paces(m, s, work)), time(std::abs(dt)), share(of) {
    for (const Pace& p : pace) all.add(p.velocity.array() - p.spread), all.add(p.velocity.array() + p.spread);
  }
  /// Upper bound of the relative displacement of any two points [m].
  [[nodiscard]] double farthest() const { return 2 * all.half() * time; }
  void find_common() {
    common = {median(pace, 0), median(pace, 1)};
    for (const Pace& p : pace) fastest = std::max(fastest, (p.velocity - common).norm() + p.spread);
  }
  [[nodiscard]] double speed(int piece) const {
    const Pace& p = pace[model.piece_body[piece]];
    return (p.velocity - common).norm() + p.spread;
  }
  /// Upper bound of the speed of a piece relative to any other [m/s].
  [[nodiscard]] double closing(int piece) const {
    const Pace& p = pace[model.piece_body[piece]];
    return (p.velocity - all.low).cwiseMax(all.high - p.velocity).norm() + p.spread;
  }
  /// Any pair that counts has one piece that is fast compared with the thinnest thickness, and one that is thin
  /// compared with the fastest speed: with v_a + v_b > s / t one of the two is above s / 2 t.
  [[nodiscard]] bool is_fast(int piece) const { return 2 * speed(piece) * time > share * model.least_thickness; }
  [[nodiscard]] bool is_thin(int piece) const {
    return (speed(piece) + fastest) * time > share * model.piece_thickness[piece];
  }
  /// A contact law holds between them, one may move, and their relative motion exceeds the share of the thinner
  /// thickness.
  [[nodiscard]] bool counts(int p, int q) const {
    const int a = model.piece_body[p], b = model.piece_body[q];
    if (a == b || state.left[a] != 0 || state.left[b] != 0) return false;
    if ((!model.body_moves(a) && !model.body_moves(b)) || contact_law(model, a, b) < 0) return false;
    return pace[a].against(pace[b]) * time > share * std::min(model.piece_thickness[p], model.piece_thickness[q]);
  }
};

/// False where no pair can count: no piece is fast, or none is thin. Then the common velocity is not needed. Otherwise
/// it is computed, and the pieces are compared with the speeds relative to it.
bool may_count(Sweep& sweep) {
  const auto some = [&](auto&& is) {
    for (int p = 0; p < sweep.model.pieces(); ++p)
      if (is(p)) return true;
    return false;
  };
  const auto distance = [&](int p) { return sweep.closing(p) * sweep.time; };
  if (!some([&](int p) { return distance(p) > sweep.share * sweep.model.least_thickness; })) return false;
  if (!some([&](int p) { return distance(p) > sweep.share * sweep.model.piece_thickness[p]; })) return false;
  sweep.find_common();
  return some([&](int p) { return sweep.is_fast(p); }) && some([&](int p) { return sweep.is_thin(p); });
}

/// Share by which fat boxes count as smaller, for the rounding of positions relative to `together`.
constexpr double box_rounding = 1e-12;

FatBox<2> as_fat_box(const Box& box, const Vec2& together) {
  return {{box.x0 - together.x(), box.y0 - together.y()}, {box.x1 - together.x(), box.y1 - together.y()}};
}

/// Largest distance by which a swept box protrudes from the fat box of its piece, 0 where it is inside [m]; unbounded
/// for a piece without a fat box.
double protrusion(const BroadPhaseState<2>& search, int piece, const Box& box) {
  if (!search.boxes.holds(piece)) return unbounded;
  const FatBox<2> swept = as_fat_box(box, search.together);
  const FatBox<2>& fat = search.boxes.box(piece);
  double most = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double rounding = box_rounding * (std::abs(fat.low[k]) + std::abs(fat.high[k]));
    most = std::max({most, fat.low[k] + rounding - swept.low[k], swept.high[k] - fat.high[k] + rounding});
  }
  return most;
}

/// Swept boxes of all pieces, and the pieces whose swept box protrudes from the fat box.
struct SweptBoxes {
  std::vector<Box> box;      ///< [piece]
  std::vector<int> outside;  ///< pieces
  double farthest = 0;       ///< largest protrusion [m]

  SweptBoxes(const Model<2>& model, const Work<2>& work, const Sweep& sweep, double dt)
      : box(static_cast<std::size_t>(model.pieces())) {
    for (int p = 0; p < model.pieces(); ++p) {
      box[p] = swept_box(model, work, p, sweep.common, sweep.pace[model.piece_body[p]], dt);
      const double out = protrusion(work.search, p, box[p]);
      if (out > 0) outside.push_back(p), farthest = std::max(farthest, out);
    }
  }
};

/// Calls keep(p, q) for each pair of pieces whose swept boxes meet. It may visit a pair twice, and pairs whose boxes do
/// not meet. Swept boxes inside fat boxes can only meet where the fat boxes do, and these pairs are the rows of
/// `work.pairs`. For the few other pieces the fat boxes are queried. If they are many, all boxes are put on a grid.
template <class Keep>
void for_meeting(const SweptBoxes& swept, const Work<2>& work, Keep&& keep) {
  if (!work.valid || !(swept.farthest < unbounded) || 8 * swept.outside.size() > swept.box.size()) {
    for (const auto& [p, q] : meeting_boxes(swept.box)) keep(p, q);
    return;
  }
  for (const NearPair& pair : work.pairs) keep(pair.piece_a, pair.piece_b);
  const BroadPhaseState<2>& search = work.search;
  for (const int p : swept.outside) {
    FatBox<2> box = as_fat_box(swept.box[p], search.together);
    for (std::size_t k = 0; k < 2; ++k) box.low[k] -= swept.farthest, box.high[k] += swept.farthest;
    search.boxes.for_meeting(box, [&](int q) { keep(p, q); });
  }
}

}  // namespace

std::vector<std::pair<int, int>> swept_pairs(const Model<2>& model, const State<2>& state, const Work<2>& work,
                                             double dt, double share) {
  Sweep sweep(model, state, work, dt, share);
  std::vector<std::pair<int, int>> found;
  // Motion that has diverged or is not finite is not followed.
  if (!(sweep.farthest() > share * model.least_thickness && sweep.farthest() < beyond_all)) return found;
  if (!may_count(sweep)) return found;
  const SweptBoxes swept(model, work, sweep, dt);
  for_meeting(swept, work, [&](int p, int q) {
    if (p != q && sweep.counts(p, q) && swept.box[p].meets(swept.box[q]))
      found.emplace_back(std::min(p, q), std::max(p, q));
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace trilith
