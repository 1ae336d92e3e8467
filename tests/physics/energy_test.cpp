// The energy ledger: every term follows from its own law, and the residual is the error of the time integration alone.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "contact/contact_samples.hpp"
#include "law/bearing/direction_samples.hpp"
#include "near.hpp"
#include "physics/collapses.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::near;
using testing::Scene;
using Term = EnergyTerm;

/// Terms that only dissipate: they may not fall by more than a trace of the energy input. (The dish of a pendulum under
/// a changing load, and a bearing that passes load to a stiffer one, may also return energy.)
constexpr std::array rising{Term::contact_friction, Term::contact_fracture, Term::mass_damping, Term::rest_damping};

/// Ledger figures of a run.
struct Books {
  Energy first, last;
  double residual = 0;  ///< largest change of the balance [J]
  double input =
      0;  ///< largest sum of initial and added energy: motion at the start, lowered weight, supports, loads [J]
  double fallen = 0;  ///< largest decrease of a term that may only rise [J]
  double least = 0;   ///< least value of the kinetic and elastic terms [J]
  int samples = 0;

  [[nodiscard]] double share() const { return residual / input; }
};

Books keep_books(Simulation<2>& sim, StageOptions options) {
  Books books;
  Energy before;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (books.samples++ == 0) books.first = before = e;
    books.residual = std::max(books.residual, std::abs(e.balance() - books.first.balance()));
    const double start =
        books.first[Term::kinetic] + books.first[Term::contact_elastic] + books.first[Term::bearing_elastic];
    const auto put_in = [&](Term t, double sign) { return std::max(0.0, sign * (e[t] - books.first[t])); };
    books.input =
        std::max(books.input, start + put_in(Term::gravity, -1) + put_in(Term::support, 1) + put_in(Term::load, 1));
    for (const Term t : rising) books.fallen = std::max(books.fallen, before[t] - e[t]);
    for (const Term t : {Term::kinetic, Term::contact_elastic, Term::bearing_elastic})
      books.least = std::min(books.least, e[t]);
    before = books.last = e;
  };
  sim.run(options, listener);
  return books;
}

StageOptions stage(double duration, double safety, double samples = 400) {
  StageOptions options;
  options.duration = duration;
  options.safety = safety;
  options.energy_interval = duration / samples;
  return options;
}

/// The ledger closes to 0.1 % of the input.
void check_closed(const std::string& name, const Books& b) {
  std::string terms;
  for (std::size_t i = 0; i < energy_terms; ++i)
    if (b.last.value[i] != 0) terms += fmt::format("{} {:.6g}, ", energy_term_info[i].name, b.last.value[i]);
  MESSAGE(name << ": residual " << b.residual << " J of " << b.input << " J put in: " << 100 * b.share()
               << " %. At the end " << terms);
  INFO(name);
  CHECK(b.samples > 100);
  CHECK(b.share() < 1e-3);
  CHECK(b.fallen < 1e-3 * b.input);
  CHECK(b.least >= -1e-6 * b.input);
}

TEST_CASE("the energy balance of a falling and bouncing block closes") {
  for (const double zeta : {0.0, 0.1, 0.5}) {
    Scene scene(Frictional{1e8, 5e7, 0.5, 2 * zeta / std::sqrt(1e5)});
    scene.fixed("base", box(-2, -0.5, 3, 0));
    BodySpec block;
    block.name = "block", block.outline = box(0, 0.4, 1, 1), block.mass = 1000, block.floating = true;
    scene.add(block);
    Simulation<2> sim = scene.start();
    const Books b = keep_books(sim, stage(2, 0.02));
    check_closed(fmt::format("bouncing block, zeta {}", zeta), b);
    CHECK((b.last[Term::contact_damping] > 0.1 * b.input) == (zeta > 0));
  }
}

TEST_CASE("the energy balance of a block that falls on a corner and tumbles closes") {
  for (const double angle : {0.3, 0.7, 1.2}) {
    Scene scene(Frictional{1e8, 5e7, 0.4, 1e-4});
    scene.fixed("base", box(-5, -0.5, 5, 0));
    BodySpec block;
    const Turn turn(angle);
    block.name = "block", block.outline = box(-0.5, -0.3, 0.5, 0.3), block.mass = 1200, block.floating = true;
    for (Vec2& p : block.outline) p = turn.apply(p) + Vec2(0, 1.2);
    block.velocity = {1.5, 0}, block.spin = 2;
    scene.add(block);
    Simulation<2> sim = scene.start();
    check_closed(fmt::format("tumbling block, {} rad", angle), keep_books(sim, stage(2, 0.02)));
  }
}

TEST_CASE("the energy balance of a sliding block closes, and friction dissipates its energy") {
  Scene scene(Frictional{1e8, 5e7, 0.3, 2e-4});
  scene.fixed("base", box(-2, -0.5, 8, 0));
  scene.block("block", box(0, 0, 1, 0.5), 1000, {3, 0});
  Simulation<2> sim = scene.start();
  const Books b = keep_books(sim, stage(2, 0.05));
  check_closed("sliding block", b);
  CHECK(near(b.last[Term::contact_friction], 0.5 * 1000 * 9, 0.01));
}

TEST_CASE("the energy balance of a rocking block closes") {
  Scene scene(Frictional{1e9, 8e8, 1.0, 2e-5});
  scene.fixed("base", box(-2, -0.5, 2, 0));
  BodySpec block;
  const double angle = 0.5 * std::atan(1.0 / 3);
  const Turn turn(-angle);
  block.name = "block", block.outline = box(-0.4, 0, 0, 1.2), block.mass = 960;
  for (Vec2& p : block.outline) p = turn.apply(p);
  scene.add(block);
  Simulation<2> sim = scene.start();
  const Books b = keep_books(sim, stage(3, 0.1));
  check_closed("rocking block", b);
}

TEST_CASE("the energy balances of eight structures that lose their support close" * doctest::test_suite("long")) {
  for (const testing::Collapse& c : testing::collapses()) {
    Simulation<2> sim(c.model());
    const Books b = keep_books(sim, stage(c.duration, c.name == "leaning stack" ? 0.01 : 0.05));
    check_closed(c.name, b);
    if (c.name.starts_with("bonded")) CHECK(b.last[Term::contact_fracture] > 0);
    if (c.name == "pulled span") {
      CHECK(b.last[Term::bearing_failure] != 0);
      CHECK(b.last[Term::bearing_inner] > 0);
    }
  }
}

TEST_CASE("the energy balance of a driven oscillator closes, and its dashpot dissipates the work of the support") {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.fixed("base", box(-1, -1, 1, 0));
  scene.block("mass", box(-0.5, 1, 0.5, 2), 1000);
  scene.builder.set_contact("*", "*", "none");
  BearingSpec link;
  link.name = "columns", link.body_a = "base", link.body_b = "mass", link.point_a = {0, 0}, link.point_b = {0, 1};
  link.law = {Linear{1e5, 1e3}, Linear{1e7, 1e4}, Linear{1e6, 1e3}};
  scene.builder.add_bearing(link);
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", testing::sine(3, 1.5, 8));
  Simulation<2> sim(model);
  const Books b = keep_books(sim, stage(10, 0.05));
  check_closed("driven oscillator", b);
  CHECK(b.last[Term::support] > 0);
  CHECK(near(b.last[Term::bearing_damping], b.last[Term::support], 0.05));
}

TEST_CASE("every bearing law keeps its part of the energy balance") {
  for (const auto& [name, law] : testing::direction_samples(200)) {
    Scene scene(Frictional{1e8, 5e7, 0.5, 1e-4});
    scene.fixed("base", box(-1, -1, 1, 0));
    scene.block("mass", box(-0.5, 0, 0.5, 0.4), 1000);
    scene.builder.set_contact("*", "*", "none");
    BearingSpec link;
    link.name = "link", link.body_a = "base", link.body_b = "mass";
    link.law = {law, Linear{1e7, 2e4}, Linear{1e6, 1e3}};
    scene.builder.add_bearing(link);
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base", testing::sine(4, 1.5, 4));
    Simulation<2> sim(model);
    check_closed(fmt::format("bearing {}", name), keep_books(sim, stage(4, 0.02)));
  }
}

TEST_CASE("every contact law keeps its part of the energy balance") {
  for (const auto& [name, law] : testing::contact_samples()) {
    Scene scene(law);
    scene.fixed("base", box(-2, -0.5, 8, 0));
    scene.block("struck", box(0, 0, 1, 0.5), 1000, {3, 0});
    BodySpec thrown;
    thrown.name = "thrown", thrown.outline = box(3, 0.1, 4, 0.5), thrown.mass = 800, thrown.floating = true;
    thrown.velocity = {1, -1}, thrown.spin = 0.5;
    scene.add(thrown);
    Simulation<2> sim = scene.start();
    check_closed(name, keep_books(sim, stage(1.5, 0.014)));
  }
}

TEST_CASE("a bearing that becomes another bearing or contact keeps the energy balance closed") {
  for (const bool becomes_contact : {false, true}) {
    Scene scene(Frictional{1e8, 5e7, 0.4, 2e-4});
    scene.fixed("base", box(-2, -0.5, 6, 0));
    scene.block("block", box(0, 0, 1, 0.5), 1000, {0.8, 0});
    BearingSpec first, second;
    first.name = "first", first.body_a = "base", first.body_b = "block", first.point_a = first.point_b = {0.5, 0};
    first.law = {Linear{2e4, 0}, Linear{1e8, 2e5}, Linear{1e6, 1e4}};
    first.limit[along] = 0.05;
    first.replaces_contact = true;
    second = first;
    second.name = "second", second.starts_waiting = true, second.limit[along] = unbounded;
    second.law = {Friction{0.3, 1e6, 0}, Linear{1.5e8, 2e5}, Linear{1e6, 1e4}};
    if (!becomes_contact) first.becomes_bearing = "second";
    scene.builder.add_bearing(first);
    if (!becomes_contact) scene.builder.add_bearing(second);
    Simulation<2> sim = scene.start();
    const Books b = keep_books(sim, stage(1.5, 0.02));
    check_closed(becomes_contact ? "bearing to contact" : "bearing to bearing", b);
    CHECK(sim.state().bearing[0].status == BearingStatus::changed);
  }
}

TEST_CASE("dampings, loads and a tilting table are booked with the sign declared") {
  Scene scene(Frictional{1e8, 5e7, 0.4, 1e-4});
  scene.fixed("base", box(-2, -0.5, 8, 0));
  BodySpec block;
  block.name = "block", block.outline = box(0, 0.01, 1, 0.5), block.mass = 1000, block.load = {5000, 0};
  block.floating = true;
  scene.add(block);
  scene.builder.mass_damping = 0.8;
  Simulation<2> sim = scene.start();
  const Books loaded = keep_books(sim, stage(2, 0.02));
  check_closed("pushed block with mass damping", loaded);
  CHECK(loaded.last[Term::load] > 0);
  CHECK(loaded.last[Term::mass_damping] > 0);
  CHECK(loaded.last[Term::contact_friction] > 0);
  CHECK(loaded.last[Term::gravity] < 0);

  Simulation<2> rest(testing::leaning_stack());
  StageOptions options = stage(1, 0.02);
  options.rest_share = 0.8;
  const Books settled = keep_books(rest, options);
  check_closed("consolidation", settled);
  CHECK(settled.last[Term::rest_damping] > 0);

  Model<2> tilting = scene.builder.build();
  tilting.load[1] = Vec2::Zero();
  tilting.gravity.tilt_rate = 0.3;
  Simulation<2> tilt(tilting);
  check_closed("tilting table", keep_books(tilt, stage(2, 0.02)));
}

TEST_CASE("the residual of a smooth motion falls with the square of the step") {
  // Two masses on springs, without damping and contact.
  const auto residual = [](double dt) {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.fixed("base", box(-1, -1, 1, 0));
    scene.block("low", box(-0.5, 1, 0.5, 2), 1000, {0.5, 0});
    scene.block("high", box(-0.5, 3, 0.5, 4), 700, {-0.8, 0.1});
    scene.builder.set_contact("*", "*", "none");
    for (const auto& [name, a, b, y] : {std::tuple{"one", "base", "low", 0.5}, std::tuple{"two", "low", "high", 2.5}}) {
      BearingSpec link;
      link.name = name, link.body_a = a, link.body_b = b, link.point_a = link.point_b = {0, y};
      link.law = {Linear{2e5, 0}, Linear{4e5, 0}, Linear{3e5, 0}};
      scene.builder.add_bearing(link);
    }
    Simulation<2> sim = scene.start();
    StageOptions options = stage(2, 0.5);
    options.dt = dt;
    return keep_books(sim, options).residual;
  };
  const double coarse = residual(2e-3), fine = residual(5e-4);
  MESSAGE("residual " << coarse << " J, with a quarter of the step " << fine << " J");
  CHECK(near(coarse / fine, 16, 0.15));
}

}  // namespace
}  // namespace trilith
