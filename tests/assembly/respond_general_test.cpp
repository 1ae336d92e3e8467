// Caches of the general contact between evaluations do not change the results, and neither does the assignment of rows
// to threads.
#include <doctest/doctest.h>

#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "events/commit.hpp"
#include "geometry/plane/random_convex.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "model/builder/builder.hpp"

using namespace trilith;

namespace {

/// Sixty boxes and random stones that fall into a trough.
Model<2> falling_stones() {
  ModelBuilder builder;
  builder.add_material({"stone", 2000});
  builder.add_law("joint", Frictional{5e7, 2.5e7, 0.5, 1e-3});
  builder.set_contact("*", "*", "joint");
  builder.gravity = Vec2(0, -standard_gravity);
  const auto add = [&](std::string name, Polygon outline, bool fixed) {
    BodySpec spec;
    spec.name = std::move(name), spec.outline = std::move(outline), spec.material = "stone";
    if (fixed) spec.support = {Support::fixed, Support::fixed, Support::fixed};
    spec.floating = !fixed;
    if (!fixed) spec.velocity = {0, -2};
    builder.add_body(std::move(spec));
  };
  add("left", {{-3, 2}, {-3, -1}, {0, -1}}, true);
  add("right", {{3, 2}, {0, -1}, {3, -1}}, true);
  std::mt19937_64 bits(47);
  RandomConvex wanted;
  wanted.smallest = 0.2, wanted.largest = 0.3, wanted.slenderest = 1.5;
  for (int i = 0; i < 60; ++i) {
    const Polygon box{{-0.15, -0.1}, {0.15, -0.1}, {0.15, 0.1}, {-0.15, 0.1}};
    add("stone" + std::to_string(i),
        placed(i % 3 == 0 ? random_convex(bits, wanted) : box, random_direction(bits),
               {-0.95 + 0.38 * (i % 6), 1.3 + 0.38 * (i / 6)}),
        false);
  }
  return builder.build();
}

struct Trace {
  std::vector<std::uint64_t> digest;
  int hints = 0, corners = 0, touching = 0;
  std::size_t runs = 0, later = 0;  ///< largest number, see GeneralRun
};

/// `change(work, step)` may change the Work before each step.
template <class Change>
Trace follow(const Model<2>& model, Change&& change) {
  State<2> state = start_state(model);
  Work<2> work;
  Trace trace;
  const double dt = 2e-4;
  for (int step = 0; step < 3000; ++step) {
    change(work, step);
    evaluate(model, state, work, dt);
    commit(model, state, work);
    advance(model, state, work, {dt, {}});
    for (const NearPair& pair : work.pairs) {
      trace.hints += pair.apart_by >= 0 ? 1 : 0;
      trace.corners += pair.corner_at.is_there() ? 1 : 0;
    }
    trace.touching = std::max(trace.touching, static_cast<int>(work.general_touching.size()));
    trace.runs = std::max(trace.runs, work.general_runs.size());
    for (const GeneralRun<2>& run : work.general_runs) trace.later = std::max(trace.later, run.later.size());
    if (step % 50 == 0) trace.digest.push_back(state_hash(state));
  }
  return trace;
}

}  // namespace

TEST_CASE("the cached separating edge or corner of two pieces does not change the results") {
  const Model<2> model = falling_stones();
  const Trace kept = follow(model, [](Work<2>&, int) {});
  REQUIRE(kept.hints > 1000);
  REQUIRE(kept.corners > 10000);
  REQUIRE(kept.touching > 40);
  const Trace dropped = follow(model, [](Work<2>& work, int step) {
    if (step % 3 == 0) work = Work<2>{};
  });
  CHECK(dropped.digest == kept.digest);
  const Trace none = follow(model, [](Work<2>& work, int) {
    for (NearPair& pair : work.pairs) pair.apart_by = -1, pair.corner_at = {};
  });
  CHECK(none.digest == kept.digest);
  // The cached pair is another one, or one that does not exist.
  const Trace wrong = follow(model, [](Work<2>& work, int step) {
    for (std::size_t row = 0; row < work.pairs.size(); ++row) {
      const int any = static_cast<int>(row) * 7 + step;
      work.pairs[row].apart_by = static_cast<std::int8_t>(any % 128);
      work.pairs[row].corner_at = {static_cast<std::uint8_t>(any % 6), static_cast<std::uint8_t>(any / 6 % 6),
                                   any % 2 == 0, any % 5 == 0};
    }
    std::fill(work.asleep_until.begin(), work.asleep_until.end(), -1.0);
  });
  CHECK(wrong.digest == kept.digest);
}

TEST_CASE("general contacts computed in partitions by threads have the bits of a sequential evaluation") {
  const Model<2> model = falling_stones();
  const Trace alone = follow(model, [](Work<2>&, int) {});
  REQUIRE(alone.runs == 1);
  CHECK(alone.later == 0);
  for (const int threads : {2, 3, 5}) {
    CAPTURE(threads);
    const Trace shared = follow(model, [&](Work<2>& work, int) { work.threads = threads; });
    CHECK(shared.digest == alone.digest);
    CHECK(shared.touching == alone.touching);
    REQUIRE(shared.runs > 1);
    CHECK(shared.later > 0);  // forces on stones shared by two runs
  }
}
