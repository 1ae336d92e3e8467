// Yielding frame members in the engine: plastic collapse, hinges with ultimate rotation, fibres, energy ledger.
#include "model/io/state_words.hpp"
#include "near.hpp"
#include "physics/members/implicit.hpp"
#include "physics/members/yielding.hpp"
#include "readings/member_forces.hpp"
#include "statics/load_path.hpp"

namespace trilith::testing {
namespace {

/// Fixed steps, for slowly growing loads.
StageOptions slow_stage(double duration) {
  StageOptions stage = implicit_stage(AlphaMethod::hht(-0.05), duration, 0.02);
  stage.tolerance = 1e-8;
  return stage;
}

/// Displacement of the portal's corner and of mid-span, one second after loads of `share` reach their full value [m].
double gone_under(const YieldingPortal& portal, double share) {
  Simulation<2> sim(portal.model(share));
  sim.run(slow_stage(3));
  const auto at = [&](int joint) { return Vec2(sim.state().position[joint] - sim.model().start_position[joint]); };
  return std::max(std::abs(at(1).x()), std::abs(at(2).y()));
}

TEST_CASE("F8: a portal stands at 1 % below its plastic collapse load and falls at 1 % above it") {
  struct Row {
    YieldingPortal portal;
    double factor;
    std::string mechanism;
  };
  for (const Row& row : {Row{{1e5, 5e4}, 1.2, "combined"}, Row{{1e5, 1e4}, 4.0 / 3, "beam"},
                         Row{{2e4, 6e4}, 5.0 / 3, "sway"}, Row{{1e5, 5e4, false}, 0.8, "on pinned feet"}}) {
    const double below = gone_under(row.portal, 0.99 * row.factor), above = gone_under(row.portal, 1.01 * row.factor);
    MESSAGE("F8 " << row.mechanism << " x " << row.factor << ": " << below << " m below, " << above << " m above");
    CHECK(below < 0.005);
    CHECK(above > 0.05);
  }
}

/// A column of 3 m with a mass of 10 t on top and a hinge at its foot, shaken along x.
Model<2> shaken_column(const HingeLaw& law, double damping) {
  BodySpec spec;
  spec.name = "column", spec.kind = BodyKind::frame, spec.material = "concrete", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "foot", .place = {0, 0}, .support = {Support::driven, Support::fixed, Support::fixed}},
                  {.name = "top", .place = {0, 3}, .mass = 1e4, .inertia = 2e3}};
  FrameMember member;
  member.name = "column", member.from = 0, member.to = 1, member.section = rectangle_section(0.4, 0.4);
  member.divisions = 4, member.yields = MemberHinges{{law, std::nullopt}};
  frame.members = {member};
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("concrete", 2400, 30e9, 0, damping), {spec});
  const auto motion =
      motion_of(4, 1e-3, [](double t) { return t < 3 ? 6 * std::sin(10 * t) * std::sin(M_PI * t / 3) : 0; });
  set_drive(model, 0, 0, motion, 0, 0);
  return model;
}

struct Shaken {
  double drift = 0, moment = 0, worst_residual = 0, plastic = 0;
  HingeReading hinge;
  std::vector<Event> events;
};
Shaken shake(const HingeLaw& law, double damping, const std::optional<AlphaMethod>& scheme) {
  Simulation<2> sim(shaken_column(law, damping));
  StageOptions stage;
  stage.duration = 2, stage.energy_interval = 0.01;
  if (scheme) stage = adaptive_stage(*scheme, 2, 0.01), stage.energy_interval = 0.01;
  Shaken out;
  RunListener<2> listener;
  listener.on_step = [&](const Instant<2>& now) {
    const Vec2 gone = now.state.position[1] - now.state.position[0] - Vec2(0, 3);
    out.drift = std::max(out.drift, std::abs(gone.x()));
    out.moment = std::max(out.moment, std::abs(member_forces(now.model, now.state, 0).front().moment));
  };
  listener.on_event = [&](const Event& e, const Instant<2>&) { out.events.push_back(e); };
  double most = 0;
  listener.on_energy = [&](const Instant<2>&, const Energy& energy) {
    most = std::max(most, std::abs(energy[EnergyTerm::support]));
    out.worst_residual = std::max(out.worst_residual, std::abs(energy.balance()));
    out.plastic = energy[EnergyTerm::plastic];
  };
  sim.run(stage, listener);
  out.worst_residual /= most;
  out.hinge = member_hinges(sim.model(), sim.state(), 0).at(0);
  return out;
}

TEST_CASE(
    "a column yields at its foot: no moment beyond its own, the same energy in the energy balance and in the hinge") {
  for (const double damping : {0.0, 2e-3}) {
    const Shaken explicit_run = shake(plain_hinge(), damping, std::nullopt);
    const Shaken implicit_run = shake(plain_hinge(), damping, AlphaMethod::hht(0));
    for (const Shaken* run : {&explicit_run, &implicit_run}) {
      CHECK(run->moment <= yield_moment * (1 + 1e-9));
      CHECK(near(run->moment, yield_moment, 1e-6));
      CHECK(run->worst_residual < 2e-3);
      CHECK(near(run->plastic, run->hinge.dissipated, 1e-9));
      CHECK(run->plastic > 1e3);
      CHECK(run->hinge.status == HingeStatus::yielded);
      REQUIRE(!run->events.empty());
      CHECK(run->events[0].type != EventType::member_failed);
    }
    CHECK(near(implicit_run.drift, explicit_run.drift, 0.01));
    CHECK(near(implicit_run.plastic, explicit_run.plastic, 0.02));
    MESSAGE("drift " << explicit_run.drift << " and " << implicit_run.drift << " m, given off " << explicit_run.plastic
                     << " and " << implicit_run.plastic << " J, ledger " << explicit_run.worst_residual << " and "
                     << implicit_run.worst_residual);
  }
}

TEST_CASE("a hinge yields and is lost once each, in that order, and carries nothing from then on") {
  HingeLaw law = plain_hinge();
  law.ultimate = 0.01;
  const Shaken run = shake(law, 0, std::nullopt);
  std::vector<EventType> order;
  for (const Event& e : run.events)
    if (e.type == EventType::member_yielded || e.type == EventType::member_failed) order.push_back(e.type);
  CHECK(order == std::vector{EventType::member_yielded, EventType::member_failed});
  CHECK(run.hinge.status == HingeStatus::lost);
  CHECK(std::abs(run.hinge.moment) < 1e-12 * yield_moment);
  for (const Event& e : run.events) {
    if (e.type == EventType::member_yielded) {
      CHECK(near(e.value, yield_moment, 1e-9));
      CHECK(e.text == "at foot");
      CHECK(std::abs(e.y) < 1e-9);
    }
    if (e.type == EventType::member_failed) CHECK(e.value >= law.ultimate);
  }
  CHECK(run.worst_residual < 2e-3);
}

TEST_CASE("hinges and fibres that never yield are the elastic member") {
  const auto run = [](const decltype(FrameMember::yields)& yields, std::array<bool, 2> pinned, bool shear) {
    BodySpec spec = beam_body("beam", {0, 0}, {3, 1}, rectangle_section(0.2, 0.5), "concrete", 3);
    FrameMember& member = spec.frame->members[0];
    member.yields = yields, member.pinned = pinned, member.shear = shear;
    spec.frame->joints[0].support = held;
    Model<2> model = of_frames(elastic_material("concrete", 2400, 30e9, 0.2), {spec});
    add_load(model, "beam", {3, 1}, {2e5, -4e5});
    Simulation<2> sim(std::move(model));
    StageOptions stage;
    stage.duration = 0.05, stage.dt = 5e-6;
    sim.run(stage);
    return sim.state().position[1];
  };
  const MemberHinges strong{{plain_hinge(1e12), plain_hinge(1e12)}};
  const MemberFibres fibres{{RectangleSection{0.2, 0.5}, UniaxialElastic{30e9}}};
  for (const bool shear : {false, true})
    for (const auto pinned : {std::array{false, false}, std::array{false, true}}) {
      const Vec2 elastic = run({}, pinned, shear);
      CHECK((run(fibres, pinned, shear) - elastic).norm() < 1e-9 * elastic.norm());
      if (!pinned[1]) CHECK((run(strong, pinned, shear) - elastic).norm() < 1e-9 * elastic.norm());
    }
}

TEST_CASE("F9: a steel member of 40 fibres bends under an even moment as its section does, and comes back straight") {
  const double young = 2.1e11, first = 160e3, curvature = 240e6 / young / 0.1;
  BilinearSteel steel;
  steel.young = young, steel.yield = 240e6;
  BodySpec spec = beam_body("beam", {0, 0}, {2, 0}, rectangle_section(0.1, 0.2), "steel", 2);
  spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = 100, spec.frame->joints[1].inertia = 10;
  FibreSpec fibres{RectangleSection{0.1, 0.2}, steel};
  fibres.layers = 40;
  spec.frame->members[0].yields = MemberFibres{fibres};
  Model<2> model = of_frames(elastic_material("steel", 7850, young), {spec});
  add_load(model, "beam", {2, 0}, {0, 0}, -first);
  for (const auto& [turned, moment] : {std::pair(1.5, 1.27778), {2.0, 1.375}, {3.0, 1.44444}}) {
    State<2> state = initial_state(model);
    const auto led_to = [&](double from, double to) {
      LoadPathOptions path;
      path.control = PathControl::load, path.begin = from, path.to = to;
      path.first = to > from ? 0.02 : -0.1, path.longest = 0.1;
      CHECK(follow_loads(model, state, path).end == PathEnd::arrived);
      return -state.rotation[1] / 2 / curvature;
    };
    const double under = led_to(0, moment);
    MESSAGE("F9: " << under << " for " << turned);
    CHECK(near(under, turned, 0.005));
    CHECK(near(led_to(moment, 0), turned - moment, 0.02));
  }
}

TEST_CASE("a state within yielding continues with the same bits, explicit and implicit") {
  HingeLaw law = plain_hinge();
  law.hardening = 1e5, law.capping = 0.01, law.softening = 0.05, law.wear = 1;
  for (const bool is_implicit : {false, true}) {
    StageOptions stage;
    stage.duration = 1.5;
    if (is_implicit) stage = adaptive_stage(AlphaMethod::hht(-0.05), 1.5, 0.01);
    Simulation<2> once(shaken_column(law, 0));
    std::vector<std::uint64_t> kept;
    RunListener<2> listener;
    listener.on_step = [&](const Instant<2>& now) {
      if (kept.empty() && now.state.time > 0.9) kept = state_words(now.state);
    };
    once.run(stage, listener);
    Simulation on(once.model(), state_from_words(once.model(), kept, "state"));
    CHECK(member_hinges(on.model(), on.state(), 0).at(0).status == HingeStatus::yielded);
    stage.end_time = once.state().time;
    on.run(stage);
    CHECK(state_hash(on.state()) == state_hash(once.state()));
  }
}

TEST_CASE("a member with impossible hinges is rejected with its name") {
  const auto made = [](const decltype(FrameMember::yields)& yields, bool pinned) {
    BodySpec spec = beam_body("beam", {0, 0}, {3, 1}, rectangle_section(0.2, 0.5), "concrete", 3);
    spec.frame->members[0].yields = yields, spec.frame->members[0].pinned[0] = pinned;
    return of_frames(elastic_material("concrete", 2400, 30e9, 0.2, 0), {spec});
  };
  HingeLaw snap = plain_hinge();
  snap.capping = 0.01, snap.softening = 1e-6;
  CHECK_THROWS_WITH_AS(made(MemberHinges{{plain_hinge(), {}}}, true), doctest::Contains("its start is pinned"),
                       InputError);
  CHECK_THROWS_WITH_AS(made(MemberHinges{{snap, {}}}, false), doctest::Contains("softens by"), InputError);
  CHECK_THROWS_WITH_AS(made(MemberHinges{{HingeLaw{}, {}}}, false), doctest::Contains("member 'beam'"), InputError);
  MemberFibres few{{RectangleSection{0.2, 0.5}, UniaxialElastic{30e9}}};
  few.stations = 2;
  CHECK_THROWS_WITH_AS(made(few, false), doctest::Contains("2 stations along a beam"), InputError);
}

}  // namespace
}  // namespace trilith::testing
