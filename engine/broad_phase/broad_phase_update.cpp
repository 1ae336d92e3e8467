#include "broad_phase/broad_phase_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/team.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

/// Motion budget of a piece in x and in y, relative to the smaller of its body's thickness and the median thickness.
/// Larger boxes find more pairs that do not touch; smaller ones are left more often. Two pieces of median thickness
/// approach each other by at most a twentieth of it, 2 sqrt(2) times this share.
constexpr double margin_share = 0.05 / 2.8284271247461903;
/// A box extends ahead by the piece's motion in this many steps, but by at most this many times its size.
constexpr double steps_ahead = 32, most_stretch = 2;
/// Pieces that will leave their boxes within this many steps are updated early, in the same pass, because patching a
/// long list costs as much for one piece as for many.
constexpr double steps_due = 12;
/// `BroadPhaseState::beside` relative to the median thickness.
constexpr double beside_share = 0.025;
/// Share of the budget that is used; the rest covers rounding of positions.
constexpr double allowed_share = 0.999;

/// For a frame, whose bounding box does not show its thickness.
double thinnest_piece(const Model<2>& model, const Body& b) {
  return *std::min_element(model.piece_thickness.begin() + b.first_piece,
                           model.piece_thickness.begin() + b.first_piece + b.pieces);
}

/// The smaller side of a body's box in its own axes [m].
double box_thickness(const Model<2>& model, const Body& b) {
  if (b.skin_is_sections()) return thinnest_piece(model, b);
  // Skin positions of a rigid body are in body axes; the skin of a deformable body consists of its nodes.
  const auto first = static_cast<std::size_t>(b.is_rigid() ? b.first_skin : b.first_node);
  const Box2 box = bounding_box(std::span(b.is_rigid() ? model.skin_place : model.start_position)
                                    .subspan(first, static_cast<std::size_t>(b.skins)));
  return (box.high - box.low).minCoeff();
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Motion budget of each piece at rest, and whether it can move at all.
void find_margins(const Model<2>& model, BroadPhaseState<2>& search) {
  const auto bodies = static_cast<int>(model.bodies.size());
  std::vector<double> thickness(model.bodies.size()), moving;
  search.may_move.assign(static_cast<std::size_t>(model.pieces()), 0);
  search.margin.assign(search.may_move.size(), 0);
  for (int b = 0; b < bodies; ++b) {
    thickness[b] = box_thickness(model, model.bodies[b]);
    if (model.body_moves(b)) moving.push_back(thickness[b]);
  }
  const double median = moving.empty() ? 1 : median_of(moving);
  search.beside = beside_share * median;
  for (int p = 0; p < model.pieces(); ++p) {
    const int b = model.piece_body[p];
    search.may_move[p] = model.body_moves(b) ? 1 : 0;
    search.margin[p] = margin_share * std::min(thickness[b], median);
  }
}

/// Half the longest diagonal: if the corners of a rigid piece move by at most r, it rotates by at most asin(r / arm).
double half_diagonal(const Model<2>& model, int piece) {
  double most = 0;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
    for (int d = model.piece_first[piece]; d < c; ++d)
      most = std::max(most, (model.skin_place[model.corner_skin[c]] - model.skin_place[model.corner_skin[d]]).norm());
  return 0.5 * most;
}

constexpr int most_samples = 63;

/// Position of a skin point relative to the common translation `together`.
Vec2 place_beside(const Work<2>& work, const BroadPhaseState<2>& search, int skin) {
  return Vec2(work.skin[skin].x, work.skin[skin].y) - search.together;
}

/// The first corners of a sample of pieces, distributed over all.
void take_sample(const Model<2>& model, const Work<2>& work, BroadPhaseState<2>& search) {
  const int count = std::min(most_samples, model.pieces());
  search.sample.resize(static_cast<std::size_t>(count));
  search.sample_at.resize(search.sample.size());
  for (int i = 0; i < count; ++i) {
    const int piece = static_cast<int>(std::int64_t{i} * model.pieces() / count);
    search.sample[i] = model.corner_skin[model.piece_first[piece]];
    search.sample_at[i] = place_beside(work, search, search.sample[i]);
  }
}

/// Component-wise median of `value(skin point of the sample, its index)`.
template <class Value>
Vec2 median_of_sample(const BroadPhaseState<2>& search, Value&& value) {
  std::array<double, most_samples> x, y;
  const auto count = static_cast<std::ptrdiff_t>(search.sample.size());
  if (count == 0) return Vec2::Zero();
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const Vec2 v = value(search.sample[i], i);
    x[i] = v.x(), y[i] = v.y();
  }
  const std::ptrdiff_t middle = count / 2;
  std::nth_element(x.begin(), x.begin() + middle, x.begin() + count);
  std::nth_element(y.begin(), y.begin() + middle, y.begin() + count);
  return {x[middle], y[middle]};
}

Vec2 common_velocity(const Work<2>& work, const BroadPhaseState<2>& search) {
  return median_of_sample(search, [&](int skin, auto) { return Vec2(work.skin[skin].u, work.skin[skin].v); });
}

/// Adds the median displacement of the sample since the last call to `together`, and sets the drift to the sample's
/// median velocity. A few flying pieces among many standing ones do not affect the median.
void follow(const Work<2>& work, BroadPhaseState<2>& search) {
  const Vec2 by = median_of_sample(
      search, [&](int skin, auto i) { return Vec2(place_beside(work, search, skin) - search.sample_at[i]); });
  const Vec2 drift = common_velocity(work, search);
  if (!(by.squaredNorm() + drift.squaredNorm() < unbounded)) return;  // not finite: the watchdog ends the stage
  search.together += by, search.drift = drift;
  search.shifted += LanePair{std::abs(by.x()), std::abs(by.y())};
  for (std::size_t i = 0; i < search.sample.size(); ++i)
    search.sample_at[i] = place_beside(work, search, search.sample[i]);
}

/// Remaining motion budget of a piece along each axis until one of its corners has used it up [m]; negative: exceeded.
/// With q = x - together and q_0 at the last update, the condition for each corner and axis is low <= q - q_0 <= high,
/// now or `ahead` [s] from now at the present velocity minus the drift.
LanePair left_to(const Model<2>& model, const Work<2>& work, int piece, double ahead = 0) {
  const BroadPhaseState<2>& s = work.search;
  const LanePair low = allowed_share * load_pair(s.low[piece].data()),
                 high = allowed_share * load_pair(s.high[piece].data());
  const Vec2 origin = s.together + ahead * s.drift;
  LanePair left{unbounded, unbounded};
  bool known = true;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const SkinMotion<2>& skin = work.skin[model.corner_skin[c]];
    const LanePair at = load_pair(&skin.x) + ahead * load_pair(&skin.u) - LanePair{origin.x(), origin.y()} -
                        load_pair(s.corner[c].data());
    left = least_of(left, least_of(at - low, high - at));
    known = known && none_below(at, at);
  }
  return known ? left : LanePair{-1, -1};
}

constexpr LanePair nothing_left{0, 0};

void set_due(BroadPhaseState<2>& search, int piece) {
  search.is_due[piece] = 1;
  search.due.push_back(piece);
}

/// Share of the remaining budget that is used; the rest covers rounding in sums over many steps.
constexpr double left_share = 1 - 1e-6;

}  // namespace

void update_broad_phase(const Model<2>& model, const State<2>& /*state*/, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  const int pieces = model.pieces();
  find_margins(model, search);
  search.boxes.reset(pieces);
  search.corner.resize(model.corner_skin.size());
  search.low.assign(static_cast<std::size_t>(pieces), Vec2::Zero());
  search.high.assign(static_cast<std::size_t>(pieces), Vec2::Zero());
  search.arm.assign(static_cast<std::size_t>(pieces), 0);
  search.is_due.assign(static_cast<std::size_t>(pieces), 0);
  search.due.clear();
  for (int p = 0; p < pieces; ++p) {
    if (model.bodies[model.piece_body[p]].is_rigid()) search.arm[p] = half_diagonal(model, p);
    set_due(search, p);
  }
  search.left.assign(model.bodies.size(), WayLeft<2>());
  search.may_have_left = true;
  search.together = search.drift = Vec2::Zero();
  set_all(search.shifted, 0);
  take_sample(model, work, search);
}

namespace {

/// Bodies in a chunk of one thread: about five microseconds.
constexpr int looked_stretch = 512;

/// Calls look(body) for all bodies whose remaining budget would be used up within `steps` more steps; true if any call
/// returned true.
template <class Look>
bool look_at_few(Work<2>& work, double steps, Look&& look) {
  struct alignas(64) Found {
    bool some = false;
  };
  BroadPhaseState<2>& search = work.search;
  std::array<Found, most_threads> by{};
  share(work.threads, static_cast<int>(search.left.size()), looked_stretch, [&](int first, int last, int thread) {
    bool some = false;
    for (int b = first; b < last; ++b)
      if (!search.left[b].lasts(steps, search.shifted)) some = look(b) || some;
    if (some) by[static_cast<std::size_t>(thread)].some = true;
  });
  return std::any_of(by.begin(), by.end(), [](const Found& found) { return found.some; });
}

/// Updates the remaining budget of a body; true where some piece of it has left its box.
bool look_at_body(const Model<2>& model, Work<2>& work, int body) {
  const Body& b = model.bodies[body];
  LanePair left{unbounded, unbounded};
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) left = least_of(left, left_to(model, work, p));
  work.search.left[body].left = left_share * left + work.search.shifted;
  return !none_below(left, nothing_left);
}

/// Marks the pieces of a body that have left their boxes or will within `ahead` [s]. Their remaining budget is set to
/// the full budget after the update.
void mark_due(const Model<2>& model, Work<2>& work, int body, double ahead) {
  BroadPhaseState<2>& search = work.search;
  const Body& b = model.bodies[body];
  LanePair left{unbounded, unbounded};
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    const LanePair now = left_to(model, work, p);
    const bool due = !none_below(now, nothing_left) || !none_below(left_to(model, work, p, ahead), nothing_left);
    search.is_due[p] = due ? 1 : 0;
    const double margin = allowed_share * search.margin[p];
    left = least_of(left, due ? LanePair{margin, margin} : now);
  }
  search.left[body].left = left_share * left + search.shifted;
}

/// Lists in order all pieces that have left their boxes or will within `steps` more steps.
void find_due(const Model<2>& model, Work<2>& work, double steps, double dt) {
  BroadPhaseState<2>& search = work.search;
  look_at_few(work, steps, [&](int body) {
    mark_due(model, work, body, steps * dt);
    return true;
  });
  for (int p = 0; p < model.pieces(); ++p)
    if (search.is_due[p] != 0) search.due.push_back(p);
}

}  // namespace

/// A body is checked only once it may have left its box.
bool some_are_due(const Model<2>& model, const State<2>& state, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  if (!search.may_have_left) return false;
  search.may_have_left = false;
  follow(work, search);
  if (!look_at_few(work, 0, [&](int body) { return look_at_body(model, work, body); })) return false;
  find_due(model, work, steps_due, state.last_dt);
  return true;
}

void place_boxes(const Model<2>& model, const State<2>& state, Work<2>& work) {
  BroadPhaseState<2>& search = work.search;
  const Vec2 common = common_velocity(work, search);
  const double ahead = steps_ahead * state.last_dt;
  for (const int p : search.due) {
    Vec2 least = Vec2::Constant(unbounded), most = -least, slowest = least, fastest = most;
    for (int c = model.piece_first[p]; c < model.piece_first[p + 1]; ++c) {
      const SkinMotion<2>& s = work.skin[model.corner_skin[c]];
      const Vec2 at = Vec2(s.x, s.y) - search.together, velocity = Vec2(s.u, s.v) - common;
      search.corner[c] = at;
      least = least.cwiseMin(at), most = most.cwiseMax(at);
      slowest = slowest.cwiseMin(velocity), fastest = fastest.cwiseMax(velocity);
    }
    const double farthest = most_stretch * (most - least).maxCoeff(), margin = search.margin[p];
    FatBox<2> box;
    for (const int k : {0, 1}) {
      search.low[p][k] = -margin - std::min(farthest, std::max(0.0, -ahead * slowest[k]));
      search.high[p][k] = margin + std::min(farthest, std::max(0.0, ahead * fastest[k]));
      box.low[k] = least[k] + search.low[p][k], box.high[k] = most[k] + search.high[p][k];
    }
    search.boxes.put(p, box);
  }
}

/// A piece updated now is at the position for which its box was built. Another piece may be at one end of its box and
/// move to the other end.
double reach_of(const BroadPhaseState<2>& search, int piece) {
  const Vec2 &low = search.low[piece], &high = search.high[piece];
  if (search.is_due[piece] == 0) return (high - low).norm();
  return high.cwiseMax(-low).norm();
}

}  // namespace trilith
