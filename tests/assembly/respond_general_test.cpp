// Caches of the general contact between evaluations do not change the results, and neither does the assignment of rows
// to threads or to groups.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <span>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "events/commit.hpp"
#include "geometry/plane/random_convex.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "model/builder/builder.hpp"

using namespace trilith;

namespace {

/// Sixty boxes and random stones that fall into a trough. `laws`: with 2, every second one is of another material, and
/// contacts of unlike materials are softer and smoother.
Model<2> falling_stones(int laws = 1) {
  ModelBuilder builder;
  builder.add_material({"stone", 2000}), builder.add_material({"brick", 2000});
  builder.add_law("joint", Frictional{5e7, 2.5e7, 0.5, 1e-3});
  builder.set_contact("*", "*", "joint");
  if (laws == 2) {
    builder.add_law("smooth", Frictional{3e7, 1e7, 0.1, 5e-4});
    builder.set_contact("stone", "brick", "smooth");
  }
  builder.gravity = Vec2(0, -standard_gravity);
  const auto add = [&](std::string name, Polygon outline, bool fixed, bool is_brick = false) {
    BodySpec spec;
    spec.name = std::move(name), spec.outline = std::move(outline), spec.material = is_brick ? "brick" : "stone";
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
        false, laws == 2 && i % 2 == 1);
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

/// The touching rows of an evaluation, evaluated again one by one: `each(contact, memory, response alone)`.
template <class Each>
void for_rows_alone(const Model<2>& model, const State<2>& state, const Work<2>& work, double dt, Each&& each) {
  const ContactHistory& before = contacts_before(state, work);
  for (const GeneralContact<2>& contact : work.general_touching) {
    const auto row = static_cast<std::size_t>(contact.row);
    const NearPair& pair = work.pairs[row];
    PieceCorners room_a, room_b;
    const PlacedPiece a = placed_piece(model, state, work, pair.piece_a, room_a),
                      b = placed_piece(model, state, work, pair.piece_b, room_b);
    std::array<Vec2, max_piece_corners> on_a, on_b;
    on_a.fill(Vec2::Zero()), on_b.fill(Vec2::Zero());
    std::array<double, 64> law_after{};
    each(contact, work.contacts.memory[row],
         respond_overlap(a, b, {before.memory[row], before.law_numbers(row)}, law_in_use(model, pair.law, dt),
                         std::span(on_a).first(a.corner.size()), std::span(on_b).first(b.corner.size()),
                         law_after.data()));
  }
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

TEST_CASE("each row of a pile with two laws has the pressure and the friction of its own law") {
  const Model<2> model = falling_stones(2);
  State<2> state = start_state(model);
  Work<2> work;
  const double dt = 2e-4;
  std::array<int, 2> corners{}, slides{};  // by law
  for (int step = 0; step < 3000; ++step) {
    evaluate(model, state, work, dt);
    if (step % 100 == 0) {
      for_rows_alone(model, state, work, dt,
                     [&](const GeneralContact<2>& in_group, const ContactMemory& kept, const OverlapResponse& alone) {
                       const NearPair& pair = work.pairs[static_cast<std::size_t>(in_group.row)];
                       // Four rows evaluated together differ from single rows by rounding. The rounding error of a
                       // position, 1e-15 m, times stiffness and length is below 1e-7 N. A stone weighs 1 kN.
                       constexpr double rounding = 1e-6;
                       CHECK((in_group.force - alone.force).norm() < rounding);
                       CHECK(std::abs(in_group.size - alone.length) < 1e-9);
                       for (const int half : {0, 1})
                         CHECK(std::abs(kept.shear_total[half] - alone.memory.shear_total[half]) < rounding);
                       const auto law = static_cast<std::size_t>(pair.law);
                       corners[law] += pair.corner_at.is_there() ? 1 : 0;
                       slides[law] += alone.lost_friction > 0 ? 1 : 0;
                     });
    }
    commit(model, state, work);
    advance(model, state, work, {dt, {}});
  }
  for (const std::size_t law : {0U, 1U}) {
    CAPTURE(law);
    CHECK(corners[law] > 50);
    CHECK(slides[law] > 10);
  }
}
