#include "run/study/processes.hpp"

#include <doctest/doctest.h>

#include <map>

#include "results/sample_run.hpp"

using namespace trilith;

namespace {

ProcessOrder shell(const testing::Folder& folder, const std::string& text, const char* name) {
  return {
      {"/bin/sh", "-c", text}, folder.path / (std::string(name) + ".out"), folder.path / (std::string(name) + ".err")};
}

struct Ends {
  std::map<std::size_t, ProcessEnd> of;
  int at_work = 0, most = 0;
  ProcessWatch watch() {
    return {[this](std::size_t) { most = std::max(most, ++at_work); },
            [this](std::size_t n, const ProcessEnd& end) {
              --at_work;
              of[n] = end;
            },
            [] { return true; }};
  }
};

}  // namespace

TEST_CASE("processes end with their code or signal, and their output is kept") {
  const testing::Folder folder;
  const std::vector<ProcessOrder> orders{shell(folder, "echo out; echo err >&2", "a"),
                                         shell(folder, "exit 3", "b"),
                                         shell(folder, "kill -9 $$", "c"),
                                         {{"/no/such/program"}, folder / "d.out", folder / "d.err"}};
  Ends ends;
  CHECK(run_processes(orders, 2, ends.watch()));
  REQUIRE(ends.of.size() == 4);
  CHECK(ends.of[0].trouble().empty());
  CHECK(testing::bytes_of(folder / "a.out") == "out\n");
  CHECK(testing::bytes_of(folder / "a.err") == "err\n");
  CHECK(ends.of[1].trouble() == "ended with code 3");
  CHECK(ends.of[2].trouble() == "ended by signal 9 (Killed)");
  CHECK(ends.of[3].trouble() == "the program could not be started");
}

TEST_CASE("no more processes run at a time than were requested") {
  const testing::Folder folder;
  std::vector<ProcessOrder> orders;
  for (int i = 0; i < 7; ++i) orders.push_back(shell(folder, "sleep 0.05", "x"));
  Ends ends;
  CHECK(run_processes(orders, 3, ends.watch()));
  CHECK(ends.of.size() == 7);
  CHECK(ends.most == 3);
}

TEST_CASE("processes that are to stop are interrupted and waited for") {
  const testing::Folder folder;
  const std::vector<ProcessOrder> orders{
      shell(folder, "trap 'echo interrupted; exit 1' INT; echo begun; while :; do sleep 0.02; done", "a")};
  Ends ends;
  ProcessWatch watch = ends.watch();
  watch.goes_on = [&] { return testing::bytes_of(folder / "a.out").empty(); };
  CHECK_FALSE(run_processes(orders, 1, watch));
  CHECK(ends.of.empty());
  CHECK(testing::bytes_of(folder / "a.out") == "begun\ninterrupted\n");
}

TEST_CASE("a process waits for its dependency, starts after it, and is skipped if it never ends") {
  const testing::Folder folder;
  std::vector<ProcessOrder> orders;
  for (int i = 0; i < 6; ++i) orders.push_back(shell(folder, i == 0 ? "sleep 0.3" : "sleep 0.02", "x"));
  Ends ends;
  ProcessWatch watch = ends.watch();
  std::vector<std::size_t> begun;
  watch.begun = [&](std::size_t n) { begun.push_back(n), ++ends.at_work; };
  // 3 after the slow 0; 4 after 1; 5 never; 2 at once.
  watch.turn = [&](std::size_t n) {
    if (n == 5) return OrderTurn::never;
    if (n >= 3 && !ends.of.contains(n - 3)) return OrderTurn::later;
    return OrderTurn::now;
  };
  CHECK(run_processes(orders, 2, watch));
  CHECK(ends.of.size() == 5);
  CHECK(begun == std::vector<std::size_t>{0, 1, 2, 4, 3});
}
