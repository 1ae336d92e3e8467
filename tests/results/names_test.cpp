// Existing entries at the names of a results file, and their treatment.
#include <doctest/doctest.h>

#include "results/sample_run.hpp"
#include "results/study/study_table.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;
namespace fs = std::filesystem;

namespace {

void put_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A run of `rows` frames; abandoned unless `finished`.
std::string run_rows(const fs::path& path, int rows, bool finished) {
  const Header header = sample_header();
  ResultsWriter writer(path, header, {.sync = false});
  for (int i = 0; i < rows; ++i) SampleRow(header, i).append_to(writer);
  if (finished) writer.finish();
  return writer.kept_from_before();
}

std::string refusal_of(const fs::path& path) {
  try {
    run_rows(path, 1, true);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "written";
}

bool holds_text(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("finished results touch no file of a like name next to them and follow no link there") {
  const Folder folder;
  put_text(folder / "victim", "forty pages");
  fs::create_symlink(folder / "victim", folder / "run.h5.new");
  put_text(folder / "copy.h5.new", "forty pages");
  run_rows(folder / "run.h5", 3, true);
  repair(folder / "run.h5", folder / "copy.h5");
  CHECK(bytes_of(folder / "victim") == "forty pages");
  CHECK(bytes_of(folder / "copy.h5.new") == "forty pages");
  CHECK(fs::is_symlink(folder / "run.h5.new"));
  for (const char* name : {"run.h5", "copy.h5"}) {
    CHECK_FALSE(fs::is_symlink(folder / name));
    CHECK(ResultsReader(folder / name).frame_count() == 3);
  }
}

TEST_CASE("results whose name is a link are written to its target, and the link stays") {
  const Folder folder;
  fs::create_directory(folder / "far");
  fs::create_symlink("far/real.h5", folder / "run.h5");
  for (const int rows : {2, 3}) {  // the link leads nowhere at first
    run_rows(folder / "run.h5", rows, true);
    CHECK(fs::is_symlink(folder / "run.h5"));
    CHECK(ResultsReader(folder / "far/real.h5").frame_count() == static_cast<std::size_t>(rows));
  }
  put_text(folder / "far/real.h5", "forty pages");
  CHECK(holds_text(refusal_of(folder / "run.h5"), "is not a Trilith results file"));
  CHECK(bytes_of(folder / "far/real.h5") == "forty pages");
  fs::create_symlink("none/real.h5", folder / "nowhere.h5");
  CHECK(holds_text(refusal_of(folder / "nowhere.h5"), "there is no folder"));
}

TEST_CASE("a foreign file that appears at the name of the results during the run is not overwritten") {
  const Folder folder;
  const Header header = sample_header();
  {
    ResultsWriter writer(folder / "run.h5", header, {.sync = false});
    SampleRow(header, 0).append_to(writer);
    put_text(folder / "run.h5", "forty pages");
    CHECK_THROWS_WITH_AS(writer.finish(), doctest::Contains("is not a Trilith results file"), ResultsError);
  }
  CHECK(bytes_of(folder / "run.h5") == "forty pages");
  CHECK(ResultsReader(folder / "run.h5.part").frame_count() == 1);
}

TEST_CASE("the rows of an abandoned run are kept under another name by the next run, with a notice") {
  const Folder folder;
  CHECK(run_rows(folder / "run.h5", 1, false).empty());
  CHECK(holds_text(run_rows(folder / "run.h5", 2, false), "(1 frame, up to 0 s) are kept in"));
  const std::string output = run_rows(folder / "run.h5", 3, true);
  CHECK(holds_text(output, "(2 frames, up to 0.01 s) are kept in"));
  CHECK(holds_text(output, "run.unfinished2.h5"));
  CHECK(ResultsReader(folder / "run.unfinished1.h5").frame_count() == 1);
  CHECK(ResultsReader(folder / "run.unfinished2.h5").frame_count() == 2);
  CHECK(ResultsReader(folder / "run.h5").frame_count() == 3);
  CHECK_FALSE(fs::exists(folder / "run.h5.part"));
  repair(folder / "run.unfinished2.h5", folder / "copy.h5");
  CHECK(ResultsReader(folder / "copy.h5").frame_count() == 2);
}

TEST_CASE("a part file without rows is discarded, an unreadable one is kept") {
  const Folder folder;
  run_rows(folder / "run.h5", 0, false);
  CHECK(fs::exists(folder / "run.h5.part"));
  CHECK(run_rows(folder / "run.h5", 0, false).empty());
  CHECK_FALSE(fs::exists(folder / "run.unfinished1.h5"));
  const std::string torn = "\x89HDF\r\n\x1a\n torn";
  put_text(folder / "run.h5.part", torn);
  CHECK(holds_text(run_rows(folder / "run.h5", 1, true), "(not readable without repair) are kept"));
  CHECK(bytes_of(folder / "run.unfinished1.h5") == torn);
}

TEST_CASE("links and foreign files at the name of the part are rejected and stay") {
  const Folder folder;
  run_rows(folder / "other.h5", 1, true);
  const std::string other = bytes_of(folder / "other.h5");
  fs::create_symlink("other.h5", folder / "run.h5.part");
  CHECK(holds_text(refusal_of(folder / "run.h5"), "is not a regular file"));
  CHECK(bytes_of(folder / "other.h5") == other);
  fs::remove(folder / "run.h5.part");
  fs::create_directory(folder / "run.h5.part");
  CHECK(holds_text(refusal_of(folder / "run.h5"), "is not a regular file"));
  fs::remove(folder / "run.h5.part");
  write_study_table(folder / "run.h5.part", {{"case", "1", "number", std::vector<std::int32_t>{1, 2}}}, {}, true);
  const std::string table = bytes_of(folder / "run.h5.part");
  CHECK(holds_text(refusal_of(folder / "run.h5"), "is not a Trilith results file"));
  CHECK(bytes_of(folder / "run.h5.part") == table);
}

TEST_CASE("a run that cannot start leaves the part file of the earlier run in place") {
  const Folder folder;
  run_rows(folder / "run.h5", 2, false);
  Header header = sample_header();
  header.histories.push_back({"long", "m", std::string(100, 'x')});
  header.histories.push_back({"long", "m", "twice"});
  CHECK_THROWS(ResultsWriter(folder / "run.h5", header));
  CHECK(ResultsReader(folder / "run.h5.part").frame_count() == 2);
  CHECK_FALSE(fs::exists(folder / "run.unfinished1.h5"));
}
