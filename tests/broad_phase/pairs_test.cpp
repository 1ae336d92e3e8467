// Broad phase by body: no contact pair is missed however bodies move, and bodies at rest are not searched.
#include "broad_phase/pairs.hpp"

#include <random>
#include <set>

#include "assembly/evaluate.hpp"
#include "broad_phase/moving_piece.hpp"
#include "geometry/plane/random_convex.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

void move_on(const Model<2>& model, State<2>& state, double dt) {
  for (int n = 0; n < model.nodes(); ++n) {
    state.position[n] += dt * state.velocity[n];
    state.rotation[n] += dt * state.spin[n];
  }
  state.last_dt = dt;
}

std::set<ContactKey> keys_of(const Work<2>& work) {
  std::set<ContactKey> keys;
  for (const NearPair& p : work.pairs) keys.insert(contact_key(p.piece_a, p.piece_b));
  return keys;
}

/// Number of bodies with a corner closer to its allowed bound than the body's stored remaining distance.
int left_less(const Model<2>& model, const BroadPhaseState<2>& search, const Work<2>& work) {
  int count = 0;
  for (int p = 0; p < model.pieces(); ++p) {
    const LanePair stored = search.left[static_cast<std::size_t>(model.piece_body[p])].left - search.shifted;
    Vec2 left = Vec2::Constant(unbounded);
    for (int c = model.piece_first[p]; c < model.piece_first[p + 1]; ++c) {
      const SkinMotion<2>& skin = work.skin[static_cast<std::size_t>(model.corner_skin[c])];
      const Vec2 gone = Vec2(skin.x, skin.y) - search.together - search.corner[static_cast<std::size_t>(c)];
      left = left.cwiseMin(gone - search.low[p]).cwiseMin(search.high[p] - gone);
    }
    count += stored[0] <= left.x() && stored[1] <= left.y() ? 0 : 1;
  }
  return count;
}

/// Stones with sizes up to a factor `unlike` apart, without overlap.
Scene stones(std::mt19937_64& bits, int count, double unlike) {
  Scene scene(Frictional{1e8, 5e7, 0.6, 0});
  scene.builder.overlap_allowed = 1;
  scene.fixed("ground", box(-30, -1, 30, 0));
  for (int i = 0; i < count; ++i) {
    RandomConvex wanted;
    wanted.smallest = std::pow(unlike, -random_between(bits, 0, 1)), wanted.largest = wanted.smallest;
    wanted.slenderest = 2;
    BodySpec spec;
    spec.name = "stone" + std::to_string(i), spec.floating = true;
    // In separate statements: the order of evaluation of arguments is unspecified.
    const Vec2 middle{random_between(bits, -5, 5), random_between(bits, 0, 5)}, direction = random_direction(bits);
    spec.outline = placed(random_convex(bits, wanted), direction, middle);
    scene.add(spec);
  }
  return scene;
}

}  // namespace

TEST_CASE("an updated pair list equals a rebuilt one to the bit and misses no overlapping pair") {
  std::mt19937_64 bits(3);
  for (const double unlike : {3.0, 100.0}) {
    Scene scene = stones(bits, 60, unlike);
    const Model<2> model = scene.builder.build();
    State<2> state = initial_state(model);
    Work<2> kept;
    int missed = 0, differ = 0, overlapping = 0, unsorted = 0, less = 0;
    for (int step = 0; step < 1500; ++step) {
      // Each changes its direction at intervals; some stand still for a while.
      for (int n = 1; n < model.nodes(); ++n)
        if (step % 50 == n % 50) {
          const double speed = bits() % 3 == 0 ? 0 : std::pow(10, random_between(bits, -2, 1));
          state.velocity[n] = speed * random_direction(bits) - 0.3 * (state.position[n] - Vec2(0, 2));
          state.spin[n] = random_between(bits, -5, 5);
        }
      move_on(model, state, 1e-3);
      evaluate(model, state, kept, 1e-3);
      less += left_less(model, kept.search, kept);
      for (std::size_t row = 1; row < kept.pairs.size(); ++row)
        unsorted += kept.pairs[row - 1].piece_a < kept.pairs[row].piece_a ||
                            (kept.pairs[row - 1].piece_a == kept.pairs[row].piece_a &&
                             kept.pairs[row - 1].piece_b < kept.pairs[row].piece_b)
                        ? 0
                        : 1;
      if (step % 10 != 0) continue;
      Work<2> fresh;
      evaluate(model, state, fresh, 1e-3);
      for (int n = 0; n < model.nodes(); ++n)
        differ += kept.force[n] == fresh.force[n] && kept.moment[n] == fresh.moment[n] ? 0 : 1;
      const std::set<ContactKey> keys = keys_of(kept);
      for (int p = 0; p < model.pieces(); ++p)
        for (int q = p + 1; q < model.pieces(); ++q) {
          if (model.piece_body[p] == model.piece_body[q]) continue;
          if (overlap_of(moving_piece(model, state, p), moving_piece(model, state, q)).depth < 0) continue;
          ++overlapping;
          missed += keys.count(contact_key(p, q)) == 1 ? 0 : 1;
        }
    }
    CHECK(missed == 0);
    CHECK(less == 0);
    CHECK(differ == 0);
    CHECK(unsorted == 0);
    CHECK(overlapping > 500);
  }
}

namespace {

/// A row of blocks on the ground, and one in the air.
Model<2> row_of_blocks() {
  Scene scene(Frictional{1e8, 5e7, 0.6, 0});
  scene.fixed("ground", box(-1, -1, 21, 0));
  for (int i = 0; i < 20; ++i) scene.block("block" + std::to_string(i), box(i, 0, i + 0.9, 1), 1000);
  BodySpec stone;
  stone.name = "stone", stone.outline = box(5, 10, 6, 11), stone.mass = 1000, stone.floating = true;
  scene.add(stone);
  return scene.builder.build();
}

}  // namespace

TEST_CASE("a passing body does not trigger a contact search for standing bodies and finds its own neighbours") {
  const Model<2> model = row_of_blocks();
  State<2> state = initial_state(model);
  const int stone = model.nodes() - 1;
  state.velocity[stone] = {0, -5};
  Work<2> work;
  evaluate(model, state, work, 1e-3);
  const auto pairs = work.pairs.size();
  const std::vector<Vec2> corners = work.search.corner;
  const WayLeft<2> of_block = work.search.left[1];
  int looked_up = 0;
  Vec2 last = corners.back();
  for (int step = 0; step < 1780; ++step) {  // 8.9 m down: into the row's boxes, not into a block
    move_on(model, state, 1e-3);
    evaluate(model, state, work, 1e-3);
    looked_up += work.search.corner.back() != last ? 1 : 0;
    last = work.search.corner.back();
  }
  const auto standing = static_cast<std::ptrdiff_t>(corners.size()) - 4;
  CHECK(std::equal(corners.begin(), corners.begin() + standing, work.search.corner.begin()));
  const WayLeft<2>& now = work.search.left[1];
  CHECK(now.left[0] == of_block.left[0]);
  CHECK(now.left[1] == of_block.left[1]);
  CHECK(looked_up > 20);
  CHECK(looked_up < 200);
  // 5 mm, the displacement of one step, above the two blocks below: they must be candidate pairs before contact.
  for (int step = 0; step < 19; ++step) move_on(model, state, 1e-3), evaluate(model, state, work, 1e-3);
  CHECK(work.pairs.size() >= pairs + 2);
}

TEST_CASE("a common translation of all bodies triggers no new search") {
  const Model<2> model = row_of_blocks();
  State<2> state = initial_state(model);
  Work<2> work;
  evaluate(model, state, work, 1e-3);
  const std::vector<Vec2> corners = work.search.corner;
  for (int step = 0; step < 2000; ++step) {
    const Vec2 velocity(4 * std::sin(0.05 * step), std::cos(0.03 * step));
    std::fill(state.velocity.begin(), state.velocity.end(), velocity);
    move_on(model, state, 1e-3);
    evaluate(model, state, work, 1e-3);
  }
  CHECK(work.search.corner == corners);
}

namespace {

constexpr double brick_height = 0.064, brick_turn = 1e-4;  // [m], [rad]

/// A fixed brick of 0.25 m from the origin on, and a turned one of 0.125 m whose lower left corner is at `at`.
Scene two_bricks(const Vec2& at, double turn) {
  Scene scene(Cohesive{1.5e11, 6e10, 0.6, 0, 2e5, 1e5, 10, 50, 0, 0}, turn);
  scene.builder.overlap_allowed = 0.01;
  scene.fixed("lower", box(0, 0, 0.25, brick_height));
  BodySpec upper;
  upper.name = "upper", upper.mass = 10, upper.floating = true;
  for (const Vec2& p : box(0, 0, 0.125, brick_height)) upper.outline.push_back(at + Turn(brick_turn).apply(p));
  scene.add(upper);
  return scene;
}

/// The faces that two bonded bricks take as their pair; none where they take none.
struct TakenFaces {
  bool any = false;
  FaceOverlap<double> overlap;

  TakenFaces(const Vec2& at, double turn) {
    const Model<2> model = two_bricks(at, turn).builder.build();
    State<2> state = initial_state(model);
    Work<2> work;
    evaluate(model, state, work, 1e-4);
    REQUIRE(work.pairs.size() == 1);
    NearPair pair = work.pairs.front();
    any = choose_face_pair(model, work, true, pair);
    const auto ends = [&](int s0, int s1) {
      const SkinMotion<2>&p = work.skin[static_cast<std::size_t>(s0)], &q = work.skin[static_cast<std::size_t>(s1)];
      return FaceEnds<double>{p.x, p.y, q.x, q.y, 0, 0, 0, 0};
    };
    if (any) overlap = {ends(pair.a0, pair.a1), ends(pair.b0, pair.b1)};
  }
};

}  // namespace

TEST_CASE("bonded bricks that meet at a corner take no faces on their far sides") {
  // The upper brick has its lower left corner to the right of the corner of the lower one, and above it. Its turn
  // brings its far end below the top of the lower brick: the ends on the far sides, 0.375 m apart, share some
  // micrometres of height.
  const Vec2 beside(0.25 + 1e-7, brick_height + 3e-6);
  const Vec2 far_low = beside + Turn(brick_turn).apply(Vec2(0.125, 0)),
             far_high = beside + Turn(brick_turn).apply(Vec2(0.125, brick_height));
  const FaceOverlap<double> far({0, brick_height, 0, 0, 0, 0, 0, 0},
                                {far_low.x(), far_low.y(), far_high.x(), far_high.y(), 0, 0, 0, 0});
  REQUIRE(far.sane);
  REQUIRE(far.gap_lo < -0.37);
  for (const double turn : {0.0, 0.6, 1.5707963267948966, 2.2, -1.0}) {
    CAPTURE(turn);
    CHECK_FALSE(TakenFaces(beside, turn).any);
    // On the lower brick, pressed or open, it lies on its bed.
    for (const double gap : {-1e-3, -1e-6, 1e-6, 1e-3}) {
      CAPTURE(gap);
      const TakenFaces bed({0.2, brick_height + gap}, turn);
      REQUIRE(bed.any);
      CHECK(near(bed.overlap.shared, 0.05, 1e-2));
      CHECK(near_zero(bed.overlap.gap_lo - gap, 1.5e-5));
    }
  }
}
