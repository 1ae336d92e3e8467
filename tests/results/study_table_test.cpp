// The table of a study: read back, and damage that HDF5 itself does not detect.
#include "results/study/study_table.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "results/file/results.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using testing::bytes_of;
using testing::Folder;

TEST_CASE("a study's column of whole numbers wider than their own bytes is rejected, not read beyond memory") {
  const Folder folder;
  const std::filesystem::path path = folder / "study.h5";
  results::write_study_table(path, {{"case", "1", "number", std::vector<std::int32_t>{1, 2, 3}}}, {}, true);
  CHECK(results::read_study_table(path).size() == 1);
  // HDF5's encoding of the type of a signed 4-byte number; its last two bytes are the number of significant bits: 32.
  const std::string whole_number{"\x10\x08\x00\x00\x04\x00\x00\x00\x00\x00\x20\x00", 12};
  std::string bytes = bytes_of(path);
  int found = 0;
  for (std::size_t at = bytes.find(whole_number); at != std::string::npos;
       at = bytes.find(whole_number, at + 1), ++found)
    bytes[at + 10] = '\xff';
  REQUIRE(found > 0);
  std::ofstream(path, std::ios::binary) << bytes;
  CHECK_THROWS_AS(results::read_study_table(path), results::ResultsError);
}

TEST_CASE("a study's column that lies outside of its rows is rejected, not read beyond memory") {
  const Folder folder;
  const std::filesystem::path path = folder / "study.h5";
  const std::vector<std::int32_t> numbers{1, 2, 3};
  results::write_study_table(path, {{"case", "1", "number", numbers}, {"status", "1", "code", numbers}}, {}, true);
  CHECK(results::read_study_table(path).size() == 2);
  // HDF5's encoding of a column: its name, padded to 8 bytes, and its place in the row.
  const std::string column{"status\0\0\x04\0\0\0", 12};
  std::string bytes = bytes_of(path);
  const std::size_t at = bytes.find(column);
  REQUIRE(at != std::string::npos);
  for (const int byte : {8, 9, 10}) {
    std::string damaged = bytes;
    damaged[at + byte] = '\xff';
    std::ofstream(path, std::ios::binary) << damaged;
    CHECK_THROWS_AS(results::read_study_table(path), results::ResultsError);
  }
}

namespace {

/// Exit code of a child process that reads a table and exits in order, with the library's clean-up; 1000 plus the
/// number of the signal if one ended it.
int end_of_reading(const std::filesystem::path& path) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(30);
    try {
      results::read_study_table(path);
    } catch (const results::ResultsError&) {
      std::exit(7);
    }
    std::exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a table whose head leads beyond its end is rejected by a process that then ends in order") {
  const Folder folder;
  const std::filesystem::path path = folder / "study.h5";
  results::write_study_table(path, {{"case", "1", "number", std::vector<std::int32_t>{1, 2, 3}}}, {}, true);
  CHECK(end_of_reading(path) == 0);
  // The root's messages continue at another place: type and size of this message, then position (8 bytes) and length (8
  // bytes).
  const std::string goes_on{"\x10\x00\x10\x00\x00\x00\x00\x00", 8};
  std::string bytes = bytes_of(path);
  const std::size_t at = bytes.find(goes_on);
  REQUIRE(at < 200);
  bytes[at + 8 + 8 + 3] = '\xdf';
  std::ofstream(path, std::ios::binary) << bytes;
  CHECK(end_of_reading(path) == 7);
}
