// A plate on four cables (VALIDATION T34): links without bending stiffness, which carry load by the geometric stiffness
// of the weight.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "model/space_builder/solid_model_builder.hpp"
#include "near.hpp"
#include "physics/space/space_implicit.hpp"

namespace trilith::testing {
namespace {

constexpr double drop = 2, plate_length = 1, width = 0.6;
const Vec3 sides(plate_length, width, 0.02);

/// A plate of 1 m x 0.6 m at z = 0 on four rods of 2 m at its corners, each pinned at both ends. The rods are light, so
/// that they act as cables; their own swing changes a period by a share of 1e-4. `motion`: velocity of a point of the
/// plate; velocities of the cables decrease in proportion to the height above the plate.
class HungPlate {
 public:
  explicit HungPlate(const Vec3& velocity, double twist) {
    builder_.gravity = Vec3(0, 0, -standard_gravity);
    builder_.set_contact("*", "*", "none");
    SolidSpec beam = body("ceiling", box_at({1.2, 0.8, 0.1}, {0, 0, drop + 0.05}), 100);
    beam.support.fill(Support::fixed);
    builder_.add_body(beam);
    SolidSpec plate = body("plate", box_at(sides, Vec3::Zero()), 30);
    plate.velocity = velocity, plate.spin = Vec3(0, 0, twist);
    builder_.add_body(plate);
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) add_cable({x * plate_length, y * width, 0}, velocity, twist);
  }
  [[nodiscard]] Model<3> model() { return builder_.build(); }

 private:
  static SolidSpec body(const std::string& name, const Polyhedron& piece, double mass) {
    SolidSpec spec;
    spec.name = name, spec.pieces = {piece}, spec.mass = mass, spec.floating = true;
    return spec;
  }
  void add_cable(const Vec3& foot, const Vec3& velocity, double twist) {
    const std::string name = "cable " + std::to_string(++cables_);
    const Vec3 head = foot + drop * Vec3::UnitZ(), at_foot = velocity + cross(Vec3(0, 0, twist), foot);
    SolidSpec cable = body(name, box_at({0.01, 0.01, drop}, 0.5 * (foot + head)), 1e-3);
    // The cable's head is fixed: v_foot = spin x (foot - head).
    cable.velocity = 0.5 * at_foot, cable.spin = Vec3(at_foot.y(), -at_foot.x(), 0) / drop;
    builder_.add_body(cable);
    pin(name + " head", "ceiling", name, head);
    pin(name + " foot", name, "plate", foot);
  }
  void pin(const std::string& name, const std::string& a, const std::string& b, const Vec3& at) {
    BearingSpecOf<3> link;
    link.name = name, link.body_a = a, link.body_b = b, link.point_a = link.point_b = at;
    link.law = {Linear{1e8, 0}, Linear{1e8, 0}, Linear{1e8, 0}, {}, {}, {}};
    builder_.add_bearing(link);
  }
  SolidModelBuilder builder_;
  int cables_ = 0;
};

struct Swing {
  double period, widest;  ///< [s]; amplitude in the unit of the measure
};

/// Mean period of `of` over three swings, by its upward passages through 0, and its amplitude.
Swing swing_of(const Vec3& velocity, double twist, const std::function<double(const State<3>&, std::size_t)>& of) {
  Simulation<3> sim(HungPlate(velocity, twist).model());
  const std::size_t plate = node_called(sim.model(), "plate");
  double before = 0, time = 0, first = -1, last = -1, widest = 0;
  int rises = 0;
  const auto see = [&](const Instant<3>& now) {
    const double value = of(now.state, plate);
    widest = std::max(widest, std::abs(value));
    if (before < 0 && value >= 0) {
      last = time + (now.state.time - time) * before / (before - value), ++rises;
      if (first < 0) first = last;
    }
    before = value, time = now.state.time;
  };
  const StageReport report = sim.run(steps_in_space(AlphaMethod::hht(-0.05), 12, 5e-3), after_each_step(see));
  INFO(report.reason);
  CHECK(report.end == StageEnd::time);
  REQUIRE(rises > 3);
  return {(last - first) / (rises - 1), widest};
}

TEST_CASE("T34: a plate on four cables sways equally in both directions and twists by its radius of gyration") {
  const double g = standard_gravity, sway = 2 * M_PI * std::sqrt(drop / g), angle = radians(1);
  const double gyration = std::hypot(plate_length, width) / std::sqrt(12), arm = 0.5 * std::hypot(plate_length, width);
  REQUIRE(near(sway, 2.83749, 1e-5));
  REQUIRE(near(sway * gyration / arm, 1.63823, 1e-5));
  const double speed = 2 * M_PI / sway * angle * drop;
  for (const int k : {0, 1}) {
    const Vec3 velocity = speed * Vec3::Unit(k);
    const Swing s = swing_of(velocity, 0, [k](const State<3>& now, std::size_t n) { return now.position[n][k]; });
    MESSAGE("sway along " << (k == 0 ? "x" : "y") << ": " << s.period << " s, " << s.widest / drop << " rad");
    CHECK(near(s.period, 2.83749, 5e-3));
    CHECK(near(s.widest, angle * drop, 0.02));
  }
  const double twist = angle * drop / arm, spin = twist * 2 * M_PI / 1.63823;
  const Swing s = swing_of(Vec3::Zero(), spin, [](const State<3>& now, std::size_t n) {
    const Vec3 along = turn_of(now.rotation[n]).apply(Vec3::UnitX());
    return std::atan2(along.y(), along.x());
  });
  MESSAGE("twist: " << s.period << " s, " << s.widest << " rad");
  CHECK(near(s.period, 1.63823, 5e-3));
  CHECK(near(s.widest, twist, 0.02));
}

}  // namespace
}  // namespace trilith::testing
