#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cstdio>
#include <iostream>
#include <random>

#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

void write_rows(const std::filesystem::path& path, int rows) {
  const Header header = sample_header();
  ResultsWriter writer(path, header);
  for (int i = 0; i < rows; ++i) SampleRow(header, i).append_to(writer);
  writer.finish();
}

std::string message_of_opening(const std::filesystem::path& path) {
  try {
    const ResultsReader reader(path);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "opened";
}

// Runs in a child process whose files may not exceed `limit` [B]: 0 if `work` ended as expected and the process ended
// in order.
template <class Work>
int with_file_limit(rlim_t limit, Work work) {
  std::fflush(nullptr);
  std::cout.flush();
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit then fails with EFBIG, as on a full disk with ENOSPC
    const struct rlimit bound = {limit, limit};
    ::setrlimit(RLIMIT_FSIZE, &bound);
    std::exit(work());  // not _exit: HDF5's own clean-up at exit is part of the test
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

// Writes until the file is full. 0: one clear error, repeated by every later call.
int write_until_full(const std::filesystem::path& path, WriterOptions options) {
  const Header header = sample_header();
  ResultsWriter writer(path, header, options);
  std::string first;
  for (int i = 0; i < 200000; ++i) {
    try {
      SampleRow(header, i).append_to(writer);
      if (i % 10 == 9) writer.flush();
    } catch (const ResultsError& error) {
      first = error.what();
      break;
    }
  }
  if (first.find("run.h5") == std::string::npos || first.find("safe in") == std::string::npos) return 1;
  try {
    writer.finish();
  } catch (const ResultsError& error) {
    return error.what() == first ? 0 : 2;
  }
  return 3;
}

// Number of rejected ones of 150 damaged copies of `whole`.
int read_damaged(const std::filesystem::path& path, const std::string& whole) {
  std::mt19937 random(11);
  int refused = 0;
  for (int trial = 0; trial < 150; ++trial) {
    std::string damaged = whole;
    for (int i = 0; i < 5; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    write_text(path, damaged);
    try {
      const ResultsReader reader(path);
      for (std::size_t i = 0; i < reader.frame_count(); ++i) reader.frame(i);
      reader.events();
      reader.energy();
      reader.stages();
      reader.notes();
      reader.history("top.x");
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  return refused;
}

}  // namespace

TEST_CASE("a full disk gives one clear error without a crash and keeps the flushed rows") {
  for (const rlim_t limit : {1000000u, 1234567u, 3000001u}) {
    const Folder folder;
    INFO("limit ", limit);
    CHECK(with_file_limit(limit, [&] { return write_until_full(folder / "run.h5", {.sync = false}); }) == 0);
    CHECK(!std::filesystem::exists(folder / "run.h5"));
    CHECK(!std::filesystem::exists(folder / "run.h5.new"));
    const ResultsReader reader(folder / "run.h5");
    CHECK(!reader.finished());
    REQUIRE(reader.frame_count() > 50);
    for (std::size_t i = 0; i < reader.frame_count(); ++i) CHECK(has_row(reader, static_cast<int>(i)));
    CHECK(reader.history("base shear").size() == reader.frame_count());
  }
}

TEST_CASE("a disk that is full from the start leaves no file behind") {
  for (const rlim_t limit : {0u, 100u, 5000u, 20000u}) {
    const Folder folder;
    INFO("limit ", limit);
    const int code = with_file_limit(limit, [&] {
      try {
        ResultsWriter(folder / "run.h5", sample_header(), {.sync = false});
      } catch (const ResultsError&) {
        return 0;
      }
      return 1;
    });
    CHECK(code == 0);
    CHECK(std::filesystem::is_empty(folder.path));
  }
}

TEST_CASE("a disk that fills while the clean copy is written keeps the rows and shows no finished file") {
  const Folder folder;
  const Header header = sample_header();
  const int code = with_file_limit(RLIM_INFINITY, [&] {
    ResultsWriter writer(folder / "run.h5", header, {.sync = false});
    std::mt19937_64 random(1);  // numbers that do not compress
    std::vector<double> noise(6);
    for (int i = 0; i < 3000; ++i) {
      for (double& number : noise) number = static_cast<double>(random());
      const SampleRow row(header, i);
      FrameRow frame = row.frame;
      frame.velocity = noise;
      writer.append_frame(frame);
    }
    writer.flush();
    const struct rlimit bound = {100000, 100000};
    ::setrlimit(RLIMIT_FSIZE, &bound);
    try {
      writer.finish();
    } catch (const ResultsError&) {
      return 0;
    }
    return 1;
  });
  CHECK(code == 0);
  CHECK(!std::filesystem::exists(folder / "run.h5"));
  CHECK(!std::filesystem::exists(folder / "run.h5.new"));
  CHECK(ResultsReader(folder / "run.h5").frame_count() == 3000);
}

TEST_CASE("places that cannot be written are rejected with the reason") {
  const Folder folder;
  const Header header = sample_header();
  const auto refusal = [&](const std::filesystem::path& path) -> std::string {
    try {
      ResultsWriter(path, header);
    } catch (const ResultsError& error) {
      return error.what();
    }
    return "written";
  };
  CHECK(refusal(folder / "none/run.h5").find("there is no folder") != std::string::npos);
  CHECK(refusal(folder.path).find("is a folder") != std::string::npos);
  CHECK(refusal("/dev/full").find("is not a regular file") != std::string::npos);
  CHECK(refusal("/proc/run.h5").find("cannot be written") != std::string::npos);
  CHECK(refusal("").find("is a folder") != std::string::npos);
  write_text(folder / "thesis.h5", "forty pages");
  CHECK(refusal(folder / "thesis.h5").find("is not a Trilith results file") != std::string::npos);
  CHECK(bytes_of(folder / "thesis.h5") == "forty pages");
  write_text(folder / "run.h5.part", "forty pages");
  CHECK(refusal(folder / "run.h5").find("is not a Trilith results file") != std::string::npos);
  CHECK(bytes_of(folder / "run.h5.part") == "forty pages");
  for (const std::string& left : {std::string(), std::string(100, '\0'), std::string("\x89HDF\r\n\x1a\n junk")}) {
    write_text(folder / "run.h5.part", left);
    CHECK(refusal(folder / "run.h5") == "written");
  }
}

TEST_CASE("a file that is not a results file is rejected with its kind") {
  const Folder folder;
  const auto mentions = [](const std::string& message, const char* part) {
    return message.find(part) != std::string::npos;
  };
  CHECK(mentions(message_of_opening(folder / "none.h5"), "there is no such file"));
  CHECK(mentions(message_of_opening(folder.path), "is a folder"));
  write_text(folder / "empty.h5", "");
  CHECK(mentions(message_of_opening(folder / "empty.h5"), "is empty"));
  write_text(folder / "text.h5", "not HDF5 at all");
  CHECK(mentions(message_of_opening(folder / "text.h5"), "is not an HDF5 file"));
}

TEST_CASE("a part file without rows is reported in one line") {
  const Folder folder;
  write_rows(folder / "run.h5", 3);
  const std::string whole = bytes_of(folder / "run.h5");
  for (const std::size_t length : {0, 1, 8, 48, 100, 1000, 4096, 5000, 8192}) {
    for (const bool zeros : {false, true}) {
      const std::string left = zeros ? std::string(length, '\0') : whole.substr(0, length);
      write_text(folder / "cut.h5.part", left);
      const std::string message = message_of_opening(folder / "cut.h5");
      INFO(length, " bytes, ", zeros ? "zeros: " : "of a file: ", message);
      CHECK(message.find("its run was stopped before the first rows were written") != std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("a results file cut at any length is an error, never a crash, and never a shorter result") {
  const Folder folder;
  write_rows(folder / "run.h5", 60);
  const std::string whole = bytes_of(folder / "run.h5");
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t length = random() % (whole.size() - 1);
    write_text(folder / "cut.h5", whole.substr(0, length));
    INFO("cut to ", length, " of ", whole.size());
    CHECK(message_of_opening(folder / "cut.h5") != "opened");
  }
  write_text(folder / "cut.h5", whole.substr(0, whole.size() - 1));
  CHECK(message_of_opening(folder / "cut.h5").find("cut") != std::string::npos);
}

TEST_CASE("a results file with damaged bytes is read or rejected, never a crash") {
  const Folder folder;
  write_rows(folder / "run.h5", 20);
  const std::string whole = bytes_of(folder / "run.h5");
  // In its own process, which exits without HDF5's clean-up: the library does not release objects that it could not
  // open, and reports them at exit.
  const pid_t child = ::fork();
  if (child == 0) ::_exit(read_damaged(folder / "damaged.h5", whole) > 0 ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
