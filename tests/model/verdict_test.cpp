#include "model/verdict.hpp"

#include <doctest/doctest.h>

using namespace trilith;

TEST_CASE("a run is reliable until the earliest of its faults, in whatever order they are added") {
  const auto until = [](bool early_first) {
    Verdict verdict;
    for (const bool early : {early_first, !early_first})
      if (early)
        verdict.add(EventType::body_passed, 2, 0, "early");
      else
        verdict.add(EventType::bond_skipped, 5, 0, "late");
    CHECK_FALSE(verdict.sound());
    return verdict.sound_until();
  };
  CHECK(until(true) == 2);
  CHECK(until(false) == 2);
  Verdict other;
  other.add(EventType::body_passed, 5, 0, "late"), other.add(EventType::bond_skipped, 2, 0, "early");
  CHECK(other.sound_until() == 2);
  other.fail(1, "check");
  CHECK(other.sound_until() == 1);
}

TEST_CASE("bodies that leave the bounds are counted, and the run remains reliable") {
  CHECK(Verdict::counts(EventType::body_left));
  CHECK(Verdict::counts(EventType::body_passed));
  CHECK_FALSE(Verdict::counts(EventType::impact));
  Verdict verdict;
  verdict.add(EventType::body_left, 1, 0, "left");
  CHECK(verdict.left() == 1);
  CHECK(verdict.sound());
  CHECK(verdict.sound_until() == 0);
}
