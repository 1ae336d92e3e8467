#include "field/field_step.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

/// A slab of 1 m2 with cells at n + 1 points: linear elements with the mean of lumped and consistent capacity.
Field slab(double length, int n, double conductivity, double density_times_heat, double start) {
  Field field;
  const double dx = length / n;
  for (int i = 0; i <= n; ++i) {
    field.capacity.push_back(density_times_heat * dx * (i == 0 || i == n ? 0.5 : 1));
    field.start.push_back(start);
    if (i > 0) field.links.push_back({i - 1, i, conductivity / dx, density_times_heat * dx / 12});
  }
  return field;
}

FieldState advanced(const Field& field, double duration, int steps, const std::vector<FieldLink>& contacts = {}) {
  const auto shared = std::make_shared<const Field>(field);
  FieldSolver solver;
  FieldState state;
  for (int i = 0; i < steps; ++i) solver.advance(shared, contacts, duration / steps, state);
  return state;
}

double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum;
}

FieldCourse constant(double value) {
  FieldCourse course;
  course.value = {value};
  return course;
}

}  // namespace

// Carslaw and Jaeger 1959, section 3.3: the series for a slab whose face is stepped, other face insulated.
TEST_CASE("a slab with a stepped face follows the series solution") {
  Field field = slab(0.2, 20, 1.5, 2200 * 900, 0);
  field.surroundings.push_back({"step", constant(1)});
  field.held.push_back({0, 0});
  for (const auto& [hours, far, middle] : {std::array{1.0, 0.013537, 0.175783}, std::array{2.0, 0.111022, 0.342425},
                                           std::array{4.0, 0.351371, 0.539944}}) {
    const FieldState s = advanced(field, 3600 * hours, static_cast<int>(60 * hours));
    CHECK(near(s.value[20], far, 0.005));
    CHECK(near(s.value[10], middle, 0.005));
  }
}

TEST_CASE("a slab in air cools as the series solution of Biot number 4 over 3") {
  Field field = slab(0.2, 20, 1.5, 2200 * 900, 1);
  field.surroundings.push_back({"air", constant(0)});
  field.exchange.push_back({0, 0, 10});
  for (const auto& [hours, far, face] : {std::array{1.0, 0.998218, 0.702674}, std::array{4.0, 0.886924, 0.524921},
                                         std::array{12.0, 0.545429, 0.316766}}) {
    const FieldState s = advanced(field, 3600 * hours, static_cast<int>(30 * hours));
    CHECK(near(s.value[20], far, 0.005));
    CHECK(near(s.value[0], face, 0.005));
  }
}

TEST_CASE("two slabs with a joint exchange heat as the series solution, and conserve it") {
  Field field = slab(0.1, 20, 2, 2300 * 900, 10);
  const Field other = slab(0.1, 20, 2, 2300 * 900, 0);
  for (const FieldLink& l : other.links) field.links.push_back({l.a + 21, l.b + 21, l.conductance, l.capacity});
  field.capacity.insert(field.capacity.end(), other.capacity.begin(), other.capacity.end());
  field.start.insert(field.start.end(), other.start.begin(), other.start.end());
  const std::vector<FieldLink> joint{{20, 21, 20.0}};
  const double before = content_of(field, {});
  for (const auto& [seconds, at_joint, outside] :
       {std::array{600.0, 0.625277, 0.998904}, std::array{3600.0, 0.375292, 0.784956},
        std::array{14400.0, 0.111291, 0.234751}}) {
    const FieldState s = advanced(field, seconds, static_cast<int>(seconds / 20), joint);
    CHECK(near((s.value[20] - s.value[21]) / 10, at_joint, 0.005));
    CHECK(near((s.value[0] - s.value[41]) / 10, outside, 0.005));
    CHECK(near(content_of(field, s), before, 1e-12));
  }
  const FieldState apart = advanced(field, 14400, 100);
  CHECK(apart.value[41] == 0.0);
}

TEST_CASE("steps of a field are of second order, also after a jump of a surrounding") {
  Field field = slab(0.2, 20, 1.5, 2200 * 900, 0);
  field.surroundings.push_back({"air", constant(1)});
  field.exchange.push_back({0, 0, 10});
  const double exact = advanced(field, 7200, 4096).value[10];
  const double coarse = std::abs(advanced(field, 7200, 16).value[10] - exact);
  const double fine = std::abs(advanced(field, 7200, 32).value[10] - exact);
  CHECK(coarse / fine > 3.4);
  CHECK(coarse / fine < 4.8);
}

TEST_CASE("a jump of a held cell decays without oscillation in steps of any length") {
  Field field = slab(0.2, 20, 1.5, 2200 * 900, 0);
  field.surroundings.push_back({"step", constant(1)});
  field.held.push_back({0, 0});
  const FieldState s = advanced(field, 1e9, 2);
  for (const double v : s.value) CHECK(near(v, 1, 1e-3));
}

TEST_CASE("the heat that surroundings supply is the change of the content") {
  Field field = slab(0.2, 10, 1.5, 2200 * 900, 5);
  FieldCourse season;
  season.time = {0, 5000, 10000}, season.value = {0, 30, 10}, season.period = 20000;
  field.surroundings.push_back({"air", season});
  field.surroundings.push_back({"ground", constant(12)});
  field.exchange.push_back({0, 0, 15});
  field.held.push_back({10, 1});
  const FieldState s = advanced(field, 50000, 70);
  const double gained = content_of(field, s) - content_of(field, {});
  CHECK(near(total(s.supplied), gained, 1e-11));
  CHECK(near(s.clock, 50000, 1e-12));
}

TEST_CASE("a course is linear between its points, repeats with its period, and refuses disorder") {
  FieldCourse course;
  course.time = {0, 10, 30}, course.value = {0, 20, 0}, course.period = 40, course.start = 100;
  CHECK(course.at(105) == 10.0);
  CHECK(course.at(120) == 10.0);
  CHECK(course.at(135) == 0.0);
  CHECK(course.at(145) == 10.0);
  CHECK(course.at(95) == 0.0);
  check_course(course, "air");
  course.period = 30;
  CHECK_THROWS_AS(check_course(course, "air"), InputError);
  course.period = 0, course.time[2] = 10;
  CHECK_THROWS_AS(check_course(course, "air"), InputError);
}

TEST_CASE("links between the same cells are added, in the order of cells") {
  std::vector<FieldLink> links{{2, 3, 1.0, 0.5}, {0, 1, 2.0}, {2, 3, 4.0, 0.25}};
  merge_links(links);
  REQUIRE(links.size() == 2);
  CHECK(links[0] == FieldLink{0, 1, 2.0});
  CHECK(links[1] == FieldLink{2, 3, 5.0, 0.75});
}

}  // namespace trilith::testing
