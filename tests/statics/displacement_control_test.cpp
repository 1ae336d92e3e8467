#include "statics/displacement_control.hpp"

#include <memory>

#include "assembly/evaluate.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "load/ramp.hpp"
#include "model/pose.hpp"
#include "model/pushes.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/space/solid_bodies.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// A post and a steel deck pinned to its top, moved and rotated so that the pin is open.
struct PinnedDeck {
  Model<2> model;
  State<2> state;
  Vec2 at{0.02, 3.2};  // on top of the deck, over the pin

  PinnedDeck() {
    BodySpec spec;
    spec.name = "bent", spec.kind = BodyKind::frame, spec.material = "steel", spec.floating = true;
    FrameSpec frame;
    frame.joints = {{.name = "foot"}, {.name = "top", .place = {0, 3}}, {.name = "end", .place = {4, 3}}};
    FrameMember post, deck;
    post.name = "post", post.from = 0, post.to = 1, post.section = rectangle_section(0.3, 0.3), post.divisions = 2;
    deck.name = "deck", deck.from = 1, deck.to = 2, deck.section = rectangle_section(0.3, 0.4), deck.divisions = 2;
    deck.pinned = {true, false};
    frame.members = {post, deck};
    spec.frame = frame;
    model = of_frames(elastic_material("steel", 7850, 2.1e11), {spec});
    state = initial_state(model);
    for (int n = 0; n < model.nodes(); ++n) {
      state.rotation[n] = 0.02 * (n + 1) * (n % 2 == 0 ? 1 : -1);
      state.position[n] += Vec2(1e-3 * n, -2e-3 * n);
      state.velocity[n] = {0.1 * n, 0.2}, state.spin[n] = 0.3 - 0.2 * n;
    }
  }
};

}  // namespace

TEST_CASE("a push at the pinned end of a member acts as a force does on that point") {
  PinnedDeck s;
  const Vec2 way = Vec2(1, 0.5).normalized();
  const auto motion = std::make_shared<GroundMotion>(even_motion(0.1, 1));
  add_push(s.model, s.state, "push", push_rows(s.model, {0}, s.at, PushPattern::mass, way), way, motion);
  Work<2> work;
  StepOptions options;
  options.dt = 1e-6;
  evaluate(s.model, s.state, work, options.dt);
  std::vector<Vec2> force = work.load;
  std::vector<double> moment = work.load_moment;
  control_displacement(s.model, s.state, work, options);
  const Attachment<2> attachment = tie_point(s.model, 0, s.at, "test");
  CHECK(attachment.turn[0] != attachment.node[0]);
  apply_force(s.model, s.state, attachment, work.push_force[0] * way, 0, force, moment);
  const double size = std::abs(work.push_force[0]);
  CHECK(size > 0);
  for (int n = 0; n < s.model.nodes(); ++n) {
    CHECK(near_zero((work.load[n] - force[n]).norm(), 1e-12 * size));
    CHECK(near_zero(work.load_moment[n] - moment[n], 1e-12 * size));
  }
}

TEST_CASE("a pushed point at a pinned end moves by the prescribed displacement") {
  PinnedDeck s;
  const auto motion = std::make_shared<GroundMotion>(even_motion(0.1, 1));
  add_push(s.model, s.state, "push", push_rows(s.model, {0}, s.at, PushPattern::mass, Vec2::UnitX()), Vec2::UnitX(),
           motion);
  const Push<2>& push = s.model.pushes[0];
  Work<2> work;
  StepOptions options;
  options.dt = 1e-6;
  for (int i = 0; i < 3; ++i) {
    evaluate(s.model, s.state, work, options.dt);
    control_displacement(s.model, s.state, work, options);
    advance(s.model, s.state, work, options);
    // Arms rotate within a step, an error of second order.
    CHECK(near_zero(push_place(s.state, push) - push.origin - motion->displacement(s.state.time), 1e-11));
  }
}

namespace {

/// A stone in space, rotated, moving and spinning, that is pushed at a point off its centroid.
struct SpinningStone {
  Model<3> model;
  State<3> state;
  Vec3 way = Vec3(1, 0.5, -0.3).normalized();

  explicit SpinningStone(bool held = false) {
    SpaceBuilder builder;
    builder.gravity({0, 0, -standard_gravity});
    SolidBody body = stone("stone", box_at({0.4, 0.6, 1.0}, {0.1, 0.2, 3}, rotation_by({0.3, -0.5, 0.8})));
    body.velocity = {0.2, -0.1, 0.3}, body.spin = {0.4, 1.1, -0.7};
    builder.add(body);
    model = builder.build();
    if (held) {
      model.support[0][3] = Support::fixed;
      model.start_spin[0].x() = 0;
    }
    state = initial_state(model);
  }
};

}  // namespace

TEST_CASE(
    "a pushed point of a stone in space moves by the prescribed displacement, free to rotate or held about an axis") {
  for (const bool held : {false, true}) {
    SpinningStone s(held);
    const auto motion = std::make_shared<GroundMotion>(even_motion(0.1, 1));
    const Vec3 at(0.2, 0.35, 3.4);
    add_push(s.model, s.state, "push", push_rows(s.model, {0}, at, PushPattern::mass, s.way), s.way, motion);
    const Push<3>& push = s.model.pushes[0];
    Work<3> work;
    StepOptions options;
    options.dt = 1e-6;
    for (int i = 0; i < 4; ++i) {
      evaluate(s.model, s.state, work, options.dt);
      control_displacement(s.model, s.state, work, options);
      advance(s.model, s.state, work, options);
      // Arms rotate within a step, an error of second order.
      CHECK(near_zero(push_place(s.state, push) - push.origin - motion->displacement(s.state.time), 1e-11));
    }
    CHECK(std::abs(work.push_force[0]) > 0);
  }
}

TEST_CASE("a push in space acts as a force does on its point, by the constraint's closed form") {
  // From rest to unit speed within the first step, which acts over half of it: lambda = v / (dt/2 (1/m + l J^-1 l)).
  SpinningStone s;
  s.state.velocity[0].setZero(), s.state.spin[0].setZero();
  s.model.gravity.field.setZero();
  const Vec3 at(0.2, 0.35, 3.4);
  const auto motion = std::make_shared<GroundMotion>(even_motion(0.1, 1));
  add_push(s.model, s.state, "push", push_rows(s.model, {0}, at, PushPattern::mass, s.way), s.way, motion);
  Work<3> work;
  StepOptions options;
  options.dt = 1e-3;  // long enough for the floating-point resolution of positions
  evaluate(s.model, s.state, work, 0);
  control_displacement(s.model, s.state, work, options);
  const Vec3 lever = cross(Vec3(at - s.state.position[0]), s.way);
  const double gives = 1 / s.model.mass[0] + lever.dot(spin_of(s.model.inertia[0], s.state.rotation[0], lever));
  const double wanted = motion->displacement(options.dt) / options.dt;
  CHECK(near(work.push_force[0], wanted / (0.5 * options.dt * gives), 1e-8));
  CHECK(near_zero((work.force[0] - work.push_force[0] * s.way).norm(), 1e-9 * work.push_force[0]));
  CHECK(near_zero((work.moment[0] - work.push_force[0] * lever).norm(), 1e-9 * work.push_force[0]));
}
