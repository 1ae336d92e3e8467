// Limit loads and critical loads of frames: snap-through, Lee's frame, columns and portals.
#include "model/pose.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("F14: a truss of two pinned bars snaps through at its limit load") {
  BodySpec spec;
  spec.name = "truss", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {-10, 0}, .support = held},
                  {.name = "b", .place = {0, 0.5}, .support = {Support::fixed, Support::fixed, Support::fixed}},
                  {.name = "c", .place = {10, 0}, .support = held}};
  FrameMember bar;
  bar.section = given_section(1e-3, 1e-9, 0.01), bar.divisions = 2, bar.pinned = {true, true};
  bar.from = 0, bar.to = 1, frame.members.push_back(bar);
  bar.from = 1, bar.to = 2, frame.members.push_back(bar);
  spec.frame = frame;
  const Model<2> model = of_frames(elastic_material("m", 1000, 1e9), {spec});
  State<2> state = initial_state(model);
  double most = 0, at = 0;
  for (double drop = 0; drop < 0.4; drop += 1e-5) {
    state.position[1].y() = 0.5 - drop;
    for (const int n : {3, 4}) state.position[n] = 0.5 * (state.position[n == 3 ? 0 : 2] + state.position[1]);
    const double turn = std::atan2(state.position[1].y(), 10) - std::atan2(0.5, 10);
    state.rotation[3] = turn, state.rotation[4] = -turn;
    const double force = forces_at(model, state)[1][1];
    if (force > most) most = force, at = drop;
  }
  CHECK(near(most, 47.9925, 1e-3));
  CHECK(near(at, .211445, 1e-3));
}

/// Force that holds the apex of half a toggle at `drop` [m], clamped at its foot and guided at its apex: twice the
/// force of the half [N].
double toggle_force(const Model<2>& model, State<2>& state, double rise, double drop) {
  state.position[1].y() = rise - drop;
  state = balance(model, state, no_load(model));
  return 2 * forces_at(model, state)[1][1];
}

TEST_CASE("F2, F3: toggles snap through at their limit loads") {
  struct Row {
    double span, rise, width, depth, young, force, drop, low, low_drop, low_allowed;
  };
  for (const Row& r : {Row{.3287522, .0098044, .0191262, .0061722, 71.016e9, 150.66, 5.910e-3, 139.15, 9.934e-3, .005},
                       Row{.5, .03, .02, .01, 210e9, 3404.0, 10.964e-3, 196.6, 35.452e-3, .02}}) {
    BodySpec spec = beam_body("half", {0, 0}, {r.span, r.rise}, rectangle_section(r.width, r.depth), "m", 10);
    spec.frame->joints[0].support = spec.frame->joints[1].support = held;
    const Model<2> model = of_frames(elastic_material("m", 2700, r.young), {spec});
    State<2> state = initial_state(model);
    double most = 0, most_at = 0, least = 1e9, least_at = 0, before = 0;
    bool over = false;
    for (double drop = r.drop / 100; drop < 1.3 * r.low_drop; drop += r.drop / 100) {
      const double force = toggle_force(model, state, r.rise, drop);
      over = over || force < before;
      if (!over && force > most) most = force, most_at = drop;
      if (over && force < least) least = force, least_at = drop;
      before = force;
    }
    CHECK(near(most, r.force, 0.005));
    CHECK(near(most_at, r.drop, 0.02));
    CHECK(near(least, r.low, r.low_allowed));
    CHECK(near(least_at, r.low_drop, 0.02));
  }
}

TEST_CASE("F4: Lee's frame reaches its first limit load") {
  // Displacement control follows the path up to the point where the displacement turns back; beyond it arc length is
  // needed.
  BodySpec spec;
  spec.name = "lee", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}, .support = hinged},
                  {.name = "b", .place = {0, 1.2}},
                  {.name = "c", .place = {1.2, 1.2}, .support = hinged}};
  FrameMember m;
  m.section = rectangle_section(0.03, 0.02), m.divisions = 10;
  for (const int i : {0, 1}) m.from = i, m.to = i + 1, frame.members.push_back(m);
  spec.frame = frame;
  spec.supports = {{{0.24, 1.2}, {0.24, 1.2}, {Support::free, Support::fixed}}};
  const Model<2> model = of_frames(elastic_material("m", 2700, 70.608e9), {spec});
  const int loaded = 3 + 9 + 1;  // joints, the nodes within the column, the second within the beam
  REQUIRE((model.start_position[loaded] - Vec2(0.24, 1.2)).norm() < 1e-12);
  State<2> state = initial_state(model);
  double most = 0, at = 0;
  for (double drop = 0.001; drop < 0.4876; drop += 0.001) {
    state.position[loaded].y() = 1.2 - drop;
    state = balance(model, state, no_load(model));
    const double force = forces_at(model, state)[loaded][1];
    if (force > most) most = force, at = drop;
  }
  CHECK(near(most, 18198, 0.005));
  CHECK(near(at, 0.4873, 0.01));
}

TEST_CASE("F6, F7: columns and portals lose their stiffness at their critical loads") {
  // The tangent stiffness, with its geometric part, becomes singular: its lowest eigenvalue changes sign between 0.995
  // and 1.005 of the critical load. The columns shorten first, so the load is read from the state and not from a
  // formula.
  const auto lowest = [](const Model<2>& model, const std::vector<NodeDofs>& load) {
    const State<2> state = balance(model, initial_state(model), load);
    const Eigen::MatrixXd k = stiffness_at(model, state).matrix;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (k + k.transpose())).eigenvalues()[0];
  };
  struct Column {
    std::array<Support, 3> foot, head;
    double load;
  };
  const std::array guided{Support::fixed, Support::free, Support::fixed},
      rolling{Support::fixed, Support::free, Support::free};
  for (const Column& c : {Column{held, {}, 29986}, Column{hinged, rolling, 119943}, Column{held, rolling, 245373},
                          Column{held, guided, 479772}}) {
    BodySpec spec = beam_body("column", {0, 0}, {0, 3}, rectangle_section(0.05, 0.05), "m", 12);
    spec.frame->joints[0].support = c.foot, spec.frame->joints[1].support = c.head;
    const Model<2> model = of_frames(elastic_material("m", 7850, 2.1e11), {spec});
    for (const double part : {0.995, 1.005}) {
      std::vector<NodeDofs> load = no_load(model);
      load[1][1] = -part * c.load;
      CHECK((lowest(model, load) > 0) == (part < 1));
    }
  }
  for (const auto& [foot, critical] : {std::pair(held, 807095.0), std::pair(hinged, 199204.0)}) {
    BodySpec spec;
    spec.name = "portal", spec.kind = BodyKind::frame, spec.material = "m", spec.floating = true;
    FrameSpec frame;
    frame.joints = {{.name = "a", .place = {0, 0}, .support = foot},
                    {.name = "b", .place = {0, 4}},
                    {.name = "c", .place = {4, 4}},
                    {.name = "d", .place = {4, 0}, .support = foot}};
    FrameMember m;
    m.section = rectangle_section(0.1, 0.1), m.divisions = 8;
    for (const int i : {0, 1, 2}) m.from = i, m.to = i + 1, frame.members.push_back(m);
    spec.frame = frame;
    const Model<2> model = of_frames(elastic_material("m", 7850, 2.1e11), {spec});
    for (const double part : {0.995, 1.005}) {
      std::vector<NodeDofs> load = no_load(model);
      load[1][1] = load[2][1] = -part * critical;
      CHECK((lowest(model, load) > 0) == (part < 1));
    }
  }
}

}  // namespace
}  // namespace trilith::testing
