#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "load/motion.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"
#include "source_dir.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

// The code blocks of docs/results.md that open with "```<language>".
std::string documented(const std::string& language) {
  std::istringstream page(bytes_of(trilith::testing::source_dir() + "/docs/results.md"));
  std::string line, code;
  bool inside = false;
  while (std::getline(page, line)) {
    if (line.starts_with("```"))
      inside = line == "```" + language;
    else if (inside)
      code += line + "\n";
  }
  return code;
}

bool has_python() {
  if (std::system("/usr/bin/python3 -c 'import h5py, pandas' >/dev/null 2>&1") == 0) return true;
  MESSAGE("skipped: /usr/bin/python3 has no h5py or pandas");
  return false;
}

// Runs the page's lines and then `checks` in `folder`; 0 if all checks hold.
int run_python(const Folder& folder, const std::string& code, const std::string& checks) {
  std::ofstream(folder / "read.py") << code << checks;
  std::fflush(nullptr);
  return std::system(("cd " + folder.path.string() + " && /usr/bin/python3 read.py >/dev/null").c_str());
}

void append_rows(ResultsWriter& writer, const Header& header, int rows) {
  for (int i = 0; i < rows; ++i) SampleRow(header, i).append_to(writer);
}

}  // namespace

TEST_CASE("the lines of docs/results.md read a finished file with h5py and pandas") {
  if (!has_python()) return;
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  append_rows(writer, header, 800);
  writer.finish();
  const char* checks = R"(
assert f.attrs["finished"] == 1 and f.attrs["format"].decode() == "trilith" and f.attrs["format_version"] == 1
assert f["frames/position"].attrs["units"].decode() == "m"
assert f["provenance/script"].asstr()[()] == "-- bridge.lua\nlocal θ = 3\n"
assert f["provenance"].attrs["command_line"].decode() == "trilith run scripts/bridge.lua pga=0.6"
assert list(bodies.name) == ["span 1", "span 2", "span 3"] and list(bodies.first_vertex) == [0, 4, 8]
assert len(events) == 800 and events.cause[5] == 4 and events.text[3] == "the bearing reached its limit"
assert len(failed) == 800 and failed.bearing_name[0] == "bearing 1" and abs(failed.value_1[2] - 2.05) < 1e-12
assert list(histories.columns) == ["top.x", "base shear"], list(histories.columns)
assert histories["base shear"].iloc[100] == -300
assert list(energy.columns) == ["kinetic", "input", "residual"]
assert time.shape == x.shape == (800,) and x[7] == 1 + 7000 + 4 / 7
assert len(last) == 3 and list(last.fx) == [-1.5 * 799] * 3
assert outline.shape == (4, 2)
def complete(name, d):
    if isinstance(d, h5py.Dataset):
        assert "units" in d.attrs and "description" in d.attrs, name
        if d.dtype.names:
            assert len(d.attrs["units"]) == len(d.attrs["columns"]) == len(d.dtype.names), name
        if d.shape and d.size * d.dtype.itemsize >= 4096:
            assert d.compression == "gzip" and d.fletcher32, name
f.visititems(complete)
)";
  CHECK(run_python(folder, documented("python"), checks) == 0);
}

TEST_CASE("the lines of docs/results.md find the faces of a solid that has turned") {
  if (!has_python()) return;
  const Folder folder;
  record_boxes(folder / "run.h5", tumbling_boxes(), 20, 0.05);
  CHECK(run_python(folder, documented("python space"), R"(
assert f.attrs["dim"] == 3 and len(faces) == 6 and all(len(loop) == 4 for loop in faces)
assert abs(volume - 0.4 * 0.2 * 0.1) < 1e-12, volume
assert abs(p.mean(axis=0) - f["frames/position"][10, 1]).max() < 1e-12
assert set(f["frames/contacts"].dtype.names) >= {"x", "y", "z", "area", "nx", "ny", "nz"}
)") == 0);
}

TEST_CASE("the lines of docs/results.md give the position prescribed by a ground motion") {
  if (!has_python()) return;
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  MotionRow row;
  row.body = row.node = 1;
  row.direction = "x";
  row.begin = 2, row.origin = 0.5, row.step = 0.01, row.start_time = 0.25;
  row.start_velocity = 0.1, row.start_displacement = -0.25;
  for (int i = 0; i < 400; ++i) row.acceleration.push_back(std::sin(0.1 * i) / 3);
  writer.append_motion(row);
  writer.finish();
  const GroundMotion motion =
      GroundMotion(row.acceleration, row.step, {row.start_velocity, row.start_displacement}).delayed(row.start_time);
  CHECK(run_python(
            folder, documented("python motions"),
            fmt::format("\nassert t.size == place.size == 400 and abs(t[200] - 4.25) < 1e-12\n"
                        "assert abs(place[200] - {:.17g}) < 1e-12 and abs(place[399] - {:.17g}) < 1e-12\n",
                        row.origin + motion.displacement(2.25), row.origin + motion.displacement(0.25 + 3.99))) == 0);
}

TEST_CASE("the lines of docs/results.md read a file that is still being written, and one left unfinished") {
  if (!has_python()) return;
  const Folder folder;
  const Header header = sample_header();
  const char* checks = R"(
assert f.attrs["finished"] == 0 and n == 30 and x.shape == (30, 3, 2) and x[29, 0, 0] == 29001
)";
  {
    ResultsWriter writer(folder / "run.h5", header);
    append_rows(writer, header, 30);
    writer.flush();
    CHECK(run_python(folder, documented("python live"), checks) == 0);
  }
  CHECK(run_python(folder, documented("python live"), checks) == 0);
  repair(folder / "run.h5", folder / "repaired.h5");
  const char* plain = R"(
import h5py
f = h5py.File("repaired.h5")
assert f.attrs["finished"] == 0 and f["frames/position"].shape == (30, 3, 2)
)";
  CHECK(run_python(folder, plain, "") == 0);
}

TEST_CASE("repair names a data set without width as damage and leaves no file") {
  if (!has_python()) return;
  const Folder folder;
  const Header header = sample_header();
  {
    ResultsWriter writer(folder / "run.h5", header);
    append_rows(writer, header, 4);
    writer.finish();
  }
  const char* narrow = R"(
import h5py
f = h5py.File("run.h5", "r+")
attributes = dict(f["frames/velocity"].attrs)
del f["frames/velocity"]
d = f.create_dataset("frames/velocity", (4, 0, 3), "f8")
for name, value in attributes.items(): d.attrs[name] = value
)";
  REQUIRE(run_python(folder, narrow, "") == 0);
  CHECK_THROWS_WITH_AS(repair(folder / "run.h5", folder / "copy.h5"),
                       doctest::Contains("run.h5': velocity is damaged: its rows have no width"), ResultsError);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), std::filesystem::directory_iterator()) == 2);
}
