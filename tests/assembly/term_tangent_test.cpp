// The term-wise tangent stiffness against differences of all forces: every law of the lists, in every branch; complete
// structures during collapse; follower loads.
#include "assembly/tangent/fd_tangent.hpp"

#include "assembly/compared_tangents.hpp"
#include "assembly/start.hpp"
#include "assembly/tangent/tangent.hpp"
#include "contact/contact_samples.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "integrate/implicit/implicit_step.hpp"
#include "law/bearing/direction_samples.hpp"
#include "model/loads.hpp"
#include "physics/collapses.hpp"
#include "physics/members/frames.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

/// worst_difference() of the two tangents at a state.
double worst_entry(const Model<2>& model, State<2> state, double dt, double rate, double disturbance = 1.5e-9) {
  Work<2> work;
  evaluate(model, state, work, dt);
  Tangent<2> tangent;
  tangent.shape(model, work);
  const TangentOptions options{dt, rate, 1, 0, disturbance};
  const std::uint64_t before = state_hash(state);
  tangent.assemble(model, state, work, options);
  CHECK(state_hash(state) == before);
  const Eigen::MatrixXd terms(tangent.matrix());
  tangent.assemble_by_differences(model, state, work, options);
  const Eigen::MatrixXd all(tangent.matrix());
  return worst_difference(terms, all);
}

/// Position of the upper block relative to the lower one, at the start and at the end of a step.
struct JointCase {
  const char* name;
  double gap, tilt, slip;  ///< [m], [rad], [m]
};

/// Two stacked free blocks of 1 m x 0.5 m.
struct TwoBlocks {
  Model<2> model;
  State<2> state;

  explicit TwoBlocks(const ContactLaw& law, bool deform) {
    Scene scene(law);
    scene.builder.add_material(elastic("soft", 2000, 1e9, 0.2, Plane::stress, ElementForm::assumed, 1e-4));
    for (const int i : {0, 1}) {
      const double y = 0.5 * i, out = 0.01 * i;
      BodySpec spec = grid_body(i == 0 ? "low" : "up", rectangle({out, y}, {1 + out, y + 0.5}), "soft", 1, 1);
      if (!deform) spec.kind = BodyKind::rigid;
      scene.add(spec);
    }
    model = scene.builder.build();
    state = initial_state(model);
    step_to({"", 0, 0, 0}, 0);
    Work<2> work;
    evaluate(model, state, work, state.last_dt);
    begin_implicit(model, state, work);
  }
  /// Moves the upper block there within a step of length `dt`, which is not committed.
  void step_to(const JointCase& at, double dt) {
    state.position_before = state.position, state.rotation_before = state.rotation;
    const Body& up = model.bodies[1];
    const Vec2 corner(0.01, 0.5), where = corner + Vec2(at.slip, at.gap);
    for (int n = up.first_node; n < up.first_node + up.nodes; ++n) {
      state.position[n] = where + Turn(at.tilt).apply(Vec2(model.start_position[n] - corner));
      state.velocity[n] = {0.02 + 0.01 * n, -0.03}, state.spin[n] = 0.05;
      if (up.is_rigid()) state.rotation[n] = at.tilt;
    }
    state.last_dt = dt, state.time += dt;
  }
  void commit_here() {
    Work<2> work;
    evaluate(model, state, work, state.last_dt);
    commit(model, state, work);
  }
};

/// Each case follows the ones before it, so that there is a history of slip, softening and crushing.
constexpr std::array joint_cases{JointCase{"pressed", -2.3e-5, 1e-6, 0},
                                 JointCase{"sticks", -2.3e-5, 1e-6, 1.1e-6},
                                 JointCase{"pulled", 2.1e-5, 3e-6, 1e-6},
                                 JointCase{"pulled beyond its strength", 1.7e-4, 4e-6, 1e-6},
                                 JointCase{"back", -1.7e-5, 2e-6, 3e-6},
                                 JointCase{"slides", -3.1e-5, 1e-6, 9e-4},
                                 JointCase{"slides back", -3.1e-5, 1e-6, 4e-4},
                                 JointCase{"opens in part", -4.3e-5, 1.3e-4, 4.02e-4},
                                 JointCase{"opens in part at the other end", 7.1e-5, -1.3e-4, 4.02e-4},
                                 JointCase{"crushes", -3.7e-4, 2e-5, 4.1e-4},
                                 JointCase{"crushed, less", -2.9e-4, 3e-5, 4.2e-4},
                                 JointCase{"stands on a corner", -1.9e-4, 0.9, 4e-4},
                                 JointCase{"rolls on it", -2.7e-4, 0.905, 1.4e-3},
                                 JointCase{"deep", -0.02, 0.31, 0.01}};

TEST_CASE("the tangent of a single contact matches the full tangent: all laws, branches and kinds of bodies") {
  for (const ContactSample& sample : contact_samples())
    for (const bool deform : {false, true}) {
      TwoBlocks blocks(sample.law, deform);
      for (const JointCase& at : joint_cases) {
        INFO(sample.name, ", ", std::string(at.name), deform ? ", quads" : ", rigid");
        blocks.step_to(at, 1e-3);
        CHECK(worst_entry(blocks.model, blocks.state, 1e-3, 2e3) < 1e-6);
        blocks.commit_here();
      }
    }
}

/// Two rigid blocks with a compressed bearing between them.
struct TwoOnBearing {
  Model<2> model;
  State<2> state;

  TwoOnBearing(const DirectionLaw& law, int direction) {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.builder.set_contact("*", "*", "none");
    for (const int i : {0, 1}) {
      BodySpec spec;
      spec.name = i == 0 ? "low" : "up", spec.outline = box(-1, 2.0 * i, 1, 2.0 * i + 1), spec.floating = true;
      scene.add(spec);
    }
    BearingSpec link;
    link.name = "link", link.body_a = "low", link.body_b = "up", link.point_a = {0.3, 1}, link.point_b = {0.3, 2};
    link.law[axial] = Linear{1e6, 0}, link.law[along] = Linear{1e5, 0};
    link.law[direction] = Linear{1e5, 0};
    scene.builder.add_bearing(link);
    model = scene.builder.build();
    model.bearings[0].law[direction] = law;  // builders reject laws that slide along the axis
    state = initial_state(model);
    Work<2> work;
    evaluate(model, state, work, 0);
    begin_implicit(model, state, work);
  }
  /// A step of `dt` along a path that reverses; not committed.
  void step(int i, double dt) {
    const double phase = 0.7 * i, way = 0.02 + 0.01 * i;
    state.position_before = state.position, state.rotation_before = state.rotation;
    state.position[0] = model.start_position[0] + Vec2(0.003, 0.001 * i), state.rotation[0] = 0.01 * i;
    const Vec2 moved(way * std::sin(phase), -0.01 + 0.008 * std::sin(2.3 * phase));
    state.position[1] = model.start_position[1] + moved;
    state.rotation[1] = 0.01 * i + 0.03 * std::sin(1.7 * phase);
    state.velocity[0] = {0.05, 0.02}, state.spin[0] = 0.3;
    state.velocity[1] = (moved + Vec2(0.1, 0)) * 1.3, state.spin[1] = -0.2;
    state.last_dt = dt, state.time += dt;
  }
};

TEST_CASE("the tangent of a single bearing matches the full tangent: all laws in all directions") {
  for (const DirectionSample& sample : direction_samples(2e3))
    for (int at = 0; at < 6; ++at) {
      const int direction = at % 3;
      TwoOnBearing pair(sample.law, direction);
      if (at >= 3)
        pair.state.bearing[0].begun_at = {0.004, 0.003, -0.01};  // as after a switch to a successor law at
                                                                 // this displacement
      for (int i = 1; i < 12; ++i) {
        INFO(sample.name, ", direction ", direction, at >= 3 ? ", from where it took over" : "", ", step ", i);
        pair.step(i, 0.01);
        CHECK(worst_entry(pair.model, pair.state, 0.01, 200) < 1e-6);
        Work<2> work;
        evaluate(pair.model, pair.state, work, 0.01);
        commit(pair.model, pair.state, work);
      }
    }
}

TEST_CASE("the tangent of a collapsing structure matches finite differences of all forces") {
  for (const Collapse& c : collapses()) {
    const Model<2> model = c.model();
    State<2> state = start_state(model);
    Work<2> work;
    for (int next = 1; next <= 7; ++next) {
      while (state.time < c.duration * next / 7) {
        evaluate(model, state, work, state.last_dt);
        if (state.step % 32 == 0) state.dt = settled_step(stable_step(model, state, work).dt, 0.5);
        commit(model, state, work);
        advance(model, state, work, {state.dt, {}});
      }
      INFO(c.name, " at ", state.time, " s");
      // Tangents belong to implicit steps; in explicit steps points move along chords of the rotation. At an instant at
      // which a contact changes its kernel there is no tangent to compare: forces jump by the kernels' rounding.
      State<2> now = state;
      begin_implicit(model, now, work);
      // Positions at metres from the origin have fewer digits: noise grows as the disturbance falls, to 1e-8 for most
      // of them.
      CHECK(worst_entry(model, now, now.last_dt, 1 / now.last_dt, 6e-9) < 1e-6);
    }
  }
}

TEST_CASE("the tangent of a beam on a bed, on bearings and next to a block matches the full tangent") {
  Scene scene(Frictional{1e8, 5e7, 0.4, 1e-4});
  scene.builder.add_material(elastic_material("concrete", 2400, 30e9, 0.2, 1e-4));
  scene.builder.overlap_allowed = 1e-3;
  scene.fixed("bed", box(-1, -1, 5, 0));
  scene.block("block", box(0.3, 0.2998, 1.3, 0.8), 900);
  scene.builder.add_body(beam_body("beam", {0, 0.15}, {4, 0.15}, rectangle_section(0.3, 0.3), "concrete", 6));
  BearingSpec link;
  link.name = "link", link.body_a = "beam", link.body_b = "block", link.point_a = {1.9, 0.3}, link.point_b = {1.3, 0.5};
  link.law[axial] = Linear{1e6, 1e3}, link.law[along] = Friction{0.3, 1e6, 0}, link.law[turning] = Linear{1e5, 10};
  scene.builder.add_bearing(link);
  const Model<2> model = scene.builder.build();
  State<2> state = initial_state(model);
  for (int n = 1; n < model.nodes(); ++n) {
    state.position[n] += 1e-4 * Vec2(std::sin(n + 1.0), -1 + 0.5 * std::cos(3 * n + 1.0));
    state.rotation[n] += 1e-4 * std::sin(2.0 * n), state.velocity[n] += Vec2(0.02 * n, -0.03), state.spin[n] = 0.01 * n;
  }
  CHECK(worst_entry(model, state, 1e-3, 10) < 1e-6);
}

TEST_CASE("the tangent of follower loads matches the full tangent: at points and on faces of all kinds of bodies") {
  for (const int kind : {0, 1, 2}) {
    Scene scene(Frictional{1e6, 1e6, 0.5, 0});
    scene.builder.add_material(elastic("soft", 2000, 1e9, 0.2, Plane::stress, ElementForm::assumed, 1e-4));
    BodySpec spec = grid_body("body", rectangle({0, 0}, {2, 1}), "soft", kind == 2 ? 3 : 1, kind == 2 ? 2 : 1);
    if (kind == 0) spec.kind = BodyKind::rigid;
    scene.add(spec);
    Model<2> model = scene.builder.build();
    PressureSpec pressure;
    pressure.name = "pressure", pressure.value = 3e6;
    loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, outline_faces(model, 0), pressure);
    PointLoadSpec load;
    load.name = "load", load.at = Vec2(1.7, 0.8), load.force = {2e6, -1e6}, load.moment = 4e5, load.follows = true;
    loads_of<PointLoad<2>>(model) = make_point_load(model, 0, load);
    State<2> state = initial_state(model);
    for (int n = 0; n < model.nodes(); ++n) {
      state.position[n] += 3e-3 * Vec2(std::sin(n + 1.0), std::cos(3 * n + 1.0));
      if (kind == 0) state.rotation[n] = 0.4;
    }
    CHECK(worst_entry(model, state, 1e-3, 10) < 1e-6);
  }
}

}  // namespace
}  // namespace trilith::testing
