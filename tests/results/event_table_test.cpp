#include "results/reading/event_table.hpp"

#include <doctest/doctest.h>

using namespace trilith;
using namespace trilith::results;

namespace {

EventRow row(std::int64_t id, double time, std::int64_t cause, const char* type, const char* text) {
  EventRow e;
  e.id = id;
  e.time = time;
  e.cause = cause;
  e.type = type;
  e.text = text;
  return e;
}

}  // namespace

TEST_CASE("the table of events lists each event below its cause, in order of time") {
  const std::string table = event_table(
      {row(0, 0, -1, "stage.begun", "shaking began"), row(1, 1, 0, "bearing.failed", "bearing A failed"),
       row(2, 1.5, 0, "bearing.failed", "bearing B failed"), row(3, 2, 1, "seat.lost", "span lost its seat"),
       row(4, 3, 99, "impact", "of a cause that is not listed")});
  CHECK(table ==
        "        time  event           what\n"
        "    0.0000 s  stage.begun     shaking began\n"
        "    1.0000 s  bearing.failed    bearing A failed\n"
        "    2.0000 s  seat.lost           span lost its seat\n"
        "    1.5000 s  bearing.failed    bearing B failed\n"
        "    3.0000 s  impact          of a cause that is not listed\n");
}

TEST_CASE("causes in a cycle are not followed") {
  const std::string table = event_table({row(0, 0, 1, "impact", "a"), row(1, 1, 0, "impact", "b")});
  CHECK(table.find("a\n") != std::string::npos);
  CHECK(table.find("b\n") != std::string::npos);
  CHECK(event_table({row(5, 0, 5, "impact", "its own cause")}).find("its own") != std::string::npos);
  CHECK(event_table({}) == "no events\n");
}

TEST_CASE("the table of events counts from the chosen origin, with a notice") {
  const std::string table =
      event_table({row(0, 1, -1, "stage.begun", "shake began"), row(1, 2.5, -1, "seat.lost", "span lost its seat")},
                  {1, "shake", "'shake' began"});
  CHECK(table ==
        "times count since 'shake' began\n"
        "        time  event        what\n"
        "    0.0000 s  stage.begun  shake began\n"
        "    1.5000 s  seat.lost    span lost its seat\n");
}
