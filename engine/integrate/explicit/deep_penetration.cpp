#include "integrate/explicit/deep_penetration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"
#include "base/team.hpp"
#include "broad_phase/broad_phase_update.hpp"
#include "broad_phase/moving_piece.hpp"
#include "broad_phase/pairs.hpp"
#include "broad_phase/swept_pairs.hpp"
#include "integrate/explicit/body_depth.hpp"
#include "integrate/explicit/tunnelling_limit.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

double deepest_allowed(const Model<2>& model, int p, int q) {
  return deep_penetration_share * std::min(model.piece_thickness[p], model.piece_thickness[q]);
}

ContactKey bodies_of(const Model<2>& model, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  return contact_key(std::min(a, b), std::max(a, b));
}

bool is_told(const Model<2>& model, const State<2>& state, int p, int q) {
  return std::binary_search(state.passed.begin(), state.passed.end(), bodies_of(model, p, q));
}

/// Two pieces at one instant.
struct Two {
  MovingPiece a, b;
  PieceOverlap overlap;

  Two(const Model<2>& model, const State<2>& state, int p, int q, double later = 0)
      : a(moving_piece(model, state, p, later)), b(moving_piece(model, state, q, later)), overlap(overlap_of(a, b)) {}

  /// Penetration that remains until the report limit `allowed` [m]; negative beyond it. Pieces of one body that meet
  /// another body at the end of an inner cut share very little volume there and are far from any surface. So the
  /// overlap width must also reach half of the limit, as it does for one of two pieces wherever the cut lies.
  [[nodiscard]] double room(double allowed) const {
    return std::max(allowed - overlap.depth, 0.5 * allowed - overlap.whole);
  }
  /// Length that the pieces share along their faces [m].
  [[nodiscard]] double shared_length() const {
    const Vec2 along = left_of(overlap.normal);
    double from = -unbounded, to = unbounded;
    for (const MovingPiece* piece : {&a, &b}) {
      double low = unbounded, high = -unbounded;
      for (int c = 0; c < piece->corners; ++c)
        low = std::min(low, along.dot(piece->at[c])), high = std::max(high, along.dot(piece->at[c]));
      from = std::max(from, low), to = std::min(to, high);
    }
    return to - from;
  }
  /// Largest closing speed of any two corners along the normal [m/s].
  [[nodiscard]] double closing_speed() const {
    double low[2] = {unbounded, unbounded}, high[2] = {-unbounded, -unbounded};
    for (const int side : {0, 1}) {
      const MovingPiece& piece = side == 0 ? a : b;
      for (int c = 0; c < piece.corners; ++c) {
        const double speed = overlap.normal.dot(piece.velocity[c]);
        low[side] = std::min(low[side], speed), high[side] = std::max(high[side], speed);
      }
    }
    return std::max(high[0] - low[1], high[1] - low[0]);
  }
};

double speed_of(const Model<2>& model, const State<2>& state, int body) {
  return state.velocity[model.bodies[body].first_node].norm();
}

/// 1 / mass of a body that may move, otherwise 0 [1/kg].
double mobility(const Model<2>& model, int piece) {
  const int body = model.piece_body[piece];
  return model.body_moves(body) ? 1 / body_mass(model, body) : 0;
}

/// Normal stiffness that would limit the penetration of two pieces to half of the report limit [Pa/m]. At that depth
/// the elastic energy equals the kinetic energy, the present contact energy and the remaining work of the weight.
///     At d = `most`, kn l d^2 / 2 = m (v^2 / 2 + g d) + kn_now l depth^2 / 2.
/// Here m = 1 / (1/m_a + 1/m_b) is the reduced mass of the two bodies.
double holding_stiffness(const Model<2>& model, const State<2>& state, int p, int q, const Two& two) {
  const double most = 0.5 * deepest_allowed(model, p, q), length = two.shared_length() * model.thickness,
               speed = two.closing_speed(), depth = two.overlap.depth;
  const double mass = 1 / (mobility(model, p) + mobility(model, q));
  const int law = contact_law(model, model.piece_body[p], model.piece_body[q]);
  const double kn = std::visit([](const auto& l) { return l.kn; }, model.laws[law]);
  const double twice =
      mass * (speed * speed + 2 * model.gravity.at(state.time).norm() * most) + kn * length * depth * depth;
  return twice / (length * most * most);
}

/// Distances to both surfaces reach half of the thickness only in the middle of a body. They count from this share on.
constexpr double share_of_half = 0.9;

/// Thickness of the thinner one of the bodies of two pieces [m].
double thinner_body(const Model<2>& model, int p, int q) {
  return std::min(body_thickness(model, model.piece_body[p]), body_thickness(model, model.piece_body[q]));
}

/// Overlap of the bodies of two pieces above which they are too deep [m].
double deepest_of_bodies(const Model<2>& model, int p, int q) {
  return share_of_half * deep_penetration_share * thinner_body(model, p, q);
}

/// Depth of two bodies at two of their pieces [m].
double depth_of_bodies(const Model<2>& model, const Work<2>& work, int p, int q) {
  return std::max(body_depth(model, work, p, q, 0), passed_depth(model, work, p, q));
}

/// Depth and text of two bodies with an element that is thin against its body.
void tell_bodies(const Model<2>& model, int p, int q, double depth, const Two& two, Event& e) {
  e.value = depth;
  e.text = fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick; use a stiffer law", two.closing_speed(),
                       thinner_body(model, p, q));
}

/// Adds the event of a deep pair and stores the pair in State::passed. The faster body is named first.
void tell(const Model<2>& model, State<2>& state, const Work<2>& work, int p, int q, const Two& two,
          std::vector<Event>& told) {
  const PieceOverlap& overlap = two.overlap;
  const ContactKey key = bodies_of(model, p, q);
  state.passed.insert(std::lower_bound(state.passed.begin(), state.passed.end(), key), key);
  Event e;
  e.type = EventType::body_passed;
  e.time = state.time, e.step = state.step;
  const bool turned = speed_of(model, state, second_piece(key)) > speed_of(model, state, first_piece(key));
  e.body_a = turned ? second_piece(key) : first_piece(key), e.body_b = turned ? first_piece(key) : second_piece(key);
  e.value = overlap.depth;
  e.x = overlap.at.x(), e.y = overlap.at.y();
  e.text =
      fmt::format("at {:.3g} m/s, the thinner {:.3g} m thick; kn of {:.1e} Pa/m would prevent it", two.closing_speed(),
                  deepest_allowed(model, p, q) / deep_penetration_share, holding_stiffness(model, state, p, q, two));
  const double depth = depth_of_bodies(model, work, p, q);
  if (is_thin_for(model, work, p, q, deepest_of_bodies(model, p, q)) && depth > overlap.depth)
    tell_bodies(model, p, q, depth, two, e);
  told.push_back(e);
}

/// Upper bound of the overlap of two pieces: the overlap along the normal of the first of two opposed faces [m]. One
/// direction bounds the overlap from above; this is a cheap test before the exact one over all normals.
double beneath_face(const Model<2>& model, const Work<2>& work, const NearPair& pair) {
  const SkinMotion<2>&from = work.skin[pair.a0], &to = work.skin[pair.a1];
  const double x = to.x - from.x, y = to.y - from.y;
  double deepest = 0;
  for (int c = model.piece_first[pair.piece_b]; c < model.piece_first[pair.piece_b + 1]; ++c) {
    const SkinMotion<2>& corner = work.skin[model.corner_skin[c]];
    deepest = std::max(deepest, x * (corner.y - from.y) - y * (corner.x - from.x));
  }
  return deepest / portable::hypot(x, y);
}

/// True if one surface edge of the owner shows that the other piece is no deeper in it than `most` [m]; see overlap_of.
bool is_beneath(const Model<2>& model, const Work<2>& work, int owner, int other, double most) {
  const int first = model.piece_first[owner], count = model.corners_of(owner);
  for (int e = 0; e < count; ++e) {
    if (model.edge_is_face[first + e] == 0) continue;
    const SkinMotion<2>&from = work.skin[model.corner_skin[first + e]],
          &to = work.skin[model.corner_skin[first + (e + 1) % count]];
    const double x = to.x - from.x, y = to.y - from.y, length = std::sqrt(x * x + y * y);
    double deepest = 0;
    for (int c = model.piece_first[other]; c < model.piece_first[other + 1]; ++c) {
      const SkinMotion<2>& corner = work.skin[model.corner_skin[c]];
      deepest = std::max(deepest, x * (corner.y - from.y) - y * (corner.x - from.x));
    }
    if (deepest <= most * length) return true;
  }
  return false;
}

/// Remaining penetration of elements that are thin against their bodies: the overlap of the bodies counts. Until an
/// element has passed another one, their own surfaces show that the bodies are not deep. A contact that ended because
/// the surfaces have passed each other is too deep.
double thin_room_of(const Model<2>& model, const State<2>& state, const Work<2>& work, int row, double allowed) {
  const int p = work.pairs[row].piece_a, q = work.pairs[row].piece_b;
  const bool touches = (work.contacts.memory[row].state & contact_touching) != 0;
  const double least = touches ? std::min(piece_width(model, work, p), piece_width(model, work, q)) : unbounded;
  if (is_told(model, state, p, q)) return least;
  if (!touches) return passed_depth(model, work, p, q) > 0 ? -allowed : least;
  const double depth = body_depth(model, work, p, q, 0.5 * allowed);
  return depth > allowed ? allowed - depth : least;
}

/// Penetration that remains for the pieces of a row [m]; negative if they are too deep and not yet reported. For pieces
/// below half of the limit the result is at least half of the limit. For pieces that do not touch it is unbounded: they
/// are checked when they begin to touch.
double room_of(const Model<2>& model, const State<2>& state, const Work<2>& work, int row) {
  const NearPair& pair = work.pairs[row];
  const int p = pair.piece_a, q = pair.piece_b;
  const double allowed = deepest_allowed(model, p, q), half = 0.5 * allowed;
  const double of_bodies = deepest_of_bodies(model, p, q);
  const bool touches = (work.contacts.memory[row].state & contact_touching) != 0;
  if (is_thin_for(model, work, p, q, of_bodies)) return thin_room_of(model, state, work, row, of_bodies);
  if (!touches) return unbounded;
  if (pair.facing > 0 && beneath_face(model, work, pair) <= half) return half;
  if (is_beneath(model, work, p, q, half) || is_beneath(model, work, q, p, half)) return half;
  if (is_told(model, state, p, q)) return half;
  const double left = Two(model, state, p, q).room(allowed);
  return left == 0 ? half : left;
}

/// Value of Work::travel until which the check of a row with this `room` [m] remains valid. It is unbounded if neither
/// piece can get too deep before the broad phase updates it. Two corners approach each other by at most twice the
/// travel of the fastest point.
double clear_until(const Work<2>& work, int row, double room) {
  const NearPair& pair = work.pairs[row];
  const double nearer = reach_of(work.search, pair.piece_a) + reach_of(work.search, pair.piece_b);
  return room > nearer ? unbounded : work.travel + 0.5 * (1 - 1e-9) * room;
}

/// Marks rows that are too deep and not yet reported.
constexpr double too_deep = -1;

/// Checks a row. Returns the travel until which the check remains valid, or `too_deep`.
double look_at_row(const Model<2>& model, const State<2>& state, Work<2>& work, int row) {
  const double room = room_of(model, state, work, row);
  return work.clear_until[row] = room < 0 ? too_deep : clear_until(work, row, room);
}

/// Checks the rows from `first` to before `last` whose checks have expired. Returns the shortest travel until which all
/// of them remain valid, or `too_deep` if a row is too deep.
double look_at_rows(const Model<2>& model, const State<2>& state, Work<2>& work, int first, int last) {
  double least = unbounded;
  for (int row = first; row < last; ++row) {
    const double clear = work.clear_until[row];
    least = std::min(least, work.travel < clear ? clear : look_at_row(model, state, work, row));
  }
  return least;
}

/// Reports the rows that are too deep, in their order, once for each pair of bodies.
void tell_deep(const Model<2>& model, State<2>& state, Work<2>& work, std::vector<Event>& told) {
  work.clear_path = unbounded;
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    if (work.clear_until[row] == too_deep) {
      const int p = work.pairs[row].piece_a, q = work.pairs[row].piece_b;
      if (!is_told(model, state, p, q)) tell(model, state, work, p, q, Two(model, state, p, q), told);
      work.clear_until[row] = clear_until(work, row, 0.5 * deepest_allowed(model, p, q));
    }
    work.clear_path = std::min(work.clear_path, work.clear_until[row]);
  }
}

/// Rows per chunk of a thread; some microseconds.
constexpr int looked_stretch = 512;

/// Checks all rows whose checks have expired.
void look_now(const Model<2>& model, State<2>& state, Work<2>& work, std::vector<Event>& told) {
  struct alignas(64) Path {
    double least = unbounded;
  };
  std::array<Path, most_threads> by{};
  share(work.threads, static_cast<int>(work.pairs.size()), looked_stretch, [&](int first, int last, int thread) {
    double& least = by[static_cast<std::size_t>(thread)].least;
    least = std::min(least, look_at_rows(model, state, work, first, last));
  });
  work.clear_path = unbounded;
  for (const Path& path : by) work.clear_path = std::min(work.clear_path, path.least);
  if (work.clear_path == too_deep) tell_deep(model, state, work, told);
}

/// Checks only the rows that began or ceased to touch in this step. A contact that a bearing had suppressed may begin
/// deep.
void look_at_new(const Model<2>& model, const State<2>& state, Work<2>& work) {
  for (const int row : work.changed_rows)
    work.clear_path = std::min(work.clear_path, look_at_row(model, state, work, row));
}

/// Largest number of checks along a step. Only a rotation that no step can follow needs more; the speed watch reports
/// it.
constexpr int most_looks = 10000;

/// Checks two pieces along the last step.
void look_back(const Model<2>& model, State<2>& state, const Work<2>& work, int p, int q, std::vector<Event>& told) {
  const double allowed = deepest_allowed(model, p, q), growth = allowed * depth_per_step / deep_penetration_share;
  double left = state.last_dt;
  for (int looks = 0; left > 0 && looks < most_looks; ++looks) {
    const Two two(model, state, p, q, -left);
    if (two.room(allowed) < 0) return tell(model, state, work, p, q, two, told);
    // Follows the step from its start with the velocities at its end. This is exactly the path of a leapfrog step,
    // including rotation.
    const double time = time_to_depth(two.a, two.b, left, growth);
    if (!(time > 0)) return;  // the motion is not finite
    left -= time;
  }
}

}  // namespace

/// Pieces get too deep in two ways. They may pass through each other and out again within the last step, which is
/// checked along its path. Or they get deeper step by step; such pairs are checked only when the travel of the fastest
/// point may have brought one to the limit.
std::vector<Event> report_deep_penetration(const Model<2>& model, State<2>& state, Work<2>& work) {
  std::vector<Event> told;
  // Only pieces that move farther than their thickness can pass through within one step.
  if (!goes_slowly(model, work, state.last_dt, 1))
    for (const auto& [p, q] : swept_pairs(model, state, work, -state.last_dt, 1))
      if (!is_told(model, state, p, q)) look_back(model, state, work, p, q, told);
  look_at_new(model, state, work);
  if (!(work.travel < work.clear_path)) look_now(model, state, work, told);
  return told;
}

}  // namespace trilith
