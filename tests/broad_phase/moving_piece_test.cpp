#include "broad_phase/moving_piece.hpp"

#include <random>

#include "geometry/plane/random_convex.hpp"
#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Two free bodies, one piece each.
struct Two {
  Model<2> model;
  State<2> state;

  Two(const Polygon& a, const Polygon& b) {
    Scene scene(Frictional{1e8, 5e7, 0.6, 0});
    scene.builder.overlap_allowed = 1;
    for (const auto& [name, outline] : {std::pair("a", a), std::pair("b", b)}) {
      BodySpec spec;
      spec.name = name, spec.outline = outline, spec.floating = true;
      scene.add(spec);
    }
    model = scene.builder.build();
    state = initial_state(model);
  }
  [[nodiscard]] double depth(double later) const {
    return overlap_of(moving_piece(model, state, 0, later), moving_piece(model, state, 1, later)).depth;
  }
  [[nodiscard]] double time(double longest, double depth) const {
    return time_to_depth(moving_piece(model, state, 0), moving_piece(model, state, 1), longest, depth);
  }
};

}  // namespace

TEST_CASE("the overlap of two pieces is the least separating translation") {
  CHECK(near(Two(box(0, 0, 1, 1), box(0.5, 0.9, 1.5, 1.9)).depth(0), 0.1, 1e-12));
  CHECK(near(Two(box(0, 0, 1, 1), box(0.98, 0.9, 1.98, 1.9)).depth(0), 0.02, 1e-12));
  CHECK(near(Two(box(0, 0, 1, 1), box(0.2, 1.25, 1.2, 2.25)).depth(0), -0.25, 1e-12));
  // A bar half way through a plate: back by its way in, or onward.
  CHECK(near(Two(box(-2, 0, 2, 0.1), box(-0.2, -0.5, 0.2, 0.6)).depth(0), 0.6, 1e-12));
}

TEST_CASE("a body that flies at a plate is limited before it and then penetrates by the allowed depth") {
  Two two(box(-1, 0, 1, 0.1), box(-0.1, 1.1, 0.1, 1.3));
  two.state.velocity[1] = {3, -100};
  CHECK(near(two.time(1, 0.01), 0.99 / 100, 1e-9));
  CHECK(two.time(0.005, 0.01) == 0.005);
  two.state.position[1].y() -= 0.985;  // 15 mm away: less than two depths
  CHECK(near(two.time(1, 0.01), 0.01 / 100, 1e-9));
  two.state.position[1].y() -= 0.02;  // 5 mm deep
  CHECK(near(two.time(1, 0.01), 0.01 / 100, 1e-9));
  two.state.velocity[1] = {3, 100};  // on its way out
  CHECK(two.time(1, 0.01) == 1);
}

TEST_CASE("a body that slides along a plate is not slowed at any speed") {
  Two two(box(-1, 0, 1, 0.1), box(-0.1, 0.0999, 0.1, 0.3));
  two.state.velocity[1] = {1000, 0};
  CHECK(two.time(0.1, 1e-3) == 0.1);
}

TEST_CASE("within the computed time to a depth, no two pieces get deeper, for any shape, velocity and spin") {
  std::mt19937_64 bits(7);
  int held = 0;
  for (int i = 0; i < 400; ++i) {
    RandomConvex wanted;
    wanted.smallest = 0.1, wanted.largest = 1, wanted.slenderest = 20;
    const Vec2 away = random_between(bits, 0, 1.5) * random_direction(bits);
    Two two(placed(random_convex(bits, wanted), random_direction(bits), {0, 0}),
            placed(random_convex(bits, wanted), random_direction(bits), away));
    for (const int body : {0, 1}) {
      two.state.velocity[body] = random_between(bits, 0, 50) * random_direction(bits);
      two.state.spin[body] = random_between(bits, -80, 80);
    }
    const double depth = random_between(bits, 0.005, 0.05), time = two.time(0.02, depth), now = two.depth(0);
    REQUIRE(time > 0);
    held += time < 0.02 ? 1 : 0;
    double most = -unbounded;
    for (int k = 0; k <= 200; ++k) most = std::max(most, two.depth(time * k / 200));
    INFO("pair ", i, ": ", now, " m deep, ", depth, " m allowed, ", time, " s");
    CHECK(most <= std::max(now + depth, -depth) + 1e-9);
  }
  CHECK(held > 50);
  CHECK(held < 350);
}
