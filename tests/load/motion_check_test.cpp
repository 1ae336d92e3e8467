#include "load/motion_check.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "load/contains.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Rest to rest, ending offset by the area under a velocity half sine: a = cos(pi t / T) on 0..T.
std::vector<double> fling(int n) {
  std::vector<double> a;
  for (int i = 0; i <= n; ++i) a.push_back(std::cos(std::numbers::pi * i / n));
  return a;
}

}  // namespace

TEST_CASE("a motion that is zero everywhere is rejected, even where drift is allowed") {
  const GroundMotion motion = GroundMotion(std::vector<double>{0, 0, 0}, 0.01).with_start_velocity(1);
  CHECK_THROWS_AS(check_usable(motion), InputError);
  CHECK(contains(why_not_usable(motion, Drift::allow), "zero everywhere"));
}

TEST_CASE("ground that still moves at the end is rejected above 10 % of PGV, whatever it did before") {
  // Up to 1 m/s and back to rest, 6 s of rest, and a final pulse to the given share of the peak velocity.
  const auto kicked_to = [](double part) {
    std::vector<double> a(100, 1.0);
    a.insert(a.end(), 100, -1.0);
    a.insert(a.end(), 600, 0.0);
    a.insert(a.end(), 10, part * 10);
    return GroundMotion(a, 0.01);
  };
  CHECK(why_not_usable(kicked_to(0.09)) == "");
  CHECK(why_not_usable(kicked_to(-0.09)) == "");
  CHECK(contains(why_not_usable(kicked_to(0.11)), "drifts"));
  CHECK(contains(why_not_usable(kicked_to(-0.11)), "drifts"));
  CHECK_NOTHROW(check_usable(kicked_to(0.11), Drift::allow));
}

TEST_CASE("the drift of a usable motion is reported above 1 % of PGV, with its velocity and displacement") {
  const auto ending_at = [](double part) {
    std::vector<double> a(100, 1.0);
    a.insert(a.end(), 100, -(1 - part));
    a.insert(a.end(), 200, 0.0);
    return GroundMotion(a, 0.01);
  };
  // The change of sign takes one interval, in which the velocity keeps 0.5 % of a second's gain; PGV is 0.99 m/s.
  CHECK(end_drift(ending_at(0.01)) == "");
  const GroundMotion drifting = ending_at(0.03);
  CHECK(why_not_usable(drifting) == "");
  CHECK(contains(end_drift(drifting), "25 mm/s at the end (2.52 % of PGV)"));
  CHECK(contains(end_drift(drifting.reversed()), "25 mm/s at the end (2.52 % of PGV)"));
  CHECK(end_drift(GroundMotion(fling(200), 0.01)) == "");
}

TEST_CASE("ground that travels one way is rejected above 5 % of PGV") {
  const auto travelling_at = [](double part) {
    std::vector<double> a(100, 1.0);
    a.insert(a.end(), 100, -(1 - part));
    a.insert(a.end(), 2000, 0.0);
    return GroundMotion(a, 0.01);
  };
  CHECK(why_not_usable(travelling_at(0.04)) == "");
  CHECK(contains(why_not_usable(travelling_at(0.06)), "drifts"));
}

TEST_CASE("a permanent offset reached at rest is not a drift") {
  const GroundMotion motion(fling(200), 0.01);
  CHECK(motion.samples().back().displacement > 0.2);
  CHECK(why_not_usable(motion) == "");
  CHECK(why_not_usable(motion.scaled(-7)) == "");
}

TEST_CASE("records integrated from rest that were moving at their start are rejected, with what to try") {
  const auto folder = record_folder();
  if (!folder) return;
  for (const std::string name : {"elcentro_1940_cit_ns.csv", "elcentro_1940_cit_ew.csv", "elcentro_1940_cit_up.csv"}) {
    CAPTURE(name);
    const GroundMotion motion = read_motion(*folder / name);
    CHECK(why_not_usable(motion) == "");
    const GroundMotion from_rest = motion.with_start_velocity(0).with_start_displacement(0);
    CHECK_THROWS_AS(check_usable(from_rest), InputError);
    CHECK_NOTHROW(check_usable(from_rest.with_start_velocity(balanced_start_velocity(from_rest))));
    CHECK_NOTHROW(check_usable(from_rest, Drift::allow));
    for (const double factor : {0.01, 3.0})
      CHECK_THROWS_AS(check_usable(from_rest.scaled(factor).time_scaled(0.8)), InputError);
  }
  const GroundMotion ns = read_motion(*folder / "elcentro_1940_cit_ns.csv").with_start_velocity(0);
  const std::string why = why_not_usable(ns);
  CHECK(contains(why, "drifts: 2.51 m in 53.74 s"));
  CHECK(contains(why, "zero mean velocity needs -4.6"));
  CHECK(near(balanced_start_velocity(ns), -0.0467, 0.005));
}
