#include "base/nearest.hpp"

#include <doctest/doctest.h>

using namespace trilith;

TEST_CASE("edit distance counts a swap of neighbours as one change") {
  CHECK(edit_distance("tensoin", "tension") == 1);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("heights", "height") == 1);
  CHECK(edit_distance("height", "heights") == 1);
  CHECK(edit_distance("abcd", "a") == 3);
  CHECK(edit_distance("height", "height") == 0);
}

TEST_CASE("the nearest name is suggested only within a limit") {
  CHECK(nearest_name("heigth", {"width", "height", "depth"}) == "height");
  CHECK(nearest_name("zzzz", {"width", "height"}).empty());
}

TEST_CASE("an abbreviated word selects the only name that begins with it") {
  CHECK(nearest_name("kin", {"gravity", "kinetic"}) == "kinetic");
  CHECK(nearest_name("bea", {"bearing_elastic", "bearing_damping"}).empty());
  CHECK(nearest_name("ki", {"gravity", "kinetic"}).empty());
}

TEST_CASE("a former name is rejected with the present name") {
  CHECK(name_hint("until_rest", {"duration", "rest"}) == "; since version 1.0 it is 'rest'");
  CHECK(name_hint("ratio", {"duration", "rest"}) == "; since version 1.0 it is 'rest = { ratio = }'");
  CHECK(name_hint("damping", {"density", "beta"}) == "; since version 1.0 it is 'beta'");
  CHECK(name_hint("damping", {"duration", "local_damping"}) == "; since version 1.0 it is 'local_damping'");
  CHECK(name_hint("still", {"step"}) != "; since version 1.0 it is 'rest'");
}
