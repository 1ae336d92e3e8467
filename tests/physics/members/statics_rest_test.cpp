// Equilibrium by statics: compared with consolidation by explicit steps, and where no equilibrium exists.
#include <algorithm>
#include <chrono>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/evaluate.hpp"
#include "build/plane/arch.hpp"
#include "model/loads.hpp"
#include "near.hpp"
#include "physics/masonry_scene.hpp"
#include "statics/equilibrium.hpp"
#include "statics/load_path.hpp"

namespace trilith::testing {
namespace {

double clock_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Forces of all joints at a state.
std::vector<TouchingContact> joint_forces(const Model<2>& model, const State<2>& state) {
  Work<2> work;
  evaluate(model, state, work, state.last_dt);
  std::vector<TouchingContact> out;
  contact_resultants(model, state, work, out);
  return out;
}

/// Force of the joint between two bodies [N]; zero if they do not touch.
Vec2 joint_force(const std::vector<TouchingContact>& joints, int a, int b) {
  Vec2 sum = Vec2::Zero();
  for (const TouchingContact& c : joints) {
    if (c.body_a == a && c.body_b == b) sum += c.resultant.force;
    if (c.body_a == b && c.body_b == a) sum -= c.resultant.force;
  }
  return sum;
}

/// Largest difference of the joint forces of two states, as a share of the largest force.
double apart(const std::vector<TouchingContact>& one, const std::vector<TouchingContact>& other) {
  double most = 0, off = 0;
  for (const auto* joints : {&one, &other})
    for (const TouchingContact& c : *joints) {
      const Vec2 difference = joint_force(one, c.body_a, c.body_b) - joint_force(other, c.body_a, c.body_b);
      off = std::max(off, difference.norm()), most = std::max(most, c.resultant.force.norm());
    }
  return off / most;
}

const std::string& body_with(const Model<2>& model, int node) {
  static const std::string none = "none";
  for (const Body& b : model.bodies)
    if (node >= b.first_node && node < b.first_node + b.nodes) return b.name;
  return none;
}

/// Equilibrium of a scene by statics, printed next to its consolidation.
Equilibrium rest_of(const std::string& what, const Model<2>& model, State<2>& state,
                    const EquilibriumOptions& options = {}) {
  const double begun = clock_now();
  const Equilibrium e = find_equilibrium(model, state, options);
  MESSAGE(fmt::format("{}: {}, {:.1e} left on {}; {} iterations in {} steps, {} cuts, {:.1f} ms", what, name_of(e.end),
                      e.left, body_with(model, e.worst), e.iterations, e.steps, e.cuts, 1e3 * (clock_now() - begun)));
  return e;
}

void check_no_rest(const std::string& what, const Model<2>& model, const std::string& worst) {
  State<2> state = initial_state(model);
  const std::uint64_t hash = state_hash(state);
  const Equilibrium e = rest_of(what, model, state);
  CHECK_FALSE(e.converged);
  CHECK(e.end != EquilibriumEnd::rests);
  REQUIRE(e.worst >= 0);
  if (!worst.empty()) CHECK(body_with(model, e.worst) == worst);
  CHECK(state_hash(state) == hash);
}

void lean(Scene& scene, double tilt) {
  scene.set_gravity({standard_gravity * std::sin(tilt), -standard_gravity * std::cos(tilt)});
}

/// Five blocks of 100 kg, each offset by 20 mm from the block below, with a gap under each.
Model<2> leaning_stack(double gap) {
  Scene scene(Frictional{1e10, 5e9, 0.6, 1e-4});
  scene.fixed("base", box(-2, -1, 2, 0));
  for (int i = 0; i < 5; ++i) {
    BodySpec spec;
    const double x = 0.02 * i, y = gap + i * (0.2 + gap);
    spec.name = "block" + std::to_string(i), spec.outline = box(x - 0.2, y, x + 0.2, y + 0.2);
    spec.mass = 100, spec.floating = true;
    scene.add(spec);
  }
  return scene.builder.build();
}

/// A square wall in running bond with an opening under a lintel in its middle; head joints open by `gap` [m].
Scene wall_with_opening(int courses, double gap) {
  Scene scene(Frictional{1e11, 5e10, 0.6, 1e-5});
  const double length = 0.4 * courses, left = 0.5 * length - 0.4, right = 0.5 * length + 0.4;  // of the opening
  scene.fixed("base", box(-1, -1, length + 1, 0));
  const auto add = [&](int course, double x0, double x1) {
    const std::string name = fmt::format("u{}_{}", course, static_cast<int>(std::lround(10 * x0)));
    if (x1 - x0 > 0.05)
      scene.block(name, box(x0 + gap / 2, 0.2 * course, x1 - gap / 2, 0.2 * course + 0.2), 400 * (x1 - x0));
  };
  for (int course = 0; course < courses; ++course) {
    const double beyond = course < courses / 2 ? 0 : course == courses / 2 ? 0.3 : -1;  // cut at the opening
    if (beyond > 0) add(course, left - beyond, right + beyond);
    for (double x = course % 2 == 0 ? 0 : -0.2; x < length - 1e-9; x += 0.4) {
      const double x0 = std::max(x, 0.0), x1 = std::min(x + 0.4, length);
      if (beyond < 0 || x1 <= left - beyond || x0 >= right + beyond) {
        add(course, x0, x1);
      } else {
        add(course, x0, std::min(x1, left - beyond));
        add(course, std::max(x0, right + beyond), x1);
      }
    }
  }
  return scene;
}

/// Consolidation by explicit steps under weight that grows over `grow` [s].
State<2> consolidated(Model<2> model, double grow) {
  model.gravity.grow_end = grow;
  Simulation<2> sim(std::move(model));
  StageOptions options;
  options.duration = 10, options.rest_share = 0.8, options.until_rest = true, options.still_from = grow;
  options.still_speed = 1e-7, options.still_ratio = 1e-6, options.still_hold = 0.02;
  const double begun = clock_now();
  const StageReport report = sim.run(options);
  CHECK(report.end == StageEnd::rest);
  MESSAGE(fmt::format("consolidated under weight that grows over {} s: {} steps, {:.1f} ms", grow, report.steps,
                      1e3 * (clock_now() - begun)));
  return sim.state();
}

TEST_CASE("statics gives each joint of a stack the weight above, from closed or open joints") {
  for (const double gap : {0.0, 0.005}) {
    const Model<2> model = leaning_stack(gap);
    State<2> state = initial_state(model);
    state.time = 3;
    REQUIRE(rest_of("stack", model, state).converged);
    CHECK(state.time == 3);
    for (const Vec2& v : state.velocity) CHECK(v.norm() == 0);
    const std::vector<TouchingContact> joints = joint_forces(model, state);
    REQUIRE(joints.size() == 5);
    for (int i = 0; i < 5; ++i) {
      const Vec2 force = joint_force(joints, i, i + 1);
      CHECK(near(force.y(), (5 - i) * 100 * standard_gravity, 1e-6));
      CHECK(near_zero(force.x(), 1e-3));
    }
  }
}

TEST_CASE("a stack brought to rest by statics has the positions of consolidation, and stays at rest") {
  const Model<2> model = leaning_stack(0);
  State<2> state = initial_state(model);
  REQUIRE(rest_of("stack", model, state).converged);
  const State<2> other = consolidated(model, 0);
  const double off = apart(joint_forces(model, state), joint_forces(model, other));
  MESSAGE(fmt::format("stack: joint forces {:.1e} apart", off));
  CHECK(off < 0.005);
  for (int n = 1; n < model.nodes(); ++n)
    CHECK((state.position[n] - other.position[n]).norm() <
          1e-3 * std::abs(state.position[n].y() - model.start_position[n].y()));
  const Vec2 top = state.position.back();
  Simulation<2> on(model, state);
  run_for(on, 0.05);
  CHECK((on.state().position.back() - top).norm() < 1e-12);
  CHECK(std::abs(on.energy().balance()) < 1e-6);
  StageOptions implicitly;
  implicitly.duration = 0.05, implicitly.integrator = AlphaMethod::hht(-0.05);
  CHECK(on.run(implicitly).end == StageEnd::time);
  CHECK((on.state().position.back() - top).norm() < 1e-12);
}

TEST_CASE("statics finds the same rest from any motion and keeps the energy balance closed") {
  const Model<2> model = leaning_stack(0);
  State<2> from_start = initial_state(model);
  REQUIRE(find_equilibrium(model, from_start).converged);
  for (const bool implicitly : {false, true}) {
    Simulation<2> moving(model);
    StageOptions options;
    options.duration = 2e-3, options.dt = implicitly ? 1e-5 : 1e-7;
    if (implicitly) options.integrator = AlphaMethod::hht(-0.05);
    moving.run(options);
    moving.refresh();
    const Energy before = moving.energy();
    REQUIRE(before[EnergyTerm::kinetic] > 1e-4);
    State<2> state = moving.state();
    REQUIRE(rest_of("moving stack", model, state).converged);
    CHECK(state.implicit() == implicitly);
    CHECK(state.time == moving.state().time);
    CHECK(apart(joint_forces(model, state), joint_forces(model, from_start)) < 1e-6);
    Simulation<2> on(model, state);
    on.refresh();
    // The kinetic energy of leapfrog is m (a dt)^2 / 8 below its value at the instant.
    const double off = std::abs(on.energy().balance() - before.balance());
    CHECK(off < (implicitly ? 1e-9 : 1e-5) * before[EnergyTerm::kinetic]);
    CHECK(on.energy()[EnergyTerm::kinetic] == 0);
    CHECK(on.energy()[EnergyTerm::rest_damping] > 0);
  }
}

TEST_CASE("a wall with an opening brought to rest by statics has the joint forces of its consolidation") {
  // If units slide, joint forces depend on the loading path. Weight applied at once makes the wall of 252 bodies
  // overshoot, and its joint forces then differ from those under slowly growing weight by 1 % of the largest.
  for (const int courses : {6, 16}) {
    Scene scene = wall_with_opening(courses, 0.01);
    const Model<2> model = scene.builder.build();
    State<2> state = initial_state(model);
    REQUIRE(rest_of(fmt::format("wall of {} bodies", model.bodies.size()), model, state).converged);
    const std::vector<TouchingContact> joints = joint_forces(model, state);
    const double at_once = apart(joints, joint_forces(model, consolidated(model, 0)));
    const double grown = apart(joints, joint_forces(model, consolidated(model, 0.2)));
    MESSAGE(fmt::format("joint forces {:.1e} apart under weight at once, {:.1e} as it grows", at_once, grown));
    if (courses == 6) CHECK(at_once < 0.005);
    CHECK(grown < 0.005);
  }
}

/// A semicircular arch of 30 voussoirs under tilted gravity.
Scene tilted_arch(double thickness, double tilt) {
  Arch arch;
  arch.voussoirs = 30, arch.thickness = thickness, arch.half_angle = 90 * degree, arch.sub_edges = 2;
  Scene scene(stiff_joint(10, M_PI / 30));
  lean(scene, tilt);
  add_parts(scene, build_arch(arch), "abutments");
  return scene;
}

/// Largest horizontal load of an arch of 40 voussoirs under its weight, as a factor of the weight, with joints of
/// `stiffness` [Pa/m]. The load acts on each voussoir; the crown's displacement is controlled.
double pushed_arch(double thickness, double stiffness) {
  Arch arch;
  arch.voussoirs = 40, arch.thickness = thickness, arch.half_angle = 90 * degree, arch.sub_edges = 2;
  Scene scene(stiff_joint(10, M_PI / 40, stiffness));
  add_parts(scene, build_arch(arch), "abutments");
  Model<2> model = scene.builder.build();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int n = model.bodies[b].first_node;
    if (!model.moves(n)) continue;
    PointLoadSpec spec;
    spec.name = "push", spec.force = {model.mass[n] * standard_gravity, 0};
    for (PointLoad<2>& load : make_point_load(model, static_cast<int>(b), spec))
      loads_of<PointLoad<2>>(model).push_back(load);
  }
  State<2> state = initial_state(model);
  double most = 0;
  LoadPathOptions o;
  o.control = PathControl::displacement, o.followed = {{{node_of(model, "v20"), 0}, 1}};
  o.first = 1e-8, o.longest = 2e-5;
  o.goes_on = [&](const PathPoint& p, const State<2>&) {
    most = std::max(most, p.factor);
    return p.factor >= 0.99 * most;
  };
  const double begun = clock_now();
  const LoadPath path = follow_loads(model, state, o);
  CHECK(path.end == PathEnd::arrived);
  MESSAGE(fmt::format("pushed arch: {} points, {} iterations, {} cuts, {:.0f} ms", path.points.size(), path.iterations,
                      path.cuts, 1e3 * (clock_now() - begun)));
  return most;
}

TEST_CASE("A6: the peak load of a pushed arch converges to its limit factor with the stiffness of its joints") {
  // A hinge that has turned by t is (1/(K t))^(1/2) long. Its length and its rotation reduce the factor least if both
  // are proportional to K^(-1/3), so two stiffnesses give the factor of rigid joints by extrapolation.
  for (const auto& [thickness, factor] : {std::pair(.12, .0468), std::pair(.15, .1445), std::pair(.20, .2843)}) {
    const double soft = pushed_arch(thickness, 4e12), stiff = pushed_arch(thickness, 4e13), part = std::cbrt(10.0);
    const double rigid = (part * stiff - soft) / (part - 1);
    MESSAGE(fmt::format("A6, t/R {}: {:.5f}, {:.5f}, rigid {:.5f} ({})", thickness, soft, stiff, rigid, factor));
    CHECK(soft < stiff);
    CHECK(stiff < factor);
    CHECK(near(rigid, factor, 0.005));
  }
}

/// Horizontal force at the crown over the weight.
double thrust_share(const Model<2>& model, const State<2>& state) {
  const Vec2 force = joint_force(joint_forces(model, state), model.find_body("v15"), model.find_body("v16"));
  double weight = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n)) weight += model.mass[n] * standard_gravity;
  return std::abs(force.x()) / weight;
}

TEST_CASE("A5: statics and consolidation give an arch the same thrust, between its limits") {
  struct Case {
    double thickness, least, most;
  };
  for (const Case& c : {Case{.12, .1907, .2073}, Case{.15, .1756, .2271}, Case{.20, .1540, .2546}}) {
    const Model<2> model = tilted_arch(c.thickness, 0).builder.build();
    State<2> state = initial_state(model);
    REQUIRE(rest_of(fmt::format("arch, t/R {}", c.thickness), model, state).converged);
    Simulation<2> laid(model);
    const double begun = clock_now();
    REQUIRE(lay_down(laid, 1e-5, {}) == StageEnd::rest);
    const double found = thrust_share(model, state), expected = thrust_share(model, laid.state());
    MESSAGE(fmt::format("thrust {:.5f}, by consolidation {:.5f} in {:.0f} ms", found, expected,
                        1e3 * (clock_now() - begun)));
    CHECK(near(found, expected, 0.01));
    CHECK(found >= c.least);
    CHECK(found <= c.most);
  }
}

TEST_CASE("A6: an arch is at rest below its limit tilt, and beyond it statics finds no rest") {
  const double limit = std::atan(.1445);  // t/R = 0.15
  const Model<2> below = tilted_arch(.15, 0.96 * limit).builder.build();
  State<2> state = initial_state(below);
  CHECK(rest_of("arch at .96 of its limit", below, state).converged);
  check_no_rest("arch at 1.02 of its limit", tilted_arch(.15, 1.02 * limit).builder.build(), "");
  check_no_rest("arch at 1.2 of its limit", tilted_arch(.15, 1.2 * limit).builder.build(), "");
}

TEST_CASE("statics that is stopped ends at its next iteration and does not change the state") {
  const Model<2> model = leaning_stack(1e-3);
  State<2> state = initial_state(model);
  const std::uint64_t hash = state_hash(state);
  int asked = 0;
  EquilibriumOptions options;
  options.is_stopped = [&asked] { return ++asked > 3; };
  const Equilibrium e = rest_of("stopped", model, state, options);
  CHECK(e.end == EquilibriumEnd::stopped);
  CHECK_FALSE(e.converged);
  CHECK(e.iterations <= 3);
  CHECK(state_hash(state) == hash);
}

TEST_CASE("a block in the air above nothing has no rest") {
  Scene scene(Frictional{1e10, 5e9, 0.6, 1e-4});
  scene.fixed("base", box(10, -1, 12, 0));
  BodySpec spec;
  spec.name = "block", spec.outline = box(0, 0, 1, 1), spec.mass = 100, spec.floating = true;
  scene.add(spec);
  check_no_rest("block in the air", scene.builder.build(), "block");
}

TEST_CASE("a block rests on a slope that its friction holds, and has no rest on a steeper one") {
  for (const double tilt : {0.98, 1.02}) {
    Scene scene(Frictional{1e10, 5e9, 0.6, 1e-4});
    lean(scene, tilt * std::atan(0.6));
    scene.fixed("base", box(-5, -1, 5, 0));
    scene.block("block", box(0, 0, 1, 0.5), 100);
    const Model<2> model = scene.builder.build();
    if (tilt > 1) {
      check_no_rest("slope too steep", model, "block");
      continue;
    }
    State<2> state = initial_state(model);
    CHECK(rest_of("slope", model, state).converged);
  }
}

}  // namespace
}  // namespace trilith::testing
