#include "detect/lookup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/team.hpp"
#include "shape/polygon.hpp"

namespace trilith {
namespace {

/// What a piece may move by in x and in y, as a share of the smaller of its body's thickness and the median. Wider
/// boxes find more pairs that do not touch, narrower ones are left more often. Two of the median keep within a
/// twentieth of it, 2 sqrt(2) of this.
constexpr double margin_share = 0.05 / 2.8284271247461903;
/// A box reaches as far ahead as its piece gets in this many steps, but by no more than this many times its size.
constexpr double steps_ahead = 24, most_stretch = 2;
/// Who leaves within so many steps is looked up with those that have left: patching a long list costs as much for one
/// as for many.
constexpr double steps_due = 8;
/// PieceSearch::beside, as a share of the median thickness.
constexpr double beside_share = 0.025;
/// Of what is allowed, for the rounding of places.
constexpr double allowed_share = 0.999;

/// Of a frame: its box says nothing of it.
double thinnest_piece(const Model<2>& model, const Body& b) {
  return *std::min_element(model.piece_thickness.begin() + b.first_piece,
                           model.piece_thickness.begin() + b.first_piece + b.pieces);
}

/// The smaller side of a body's box in its own axes [m].
double box_thickness(const Model<2>& model, const Body& b) {
  if (b.skin_is_sections()) return thinnest_piece(model, b);
  // Places of the skin of a rigid body are in its own axes, those of a deformable one are its nodes.
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

/// How far each piece may go however slow it is, and whether it may move at all.
void find_margins(const Model<2>& model, PieceSearch<2>& search) {
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

/// Half the longest diagonal: a corner of a rigid piece that may move by r lets it turn by asin(r / arm) at most.
double half_diagonal(const Model<2>& model, int piece) {
  double most = 0;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
    for (int d = model.piece_first[piece]; d < c; ++d)
      most = std::max(most, (model.skin_place[model.corner_skin[c]] - model.skin_place[model.corner_skin[d]]).norm());
  return 0.5 * most;
}

constexpr int most_samples = 63;

/// The first corners of some pieces, spread over all.
void take_sample(const Model<2>& model, const Work<2>& work, PieceSearch<2>& search) {
  const int count = std::min(most_samples, model.pieces());
  search.sample.resize(static_cast<std::size_t>(count));
  search.sample_at.resize(search.sample.size());
  for (int i = 0; i < count; ++i) {
    const int piece = static_cast<int>(std::int64_t{i} * model.pieces() / count);
    search.sample[i] = model.corner_skin[model.piece_first[piece]];
    const SkinMotion<2>& s = work.skin[search.sample[i]];
    search.sample_at[i] = {s.x, s.y};
  }
}

/// The middle one of `value(skin point of the sample, its number)`, for both axes apart.
template <class Value>
Vec2 median_of_sample(const PieceSearch<2>& search, Value&& value) {
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

/// Moves `together` on by what the middle one of the sample has moved by since: a few that fly do not count among many
/// that stand.
void follow(const Work<2>& work, PieceSearch<2>& search) {
  const auto at = [&](int skin) { return Vec2(work.skin[skin].x, work.skin[skin].y); };
  const Vec2 by = median_of_sample(search, [&](int skin, auto i) { return Vec2(at(skin) - search.sample_at[i]); });
  if (!(by.squaredNorm() < unbounded)) return;  // no numbers: the watch ends the stage
  search.together += by;
  for (std::size_t i = 0; i < search.sample.size(); ++i) search.sample_at[i] = at(search.sample[i]);
}

Vec2 common_velocity(const Work<2>& work, const PieceSearch<2>& search) {
  return median_of_sample(search, [&](int skin, auto) { return Vec2(work.skin[skin].u, work.skin[skin].v); });
}

/// What is left to a piece before one of its corners has gone as far as it may [m]; below 0: it has.
/// With q = x - together and q_0 where it was looked up, for each corner and axis
///     low <= q - q_0 <= high        on time, and for `ahead` [s] at the velocity of now beside `common`.
double left_to(const Model<2>& model, const Work<2>& work, int piece, double ahead, const Vec2& common) {
  const PieceSearch<2>& s = work.search;
  const double x0 = allowed_share * s.low[piece].x(), x1 = allowed_share * s.high[piece].x(),
               y0 = allowed_share * s.low[piece].y(), y1 = allowed_share * s.high[piece].y();
  const double dx = s.together.x() + ahead * common.x(), dy = s.together.y() + ahead * common.y();
  double left = unbounded;
  bool known = true;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c) {
    const SkinMotion<2>& skin = work.skin[model.corner_skin[c]];
    const double x = skin.x + ahead * skin.u - dx - s.corner[c].x(), y = skin.y + ahead * skin.v - dy - s.corner[c].y();
    left = std::min(left, std::min(std::min(x - x0, x1 - x), std::min(y - y0, y1 - y)));
    known = known && x == x && y == y;
  }
  return known ? left : -1;
}

void set_due(PieceSearch<2>& search, int piece) {
  search.is_due[piece] = 1;
  search.due.push_back(piece);
}

/// From how far the fastest point has gone now, no piece leaves its box before it has gone as far as this.
/// A corner goes no farther in x or y than that path, and neither does what all move by together.
double put_off(const Work<2>& work, double left) {
  return work.travel + 0.5 * (1 - 1e-6) * left;
}

}  // namespace

void look_up_all(const Model<2>& model, const State<2>& /*state*/, Work<2>& work) {
  PieceSearch<2>& search = work.search;
  const int pieces = model.pieces();
  find_margins(model, search);
  search.boxes.reset(pieces);
  search.corner.resize(model.corner_skin.size());
  search.low.assign(static_cast<std::size_t>(pieces), Vec2::Zero());
  search.high.assign(static_cast<std::size_t>(pieces), Vec2::Zero());
  search.arm.assign(static_cast<std::size_t>(pieces), 0);
  search.until.assign(static_cast<std::size_t>(pieces), 0);
  search.is_due.assign(static_cast<std::size_t>(pieces), 0);
  search.due.clear();
  for (int p = 0; p < pieces; ++p) {
    if (model.bodies[model.piece_body[p]].is_rigid()) search.arm[p] = half_diagonal(model, p);
    set_due(search, p);
  }
  search.together = Vec2::Zero();
  take_sample(model, work, search);
}

/// Pieces that threads take at a time: some five microseconds.
static constexpr int looked_stretch = 512;

/// Lists all that have left their boxes or will within `ahead` [s], and puts the next look at each of the others off
/// until it may have; at those until they may have once they are looked up. Threads mark their pieces; they are listed
/// in order.
static void find_due(const Model<2>& model, Work<2>& work, const Vec2& common, double ahead) {
  PieceSearch<2>& search = work.search;
  std::array<double, most_threads> by;
  by.fill(unbounded);
  share(work.threads, model.pieces(), looked_stretch, [&](int first, int last, int thread) {
    double least = by[static_cast<std::size_t>(thread)];  // of its own: beside those of others it would go to and fro
    for (int p = first; p < last; ++p) {
      const double now = left_to(model, work, p, 0, common);
      const bool due = now < 0 || left_to(model, work, p, ahead, common) < 0;
      search.is_due[p] = due ? 1 : 0;
      search.until[p] = put_off(work, due ? allowed_share * search.margin[p] : now);
      least = std::min(least, search.until[p]);
    }
    by[static_cast<std::size_t>(thread)] = least;
  });
  for (int p = 0; p < model.pieces(); ++p)
    if (search.is_due[p] != 0) search.due.push_back(p);
  work.look_again = *std::min_element(by.begin(), by.end());
}

/// A piece is looked at only once it may have left its box. Each thread keeps the least of what it looks at: the least
/// of these is the same in any order.
bool some_are_due(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (work.travel < work.look_again) return false;
  PieceSearch<2>& search = work.search;
  follow(work, search);
  const int pieces = model.pieces();
  std::array<double, most_threads> by;
  by.fill(unbounded);
  share(work.threads, pieces, looked_stretch, [&](int first, int last, int thread) {
    double least = by[static_cast<std::size_t>(thread)];
    for (int p = first; p < last; ++p) {
      if (!(work.travel < search.until[p])) search.until[p] = put_off(work, left_to(model, work, p, 0, Vec2::Zero()));
      least = std::min(least, search.until[p]);
    }
    by[static_cast<std::size_t>(thread)] = least;
  });
  work.look_again = *std::min_element(by.begin(), by.end());
  // Who has left has less than nothing left.
  if (work.look_again >= work.travel) return false;
  find_due(model, work, common_velocity(work, search), steps_due * state.last_dt);
  return true;
}

void place_boxes(const Model<2>& model, const State<2>& state, Work<2>& work) {
  PieceSearch<2>& search = work.search;
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

/// One that is looked up now is where its box was made for; another may be at one end of it and go to the other.
double reach_of(const PieceSearch<2>& search, int piece) {
  const Vec2 &low = search.low[piece], &high = search.high[piece];
  if (search.is_due[piece] == 0) return (high - low).norm();
  return high.cwiseMax(-low).norm();
}

}  // namespace trilith
