// `trilith report`, and its page printed by headless Chromium. PDF and picture stay in tests/report_pages/ of the build
// tree.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "program/verb.hpp"
#include "run/falling_span.hpp"
#include "source_dir.hpp"

using namespace trilith;
using testing::ask;
using testing::Said;

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

/// What Chromium makes of the page: a PDF, or a picture of its first screen.
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

TEST_CASE("the report of the bridge prints on a few pages and names what failed first" * doctest::test_suite("long")) {
  if (is_missing(testing::program_path()) || is_missing("/usr/bin/chromium")) return;
  const testing::Folder here;
  const Said run =
      ask(here.path, fmt::format("run '{}/scripts/bridge.lua' --quiet out=bridge.h5", testing::source_dir()));
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(ask(here.path, "report bridge.h5").out == "bridge.report.html\n");
  const std::string page = testing::bytes_of(here / "bridge.report.html");
  CHECK(page.size() < 1'500'000);
  CHECK(page.find("The first failure came at") != std::string::npos);
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

TEST_CASE("a run that was stopped is reported, and trilith report says so") {
  if (is_missing(testing::program_path())) return;
  const testing::Folder here;
  {
    Simulation<2> simulation(testing::falling_span());
    Recording<2> recording(here / "early.h5", simulation.model(), simulation.state());
    StageOptions o;
    o.duration = 0.1;
    o.frame_interval = 0.02;
    simulation.run(o, recording.listener());
    CHECK(ask(here.path, "report early.h5").says("the run still goes on"));
    recording.abandon("the power went");
  }
  CHECK(ask(here.path, "report early.h5 -o stopped.html").says("the run was stopped"));
  CHECK(testing::bytes_of(here / "stopped.html").find("the run ended before its end") != std::string::npos);
}

TEST_CASE("trilith report refuses what is no report and what is no results file") {
  if (is_missing(testing::program_path())) return;
  const testing::Folder here;
  testing::check_refused(ask(here.path, "report nothing.h5"), "there is no such file");
  std::ofstream(here / "text.h5") << "no results";
  testing::check_refused(ask(here.path, "report text.h5"), "not an HDF5 file");
  { results::ResultsWriter(here / "empty.h5", testing::sample_header()).finish(); }
  testing::check_refused(ask(here.path, "report empty.h5 -o page.pdf"), "ends with .html");
  testing::check_refused(ask(here.path, "report empty.h5 -o no/where/page.html"), "cannot write");
  CHECK(ask(here.path, "report").code == 2);
  CHECK(ask(here.path, "report empty.h5").out == "empty.report.html\n");
}
