// A beam whose hinge has lost its moment is removed: its stored energy is dissipated, its mass stays, the rest carries
// on.
#include "assembly/start.hpp"
#include "base/error.hpp"
#include "near.hpp"
#include "physics/members/implicit.hpp"
#include "physics/members/yielding.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

constexpr double young = 2.1e11, height = 4, side = 1.2e5;
constexpr double bending = young * 0.1 * 0.2 * 0.2 * 0.2 / 12;

/// Two columns under a cap that is pinned to the left one. Each is a cantilever; the left one has a hinge at its foot
/// with an ultimate rotation of 0.004 rad. A force acts at the head of the right one, constant or growing over 2 s.
Model<2> two_columns(bool removes, bool grows) {
  HingeLaw law = plain_hinge();
  law.ultimate = 0.004, law.removes = removes;
  BodySpec spec;
  spec.name = "bent", spec.kind = BodyKind::frame, spec.material = "steel", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}, .support = held},
                  {.name = "b", .place = {0, height}},
                  {.name = "c", .place = {3, height}},
                  {.name = "d", .place = {3, 0}, .support = held}};
  const auto add = [&](const char* name, int from, int to) -> FrameMember& {
    FrameMember member;
    member.name = name, member.from = from, member.to = to, member.divisions = 1;
    member.section = rectangle_section(0.1, 0.2);
    frame.members.push_back(member);
    return frame.members.back();
  };
  add("left", 0, 1).yields = MemberHinges{{law, std::nullopt}};
  add("cap", 1, 2).pinned = {true, false};
  add("right", 3, 2);
  spec.frame = frame;
  Model<2> model = of_frames(elastic_material("steel", 7850, young), {spec});
  add_load(model, "bent", {3, height}, {side, 0}, 0, grows ? LoadCurve{{0, 2}, {0, 1}} : LoadCurve{});
  model.mass_damping = 8;
  return model;
}

struct Ended {
  double drift = 0, plastic = 0, residual = 0, mass = 0;
  std::vector<Event> events;
  double left_moment = 0, left_normal = 0;
  HingeStatus status{};
};

Ended end_of(const Model<2>& model, const State<2>& state, std::vector<Event> events) {
  Ended out;
  out.drift = state.position[2].x() - 3;
  for (const double m : model.mass) out.mass += m;
  for (Event& e : events)
    if (e.type == EventType::member_yielded || e.type == EventType::member_failed ||
        e.type == EventType::member_removed)
      out.events.push_back(std::move(e));
  const std::vector<SectionForces> forces = member_forces(model, state, 0);
  out.left_moment = forces[0].moment, out.left_normal = forces[0].normal;
  out.status = member_hinges(model, state, 0).at(0).status;
  return out;
}

Ended run(bool removes, const std::optional<AlphaMethod>& scheme) {
  Simulation<2> sim(two_columns(removes, true));
  StageOptions o;
  o.duration = 5;
  if (scheme) o = adaptive_stage(*scheme, 5, 0.01);
  std::vector<Event> events;
  RunListener<2> listener;
  listener.on_event = [&](const Event& e, const Instant<2>&) { events.push_back(e); };
  double most = 0;
  Ended worst;
  listener.on_step = [&](const Instant<2>&) {
    const Energy e = sim.energy();
    worst.residual = std::max(worst.residual, std::abs(e.balance())), most = std::max(most, e[EnergyTerm::load]);
  };
  sim.run(o, listener);
  Ended out = end_of(sim.model(), sim.state(), events);
  out.residual = worst.residual / most;
  sim.refresh();
  out.plastic = sim.energy()[EnergyTerm::plastic];
  return out;
}

}  // namespace

TEST_CASE("a removed member: the other column carries all, by statics, implicit and explicit steps the same way") {
  const double alone = side * height * height * height / (3 * bending);  // of a single cantilever
  Model<2> model = two_columns(true, false);
  State<2> state = start_state(model);
  EquilibriumOptions options;
  options.shares = 40;
  const Equilibrium found = find_equilibrium(model, state, options);
  REQUIRE(found.converged);
  const Ended by_statics = end_of(model, state, found.events);
  const Ended by_explicit = run(true, std::nullopt), by_implicit = run(true, AlphaMethod::from_radius(0.8));
  for (const Ended* e : {&by_statics, &by_explicit, &by_implicit}) {
    REQUIRE(e->events.size() == 3);
    CHECK(e->events[0].type == EventType::member_yielded);
    CHECK(e->events[1].type == EventType::member_failed);
    CHECK(e->events[2].type == EventType::member_removed);
    CHECK(e->events[2].text == "left at a");
    CHECK(e->status == HingeStatus::removed);
    CHECK(e->left_moment == 0);
    CHECK(e->left_normal == 0);
    CHECK(near(e->drift, alone, 0.01));
    CHECK(near(e->drift, by_statics.drift, 1e-3));
    CHECK(near(e->mass, by_statics.mass, 1e-15));
    // The released energy is the bending energy at the yield moment: M^2 h / (6 EI).
    CHECK(near(e->events[2].value, yield_moment * yield_moment * height / (6 * bending), 0.02));
  }
  CHECK(by_explicit.residual < 2e-3);
  CHECK(by_implicit.residual < 5e-3);
  CHECK(near(by_implicit.plastic, by_explicit.plastic, 0.02));
  // Plastic work up to 0.004 rad plus the stored elastic energy.
  CHECK(near(by_explicit.plastic, yield_moment * 0.004 + yield_moment * yield_moment * height / (6 * bending), 0.03));
  MESSAGE("drift " << by_statics.drift << " " << by_explicit.drift << " " << by_implicit.drift << ", alone " << alone
                   << "; let go " << by_explicit.events[2].value << " J, plastic " << by_explicit.plastic << " "
                   << by_implicit.plastic << ", ledger " << by_explicit.residual << " " << by_implicit.residual);
}

TEST_CASE("a hinge that becomes pinned loses only its moment") {
  const Ended pinned = run(false, std::nullopt);
  CHECK(pinned.events.size() == 2);
  CHECK(pinned.status == HingeStatus::lost);
  CHECK(near_zero(pinned.left_moment, 1e-6 * yield_moment));
}

TEST_CASE("a hinge that never loses its moment cannot remove a member") {
  HingeLaw law = plain_hinge();
  law.removes = true;
  CHECK_THROWS_WITH_AS(law.check(), doctest::Contains("never loses its moment"), InputError);
  law.capping = 0.01, law.softening = 0.02;
  law.check();
  law.residual = 0.2;
  CHECK_THROWS_AS(law.check(), InputError);
}

}  // namespace trilith::testing
