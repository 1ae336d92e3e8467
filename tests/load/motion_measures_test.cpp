#include "load/motion_measures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "load/motion_check.hpp"
#include "load/motion_read.hpp"
#include "load/motion_summary.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

struct ManifestRow {
  std::string file;
  std::size_t count = 0;
  double dt = 0, duration = 0, pga = 0, t_pga = 0, pgv = 0, t_pgv = 0, pgd = 0, t_pgd = 0, v_end = 0, u_end = 0;
};

std::vector<ManifestRow> manifest(const std::filesystem::path& folder) {
  std::ifstream file(folder / "manifest.csv");
  std::string line;
  std::getline(file, line);
  std::vector<ManifestRow> rows;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::stringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    REQUIRE(cells.size() == 13);
    const auto number = [&cells](std::size_t i) { return std::stod(cells[i]); };
    rows.push_back({cells[0], std::stoul(cells[3]), number(2), number(4), number(5), number(6), number(7), number(8),
                    number(9), number(10), number(11), number(12)});
  }
  return rows;
}

/// 0.1 % of the listed value, plus half of its last digit.
bool agrees(double ours, double listed, double last_digit) {
  return std::abs(ours - listed) <= 1e-3 * std::abs(listed) + last_digit / 2;
}

void check_row(const std::filesystem::path& folder, const ManifestRow& row) {
  CAPTURE(row.file);
  const GroundMotion motion = read_motion(folder / row.file);
  const auto [a, v, u] = motion_peaks(motion);
  CHECK(motion.samples().size() == row.count);
  CHECK(motion.step() == row.dt);
  CHECK(near(motion.duration(), row.duration, 1e-9));
  CHECK(agrees(a.value / standard_gravity, row.pga, 1e-5));
  CHECK(agrees(v.value * 100, row.pgv, 1e-3));
  CHECK(agrees(u.value * 100, row.pgd, 1e-3));
  CHECK(std::abs(a.time - row.t_pga) <= 0.00051);
  CHECK(std::abs(v.time - row.t_pgv) <= 0.00051);
  CHECK(std::abs(u.time - row.t_pgd) <= 0.00051);
  CHECK(std::abs(motion.samples().back().velocity * 100 - row.v_end) <= 1e-3);
  CHECK(std::abs(motion.samples().back().displacement * 100 - row.u_end) <= 2e-3);
  CHECK(why_not_usable(motion) == "");
}

}  // namespace

TEST_CASE("D8: every record has the peaks of the manifest and is usable") {
  const auto folder = record_folder();
  if (!folder) return;
  const auto rows = manifest(*folder);
  CHECK(rows.size() == 71);
  for (const ManifestRow& row : rows) check_row(*folder, row);
}

TEST_CASE("the project's own records have the peaks of their source") {
  const auto [a, v, u] = motion_peaks(read_motion(own_record("elcentro_1940_rest_ns.csv")));
  CHECK(near(a.value, 0.34874 * standard_gravity, 1e-4));
  CHECK(near(a.time, 3.14, 1e-12));
  CHECK(near(v.value, 0.33437, 1e-4));
  CHECK(near(u.value, -0.13670, 1e-4));
  CHECK(near(motion_peaks(read_motion(own_record("elcentro_1940_rest_up.csv"))).acceleration.value,
             -0.21006 * standard_gravity, 1e-4));
}

TEST_CASE("Arias intensity and CAV of a triangle that changes its sign are exact") {
  const GroundMotion motion(std::vector<double>{0, 3, -3, 0}, 0.5);
  // Integral of a^2: three legs of 3^2 * 0.5 / 3; of |a|: two triangles of 3 * 0.5 / 2 and one pair of 3 * 0.25 / 2.
  CHECK(near(arias_intensity(motion), std::numbers::pi / (2 * standard_gravity) * 4.5, 1e-14));
  CHECK(near(cumulative_absolute_velocity(motion), 0.75 + 0.75 + 0.75, 1e-14));
}

TEST_CASE("Arias intensity and CAV of a sine meet the closed forms") {
  std::vector<double> a;
  const int n = 2000;
  for (int i = 0; i <= n; ++i) a.push_back(2 * std::sin(2 * std::numbers::pi * i / n));
  const GroundMotion motion(a, 1.0 / n);
  CHECK(near(arias_intensity(motion), std::numbers::pi / (2 * standard_gravity) * 2.0, 1e-5));
  CHECK(near(cumulative_absolute_velocity(motion), 4 / std::numbers::pi, 1e-5));
}

TEST_CASE("scaled by f, Arias grows as f^2 and CAV as f, and with time times f both grow as f") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  CHECK(near(arias_intensity(motion.scaled(3)), 9 * arias_intensity(motion), 1e-12));
  CHECK(near(cumulative_absolute_velocity(motion.scaled(-3)), 3 * cumulative_absolute_velocity(motion), 1e-12));
  CHECK(near(arias_intensity(motion.time_scaled(0.8)), 0.8 * arias_intensity(motion), 1e-12));
  CHECK(near(significant_duration(motion.time_scaled(0.8), 0.05, 0.95).length(),
             0.8 * significant_duration(motion, 0.05, 0.95).length(), 1e-9));
}

TEST_CASE("the significant duration of a constant acceleration is the given part of its length") {
  const GroundMotion motion = GroundMotion(std::vector<double>{1, 1, 1, 1, 1}, 2.5).delayed(1);
  const TimeSpan span = significant_duration(motion, 0.05, 0.75);
  CHECK(near(span.begin, 1.5, 1e-12));
  CHECK(near(span.end, 8.5, 1e-12));
  CHECK(near(significant_duration(motion, 0, 1).length(), 10, 1e-12));
  CHECK_THROWS_AS(significant_duration(motion, 0.5, 0.5), InputError);
  CHECK_THROWS_AS(significant_duration(motion, 0.5, 1.5), InputError);
  CHECK(significant_duration(GroundMotion(std::vector<double>{0, 0}, 1), 0.05, 0.95).length() == 0);
}

TEST_CASE("the bracketed duration runs between the exact crossings of the level") {
  const GroundMotion motion(std::vector<double>{0, 1, 0, 0, -1, 0}, 1);
  const TimeSpan span = bracketed_duration(motion, 0.25);
  CHECK(near(span.begin, 0.25, 1e-12));
  CHECK(near(span.end, 4.75, 1e-12));
  CHECK(near(bracketed_duration(motion, 1).begin, 1, 1e-12));
  CHECK(near(bracketed_duration(motion, 1).end, 4, 1e-12));
  CHECK(bracketed_duration(motion, 1.001).length() == 0);
  CHECK(near(bracketed_duration(GroundMotion(std::vector<double>{1, 1}, 1), 1).length(), 1, 1e-12));
  CHECK_THROWS_AS(bracketed_duration(motion, 0), InputError);
}

TEST_CASE("the traces are the samples") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_up.csv")).delayed(0.5);
  const MotionTraces traces = motion_traces(motion);
  REQUIRE(traces.time.size() == motion.samples().size());
  CHECK(traces.time.front() == 0.5);
  CHECK(traces.acceleration[100] == motion.samples()[100].acceleration);
  CHECK(traces.velocity[100] == motion.samples()[100].velocity);
  CHECK(traces.displacement[100] == motion.samples()[100].displacement);
}

TEST_CASE("the summary names the motion, its figures and whether it can be used") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  const std::string text = motion_summary(motion);
  for (const std::string part :
       {"elcentro_1940_rest_ns.csv", "2792 at 0.02 s", "0.34874 g (3.4200 m/s2) at 3.140 s",
        "33.437 cm/s (13.164 in/s)", "CIT Volume II", "Arias", "CAV", "D5-95", "usable               yes"}) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
  CHECK(motion_summary(motion.with_start_velocity(0.5)).find("no: motion") != std::string::npos);
}
