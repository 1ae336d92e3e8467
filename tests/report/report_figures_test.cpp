// Figures of a report against closed forms: moved bodies, damage of joints, masses and largest values of events.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/quantity_text.hpp"
#include "report/report.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

bool page_says(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

/// The report of one frame in which the second body lies `way` [m] from its start.
std::string page_of_displaced(double way) {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  writer.begin_stage("rest", "dynamic", 0);
  SampleRow row(header, 0);
  row.position = header.node_position;
  row.position[2] += way;
  row.frame.position = row.position;
  row.append_to(writer);
  writer.end_stage(0, "rest");
  writer.finish();
  return report::report_page(ResultsReader(folder / "run.h5"));
}

}  // namespace

TEST_CASE("a body in plane has moved from half its depth on: area over its longest diagonal") {
  const double depth = 1 * 2 / std::sqrt(1 * 1 + 2 * 2);  // of 1 m x 2 m
  CHECK(page_says(page_of_displaced(0.52 * depth), "1 of 2 free bodies moved by more than half their depth"));
  CHECK(page_says(page_of_displaced(0.48 * depth), "no body moved by more than half its depth"));
}

TEST_CASE("the mean damage of a storey is over its joints with a bond") {
  const Folder folder;
  Header header = sample_header();
  for (const int bonded : {1, 0, 1, 0}) header.joints.push_back({0, 1, 0, bonded, {0.5, 0, 0}, {0.5, 1, 0}});
  for (const char* name : {"joint_opening", "joint_slip", "joint_damage"})
    header.fields.push_back({name, "m", "of each joint", 4, 1});
  const std::vector<std::vector<double>> damage{{0, 0, 0, 0}, {0, 0, 0, 0}, {0.5, 0, 0.25, 0}};
  ResultsWriter writer(folder / "run.h5", header);
  writer.begin_stage("rest", "dynamic", 0);
  SampleRow row(header, 0);
  row.frame.fields = damage;
  row.append_to(writer);
  writer.finish();
  CHECK(page_says(report::report_page(ResultsReader(folder / "run.h5")), ">37.5 %<"));
}

TEST_CASE("the masses of equal bodies are given from the smallest to the largest in any order") {
  const std::vector<double> none{0.0}, inertia{1.0}, outline{-0.5, -1, 0.5, -1, 0.5, 1, -0.5, 1};
  for (const std::array<double, 3>& masses :
       {std::array{120.0, 100.0, 110.0}, std::array{100.0, 110.0, 120.0}, std::array{110.0, 120.0, 100.0}}) {
    const Folder folder;
    Header header = sample_header(0);
    for (const double mass : masses) {
      const std::vector<double> at{mass, 0};
      header.add_rigid_body({"b", "rigid", "stone", "", "free"}, at, none, mass, inertia, outline);
    }
    { ResultsWriter(folder / "run.h5", header).finish(); }
    const std::string least = quantity_text(100, "kg"), most = quantity_text(120, "kg");
    CHECK(page_says(report::report_page(ResultsReader(folder / "run.h5")), fmt::format("{} to {}", least, most)));
  }
}

TEST_CASE("the largest value of a type of events is the one farthest from zero") {
  const Folder folder;
  ResultsWriter writer(folder / "run.h5", sample_header());
  writer.begin_stage("shake", "dynamic", 0);
  int id = 0;
  for (const double displacement : {0.02, -0.05, 0.03}) {
    EventRow event;
    event.id = id++, event.time = 0.1 * id, event.type = "bearing.failed";
    event.first = {"displacement", "m", displacement}, event.text = "failed";
    writer.append_event(event);
  }
  writer.finish();
  const std::string page = report::report_page(ResultsReader(folder / "run.h5"));
  CHECK(page_says(page, fmt::format("displacement {}", quantity_text(-0.05, "m"))));
}
