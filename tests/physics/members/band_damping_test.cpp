// Damping that is constant over a frequency band: its ratio from free vibration, its cost, its ledger term.
#include "element/band_damping.hpp"

#include "assembly/start.hpp"
#include "assembly/tangent/beam_tangent.hpp"
#include "base/error.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "modal/mode_damping.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"
#include "physics/members/implicit.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::testing {
namespace {

/// A cantilever with a tip mass of about a hundred times its own mass, which sets its frequency to about `hertz`;
/// initial velocity 0.1 m/s across at the tip.
Model<2> mast(double hertz, const std::optional<BandDamping>& band) {
  BodySpec spec = beam_body("mast", {0, 0}, {0, 3}, rectangle_section(0.1, 0.1), "steel", 2);
  const double bending = 2.1e11 * 1e-4 / 12, w = 2 * M_PI * hertz;
  spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = 3 * bending / (27 * w * w);
  spec.frame->joints[1].inertia = 1e-3 * spec.frame->joints[1].mass;
  Material steel = elastic_material("steel", 8000 / (hertz * hertz), 2.1e11);
  steel.band = band;
  Model<2> model = of_frames(steel, {spec});
  model.start_velocity[1] = {0.1, 0};
  return model;
}

struct Swing {
  double ratio = 0;     ///< by the logarithmic decrement over several cycles
  double given = 0;     ///< dissipation by the ledger, over the initial energy
  double residual = 0;  ///< largest, over the initial energy
};

/// Damping ratio from the peaks of the tip's sway without the first ones.
Swing swing(Model<2> model, double hertz, std::optional<AlphaMethod> scheme) {
  Simulation<2> sim(std::move(model));
  StageOptions o;
  o.duration = 12 / hertz;
  if (scheme) o = implicit_stage(*scheme, o.duration, 1 / (200 * hertz));
  std::vector<double> peaks;
  double before = 0, last = 0;
  Swing out;
  sim.refresh();
  const double begun = sim.energy()[EnergyTerm::kinetic];
  sim.run(o, each_step([&](const Instant<2>& now) {
            const double x = now.state.position[1].x();
            if (std::abs(last) > std::abs(before) && std::abs(last) > std::abs(x) && last * x > 0)
              peaks.push_back(std::abs(last));
            before = last, last = x;
          }));
  sim.refresh();
  const Energy end = sim.energy();
  out.given = end[EnergyTerm::element_damping] / begun;
  out.residual = std::abs(end.balance() - begun) / begun;
  REQUIRE(peaks.size() > 16);
  out.ratio = std::log(peaks[4] / peaks[16]) / (12 * M_PI);
  return out;
}

}  // namespace

TEST_CASE("damping over a band: free vibration has the requested ratio at five frequencies") {
  for (const double ratio : {0.02, 0.05}) {
    const BandDamping band{ratio, 1, 20};
    for (const double hertz : {1.0, 2.1, 4.5, 9.5, 20.0}) {
      const Swing s = swing(mast(hertz, band), hertz, std::nullopt);
      MESSAGE("asked " << ratio << ", at " << hertz << " Hz " << s.ratio << ", given off " << s.given << ", ledger "
                       << s.residual);
      CHECK(near(s.ratio, ratio, 0.15));
      CHECK(s.residual < 2e-3);
    }
  }
}

TEST_CASE("damping over a band: implicit and explicit steps decay the same, with the loss in the energy balance") {
  const BandDamping band{0.03, 1, 20};
  for (const double hertz : {2.1, 9.5}) {
    const Swing by_explicit = swing(mast(hertz, band), hertz, std::nullopt);
    const Swing by_implicit = swing(mast(hertz, band), hertz, AlphaMethod::hht(0));
    CHECK(near(by_implicit.ratio, by_explicit.ratio, 0.01));
    CHECK(near(by_implicit.given, by_explicit.given, 0.02));
    // A share of exp(-2 zeta w t) of the energy remains after 12 cycles.
    CHECK(near(by_explicit.given, 1 - std::exp(-4 * M_PI * 12 * by_explicit.ratio), 0.05));
  }
}

TEST_CASE("damping over a band: modes give the ratio that free vibration has") {
  const BandDamping band{0.04, 0.5, 30};
  for (const double hertz : {0.7, 6.0, 25.0}) {
    const Model<2> model = mast(hertz, band);
    const State<2> state = start_state(model);
    const std::vector<Mode> found = modes(model, state, 1);
    CHECK(near(found[0].frequency(), hertz, 0.02));
    const ModeDamping damping = mode_damping(model, state, found)[0];
    CHECK(near(damping.bands, swing(model, hertz, std::nullopt).ratio, 0.05));
    CHECK(near_zero(damping.elements, 1e-9));
    CHECK(damping.total() == damping.bands);
  }
}

TEST_CASE("damping over a band costs the square root of its stiffening of the longest step and nothing else") {
  for (const double ratio : {0.01, 0.02, 0.05}) {
    const BandDamping band{ratio, 1, 20};
    const Model<2> bare = mast(5, std::nullopt), damped = mast(5, band);
    const auto step = [](const Model<2>& model) {
      const State<2> state = start_state(model);
      Work<2> work;
      evaluate(model, state, work, 1e-6);
      return std::pair(stable_step(model, state, work).dt, unbanded_step(model, state, work).dt);
    };
    const double stiffening = damping_branches(band).stiffening(), without = step(bare).first;
    CHECK(near(step(damped).first, without / std::sqrt(stiffening), 1e-12));
    CHECK(step(damped).second == without);
    MESSAGE("ratio " << ratio << ": stable step " << step(damped).first << " s, without " << without << " s");
    // Stiffness-proportional damping of the same ratio at the middle of the band allows a far shorter step.
    const double beta = 2 * ratio / (2 * M_PI * std::sqrt(20.0)), highest = 2 / without;
    CHECK(step_for(highest * highest, beta * highest * highest) < 0.3 * step(damped).first);
  }
}

TEST_CASE("damping over a band does not change the position of rest") {
  BodySpec spec = beam_body("beam", {0, 0}, {3, 0}, rectangle_section(0.1, 0.2), "steel", 4);
  spec.frame->joints[0].support = held;
  const auto sag = [&](const std::optional<BandDamping>& band) {
    Material steel = elastic_material("steel", 7850, 2.1e11);
    steel.band = band;
    ModelBuilder builder;
    builder.gravity = {0, -10};
    builder.add_material(steel);
    builder.add_body(spec);
    const Model<2> model = builder.build();
    State<2> state = start_state(model);
    REQUIRE(find_equilibrium(model, state).converged);
    return state.position[1].y();
  };
  CHECK(near(sag(BandDamping{0.1, 1, 50}), sag(std::nullopt), 1e-9));
}

TEST_CASE("damping over a band: the tangent matches central differences") {
  Material steel = elastic_material("steel", 7850, 2.1e11);
  steel.band = BandDamping{0.1, 1, 50};
  const Model<2> model = of_frames(steel, {beam_body("beam", {0, 0}, {2, 1}, rectangle_section(0.1, 0.2), "steel", 1)});
  State<2> state = start_state(model);
  for (std::size_t i = 0; i < state.beam_memory.size(); ++i)
    state.beam_memory[i] = 1e4 * std::sin(1.0 + static_cast<double>(i));
  state.position[1] += Vec2(1e-3, -2e-3), state.rotation[0] = 1e-3, state.rotation[1] = -2e-3;
  for (const double dt : {1e-4, 1e-2, 1.0}) {
    const BeamBlock block = beam_block(model, state, model.beams[0], 0, dt);
    for (int column = 0; column < 6; ++column) {
      const double way = column % 3 == 2 ? 1e-6 : 1e-6;
      std::array<std::array<double, 6>, 2> force{};
      for (const int side : {0, 1}) {
        State<2> moved = state;
        dof_of(moved, column / 3, column % 3) += side == 0 ? way : -way;
        Work<2> work;
        internal_forces(model, moved, work, dt);
        for (int n = 0; n < 2; ++n) {
          const Vec2 f = work.element_force[n] + work.element_damping[n];
          force[side][3 * n] = f.x(), force[side][3 * n + 1] = f.y();
          force[side][3 * n + 2] = work.element_moment[n] + work.element_damping_moment[n];
        }
      }
      for (int row = 0; row < 6; ++row)
        CHECK(std::abs((force[0][row] - force[1][row]) / (2 * way) - block(row, column)) <
              1e-6 * block.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("damping over a band: impossible bands are rejected") {
  CHECK_THROWS_WITH_AS(damping_branches({0.02, 5, 5}), doctest::Contains("its end must be above its beginning"),
                       InputError);
  CHECK_THROWS_WITH_AS(damping_branches({0.02, 1e-4, 1e4}), doctest::Contains("is wider than 6.3 decades"), InputError);
  CHECK_THROWS_WITH_AS(damping_branches({0.15, 1, 1000}), doctest::Contains("would be 5.9 times as stiff"), InputError);
  CHECK_THROWS_AS(damping_branches({0.3, 1, 20}), InputError);
  CHECK_THROWS_AS(damping_branches({0, 1, 20}), InputError);
}

TEST_CASE("damping over a band: the fit is within a tenth all over bands of any width") {
  for (const double to : {1.5, 3.0, 10.0, 100.0, 3000.0, 1e6})
    for (const double ratio : {0.005, 0.02, 0.05}) {
      const DampingBranches b = damping_branches({ratio, 1, to});
      double worst = 0;
      for (int i = 0; i <= 100; ++i) {
        const double w = 2 * M_PI * std::pow(to, i / 100.0);
        worst = std::max(worst, std::abs(0.5 * b.loss(w) / b.stiffness(w) / ratio - 1));
      }
      CHECK(worst < 0.1);
      MESSAGE("to " << to << ", " << ratio << ": " << b.count << " branches, stiffer by " << b.stiffening() - 1
                    << ", off by " << worst);
    }
}

}  // namespace trilith::testing
