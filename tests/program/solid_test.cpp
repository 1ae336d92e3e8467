// The program's verbs on results in space, and its output for other programs.
#include <cstdlib>

#include "program/verb.hpp"
#include "results/tumbling_boxes.hpp"

using namespace trilith;
using testing::bytes_of;
using testing::check_refused;
using testing::Output;
using testing::program_is_missing;
using testing::run_program;

namespace {

/// A folder with recorded results in space, and of a model in the plane.
const std::filesystem::path& solid_folder() {
  static const testing::Folder made;
  static const bool recorded = [] {
    testing::record_boxes(made / "stones.h5", testing::tumbling_boxes(), 11, 0.1);
    const results::Header header = testing::sample_header();
    results::ResultsWriter writer(made / "plane.h5", header);
    for (int i = 0; i < 4; ++i) testing::SampleRow(header, i).append_to(writer);
    writer.finish();
    return true;
  }();
  REQUIRE(recorded);
  return made.path;
}

}  // namespace

TEST_CASE("trilith draw makes pictures of a model in space, from names and angles, cut and coloured") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = solid_folder();
  CHECK(run_program(here, "draw stones.h5").out == "stones.png\n");
  CHECK(bytes_of(here / "stones.png").starts_with("\x89PNG"));
  CHECK(run_program(here, "draw stones.h5 --at 0,0.55,end --view front --ghost --forces -o front.svg").code == 0);
  CHECK(run_program(here, "draw stones.h5 --view=-120,35 --colour speed --cut x=0.3 -o cut.pdf").code == 0);
  CHECK(run_program(here, "draw stones.h5 --magnify 2 --colour displacement -o more.svg").code == 0);
  CHECK(bytes_of(here / "cut.pdf").starts_with("%PDF"));
  CHECK(run_program(here, "draw stones.h5 --cracks -o cracks.svg").code == 0);
  CHECK(run_program(here, "draw plane.h5 --at 0 --colour displacement -o plane.svg").code == 0);
  CHECK(run_program(here, "info stones.h5").prints("24, of 32 corners"));
}

TEST_CASE("trilith draw rejects invalid views, cuts and colours in one line") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = solid_folder();
  check_refused(run_program(here, "draw stones.h5 --view fornt"), "there is no view 'fornt'; did you mean 'front'?");
  check_refused(run_program(here, "draw stones.h5 --view 10,95"), "an elevation of -90 to 90");
  check_refused(run_program(here, "draw stones.h5 --cut w=2"), "must be an axis and a place on it");
  check_refused(run_program(here, "draw stones.h5 --cut x=abc"), "--cut");
  check_refused(run_program(here, "draw stones.h5 --view left --cut x=90"),
                "no body lies behind the cut, so there is nothing to draw");
  check_refused(run_program(here, "draw stones.h5 --thrust stones"), "in the plane only");
  check_refused(run_program(here, "draw plane.h5 --cut x=1"), "is of a model in the plane, which cannot be cut");
  check_refused(run_program(here, "draw plane.h5 --view iso"), "must be four numbers");
}

TEST_CASE("trilith export writes a folder for ParaView with all or some frames and names the file to open") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = solid_folder();
  CHECK(run_program(here, "export stones.h5").out ==
        "stones_vtk/stones_bodies.pvd\nstones_vtk/stones_contacts.pvd\nstones_vtk/stones_bearings.pvd\n");
  CHECK(std::filesystem::exists(here / "stones_vtk/stones_bodies/000010.vtu"));
  CHECK(run_program(here, "export plane.h5 --to vtk -o some/where --frames 1::2").code == 0);
  const auto files = [&](const char* folder) {
    return std::distance(std::filesystem::directory_iterator(here / folder), {});
  };
  CHECK(files("some/where/plane_bodies") == 2);
  CHECK(run_program(here, "export stones.h5 -o one --frames 7").code == 0);
  CHECK(files("one/stones_bodies") == 1);
  CHECK(run_program(here, "export stones.h5 -o five --frames :4").code == 0);
  CHECK(files("five/stones_bodies") == 5);
  check_refused(run_program(here, "export stones.h5 -o none --frames 20:"), "frames count from 0 to 10");
  for (const char* range : {"x", "1:2:0", "5:2", "1:2:3:4", ":", "-1"})
    check_refused(run_program(here, std::string("export stones.h5 --frames=") + range), "--frames");
  check_refused(run_program(here, "export nowhere.h5"), "there is no such file");
  CHECK(run_program(here, "export stones.h5 --to stl").code == 2);
}

TEST_CASE("trilith report covers a model in space") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = solid_folder();
  CHECK(run_program(here, "report stones.h5").code == 0);
  CHECK(bytes_of(here / "stones.report.html").find("The structure (a) at 0") != std::string::npos);
}
