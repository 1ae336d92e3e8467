// The seal of a run: each check for a run that passes it and for one that fails it.
#include "run/seal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "near.hpp"
#include "run/dropped_block.hpp"
#include "run/step_check.hpp"
#include "statics/travel.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const SealRow& row_of(const std::vector<SealRow>& rows, const std::string& check) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const SealRow& r) { return r.check == check; });
  REQUIRE(found != rows.end());
  return *found;
}

std::vector<SealRow> rows_of(const Simulation<2>& sim) {
  return sim.seal().rows(sim.verdict(), 0);
}

/// The rows after a sample of this model, state and work, with this ledger, and the end of a stage.
struct Sampled {
  Verdict verdict;
  std::vector<SealRow> rows;
};
Sampled sampled(const Model<2>& model, const State<2>& state, const Work<2>& work, const Energy& ledger = {}) {
  const StageOptions options;
  Seal seal;
  seal.sample(Instant<2>{model, state, work, options, 0, 1e-4, 0, 0}, Energy{}, false);
  seal.sample(Instant<2>{model, state, work, options, 0, 1e-4, 0, 0}, ledger, true);
  Sampled out;
  StageReport report;
  report.begun = 2;
  seal.end_stage(report, false, {}, "", out.verdict);
  out.rows = seal.rows(out.verdict, 3);
  return out;
}

/// A block that stands on driven ground, 0.1 s into a motion.
Simulation<2> shaken_block() {
  Model<2> model = dropped_block(0);
  const auto motion = std::make_shared<const GroundMotion>(std::vector<double>{0, 2, -2, 0, 0}, 0.05);
  set_drive(model, 0, 0, motion, 0, model.start_position[0].x());
  Simulation<2> sim(std::move(model));
  sim.run(fall_stage(0.1));
  return Simulation<2>(sim.model(), sim.state());
}

}  // namespace

TEST_CASE("a block that falls, bounces and rests passes all checks of the seal that apply") {
  Simulation<2> sim(dropped_block(0.2));
  StageOptions fall = fall_stage(6);
  fall.until_rest = true;
  REQUIRE(sim.run(fall).end == StageEnd::rest);
  CHECK(sim.verdict().sound());
  const std::vector<SealRow> rows = rows_of(sim);
  CHECK(rows.size() == 9);
  for (const SealRow& row : rows) CHECK(row.state != "failed");
  const SealRow& energy = row_of(rows, "energy balance");
  CHECK(energy.state == "passed");
  CHECK(energy.value > 0);
  CHECK(energy.value < 0.01);
  // The block lies with its weight on kn: its penetration at rest is a lower bound of the deepest one.
  const double at_rest = block_weight / (1e8 * 1 * 1) / 0.5;
  CHECK(row_of(rows, "deepest penetration").value > (1 - 1e-6) * at_rest);
  CHECK(row_of(rows, "deepest penetration").value < 0.1);
  CHECK(row_of(rows, "steps").state == "passed");
  CHECK(row_of(rows, "rest as static equilibrium").state == "not made");  // it fell: no search for rest
  CHECK(row_of(rows, "applied motion against record").state == "not made");
  const std::vector<std::string> lines = seal_lines(rows);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].starts_with("seal: passed: energy balance: "));
}

TEST_CASE("the ledger fails the seal above a fifth of the input, and not below it") {
  const Simulation<2> sim = shaken_block();
  for (const double share : {0.19, 0.21}) {
    CAPTURE(share);
    Energy ledger;
    ledger[EnergyTerm::kinetic] = 100, ledger[EnergyTerm::support] = 100 - 100 * share;
    const Sampled out = sampled(sim.model(), sim.state(), sim.work(), ledger);
    CHECK(near(row_of(out.rows, "energy balance").value, share, 1e-12));
    CHECK((row_of(out.rows, "energy balance").state == "failed") == (share > 0.2));
    CHECK(out.verdict.sound() == (share < 0.2));
    if (out.verdict.sound()) continue;
    CHECK(out.verdict.sound_until() == 2);
    CHECK(out.verdict.text() == "not reliable after 2 s: energy balance: 21 % of the input, must be at most 20 %");
    CHECK(seal_lines(out.rows) ==
          std::vector<std::string>{"seal: FAILED: energy balance: 21 % of the input, must be at most 20 %"});
  }
}

TEST_CASE("a force without its reaction fails the base shear of the seal") {
  Simulation<2> sim = shaken_block();
  sim.refresh();
  CHECK(row_of(sampled(sim.model(), sim.state(), sim.work()).rows, "base shear against inertia").state == "passed");
  Work<2> work = sim.work();
  work.force[0] += Vec2(1e-3 * block_weight, 0);
  const Sampled out = sampled(sim.model(), sim.state(), work);
  CHECK(row_of(out.rows, "base shear against inertia").state == "failed");
  // A thousandth of the weight against contact forces of the weight on either side.
  CHECK(near(row_of(out.rows, "base shear against inertia").value, 0.5e-3, 0.5));
}

TEST_CASE("ground that deviates from its record fails the seal") {
  Simulation<2> sim = shaken_block();
  sim.refresh();
  const Sampled good = sampled(sim.model(), sim.state(), sim.work());
  CHECK(row_of(good.rows, "applied motion against record").state == "passed");
  CHECK(row_of(good.rows, "applied motion against record").value < 1e-9);
  State<2> state = sim.state();
  const double moved = sim.model().drives[0].motion->displacement(state.time);
  for (const double share : {0.009, 0.011}) {
    CAPTURE(share);
    State<2> off = state;
    off.position[0].x() += share * std::abs(moved);
    const Sampled out = sampled(sim.model(), off, sim.work());
    CHECK((row_of(out.rows, "applied motion against record").state == "failed") == (share > 0.01));
  }
}

TEST_CASE(
    "a body that moves by more than its size in a search for rest fails the seal, and so do forces left at rest") {
  struct Case {
    double share, ratio;
    bool passes;
  };
  for (const Case& c : {Case{0.99, 0.04, true}, Case{1.01, 0.04, false}, Case{0.99, 0.06, false}}) {
    CAPTURE(c.share);
    Seal seal;
    Verdict verdict;
    StageReport report;
    report.end = StageEnd::rest, report.ratio = c.ratio;
    Travel travel;
    travel.body = 1, travel.share = c.share;
    seal.end_stage(report, true, travel, "top", verdict);
    CHECK(verdict.sound() == c.passes);
    CHECK(row_of(seal.rows(verdict, 0), "motion in a search for rest").text == "of the body's size (top)");
  }
}

TEST_CASE("a bond that a step skips fails the seal") {
  Seal seal;
  Verdict verdict;
  CHECK(row_of(seal.rows(verdict, 0), "bonds skipped by a step").state == "passed");
  verdict.add(EventType::bond_skipped, 0.5, -1, "a joint");
  verdict.add(EventType::bond_skipped, 0.6, -1, "another joint");
  const SealRow row = row_of(seal.rows(verdict, 0), "bonds skipped by a step");
  CHECK(row.failed());
  CHECK(row.value == 2);
  CHECK(row.valid_until == 0.5);
}

TEST_CASE("half the step leads to the same motion where the step is short, and to another one where it is not") {
  for (const double safety : {0.1, 0.9}) {
    CAPTURE(safety);
    Simulation<2> sim(dropped_block(0.2));
    StageOptions fall = fall_stage(0.6);
    fall.safety = safety;
    StepCheck<2> check({0.1, 0.6}, fall, sim);
    RunListener<2> listener;
    listener.at_border = [&] { check.look(sim); };
    const StageReport report = sim.run(fall, listener);
    const double before = sim.state().position[1].y();
    const std::optional<SealRow> row = check.repeat(sim);
    REQUIRE(row.has_value());
    CHECK(sim.state().position[1].y() == before);
    CHECK((row->value > 1e-12));
    if (safety < 0.5) CHECK(row->state == "passed");
    CHECK(row->text.find(" to 0.6 s") != std::string::npos);
    sim.add_check(*row, report.begun);
    CHECK(sim.verdict().sound() == (row->state == "passed"));
  }
}
