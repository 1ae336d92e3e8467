// The equilibria of a path of loads, told as frames and samples of the stage that ends it.
#include "run/load_way.hpp"

#include "near.hpp"
#include "physics/statics_frames.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("every equilibrium of a path is told as a frame with its place and loads and the model is then as it was") {
  const Model<2> model = shallow_truss();
  LoadWay<2> way{model.point_loads, {}};
  LoadPathOptions how;
  how.first = how.longest = 0.02;
  const int apex = 1;
  how.goes_on = [&](const PathPoint& point, const State<2>& state) {
    way.points.push_back({state, point.factor});
    return state.position[apex].y() > -0.3;
  };
  State<2> end = initial_state(model);
  REQUIRE(follow_loads(model, end, how).end == PathEnd::arrived);
  REQUIRE(way.points.size() > 10);
  Model<2> loaded = model;
  for (PointLoad<2>& load : loaded.point_loads) load.force *= way.points.back().factor;

  for (const bool asked : {false, true}) {
    Simulation<2> sim(loaded, end);
    StageOptions stage;
    stage.name = "pushed", stage.duration = 1;
    stage.frame_interval = stage.history_interval = asked ? 0.1 : 0;
    std::vector<double> heights, forces;
    std::size_t samples = 0;
    RunListener<2> listener;
    listener.on_frame = [&](const Instant<2>& now) {
      heights.push_back(now.state.position[apex].y());
      forces.push_back(now.model.point_loads[0].force.y());
      CHECK(now.state.time == 0);
      if (forces.back() != 0) CHECK(now.ratio < 1e-6);
    };
    listener.on_history = [&](const Instant<2>&) { ++samples; };
    const StageReport report = sim.settle(stage, {}, listener, &way);
    CHECK(report.end == StageEnd::rest);
    CHECK(sim.model().point_loads[0].force == loaded.point_loads[0].force);
    CHECK(near(sim.state().position[apex].y(), end.position[apex].y(), 1e-9));
    // And one more of the end itself, as of any stage.
    CHECK(heights.size() == (asked ? way.points.size() + 1 : 0));
    CHECK(samples == heights.size());
    for (std::size_t i = 0; asked && i < way.points.size(); ++i) {
      CHECK(heights[i] == way.points[i].state.position[apex].y());
      CHECK(forces[i] == -way.points[i].factor);
    }
  }
}

TEST_CASE("a path whose points are strained beyond the limit is told up to there and ends as diverged") {
  Model<2> model = shallow_truss();
  LoadWay<2> way{model.point_loads, {}};
  LoadPathOptions how;
  how.first = how.longest = 0.02;
  const auto strain_of = [&](const State<2>& state) {
    const Beam& bar = model.beams[0];
    return std::abs((state.position[bar.node[1]] - state.position[bar.node[0]]).norm() / bar.length - 1);
  };
  double most = 0;
  how.goes_on = [&](const PathPoint& point, const State<2>& state) {
    way.points.push_back({state, point.factor});
    most = std::max(most, strain_of(state));
    return state.position[1].y() > 0.05;
  };
  State<2> end = initial_state(model);
  REQUIRE(follow_loads(model, end, how).end == PathEnd::arrived);
  REQUIRE(most > 0);
  for (const double share : {0.5, 2.0}) {
    for (Member& m : model.members) m.strain_limit = share * most;
    Model<2> loaded = model;
    for (PointLoad<2>& load : loaded.point_loads) load.force *= way.points.back().factor;
    Simulation<2> sim(loaded, end);
    StageOptions stage;
    stage.name = "pushed", stage.duration = 1, stage.frame_interval = 0.1;
    std::size_t frames = 0, strained = 0;
    RunListener<2> listener;
    listener.on_frame = [&](const Instant<2>& now) {
      ++frames;
      CHECK(strain_of(now.state) <= share * most);
    };
    listener.on_event = [&](const Event& e, const Instant<2>&) {
      strained += e.type == EventType::element_overstrained ? 1 : 0;
    };
    const StageReport report = sim.settle(stage, {}, listener, &way);
    if (share > 1) {
      CHECK(report.end == StageEnd::rest);
      CHECK(frames == way.points.size() + 1);
      continue;
    }
    CHECK(report.end == StageEnd::diverged);
    CHECK(strained == 1);
    CHECK(frames > 3);
    CHECK(frames < way.points.size());
    CHECK(report.reason.find("as the load factor of '" + way.loads.front().name + "' came to ") != std::string::npos);
    CHECK_THROWS_AS(sim.settle(stage, {}, listener), InputError);
  }
}

}  // namespace
}  // namespace trilith::testing
