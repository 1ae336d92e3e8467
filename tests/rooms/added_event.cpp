// Sentence, severity and verdict follow from the row that docs/architecture.md adds. tests/rooms/add_an_event compiles
// it in a copy of the tree that has the row.
#include <fmt/format.h>

#include "model/event/event_text.hpp"
#include "model/verdict.hpp"

namespace {

int failed = 0;

void check(bool holds, const char* what) {
  fmt::print("{}: {}\n", holds ? "ok" : "FAILED", what);
  failed += holds ? 0 : 1;
}

}  // namespace

int main() {
  using namespace trilith;
  Model<2> model;
  model.bodies.resize(1);
  model.bodies[0].name = "pier";
  Event e;
  e.type = EventType::body_toppled;
  e.body_a = 0, e.value = 1.6;
  check(event_text(e, model) == "pier toppled over by 1.6 rad", "the sentence is the row's");
  check(severity_of("body.toppled") == Severity::loss, "the severity is the row's");
  check(is_of_note("body.toppled", e.value), "it is of note");
  Verdict verdict;
  verdict.add(e.type, 1, e.value, event_text(e, model));
  check(verdict.sound(), "a loss leaves the run valid");
  return failed;
}
