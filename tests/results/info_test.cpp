#include "results/reading/info.hpp"

#include <doctest/doctest.h>

#include <chrono>

#include "results/file/provenance.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

bool mentions(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the info text has state, provenance, model, stages, events and energy") {
  const Folder folder;
  const Header header = sample_header();
  {
    ResultsWriter writer(folder / "run.h5", header);
    writer.begin_stage("settle", "rest", 0);
    for (int i = 0; i < 21; ++i) SampleRow(header, i).append_to(writer);
    writer.end_stage(0.2, "at rest");
    writer.begin_stage("shake", "dynamic", 0.2);
    writer.append_note(0.1, "a note");
    writer.flush();
    const std::string running = info_text(ResultsReader(folder / "run.h5"));
    CHECK(mentions(running, "run.h5.part: a run is writing it"));
    CHECK(mentions(running, "shake (dynamic): from 0.2 s, not ended"));
  }
  CHECK(mentions(info_text(ResultsReader(folder / "run.h5")), "NOT finished"));
  repair(folder / "run.h5", folder / "clean.h5");
  const std::string text = info_text(ResultsReader(folder / "clean.h5"));
  CHECK(mentions(text, "NOT finished"));
  CHECK(mentions(text, "trilith 1.0.0 (abc123)"));
  CHECK(mentions(text, "scripts/bridge.lua, 2 lines"));
  CHECK(mentions(text, "pga = 0.6 g (default 0.35): peak ground acceleration"));
  CHECK(mentions(text, "ground 2: same, reversed"));
  CHECK(mentions(text, "3: 3 rigid; 1 fixed, 2 free"));
  CHECK(mentions(text, "303 kg"));
  CHECK(mentions(text, "settle (rest): 0 s to 0.2 s, 0.2 s long; ended: at rest"));
  CHECK(mentions(text, "21, 0 s to 0.2 s"));
  CHECK(mentions(text, "base shear [N]: sum at the base"));
  CHECK(mentions(text, "21 bearing.failed, first at 0 s, last at 0.2 s"));
  CHECK(mentions(text, "largest residual 1e-09 J, 0 % of the largest term"));
  CHECK(mentions(text, "0.1 s: a note"));
}

TEST_CASE("the info text of a finished file mentions a later run next to it") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter(folder / "run.h5", header).finish();
  CHECK(mentions(info_text(ResultsReader(folder / "run.h5")), "run.h5: finished"));
  CHECK(!mentions(info_text(ResultsReader(folder / "run.h5")), "later run"));
  CHECK(newer_run_text(ResultsReader(folder / "run.h5")).empty());
  {
    const ResultsWriter writer(folder / "run.h5", header);
    CHECK(mentions(newer_run_text(ResultsReader(folder / "run.h5")), "a later run is writing"));
    CHECK(newer_run_text(ResultsReader(folder / "run.h5.part")).empty());
  }
  CHECK(mentions(info_text(ResultsReader(folder / "run.h5")), "a later run stopped early and left"));
}

TEST_CASE("a part file older than the finished file next to it is not a later run") {
  const Folder folder;
  const Header header = sample_header();
  { const ResultsWriter writer(folder / "run.h5", header); }
  std::filesystem::rename(folder / "run.h5.part", folder / "old");
  ResultsWriter(folder / "run.h5", header).finish();
  std::filesystem::rename(folder / "old", folder / "run.h5.part");
  const auto finished = std::filesystem::last_write_time(folder / "run.h5");
  std::filesystem::last_write_time(folder / "run.h5.part", finished - std::chrono::seconds(1));
  CHECK(newer_run_text(ResultsReader(folder / "run.h5")).empty());
  std::filesystem::last_write_time(folder / "run.h5.part", finished + std::chrono::seconds(1));
  CHECK_FALSE(newer_run_text(ResultsReader(folder / "run.h5")).empty());
}

TEST_CASE("provenance contains compiler, platform and time") {
  const Provenance here = provenance_here();
  CHECK(!here.compiler.empty());
  CHECK(mentions(here.platform, "Linux"));
  CHECK(here.start_time.size() == 20);
  CHECK(here.start_time[10] == 'T');
  CHECK(here.start_time.back() == 'Z');
}
