#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <random>
#include <thread>

#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

// Runs `work` in a child process that ends without the parent's destructors in any case.
template <class Work>
pid_t in_child(Work work) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  int code = 99;
  try {
    code = work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "child: %s\n", error.what());
  }
  ::_exit(code);
}

int wait_for(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

// Writes rows until it is killed; each row count made safe by a flush is sent to `report`.
int write_until_killed(const std::filesystem::path& path, int report, WriterOptions options, int flush_every) {
  const Header header = sample_header();
  ResultsWriter writer(path, header, options);
  writer.begin_stage("shake", "dynamic", 0);
  for (int i = 0;; ++i) {
    SampleRow(header, i).append_to(writer);
    if (i % flush_every != 0) continue;
    writer.flush();
    const int safe = i + 1;
    if (::write(report, &safe, sizeof safe) != sizeof safe) return 1;
  }
}

// The last count in the pipe, or 0.
int last_report(int pipe) {
  int safe = 0, value = 0;
  while (::read(pipe, &value, sizeof value) == sizeof value) safe = value;
  return safe;
}

struct Killed {
  int safe = 0;
  std::filesystem::path path;
};

Killed write_and_kill(const std::filesystem::path& path, std::chrono::microseconds after, WriterOptions options,
                      int flush_every) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = in_child([&] { return write_until_killed(path, ends[1], options, flush_every); });
  ::close(ends[1]);
  int first = 0;
  REQUIRE(::read(ends[0], &first, sizeof first) == sizeof first);
  std::this_thread::sleep_for(after);
  ::kill(child, SIGKILL);
  const int status = wait_for(child);
  CHECK(WIFSIGNALED(status));
  const int safe = std::max(first, last_report(ends[0]));
  ::close(ends[0]);
  return {safe, path};
}

bool has_all_rows(const ResultsReader& reader, int rows) {
  if (reader.frame_count() < static_cast<std::size_t>(rows)) return false;
  const std::vector<double> shear = reader.history("base shear");
  const EnergyTable energy = reader.energy();
  const std::vector<EventRow> events = reader.events();
  for (std::size_t i = 0; i < reader.frame_count(); ++i) {
    const int row = static_cast<int>(i);
    if (!has_row(reader, row) || shear.at(i) != -3.0 * row || energy.terms.at(1).at(i) != 2.0 * row ||
        events.at(i).id != row)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a run killed at any moment keeps every row its last flush reported") {
  const Folder folder;
  std::mt19937 random(20251121);
  std::uniform_int_distribution<int> microseconds(0, 60000);
  const char* trials = std::getenv("TRILITH_KILLS");
  const int kills = trials ? std::atoi(trials) : 30;
  std::size_t rows = 0;
  for (int trial = 0; trial < kills; ++trial) {
    const WriterOptions options = {.sync = trial % 3 == 0};
    const Killed killed =
        write_and_kill(folder / "run.h5", std::chrono::microseconds(microseconds(random)), options, 1 + trial % 5);
    const ResultsReader reader(folder / "run.h5");
    INFO("trial ", trial, ", rows reported ", killed.safe, ", rows read ", reader.frame_count());
    CHECK(reader.path() == folder / "run.h5.part");
    CHECK(!reader.finished());
    CHECK(!reader.running());
    CHECK(has_all_rows(reader, killed.safe));
    CHECK(reader.stages().size() == 1);
    CHECK(!reader.stages().at(0).ended);
    rows += reader.frame_count();
  }
  CHECK(!std::filesystem::exists(folder / "run.h5"));
  MESSAGE(kills, " kills, ", rows, " rows read back");
}

TEST_CASE("a killed run is repaired into a clean file with all its rows, still marked unfinished") {
  const Folder folder;
  const Killed killed = write_and_kill(folder / "run.h5", std::chrono::milliseconds(40), {}, 3);
  repair(folder / "run.h5", folder / "repaired.h5");
  const ResultsReader reader(folder / "repaired.h5");
  CHECK(!reader.finished());
  CHECK(has_all_rows(reader, killed.safe));
  CHECK(std::filesystem::exists(folder / "run.h5.part"));
  CHECK_THROWS_AS(repair(folder / "run.h5", folder / "run.h5.part"), ResultsError);
}

TEST_CASE("readers follow a run while it is written, up to its end") {
  const Folder folder;
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const int rows = 400;
  const pid_t child = in_child([&] {
    const Header header = sample_header();
    ResultsWriter writer(folder / "run.h5", header, {.sync = false});
    for (int i = 0; i < rows; ++i) {
      SampleRow(header, i).append_to(writer);
      writer.flush();
      if (i == 0 && ::write(ends[1], &i, sizeof i) != sizeof i) return 1;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    writer.finish();
    return 0;
  });
  ::close(ends[1]);
  int first = 0;
  REQUIRE(::read(ends[0], &first, sizeof first) == sizeof first);
  ResultsReader reader(folder / "run.h5");
  std::size_t seen = 0, grown = 0;
  bool was_running = false;
  int status = 0;
  bool ended = false;
  while (!(ended = ::waitpid(child, &status, WNOHANG) == child)) {
    const bool running = reader.running();
    try {
      reader.refresh();
    } catch (const ResultsError&) {
      CHECK(!std::filesystem::exists(folder / "run.h5.part"));  // it finished before the kill
      break;
    }
    CHECK(reader.frame_count() >= seen);
    if (reader.frame_count() > seen) ++grown;
    seen = reader.frame_count();
    if (running) was_running = true;
    REQUIRE(seen > 0);
    CHECK(has_row(reader, static_cast<int>(seen) - 1));
    CHECK(reader.events().size() >= seen);
  }
  ::close(ends[0]);
  if (!ended) status = wait_for(child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(was_running);
  CHECK(grown > 3);
  CHECK(has_all_rows(ResultsReader(folder / "run.h5"), rows));
}

TEST_CASE("an abandoned writer leaves a readable unfinished file and none of the final name") {
  const Folder folder;
  const Header header = sample_header();
  {
    ResultsWriter writer(folder / "run.h5", header);
    for (int i = 0; i < 20; ++i) SampleRow(header, i).append_to(writer);
  }
  CHECK(!std::filesystem::exists(folder / "run.h5"));
  const ResultsReader reader(folder / "run.h5");
  CHECK(!reader.finished());
  CHECK(!reader.running());
  CHECK(has_all_rows(reader, 20));
}

TEST_CASE("two runs cannot write one file, and the second does not affect the first") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  SampleRow(header, 0).append_to(writer);
  CHECK_THROWS_WITH_AS(ResultsWriter(folder / "run.h5", header), doctest::Contains("another run is writing it"),
                       ResultsError);
  writer.flush();
  {
    const ResultsReader reader(folder / "run.h5");
    CHECK(reader.running());
    CHECK(has_all_rows(reader, 1));
  }
  writer.finish();
  CHECK(has_all_rows(ResultsReader(folder / "run.h5"), 1));
}

TEST_CASE("an earlier results file is replaced only when the new run has finished") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter(folder / "run.h5", header).finish();
  {
    ResultsWriter writer(folder / "run.h5", header);
    SampleRow(header, 0).append_to(writer);
  }
  {
    const ResultsReader reader(folder / "run.h5");
    CHECK(reader.finished());
    CHECK(reader.frame_count() == 0);
    CHECK(reader.newer_part());
  }
  ResultsWriter writer(folder / "run.h5", header);
  SampleRow(header, 0).append_to(writer);
  writer.finish();
  CHECK(ResultsReader(folder / "run.h5").frame_count() == 1);
  CHECK(!ResultsReader(folder / "run.h5").newer_part());
}
