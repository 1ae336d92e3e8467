#include "run/progress.hpp"

#include <doctest/doctest.h>

#include "model/event/event_text.hpp"
#include "near.hpp"
#include "run/falling_span.hpp"
#include "run/listeners.hpp"

using namespace trilith;
using testing::near;

namespace {

Event event_of(EventType type, std::int64_t id, double time, std::int64_t cause = -1) {
  Event e;
  e.type = type;
  e.id = id;
  e.time = time;
  e.cause = cause;
  e.body_a = 4;
  e.body_b = 3;
  e.bearing = 1;
  e.value = type == EventType::impact ? 3 : 0.051;
  e.text = "right seat";
  return e;
}

bool has(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the speed of progress is averaged over the last seconds and gives the remaining time") {
  Pace pace;
  CHECK(pace.speed() == 0);
  CHECK_FALSE(pace.left(1));
  for (int i = 0; i <= 100; ++i) pace.add(0.01 * i, 0.1 * i);  // a tenth of real time for ten seconds
  CHECK(near(pace.speed(), 0.1, 1e-12));
  CHECK(near(*pace.left(2), 10, 0.02));
  for (int i = 1; i <= 100; ++i) pace.add(1 + 0.1 * i, 10 + 0.1 * i);  // then as fast as real time
  CHECK(near(pace.speed(), 1, 0.01));
  pace.reset();
  CHECK(pace.speed() == 0);
}

TEST_CASE("durations of wall clock are written as m:ss or h:mm:ss") {
  CHECK(duration_text(0) == "0:00");
  CHECK(duration_text(44.2) == "0:45");
  CHECK(duration_text(125) == "2:05");
  CHECK(duration_text(7390) == "2:03:10");
  CHECK(duration_text(1e300) == "277777:46:40");
}

TEST_CASE("the status line has stage, time, step, energy and out-of-balance ratio") {
  Simulation<2> simulation(testing::falling_span());
  std::string status;
  StageOptions o;
  o.name = "consolidation";
  o.duration = 0.02;
  RunListener<2> listener;
  Pace pace;
  listener.on_step = [&](const Instant<2>& now) {
    pace.add(now.state.time, 10 * now.state.time + 0.1 * static_cast<double>(now.state.step));
    status = status_text(now, pace);
  };
  simulation.run(o, listener);
  for (const char* part : {"consolidation  t 0.0", "step ", "dt ", "x real time", "kinetic ", "unbalanced ", " left"})
    CHECK_MESSAGE(has(status, part), status);
  CHECK(status.find('\n') == std::string::npos);
}

TEST_CASE("the line of an event names its cause") {
  const Model<2> model = testing::falling_span();
  EventLines lines;
  CHECK(lines.tell(event_of(EventType::bearing_failed, 1, 11.02), model).at(0) ==
        "    11.020 s  bearing failed   bearing right failed at 51 mm");
  CHECK(lines.tell(event_of(EventType::seat_lost, 2, 12.43, 1), model).at(0) ==
        "    12.430 s  seat lost        span lost its seat on P2 (right seat)  "
        "(because at 11.020 s: bearing right failed at 51 mm)");
}

TEST_CASE("contacts made and lost and slow impacts are listed only if all events are requested") {
  const Model<2> model = testing::falling_span();
  const Event made = event_of(EventType::contact_made, 1, 1), hit = event_of(EventType::impact, 2, 1);
  EventLines important, all(EventShow::all), none(EventShow::none);
  CHECK(important.tell(made, model).empty());
  CHECK(important.tell(hit, model).size() == 1);
  CHECK(all.tell(made, model).size() == 1);
  CHECK(none.tell(hit, model).empty());
  Event touch = hit;
  touch.value = 0.7;
  CHECK(important.tell(touch, model).empty());
  CHECK(all.tell(touch, model).size() == 1);
  CHECK(EventLines(EventShow::important, 0.5).tell(touch, model).size() == 1);
}

TEST_CASE("many impacts at once are counted, not listed") {
  const Model<2> model = testing::falling_span();
  EventLines lines;
  std::size_t told = 0;
  for (int i = 0; i < 100; ++i) told += lines.tell(event_of(EventType::impact, i, 1 + 0.001 * i), model).size();
  CHECK(told == 12);
  const std::vector<std::string> next = lines.tell(event_of(EventType::impact, 100, 3), model);
  REQUIRE(next.size() == 2);
  CHECK(has(next[0], "88 more: impact"));
  CHECK(lines.rest().empty());
}

TEST_CASE("every type of event has its own text") {
  const Model<2> model = testing::falling_span();
  std::vector<std::string> seen;
  for (int t = 0; t < event_types; ++t) {
    const Event e = event_of(static_cast<EventType>(t), t, 1);
    const std::string text = event_text(e, model);
    CHECK_FALSE(text.empty());
    CHECK_FALSE(info_of(e.type).heading.empty());
    CHECK(std::find(seen.begin(), seen.end(), text) == seen.end());
    seen.push_back(text);
  }
  Event ended = event_of(EventType::stage_ended, 1, 1);
  ended.text = "first: shaking: rest";
  CHECK(event_text(ended, model) == "first: shaking ended (rest)");
}

TEST_CASE("two listeners both receive the events of a run, in their order") {
  Simulation<2> simulation(testing::falling_span());
  std::string heard;
  RunListener<2> first, second;
  first.on_event = [&](const Event&, const Instant<2>&) { heard += "1"; };
  second.on_event = [&](const Event&, const Instant<2>&) { heard += "2"; };
  int steps = 0;
  second.on_step = [&](const Instant<2>&) { ++steps; };
  StageOptions o;
  o.duration = 0.001;
  simulation.run(o, both(first, second));
  CHECK(heard.starts_with("12"));
  CHECK(heard.ends_with("12"));
  CHECK(steps > 0);
}

TEST_CASE("event times count from a stage or an event after its start, with a notice") {
  const Model<2> model = testing::falling_span();
  EventLines lines(EventShow::important, slow_impact, "shake");
  CHECK(lines.waits());
  CHECK(lines.tell(event_of(EventType::bearing_failed, 1, 9), model).at(0).starts_with("     9.000 s"));
  Event begun = event_of(EventType::stage_begun, 2, 10);
  begun.text = "shake";
  const std::vector<std::string> told = lines.tell(begun, model);
  REQUIRE(told.size() == 2);
  CHECK(told[0] == "    10.000 s  times count from here on");
  CHECK(told[1].starts_with("     0.000 s  stage begun"));
  CHECK_FALSE(lines.waits());
  CHECK(lines.zero() == 10);
  const std::string lost = lines.tell(event_of(EventType::seat_lost, 3, 12.43, 1), model).at(0);
  CHECK(lost.starts_with("     2.430 s  seat lost"));
  CHECK(has(lost, "(because at -1.000 s: bearing right failed"));

  EventLines of_type(EventShow::important, slow_impact, "seat.lost");
  CHECK(of_type.tell(event_of(EventType::seat_lost, 1, 12.43), model).at(1).starts_with("     0.000 s  seat lost"));
}
