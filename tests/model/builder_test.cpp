// Input that a builder rejects, and its notes.
#include "model/builder/builder.hpp"

#include <doctest/doctest.h>

#include "model/plausible_ranges.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "run/contact_damping.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Error message for a bearing between two blocks of 1 m, side by side; empty if it is accepted.
std::string refusal(const BearingSpec& bearing) {
  Scene scene(Frictional{1e9, 5e8, 0.6, 0});
  scene.fixed("a", box(0, 0, 1, 1));
  scene.fixed("b", box(1, 0, 2, 1));
  try {
    scene.builder.add_bearing(bearing);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

BearingSpec spring(double x) {
  BearingSpec b;
  b.name = "B", b.body_a = "a", b.body_b = "b";
  b.law[along] = Linear{1e6, 0};
  b.point_a = {1, 0.5}, b.point_b = {x, 0.5};
  return b;
}

}  // namespace

TEST_CASE("a bearing without a law is rejected") {
  BearingSpec none = spring(1);
  none.law = {};
  CHECK(refusal(none).find("'B': has no law") != std::string::npos);
  for (const int k : {0, 1, 2}) {
    BearingSpec one = none;
    one.law[k] = Linear{1e6, 0};
    CHECK(refusal(one).empty());
  }
}

TEST_CASE("a bearing with a successor needs a limit") {
  BearingSpec endless = spring(1);
  endless.contact_after = "joint";
  CHECK(refusal(endless).find("becomes 'joint' at its limit, but has none") != std::string::npos);
  endless.contact_after = "", endless.becomes_bearing = "C";
  CHECK(refusal(endless).find("becomes 'C' at its limit, but has none") != std::string::npos);
  endless.limit[turning] = 0.1;
  CHECK(refusal(endless).empty());
}

TEST_CASE("a bearing point may be at most one body size away from its body") {
  const double size = std::sqrt(2.0);  // diagonal of a square of 1 m
  CHECK(refusal(spring(2 + 0.99 * size)).empty());
  CHECK(refusal(spring(2 + 1.01 * size)).find("is 1.43 m away from body 'b', which is 1.41 m large") !=
        std::string::npos);
}

TEST_CASE("a contact with a name of no body is an error, even if a body of that name is added later") {
  Scene scene(Frictional{1e9, 5e8, 0.6, 0});
  scene.builder.set_contact("stone", "late", "joint");
  scene.fixed("a", box(0, 0, 1, 1));
  REQUIRE(scene.builder.faults().size() == 1);
  CHECK(scene.builder.faults()[0] ==
        "contact of 'stone' and 'late': there is no material, group or body 'late'; known: *, stone");
  CHECK_THROWS_WITH_AS(scene.builder.build(), scene.builder.faults()[0].c_str(), InputError);
  scene.fixed("late", box(3, 0, 4, 1));
  CHECK(scene.builder.faults().empty());
  CHECK(scene.builder.build().bodies.size() == 2);
}

TEST_CASE("every pair of bodies that overlaps is a fault, the deepest first") {
  Scene scene(Frictional{1e9, 5e8, 0.6, 0});
  scene.fixed("a", box(0, 0, 1, 1));
  scene.fixed("b", box(0.9, 0, 2, 1));
  scene.fixed("c", box(1.7, 0, 2.7, 1));
  const std::vector<std::string> faults = scene.builder.faults();
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].find("bodies 'b' and 'c' overlap by 0.3 m") == 0);
  CHECK(faults[1].find("bodies 'a' and 'b' overlap by 0.1 m") == 0);
}

TEST_CASE("a number gets a note beyond its usual range and not within") {
  CHECK(plausibility_note("mu", "1", 2).empty());
  CHECK(plausibility_note("mu", "1", 2.01) ==
        "mu = 2.01 is above the usual 2: it is the tangent of the friction angle, as in "
        "math.tan(35*deg)");
  CHECK(plausibility_note("density", "kg/m3", 25).empty());
  CHECK(plausibility_note("density", "kg/m3", 24).find("density = 24 kg/m3 is below the usual 25 kg/m3") == 0);
  CHECK(plausibility_note("rate", "rad/s", -0.5).empty());
  CHECK(plausibility_note("rate", "rad/s", -0.6).find("is below the usual -0.5 rad/s") != std::string::npos);
  CHECK(plausibility_note("by", "rad", unbounded).empty());
  CHECK(plausibility_note("kn", "Pa/m", 1e300).empty());
}

TEST_CASE("the damping of a contact is beta times its frequency over two") {
  const double kn = 1e9, beta = 1e-4, mass = 2000;
  Scene scene(Frictional{kn, 0.5 * kn, 0.6, beta});
  scene.fixed("base", box(-1, -1, 2, 0));
  scene.block("low", box(0, 0, 1, 1), mass);
  scene.block("top", box(0, 1, 0.5, 2), 0.5 * mass);
  const Model<2> model = scene.builder.build();
  const std::vector<ContactDamping> found = contact_damping(model, find_joints(model));
  REQUIRE(found.size() == 2);
  for (const ContactDamping& c : found) {
    const bool on_base = model.bodies[c.body_a].name == "base" || model.bodies[c.body_b].name == "base";
    const double frequency = on_base ? std::sqrt(kn * 1 / mass) : std::sqrt(kn * 0.5 / (mass / 3));
    CHECK(near(c.frequency, frequency, 1e-9));
    CHECK(near(c.share, 0.5 * beta * frequency, 1e-9));
  }
}
