// Equilibria of a load path, recorded as frames and samples of the stage that ends it.
#include "run/load_way.hpp"

#include "near.hpp"
#include "physics/members/statics_frames.hpp"

namespace trilith::testing {
namespace {

TEST_CASE("every equilibrium of a path is recorded as a frame, and the model is unchanged afterwards") {
  const Model<2> model = shallow_truss();
  LoadWay<2> way{loads_of<PointLoad<2>>(model), {}};
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
  for (PointLoad<2>& load : loads_of<PointLoad<2>>(loaded)) load.force *= way.points.back().factor;

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
      forces.push_back(loads_of<PointLoad<2>>(now.model)[0].force.y());
      CHECK(now.state.time == 0);
      if (forces.back() != 0) CHECK(now.ratio < 1e-6);
    };
    listener.on_history = [&](const Instant<2>&) { ++samples; };
    const StageReport report = sim.settle(stage, {}, listener, &way);
    CHECK(report.end == StageEnd::rest);
    CHECK(loads_of<PointLoad<2>>(sim.model())[0].force == loads_of<PointLoad<2>>(loaded)[0].force);
    CHECK(near(sim.state().position[apex].y(), end.position[apex].y(), 1e-9));
    // Plus one of the end itself, as for any stage.
    CHECK(heights.size() == (asked ? way.points.size() + 1 : 0));
    CHECK(samples == heights.size());
    for (std::size_t i = 0; asked && i < way.points.size(); ++i) {
      CHECK(heights[i] == way.points[i].state.position[apex].y());
      CHECK(forces[i] == -way.points[i].factor);
    }
  }
}

TEST_CASE("points of a path have increasing times with their events, and time-dependent actions pause") {
  Model<2> model = shallow_truss();
  LoadWay<2> way{loads_of<PointLoad<2>>(model), {}};
  LoadPathOptions how;
  how.first = how.longest = 0.02;
  how.goes_on = [&](const PathPoint& point, const State<2>& state) {
    way.points.push_back({state, point.factor, point.length, {}});
    return state.position[1].y() > -0.3;
  };
  State<2> end = initial_state(model);
  REQUIRE(follow_loads(model, end, how).end == PathEnd::arrived);
  Event yielded;
  yielded.type = EventType::member_yielded, yielded.body_a = 0;
  way.points[5].events = {yielded};
  for (PointLoad<2>& load : loads_of<PointLoad<2>>(model)) load.force *= way.points.back().factor;
  PointLoad<2> other = loads_of<PointLoad<2>>(model)[0];
  other.name = "other", other.force = Vec2::Zero(), other.curve = {{-1, 1}, {0, 1}, false};
  loads_of<PointLoad<2>>(model).push_back(other);
  Simulation<2> sim(model, end);
  StageOptions stage;
  stage.name = "pushed", stage.duration = path_duration, stage.frame_interval = 10;
  std::vector<double> times;
  double told = -1;
  RunListener<2> listener;
  listener.on_frame = [&](const Instant<2>& now) {
    times.push_back(now.state.time);
    CHECK(near(loads_of<PointLoad<2>>(now.model).back().curve.at(now.state.time), 0.5, 1e-12));
  };
  listener.on_event = [&](const Event& e, const Instant<2>& now) {
    if (e.type != EventType::member_yielded) return;
    told = e.time;
    CHECK(e.cause >= 0);
    CHECK(now.state.position[1] == way.points[5].state.position[1]);
  };
  const StageReport report = sim.settle(stage, {}, listener, &way);
  REQUIRE(times.size() == way.points.size() + 1);
  CHECK(times.front() == 0);
  for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] > times[i - 1]);
  const double length = way.points.back().length, last = times[times.size() - 2];
  for (std::size_t i = 0; i < way.points.size(); ++i)
    CHECK(near(times[i], last * way.points[i].length / length, 1e-12));
  CHECK(times.back() == path_duration);
  CHECK(report.ended == path_duration);
  CHECK(sim.state().time == path_duration);
  CHECK(told == times[5]);
}

TEST_CASE("a path beyond the strain limit is recorded up to that point and ends as diverged") {
  Model<2> model = shallow_truss();
  LoadWay<2> way{loads_of<PointLoad<2>>(model), {}};
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
    for (PointLoad<2>& load : loads_of<PointLoad<2>>(loaded)) load.force *= way.points.back().factor;
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
    CHECK(report.reason.find("when the load factor of '" + way.loads.front().name + "' reached ") != std::string::npos);
    CHECK_THROWS_AS(sim.settle(stage, {}, listener), InputError);
  }
}

}  // namespace
}  // namespace trilith::testing
