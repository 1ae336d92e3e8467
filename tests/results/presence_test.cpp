#include "results/file/presence.hpp"

#include <doctest/doctest.h>

using namespace trilith::results;

namespace {

EventRow row(const char* type, int body, double time) {
  EventRow out;
  out.type = type, out.body_a = body, out.time = time;
  return out;
}

}  // namespace

TEST_CASE("a body is followed from its addition until it is removed or leaves the bounds, both without the end") {
  const Presence presence({row("body.left", 0, 2), row("body.added", 1, 1), row("body.removed", 1, 3)}, 3);
  for (const double time : {0.0, 0.999, 1.0, 1.999, 2.0, 2.5, 2.999, 3.0, 10.0}) {
    CAPTURE(time);
    CHECK(presence.is_followed(0, time) == (time < 2));
    CHECK(presence.is_there(0, time));
    CHECK(presence.is_followed(1, time) == (time >= 1 && time < 3));
    CHECK(presence.is_followed(2, time));
  }
}
