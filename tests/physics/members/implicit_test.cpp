// Implicit steps: the schemes' own arithmetic, history-dependent laws, impacts, bodies in contact.
#include "physics/members/implicit.hpp"

#include "near.hpp"

namespace trilith::testing {
namespace {

constexpr double unit_stiffness = 4 * M_PI * M_PI;  // period of 1 s with a mass of 1 kg [N/m]

/// x_(j+1) = a x_j - b x_(j-1): spectral radius and period of a free vibration in steps, by least squares.
struct Vibration {
  double radius, period;  ///< per step; in steps
  explicit Vibration(const std::vector<double>& x, std::size_t from = 10) {
    double xx = 0, xy = 0, yy = 0, zx = 0, zy = 0;
    for (std::size_t j = from; j + 1 < x.size(); ++j) {
      xx += x[j] * x[j], xy += x[j] * x[j - 1], yy += x[j - 1] * x[j - 1];
      zx += x[j + 1] * x[j], zy += x[j + 1] * x[j - 1];
    }
    const double det = xx * yy - xy * xy, a = (zx * yy - zy * xy) / det, b = -(zy * xx - zx * xy) / det;
    radius = std::sqrt(b);
    period = 2 * M_PI / std::acos(a / (2 * radius));
  }
};

/// `from`: number of first steps left out, in which start effects decay.
Vibration vibration(const AlphaMethod& scheme, double step, double duration = 20, std::size_t from = 10) {
  return Vibration(history_of({Linear{unit_stiffness, 0}, 1, 1}, implicit_stage(scheme, duration, step)), from);
}

TEST_CASE("I1: average acceleration keeps the amplitude and lengthens the period by the formula") {
  for (const double h : {0.02, 0.05, 0.1, 0.2}) {
    const Vibration v = vibration(AlphaMethod::hht(0), h, 100);
    const double w = 2 * M_PI * h, longer = (w / 2) / std::atan(w / 2) - 1;
    MESSAGE("I1 h/T = " << h << ": elongation " << 100 * (v.period * h - 1) << " %, formula " << 100 * longer << " %");
    CHECK(near(v.period * h - 1, longer, 1e-3));
    CHECK(near(v.radius, 1, 1e-9));
  }
}

TEST_CASE("I2: damping and period error of HHT follow its amplification matrix") {
  struct Row {
    double alpha, step, radius, longer;
  };
  for (const Row& row : {Row{-0.05, 0.05, .999948, 0}, Row{-0.05, 0.1, .999282, .03611}, Row{-0.05, 0.2, .993015, 0},
                         Row{-0.1, 0.05, .999907, 0}, Row{-0.1, 0.1, .998728, .03951}, Row{-0.1, 0.2, .987832, 0},
                         Row{-0.3, 0.05, .999832, 0}, Row{-0.3, 0.1, .997750, .04657}, Row{-0.3, 0.2, .979310, 0}}) {
    const Vibration v = vibration(AlphaMethod::hht(row.alpha), row.step);
    CAPTURE(row.alpha);
    CAPTURE(row.step);
    CHECK(near(v.radius, row.radius, 1e-5));
    if (row.longer > 0) CHECK(near(v.period * row.step - 1, row.longer, 1e-3));
  }
}

TEST_CASE("I3: damping and period error of generalised alpha follow its spectral radius") {
  struct Row {
    double radius, at_tenth, at_fifth, longer;
  };
  for (const Row& row : {Row{0.9, .999990, .999872, .03247}, Row{0.8, .999904, .998853, .03383},
                         Row{0.5, .997733, .979178, .04672}, Row{0, .969708, .853874, .12321}}) {
    const Vibration tenth = vibration(AlphaMethod::from_radius(row.radius), 0.1, 10),
                    fifth = vibration(AlphaMethod::from_radius(row.radius), 0.2, 10, 25);
    CAPTURE(row.radius);
    CHECK(near(tenth.radius, row.at_tenth, 1e-5));
    CHECK(near(fifth.radius, row.at_fifth, 1e-5));
    CHECK(near(tenth.period * 0.1 - 1, row.longer, 1e-3));
  }
}

TEST_CASE("I4: a suddenly loaded mass has the digits of Newmark and HHT, of second order") {
  const double c = 2 * 0.05 * std::sqrt(unit_stiffness);
  const MassOnLaw mass{Linear{unit_stiffness, c}, 1, 0, unit_stiffness};
  struct Row {
    double alpha;
    std::array<double, 5> at;
  };
  const double exact = .26990723;
  for (const Row& row : {Row{0, {.27140902, .26745978, .26910307, .26969391, .26985313}},
                         Row{-0.1, {.28324395, .26810278, .26899266, .26963711, .26983565}}}) {
    double h = 0.1, last = 0;
    for (const double expected : row.at) {
      const double u = history_of(mass, implicit_stage(AlphaMethod::hht(row.alpha), 1, h)).back();
      CAPTURE(row.alpha);
      CAPTURE(h);
      CHECK(std::abs(u - expected) < 1e-7);
      last = u - exact, h /= 2;
    }
    const double next = history_of(mass, implicit_stage(AlphaMethod::hht(row.alpha), 1, h)).back() - exact;
    CHECK(near(last / next, row.alpha == 0 ? 3.99 : 3.9, 0.02));
  }
}

TEST_CASE("I6: an elastic-plastic mass after a blow: peak, rest, energy") {
  Simulation<2> sim(MassOnLaw{ElasticPlastic{1e6, 1e4, 0, 0}, 1000, 0.8}.model());
  const int node = node_of(sim.model(), "mass");
  double most = 0, at = 0, least = 1, low_at = 0;
  sim.run(implicit_stage(AlphaMethod::hht(0), 0.25, 1e-3), each_step([&](const Instant<2>& now) {
            const double x = now.state.position[node].x();
            if (x > most && now.state.time < 0.15) most = x, at = now.state.time;
            if (x < least && now.state.time > at) least = x, low_at = now.state.time;
          }));
  const Energy energy = sim.energy();
  CHECK(near(most, .037, 0.002));
  CHECK(near(at, .086335, 0.01));
  CHECK(near(least, .017, 0.002));
  CHECK(near(2 * (low_at - at), .198692, 0.01));
  CHECK(near(energy[EnergyTerm::bearing_inner], 270, 0.002));
  CHECK(std::abs(energy.balance() - 320) < 0.005 * 320);
}

/// A block on a base of stiffness `k` [N/m], dropped from `height` [m]. It cannot rotate: the flat impact of a free
/// block is unstable, and rounding would set it spinning within about ten bounces.
Simulation<2> falling_block(double k, double mass, double height) {
  Scene scene(Frictional{k, k / 2, 0, 0});
  scene.fixed("base", box(-2, -1, 2, 0));
  BodySpec body;
  body.name = "block", body.outline = box(-0.5, height, 0.5, height + 1), body.mass = mass, body.floating = true;
  body.support = {Support::free, Support::free, Support::fixed};
  scene.add(body);
  return scene.start();
}

TEST_CASE("I9: twenty bounces on a compression-only spring keep height and period") {
  Simulation<2> sim = falling_block(4e6, 1000, 0.5);
  const int node = node_of(sim.model(), "block");
  double deepest = 0, highest = 0, last = 1;
  std::vector<double> touched;
  sim.run(adaptive_stage(AlphaMethod::hht(0), 20 * .689897, 0.01), each_step([&](const Instant<2>& now) {
            const double y = now.state.position[node].y() - 0.5;
            deepest = std::min(deepest, y);
            if (y < 0 && last >= 0) touched.push_back(now.state.time - now.state.last_dt * y / (y - last));
            if (now.state.time > 0.35) highest = std::max(highest, y);
            last = y;
          }));
  REQUIRE(touched.size() > 15);
  const double period = (touched.back() - touched.front()) / static_cast<double>(touched.size() - 1);
  MESSAGE("I9: touch " << touched[0] << " s, deepest " << deepest << " m, period " << period << " s over "
                       << touched.size() << " blows, highest " << highest << " m, " << sim.state().step << " steps");
  CHECK(near(touched[0], .319330, 0.005));
  CHECK(near(-deepest, .0520266, 0.01));
  CHECK(near(period, .689897, 0.005));
  CHECK(highest < 0.5025);
  CHECK(highest > 0.49);
}

/// A base that swings along x, and a block that slides on it.
struct ShakenBlock {
  Scene scene{Frictional{1e9, 5e8, 0.3, 2e-5}};
  [[nodiscard]] std::vector<double> slid(const StageOptions& stage, double every) {
    scene.fixed("base", box(-3, -0.5, 3, 0));
    scene.block("block", box(-0.5, 0, 0.5, 0.4), 960);
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base", *motion_of(4, 0.002, [](double t) {
                          return 5 * std::sin(2 * M_PI * 1.5 * t) * std::min(1.0, t);
                        }));
    Simulation<2> sim(model);
    const int block = node_of(model, "block"), base = node_of(model, "base");
    std::vector<double> out;
    double next = every, last = 0;
    sim.run(stage, each_step([&](const Instant<2>& now) {
              const double at = now.state.position[block].x() - now.state.position[base].x();
              if (now.state.time >= next - 1e-9)
                out.push_back(at - (at - last) * (now.state.time - next) / now.state.last_dt), next += every;
              last = at;
            }));
    steps = sim.state().step;
    return out;
  }
  std::int64_t steps = 0;
};

TEST_CASE("a block on a shaken base slides the same distance with implicit and explicit steps") {
  StageOptions explicitly;
  explicitly.duration = 4;
  StageOptions implicitly = adaptive_stage(AlphaMethod::hht(-0.05), 4, 0.005);
  implicitly.accuracy = 3e-4;
  ShakenBlock a, b;
  const std::vector<double> fine = a.slid(explicitly, 0.5), coarse = b.slid(implicitly, 0.5);
  REQUIRE(fine.size() == coarse.size());
  double most = 0, off = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    most = std::max(most, std::abs(fine[i]));
    off = std::max(off, std::abs(fine[i] - coarse[i]));
  }
  MESSAGE("slid at most " << most << " m, off by " << off << " m; steps " << a.steps << " and " << b.steps);
  CHECK(most > 0.02);
  CHECK(off < 0.02 * most);
}

TEST_CASE("the state within an implicit stage continues with the same bits") {
  const StageOptions whole = adaptive_stage(AlphaMethod::hht(-0.05), 0.6, 0.005);
  Simulation<2> once = falling_block(4e8, 1000, 0.05);
  once.run(whole);
  StageOptions first = whole;
  std::optional<State<2>> kept;
  Simulation<2> broken = falling_block(4e8, 1000, 0.05);
  RunListener<2> listener;
  listener.on_step = [&](const Instant<2>& now) {
    if (now.state.step == 40) kept = now.state;
  };
  broken.run(whole, listener);
  REQUIRE(kept.has_value());
  Simulation<2> on(broken.model(), *kept);
  StageOptions rest = whole;
  rest.end_time = once.state().time;
  on.run(rest);
  CHECK(on.state().step == once.state().step);
  CHECK(state_hash(on.state()) == state_hash(once.state()));
}

TEST_CASE("a step that does not converge changes no state and reports the place") {
  // A law so steep about 0 that the floating-point resolution of a position cannot represent its force.
  Table steep;
  steep.displacement = {-1, -1e-12, 1e-12, 1}, steep.force = {-1e6, -1e6, 1e6, 1e6};
  Simulation<2> sim(MassOnLaw{steep, 1e-3, 0.1}.model());
  const int node = node_of(sim.model(), "mass");
  const StageReport report = sim.run(adaptive_stage(AlphaMethod::hht(-0.05), 0.1, 0.005));
  CHECK(report.end == StageEnd::not_converged);
  CHECK(report.reason.find("on mass") != std::string::npos);
  CHECK(report.reason.find("smaller dt") != std::string::npos);
  MESSAGE(report.reason);
  CHECK(sim.state().time == report.ended);
  CHECK(sim.state().step == 0);
  CHECK(sim.state().position[node].x() == 0);
  CHECK(sim.state().velocity[node].x() == 0.1);
  CHECK(near(sim.energy().balance(), 0.5 * 1e-3 * 0.01, 1e-9));
}

TEST_CASE("a body that leaves the bounds in an implicit stage does not move afterwards") {
  Scene scene(Frictional{1e9, 5e8, 0.6, 1e-4});
  scene.set_gravity({0, 0});
  scene.block("stays", box(-1, 0, -0.5, 0.5), 100, {0, 0.1});
  scene.block("leaves", box(0, 0, 0.5, 0.5), 100, {5, 0});
  Model<2> model = scene.builder.build();
  model.bounds = {Vec2(-2, -2), Vec2(2, 2)};
  Simulation<2> sim(model);
  CHECK(sim.run(adaptive_stage(AlphaMethod::hht(-0.05), 1, 0.01)).end == StageEnd::time);
  const Vec2 out = sim.state().position[node_of(model, "leaves")], in = sim.state().position[node_of(model, "stays")];
  CHECK(out.x() > 2);
  CHECK(out.x() < 2.4);
  CHECK(near(in.y(), 0.35, 1e-9));
  CHECK(std::abs(sim.energy().balance() - 1250.5) < 1e-6);
}

TEST_CASE("explicit, implicit, explicit again: the energy balance stays closed and the motion is continuous") {
  Simulation<2> sim(MassOnLaw{Linear{unit_stiffness, 0.3}, 1, 1}.model());
  const int node = node_of(sim.model(), "mass");
  run_for(sim, 0.37, 1e-4);
  const StageReport middle = sim.run(implicit_stage(AlphaMethod::hht(0), 0.5, 1e-3));
  CHECK(middle.end == StageEnd::time);
  INFO(middle.reason);
  const StageReport last = run_for(sim, 0.63, 1e-4);
  INFO(last.reason);
  CHECK(last.end == StageEnd::time);
  const double decay = 0.15, w = std::sqrt(unit_stiffness - decay * decay), t = sim.state().time;
  CHECK(near(t, 1.5, 1e-9));
  CHECK(std::abs(sim.state().position[node].x() - std::exp(-decay * t) * std::sin(w * t) / w) < 1e-4 / w);
  CHECK(std::abs(sim.energy().balance() - 0.5) < 1e-4);
}

}  // namespace
}  // namespace trilith::testing
