// Implicit steps twenty times as long as explicit steps, compared with them, for rocking and sliding bodies.
#include <algorithm>

#include "near.hpp"
#include "physics/members/implicit.hpp"

namespace trilith::testing {
namespace {

/// Values at intervals of `every` [s] of a stage, linearly interpolated between steps.
struct Sampled {
  std::vector<double> value;
  std::int64_t steps = 0;
  double longest = 0;  ///< step [s]
  StageEnd end = StageEnd::time;

  Sampled() = default;
  template <class F>
  Sampled(Simulation<2>& sim, const StageOptions& stage, double every, F&& read) {
    double next = every, last = read(sim.state());
    const StageReport report =
        sim.run(stage, each_step([&](const Instant<2>& now) {
                  const double at = read(now.state);
                  for (; now.state.time >= next - 1e-9; next += every)
                    value.push_back(at - (at - last) * (now.state.time - next) / now.state.last_dt);
                  last = at;
                }));
    steps = report.steps, longest = report.longest_dt, end = report.end;
  }
};

StageOptions explicit_stage(double duration) {
  StageOptions stage;
  stage.duration = duration;
  return stage;
}

/// Largest difference of the second series from the first, as a share of the largest value of the first.
double apart_at_most(const std::string& what, const Sampled& fine, const Sampled& coarse) {
  CHECK(coarse.end == StageEnd::time);
  REQUIRE(fine.value.size() == coarse.value.size());
  double size = 0, off = 0;
  for (std::size_t i = 0; i < fine.value.size(); ++i) {
    size = std::max(size, std::abs(fine.value[i]));
    off = std::max(off, std::abs(fine.value[i] - coarse.value[i]));
  }
  MESSAGE(
      fmt::format("{}: {:.5f} at most, {:.2e} apart, {:.2f} %; {} explicit steps of {:.2e} s, {} implicit ones of "
                  "{:.2e} s at most",
                  what, size, off, 100 * off / size, fine.steps, fine.longest, coarse.steps, coarse.longest));
  return off / size;
}

/// A block of 0.4 m by 1.2 m released at a tilt of half of its critical angle.
Simulation<2> rocking_block() {
  Scene scene(Frictional{1e11, 5e10, 2, 2e-5});
  scene.fixed("base", box(-4, -1, 4, 0));
  Polygon outline = box(-0.4, 0, 0, 1.2);
  for (Vec2& p : outline) p = Turn(-0.5 * std::atan(1 / 3.0)).apply(p);
  scene.block("block", outline, 480);
  return scene.start();
}

TEST_CASE("a block rocks the same with implicit steps and explicit ones a twentieth as long") {
  Simulation<2> a = rocking_block(), b = rocking_block();
  const int n = node_of(a.model(), "block");
  const auto tilt = [&](const State<2>& s) { return s.rotation[n]; };
  const Sampled fine(a, explicit_stage(2), 0.01, tilt);
  // The energy tolerance of steps is tighter than usual: with the default of 1e-3 the two differ by 2.02 %.
  StageOptions implicitly = adaptive_stage(AlphaMethod::hht(-0.05), 2, 20 * fine.longest);
  implicitly.accuracy = 3e-4;
  CHECK(apart_at_most("rocking", fine, Sampled(b, implicitly, 0.01, tilt)) < 0.02);
}

/// A block on a base that is shaken along x; its friction changes direction about a dozen times.
struct ShakenSlider {
  double kn = 1e11, mu = 0.3, beta = 2e-5, frequency = 1.5;
  bool pointed = false;  ///< stands on a corner, and cannot rotate

  [[nodiscard]] Simulation<2> start() const {
    Scene scene(Frictional{kn, kn / 2, mu, beta});
    scene.fixed("base", box(-3, -0.5, 3, 0));
    BodySpec spec;
    spec.name = "block", spec.outline = box(-0.5, 0, 0.5, 0.4), spec.mass = 960;
    if (pointed) spec.outline = {{0, 0}, {0.5, 0.2}, {0.5, 0.4}, {-0.5, 0.4}, {-0.5, 0.2}};
    if (pointed) spec.support = {Support::free, Support::free, Support::fixed};
    scene.add(spec);
    Model<2> model = scene.builder.build();
    scene.drive_along_x(model, "base", *motion_of(4, 0.002, [f = frequency](double t) {
                          return 5 * std::sin(2 * M_PI * f * t) * std::min(1.0, t);
                        }));
    return Simulation(std::move(model));
  }
};

double slides_apart(const std::string& what, const ShakenSlider& slider, const StageOptions& stage, Sampled& fine) {
  Simulation<2> a = slider.start(), b = slider.start();
  const int block = node_of(a.model(), "block"), base = node_of(a.model(), "base");
  const auto slid = [&](const State<2>& s) { return s.position[block].x() - s.position[base].x(); };
  if (fine.value.empty()) fine = Sampled(a, explicit_stage(4), 0.02, slid);
  StageOptions implicitly = stage;
  if (implicitly.dt == 0) implicitly.dt = 20 * fine.longest;
  return apart_at_most(what, fine, Sampled(b, implicitly, 0.02, slid));
}

TEST_CASE("a block slides on a shaken base the same with implicit steps and explicit ones a twentieth as long") {
  for (const auto& [what, slider] : {std::pair{"sliding, stiff", ShakenSlider{}},
                                     {"sliding, soft", ShakenSlider{1e9}},
                                     {"sliding, well damped", ShakenSlider{1e9, 0.2, 1e-4, 2.5}},
                                     {"sliding on a corner at rest", ShakenSlider{1e9, 0.3, 1e-3, 1.5, true}}}) {
    Sampled fine;
    CHECK(slides_apart(what, slider, adaptive_stage(AlphaMethod::hht(-0.05), 4, 0), fine) < 0.02);
  }
}

TEST_CASE("the sliding distance of a block does not depend on the longest implicit step") {
  Sampled fine;
  for (const double dt : {2e-3, 5e-3, 10e-3})
    for (const double accuracy : {1e-3, 3e-4, 1e-4}) {
      StageOptions stage = adaptive_stage(AlphaMethod::hht(-0.05), 4, dt);
      stage.accuracy = accuracy;
      CHECK(slides_apart(fmt::format("sliding, accuracy {:g}", accuracy), ShakenSlider{1e9}, stage, fine) < 0.02);
    }
}

/// A mass on a bearing that yields at 0.3 of the weight, without hardening, on a base that is shaken along x.
Simulation<2> shaken_bearing(double stiffness) {
  Scene scene(Frictional{1e6, 1e6, 0.5, 0});
  scene.set_gravity({0, 0});
  scene.fixed("base", box(-1, -1, 1, 0));
  BodySpec body;
  body.name = "mass", body.outline = box(-0.5, 1, 0.5, 2), body.mass = 960;
  body.support = {Support::free, Support::fixed, Support::fixed};
  scene.add(body);
  scene.builder.set_contact("*", "*", "none");
  BearingSpec link;
  link.name = "bearing", link.body_a = "base", link.body_b = "mass";
  link.point_a = {0, 0}, link.point_b = {0, 1.5};
  link.law = {ElasticPlastic{stiffness, 0.3 * 960 * standard_gravity, 0, 0}, {}, {}};
  scene.builder.add_bearing(link);
  Model<2> model = scene.builder.build();
  scene.drive_along_x(model, "base", *motion_of(4, 0.002, [](double t) {
                        return 5 * std::sin(2 * M_PI * 1.5 * t) * std::min(1.0, t);
                      }));
  return Simulation(std::move(model));
}

TEST_CASE("a bearing yields back and forth the same with implicit and explicit steps") {
  for (const double stiffness : {5e8, 5e10}) {
    Simulation<2> fine_run = shaken_bearing(stiffness);
    const int mass = node_of(fine_run.model(), "mass"), base = node_of(fine_run.model(), "base");
    const auto moved = [&](const State<2>& s) { return s.position[mass].x() - s.position[base].x(); };
    const Sampled fine(fine_run, explicit_stage(4), 0.02, moved);
    for (const double dt : {5e-3, 10e-3}) {
      Simulation<2> sim = shaken_bearing(stiffness);
      const Sampled coarse(sim, adaptive_stage(AlphaMethod::hht(-0.05), 4, dt), 0.02, moved);
      CHECK(apart_at_most(fmt::format("yielding, {:g} N/m", stiffness), fine, coarse) < 0.02);
    }
  }
}

}  // namespace
}  // namespace trilith::testing
