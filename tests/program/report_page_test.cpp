// `trilith report`, and its page printed by headless Chromium. PDF and picture stay in tests/report_pages/ of the build
// tree.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "draw/chart/stored_motion.hpp"
#include "program/verb.hpp"
#include "run/falling_span.hpp"
#include "source_dir.hpp"

using namespace trilith;
using testing::Output;
using testing::run_program;

namespace {

bool is_missing(const std::filesystem::path& program) {
  if (!program.empty() && std::filesystem::exists(program)) return false;
  MESSAGE("skipped: ", program.empty() ? "trilith" : program.string(), " is not there");
  return true;
}

std::filesystem::path page_folder() {
  const auto folder = testing::program_path().parent_path().parent_path() / "tests" / "report_pages";
  std::filesystem::create_directories(folder);
  return folder;
}

/// Output of Chromium for the page: a PDF, or a picture of its first screen.
std::string browsed(const testing::Folder& here, const std::filesystem::path& page, const std::string& to,
                    const std::string& options) {
  const std::filesystem::path out = page_folder() / to;
  std::filesystem::remove(out);
  const std::string command = fmt::format(
      "HOME='{0}' timeout 60 chromium --headless=new --disable-gpu --hide-scrollbars --user-data-dir='{0}/profile' {1} "
      "{2}'{3}' 'file://{4}' > '{0}/browser.txt' 2>&1",
      here.path.string(), ::getuid() == 0 ? "--no-sandbox" : "", options, out.string(), page.string());
  CHECK(std::system(command.c_str()) == 0);
  return testing::bytes_of(out);
}

}  // namespace

TEST_CASE("the report of the bridge prints on a few pages and names the first failure" * doctest::test_suite("long")) {
  if (is_missing(testing::program_path()) || is_missing("/usr/bin/chromium")) return;
  const testing::Folder here;
  const Output run =
      run_program(here.path, fmt::format("run '{}/scripts/bridge.lua' --quiet out=bridge.h5", testing::source_dir()));
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "report bridge.h5").out == "bridge.report.html\n");
  const std::string page = testing::bytes_of(here / "bridge.report.html");
  CHECK(page.size() < 1'500'000);
  CHECK(page.find("The first failure occurred at") != std::string::npos);
  CHECK(page.find("spectra of all motions") != std::string::npos);
  CHECK(page.find("could not be drawn") == std::string::npos);
  const std::string pdf =
      browsed(here, here / "bridge.report.html", "bridge.pdf", "--no-pdf-header-footer --print-to-pdf=");
  CHECK(pdf.starts_with("%PDF"));
  int pages = 0;  // the root of the tree of pages has the largest count
  for (std::size_t at = pdf.find("/Count "); at != std::string::npos; at = pdf.find("/Count ", at + 1))
    pages = std::max(pages, std::atoi(pdf.c_str() + at + 7));
  CHECK(pages >= 5);
  CHECK(pages <= 14);
  CHECK(browsed(here, here / "bridge.report.html", "bridge.png", "--window-size=900,6000 --screenshot=").size() >
        100'000);
}

TEST_CASE("a stopped run is reported, with a notice of trilith report") {
  if (is_missing(testing::program_path())) return;
  const testing::Folder here;
  {
    Simulation<2> simulation(testing::falling_span());
    Recording<2> recording(here / "early.h5", simulation.model(), simulation.state());
    StageOptions o;
    o.duration = 0.1;
    o.frame_interval = 0.02;
    simulation.run(o, recording.listener());
    CHECK(run_program(here.path, "report early.h5").prints("the run is in progress"));
    recording.abandon("the power went");
  }
  CHECK(run_program(here.path, "report early.h5 -o stopped.html").prints("the run was stopped"));
  CHECK(testing::bytes_of(here / "stopped.html").find("the run stopped early") != std::string::npos);
}

TEST_CASE("the report takes ground motions from the results file, and each body followed its motion") {
  if (is_missing(testing::program_path())) return;
  const testing::Folder here;
  std::ofstream(here / "shake.lua") << R"(
local trilith = require "trilith"
local m = trilith.model { name = "two supports" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 } }
local one = m:block { name = "one", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
local two = m:block { name = "two", width = 2, height = 0.2, at = { 3, -0.2 }, material = "stone", support = "fixed" }
m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0 }, material = "stone" }
m:results { file = "shake.h5" }
m:consolidate { duration = 2 }
local motion = trilith.motion "elcentro_1940_rest_ns.csv"
m:shake { motions = { { body = one, x = motion }, { body = two, x = motion:delay(0.1), y = motion:scale { factor = 0.1 } } },
  duration = 1 }
m:shake { body = one, x = motion:scale { factor = 2 }, duration = 0.5 }
)";
  REQUIRE(run_program(here.path, "run shake.lua --quiet").code == 0);
  std::filesystem::remove(here / "shake.lua");
  const std::vector<results::MotionRow> rows = results::ResultsReader(here / "shake.h5").motions();
  REQUIRE(rows.size() == 4);
  CHECK(rows[1].first_sample == rows[0].first_sample);  // a delayed copy
  CHECK(run_program(here.path, "report shake.h5").code == 0);
  const std::string page = testing::bytes_of(here / "shake.report.html");
  CHECK(page.find("<h1>two supports</h1>") != std::string::npos);
  CHECK(page.find("From the samples in the results file") != std::string::npos);
  CHECK(page.find("records were not found") == std::string::npos);
  const results::ResultsReader reader(here / "shake.h5");
  for (const double miss : draw::motion_misses(reader, rows)) CHECK(miss < 1e-14);
  const Output shown = run_program(here.path, "motion shake.h5 --number 4 -o pictures/motion.svg");
  CHECK(shown.code == 0);
  CHECK(shown.prints("2792 at 0.02 s"));
  CHECK(std::filesystem::exists(here / "pictures" / "motion.svg"));
  testing::check_refused(run_program(here.path, "motion shake.h5 --number 5"), "has motions 1 to 4");
}

TEST_CASE("trilith report rejects wrong output names and foreign files") {
  if (is_missing(testing::program_path())) return;
  const testing::Folder here;
  testing::check_refused(run_program(here.path, "report nothing.h5"), "there is no such file");
  std::ofstream(here / "text.h5") << "no results";
  testing::check_refused(run_program(here.path, "report text.h5"), "not an HDF5 file");
  { results::ResultsWriter(here / "empty.h5", testing::sample_header()).finish(); }
  testing::check_refused(run_program(here.path, "report empty.h5 -o page.pdf"), "end with .html");
  testing::check_refused(run_program(here.path, "report empty.h5 -o text.h5/where/page.html"), "cannot write");
  const Output made = run_program(here.path, "report empty.h5 -o new/folder/page.html");
  CHECK(made.out == "new/folder/page.html\n");
  CHECK(made.err.find("note: made folder new/folder") != std::string::npos);
  CHECK(run_program(here.path, "report").code == 2);
  CHECK(run_program(here.path, "report empty.h5").out == "empty.report.html\n");
}
