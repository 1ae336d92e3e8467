// Contact rows divided into runs for threads: completeness, and rows at the border between runs.
#include "assembly/contact/contact_partition.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <set>
#include <vector>

#include "assembly/contact/face_contact_simd.hpp"
#include "assembly/evaluate.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A wall of 24 courses of 12 blocks.
Model<2> wall() {
  Scene scene(Frictional{1e9, 4e8, 0.5, 1e-4});
  scene.fixed("ground", box(-1, -1, 6, 0));
  for (int course = 0; course < 24; ++course)
    for (int i = 0; i < 12; ++i)
      scene.block(fmt::format("u{}.{}", course, i), box(0.4 * i, 0.2 * course, 0.4 * (i + 1), 0.2 * (course + 1)), 100);
  return scene.builder.build();
}

}  // namespace

TEST_CASE("every row belongs to one run and a side is at a border where its body has rows in two") {
  const Model<2> model = wall();
  for (const int threads : {2, 3, 5}) {
    CAPTURE(threads);
    State<2> state = initial_state(model);
    Work<2> work;
    work.threads = threads;
    for (int i = 0; i < 20; ++i) evaluate(model, state, work, 1e-4);
    const RowShares& shares = work.row_shares;
    REQUIRE(shares.threads == threads);
    REQUIRE(shares.runs() >= threads);
    CHECK(shares.runs() <= runs_a_thread * threads);
    CHECK(shares.first.front() == 0);
    CHECK(shares.first.back() == static_cast<int>(work.pairs.size()));
    std::vector<std::set<int>> in_shares(model.bodies.size());
    const auto body = [&](int piece) { return static_cast<std::size_t>(model.piece_body[piece]); };
    for (int t = 0; t < shares.runs(); ++t) {
      CHECK(shares.first[t] < shares.first[t + 1]);
      for (int row = shares.first[t]; row < shares.first[t + 1]; ++row)
        for (const int piece : {work.pairs[row].piece_a, work.pairs[row].piece_b}) in_shares[body(piece)].insert(t);
    }
    int inside = 0;
    for (std::size_t row = 0; row < work.pairs.size(); ++row) {
      const bool a = in_shares[body(work.pairs[row].piece_a)].size() > 1,
                 b = in_shares[body(work.pairs[row].piece_b)].size() > 1;
      CHECK(shares.border[row] == ((a ? side_a : 0) | (b ? side_b : 0)));
      inside += !a && !b ? 1 : 0;
    }
    CHECK(inside > 0);  // otherwise the runs would save nothing
  }
}

TEST_CASE("rows have no shares with one thread, nor before their pairs are unchanged for a while") {
  const Model<2> model = wall();
  const State<2> state = initial_state(model);
  Work<2> alone, found;
  found.threads = 2;
  for (int i = 0; i < 20; ++i) evaluate(model, state, alone, 1e-4);
  CHECK(alone.row_shares.threads == 0);
  evaluate(model, state, found, 1e-4);
  CHECK(found.row_shares.threads == 0);
}
