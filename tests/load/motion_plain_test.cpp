// Records of plain columns.
#include "load/motion_plain.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

TEST_CASE("two columns give time and acceleration in the stated unit") {
  const char* const text = "Station 7, NS\n# a note\n 0.00  10\n 0.02 -20\n\n 0.04;30\n";
  const GroundMotion motion = parse_plain_motion(text, "folder/ns.txt", {"cm/s2", {}});
  CHECK(motion.samples().size() == 3);
  CHECK(near(motion.step(), 0.02, 1e-14));
  CHECK(near(motion.samples()[1].acceleration, -0.2, 1e-14));
  CHECK(motion.source().title == "Station 7, NS");
  CHECK(motion.description() == "ns.txt");
}

TEST_CASE("accelerations alone, any number to a line, need their step") {
  const char* const text = "0.1 -0.2 0.3\n0.4 0.1\n";
  const GroundMotion motion = parse_plain_motion(text, "a.txt", {"g", 0.005});
  CHECK(motion.samples().size() == 5);
  CHECK(motion.step() == 0.005);
  CHECK(near(motion.samples()[3].acceleration, 0.4 * standard_gravity, 1e-14));
  CHECK_THROWS_WITH_AS(parse_plain_motion(text, "a.txt", {"g", {}}), doctest::Contains("give the time step"),
                       InputError);
}

TEST_CASE("an ambiguous plain record is rejected with its line") {
  const auto refused = [](const char* text, const PlainForm& form, const char* why) {
    CHECK_THROWS_WITH_AS(parse_plain_motion(text, "a.txt", form), doctest::Contains(why), InputError);
  };
  refused("0 1\n0.01 2\n", {"furlong", {}}, "must be one of g, m/s2");
  refused("0 1\n0.01 2\n0.05 3\n", {"m/s2", {}}, "the step must be uniform");
  refused("0 1\n0.01 2\n", {"m/s2", 0.02}, "dt is given as 0.02 s");
  refused("0 1\n0.01 x\n", {"m/s2", {}}, "line 2");
  refused("0 1\n0.01 2 3\n", {"m/s2", {}}, "has 3 columns");
  refused("0 100\n0.01 200\n", {"m/s2", {}}, "peak is 20.4 g with unit = \"m/s2\", above 5 g; probably");
  refused("title\n", {"m/s2", {}}, "no numbers");
  refused("1 1\n1 2\n", {"m/s2", {}}, "do not increase");
}
