// The program's verbs on a small recorded collapse.
#include <algorithm>
#include <cstdlib>

#include "program/verb.hpp"
#include "run/falling_span.hpp"
#include "source_dir.hpp"

using namespace trilith;
using testing::check_refused;
using testing::Output;
using testing::program_is_missing;
using testing::run_program;

namespace {

/// The results that all cases read, recorded once.
const testing::Folder& folder() {
  static const testing::Folder made;
  static const bool recorded = [] {
    testing::record_falling_span(made / "span.h5");
    return true;
  }();
  REQUIRE(recorded);
  return made;
}

bool is_picture(const std::filesystem::path& path, std::string_view head) {
  return testing::bytes_of(path).starts_with(head);
}

}  // namespace

TEST_CASE("trilith draw makes a picture of one moment or panels of several, in the format requested") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  CHECK(run_program(here, "draw span.h5").out == "span.png\n");
  CHECK(is_picture(here / "span.png", "\x89PNG"));
  CHECK(run_program(here, "draw span.h5 --at 0,seat.lost,1.4,end --ghost --forces -o four.svg").code == 0);
  const std::string four = testing::bytes_of(here / "four.svg");
  CHECK(four.find("<svg") != std::string::npos);
  CHECK(run_program(here, "draw span.h5 --at 0,1,end --stage shaking --columns 3 --units us -o three.pdf").code == 0);
  CHECK(is_picture(here / "three.pdf", "%PDF"));
  CHECK(run_program(here, "draw span.h5 --view=-2,-1,4,7 -o view.svg").code == 0);
}

TEST_CASE("commands for finished results mention a newer part file next to them") {
  if (program_is_missing()) return;
  const testing::Folder here;
  testing::record_falling_span(here / "span.h5");
  std::filesystem::copy_file(here / "span.h5", here / "other.h5");
  const auto note_of = [&](const char* arguments) {
    const Output output = run_program(here.path, arguments);
    CHECK_MESSAGE(output.code == 0, output.err);
    return output.err;
  };
  const std::vector<const char*> verbs{"draw span.h5",   "plot span.h5",          "view span.h5",
                                       "report span.h5", "info span.h5 --events", "plot other.h5 -r span.h5"};
  for (const char* verb : verbs) CHECK_MESSAGE(note_of(verb).empty(), verb);
  {
    const results::Header header = testing::sample_header();
    results::ResultsWriter writer(here / "span.h5", header);
    testing::SampleRow(header, 0).append_to(writer);
    for (const char* verb : verbs)
      CHECK(note_of(verb).find("a later run is writing span.h5.part") != std::string::npos);
  }
  for (const char* verb : verbs) {
    const std::string note = note_of(verb);
    CHECK(note ==
          "note: span.h5: these are the results of an earlier run; a later run stopped early and left span.h5.part\n");
  }
  CHECK(run_program(here.path, "info span.h5").prints("a later run stopped early and left span.h5.part"));
  CHECK(note_of("draw span.h5.part").empty());
}

TEST_CASE("trilith draw rejects unknown times, stages, views and files in one line") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  check_refused(run_program(here, "draw nowhere.h5"), "there is no such file");
  check_refused(run_program(here, "draw span.h5 --at 99"), "outside the frames of 'span.h5', 0 s to 3 s");
  check_refused(run_program(here, "draw span.h5 --at 1x"), "'1x' is not a number");
  check_refused(run_program(here, "draw span.h5 --at seat.lots"), "did you mean 'seat.lost'?");
  check_refused(run_program(here, "draw span.h5 --stage shakin"),
                "'span.h5' has no stage 'shakin'; did you mean 'shaking'?");
  check_refused(run_program(here, "draw span.h5 --view 1,2,3"), "must be four numbers");
  check_refused(run_program(here, "draw span.h5 --view 1,2,0,5"), "must be above 0");
  check_refused(run_program(here, "draw span.h5 -o picture.gif"), "'.gif' is not a picture format");
  check_refused(run_program(here, "draw span.h5 -o span.h5/such/folder.png"), "span.h5/such");
  CHECK_FALSE(std::filesystem::exists(here / "picture.gif"));
}

TEST_CASE("trilith draw --mode draws the modes that a script has found, before its first stage and without one") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  std::ofstream(here / "modes.lua") << R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "cantilever", thickness = 1, gravity = 0 }
m:material { name = "steel", density = 7850, E = 2.1e11 }
m:results { file = "modes.h5" }
m:frame { name = "mast", material = "steel", floating = true,
  joints = { foot = { at = { 0, 0 }, support = "fixed" }, head = { 0, 3 } },
  members = { { from = "foot", to = "head", section = trilith.rectangle_section { width = 0.1, depth = 0.2 } } } }
assert(#m:modes { count = 3 } == 3)
)lua";
  const Output run = run_program(here, "run modes.lua");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run.prints("modes are in modes.h5"));
  CHECK(run_program(here, "info modes.h5").prints("modes       3, the last ones computed at 0 s"));
  CHECK(run_program(here, "draw modes.h5 --mode 1,3 -o modes.svg").code == 0);
  CHECK(testing::bytes_of(here / "modes.svg").find("<svg") != std::string::npos);
  check_refused(run_program(here, "draw modes.h5 --mode 4"), "there is no mode 4; 'modes.h5' has modes 1 to 3");
  check_refused(run_program(here, "draw modes.h5 --mode first"), "'first' is not a number");
  check_refused(run_program(here, "draw modes.h5 --mode 1 --forces"), "shows the shape alone");
  check_refused(run_program(here, "draw span.h5 --mode 1"), "'span.h5' has no natural modes");
}

TEST_CASE("trilith plot draws histories and energy of one or several runs and lists the available ones") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  std::filesystem::copy_file(here / "span.h5", here / "other.h5", std::filesystem::copy_options::overwrite_existing);
  CHECK(run_program(here, "plot span.h5").out == "span.plot.png\n");
  CHECK(run_program(here, "plot span.h5 span.y energy --events -o y.svg").code == 0);
  CHECK(run_program(here, "plot span.h5 span.y left.force -r other.h5 -o both.pdf").code == 0);
  CHECK(run_program(here, "plot span.h5 energy --lines -r other.h5 -o energy.png").code == 0);
  const Output list = run_program(here, "plot span.h5 --list");
  CHECK(list.prints("span.y      m        height of the span\n"));
  CHECK(list.prints("energy "));
  check_refused(run_program(here, "plot span.h5 span.z"), "no history 'span.z'; did you mean 'span.x'?");
}

TEST_CASE("trilith plot draws one history over another, and a stage or a part of a run alone") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  CHECK(run_program(here, "plot span.h5 span.y --against span.x -o loop.svg").out == "loop.svg\n");
  CHECK(run_program(here, "plot span.h5 span.y --stage shaking --to 1 -o part.svg").code == 0);
  check_refused(run_program(here, "plot span.h5 span.y --against span.z"), "did you mean 'span.x'?");
  check_refused(run_program(here, "plot span.h5 span.y --stage shakin"), "did you mean 'shaking'?");
  check_refused(run_program(here, "plot span.h5 span.y --from 90"),
                "no samples of its histories in that part of the run");
  check_refused(run_program(here, "plot span.h5 energy --against span.x"), "the energy is drawn over time");
  check_refused(run_program(here, "plot span.h5 --fragility collapsed"), "for the table of a study");
}

TEST_CASE("times count from a stage or an event in plots, pictures, tables, report and page, with a notice") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  const auto holds = [&](const char* file, const std::string& part) {
    CHECK_MESSAGE(testing::bytes_of(here / file).find(part) != std::string::npos, file, " does not hold ", part);
  };
  CHECK(run_program(here, "plot span.h5 span.y --since shaking -o since.svg").code == 0);
  CHECK(run_program(here, "draw span.h5 --since shaking --at 0 -o since.png").code == 0);
  CHECK(run_program(here, "draw span.h5 --names none -o bare.svg").code == 0);
  CHECK(run_program(here, "report span.h5 --since shaking -o since.html").code == 0);
  holds("since.html", "times count since &#39;shaking&#39; began");
  const Output table = run_program(here, "info span.h5 --events --since shaking");
  CHECK(table.out.starts_with("times count since 'shaking' began\n"));
  CHECK(table.prints("    0.0000 s  stage.begun"));
  CHECK(run_program(here, "view span.h5 --since shaking -o page.html").code == 0);
  check_refused(run_program(here, "plot span.h5 --since shakin"), "did you mean 'shaking'?");
  check_refused(run_program(here, "draw span.h5 --since seat.los"), "no stage and no event 'seat.los'");
  check_refused(run_program(here, "info span.h5 --since shaking"), "with --events or --of-note");
}

TEST_CASE("control characters in a results file do not reach the terminal") {
  if (program_is_missing()) return;
  const testing::Folder here;
  results::Header header = testing::sample_header();
  header.histories[0].name = "top\033[31m";
  header.provenance.motions = {"\033]0;title\a"};
  results::ResultsWriter writer(here / "old.h5", header);
  testing::SampleRow row(header, 0);
  row.event.text = "\033[2Ja span fell\xC2\x9B";
  row.append_to(writer);
  writer.finish();
  CHECK(run_program(here.path, "info old.h5").prints("top\\27[31m"));
  for (const char* list : {"info old.h5", "info old.h5 --events", "info old.h5 --of-note"}) {
    const Output output = run_program(here.path, list);
    CHECK(output.code == 0);
    CHECK(output.out.find_first_of("\033\a") == std::string::npos);
  }
  CHECK(run_program(here.path, "info old.h5 --events").prints("\\27[2Ja span fell\\194\\155"));
}

TEST_CASE("trilith info describes a file and lists its events below their causes") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  const Output info = run_program(here, "info span.h5");
  CHECK(info.code == 0);
  CHECK(info.prints("span.h5: finished"));
  CHECK(info.prints("ground motion"));
  const Output events = run_program(here, "info span.h5 --of-note");
  CHECK(events.prints("  bearing.failed     bearing right failed at 0.3 m\n"));
  CHECK(events.prints("  seat.lost              span lost its seat on P2 (right seat)\n"));
  CHECK_FALSE(events.prints("contact.made"));
  CHECK(run_program(here, "info span.h5 --events").prints("contact.made"));
}

TEST_CASE("unfinished results are reported, drawn, and repaired to a clean file") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  {
    Simulation<2> simulation(testing::falling_span());
    Recording<2> recording(here / "early.h5", simulation.model(), simulation.state());
    StageOptions o;
    o.duration = 0.1;
    o.frame_interval = 0.02;
    simulation.run(o, recording.listener());
    recording.abandon("the power went");
  }
  const Output info = run_program(here, "info early.h5");
  CHECK(info.prints("NOT finished"));
  CHECK(info.prints("the power went"));
  CHECK(run_program(here, "draw early.h5").code == 0);
  CHECK(run_program(here, "repair early.h5 -o clean.h5").out == "clean.h5: 6 frames\n");
  CHECK(run_program(here, "info clean.h5").prints("NOT finished"));
  check_refused(run_program(here, "repair early.h5 -o early.h5.part"), "cannot be repaired in place");
  // If a dataset that every frame needs is missing, the rest is copied, and missing frames are not counted.
  const std::string lose = "cd '" + here.string() + "' && /usr/bin/python3 2>/dev/null -c 'import h5py\n" +
                           "with h5py.File(\"clean.h5\", \"r+\") as f: del f[\"frames/position\"]'";
  if (std::system(lose.c_str()) != 0) {
    MESSAGE("skipped: /usr/bin/python3 has no h5py");
    return;
  }
  const Output poor = run_program(here, "repair clean.h5 -o poor.h5");
  check_refused(poor, "there is no readable /frames/position");
  check_refused(poor, "; of 6 frames in this copy 0 can be read");
  CHECK(run_program(here, "info poor.h5").code == 0);
}

TEST_CASE("impossible numbers of threads are rejected, from the command line and from the environment") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  std::ofstream(here / "block.lua") << R"(local m = require("trilith").model { name = "m" }
m:material { name = "s", density = 1 }
m:block { name = "b", width = 1, height = 1, material = "s", floating = true }
m:run { duration = 1e-3 }
)";
  for (const std::string wrong : {"0", "-1", "65", "two"}) {
    const Output output = run_program(here, "run block.lua --quiet --threads " + wrong);
    CHECK(output.code == 2);
    CHECK(output.err.find("--threads") != std::string::npos);
    ::setenv("TRILITH_THREADS", wrong.c_str(), 1);
    const Output surrounded = run_program(here, "run block.lua --quiet");
    ::unsetenv("TRILITH_THREADS");
    CHECK(surrounded.code == 1);
    CHECK(surrounded.err.find("TRILITH_THREADS is '" + wrong + "', must be a whole number from 1 to 64") !=
          std::string::npos);
  }
  CHECK(run_program(here, "run block.lua --quiet --threads 1").code == 0);
}

TEST_CASE("trilith motion prints the figures of a record and draws it") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  const std::string record = "'" + testing::source_dir() + "/scripts/records/elcentro_1940_rest_ns.csv'";
  const Output output = run_program(here, "motion " + record);
  CHECK(output.code == 0);
  CHECK(output.prints("PGA                  0.34874 g"));
  CHECK(is_picture(here / "elcentro_1940_rest_ns.png", "\x89PNG"));
  const Output scaled = run_program(here, "motion " + record + " --peak 0.8 --reverse --no-picture");
  CHECK(scaled.prints("PGA                  -0.80000 g"));
  check_refused(run_program(here, "motion nowhere.csv"), "nowhere.csv");
  CHECK(run_program(here, "motion " + record + " --scale 0 --no-picture").prints("PGA                  0.00000 g"));
  check_refused(run_program(here, "motion " + record + " --scale inf -o x.png"), "inf");
}

namespace {

constexpr const char* drop_script = R"lua(
local trilith = require "trilith"
local p = trilith.params { height = { 0.2, "m", "of the fall" } }
local m = trilith.model { name = "drop" }
m:results { file = "drop.h5", frames = 0.02 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e7, ks = 3e7, mu = 0.6, beta = 2e-4 } }
m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, p.height }, material = "stone", floating = true }
m:on("impact", function(e) print("output by the script") end)
m:run { name = "fall", duration = 1 }
if os.getenv("TRILITH_FAIL") then error("on purpose") end
)lua";

void write_script(const std::filesystem::path& here) {
  std::ofstream(here / "drop.lua") << drop_script;
}

}  // namespace

TEST_CASE("trilith run prints events and stages in plain lines without a terminal and leaves results") {
  if (program_is_missing()) return;
  const testing::Folder here;
  write_script(here.path);
  const Output output = run_program(here.path, "run drop.lua height=0.5");
  CHECK_MESSAGE(output.code == 0, output.err);
  CHECK(output.prints("fall began"));
  CHECK(output.prints("block hit base at"));
  CHECK(output.prints("output by the script\n"));
  CHECK(output.prints("fall ended (time) after 1 s in "));
  CHECK(output.prints("results are in"));
  CHECK(output.prints("of the input"));
  CHECK(run_program(here.path, "info drop.h5").prints("height = 0.5"));
  CHECK_FALSE(run_program(here.path, "run drop.lua --impacts 100").prints("hit base"));
  CHECK_FALSE(run_program(here.path, "run drop.lua --events none").prints("began"));
  CHECK(run_program(here.path, "run drop.lua --events all").prints("block left base"));
  CHECK(run_program(here.path, "run drop.lua --quiet").out.find("fall") == std::string::npos);
  CHECK(run_program(here.path, "run drop.lua --events some").code == 2);
}

TEST_CASE("a failed script leaves unfinished results and prints their file name") {
  if (program_is_missing()) return;
  const testing::Folder here;
  write_script(here.path);
  ::setenv("TRILITH_FAIL", "1", 1);
  const Output output = run_program(here.path, "run drop.lua");
  ::unsetenv("TRILITH_FAIL");
  CHECK(output.code == 1);
  CHECK(output.err.find("drop.lua:12: on purpose") != std::string::npos);
  CHECK(output.prints("drop.h5.part"));
  CHECK_FALSE(std::filesystem::exists(here / "drop.h5"));
  CHECK(run_program(here.path, "info drop.h5").prints("on purpose"));
}

TEST_CASE("on a terminal the status is one line that is redrawn, in colours unless NO_COLOR is set") {
  if (program_is_missing()) return;
  const testing::Folder here;
  write_script(here.path);
  if (std::system("command -v script > /dev/null") != 0) {
    MESSAGE("skipped: there is no program `script` to make a terminal with");
    return;
  }
  const auto in_terminal = [&](const std::string& environment) {
    const std::string command = "cd '" + here.path.string() + "' && TERM=xterm " + environment + " script -qec \"'" +
                                testing::program_path().string() +
                                "' run slow.lua\" /dev/null > terminal.txt < /dev/null";
    CHECK(std::system(command.c_str()) == 0);
    return testing::bytes_of(here / "terminal.txt");
  };
  std::string slow = drop_script;  // long enough for a drawn status line
  slow.insert(slow.find("m:run"),
              "m:every(0.02, function() local t = os.clock() repeat until os.clock() > t + 0.02 end)\n");
  std::ofstream(here / "slow.lua") << slow;
  const std::string colours = in_terminal(""), plain = in_terminal("NO_COLOR=1"), dumb = in_terminal("TERM=dumb");
  CHECK(colours.find("\rfall  t 0.") != std::string::npos);
  CHECK(colours.find("\033[K") != std::string::npos);
  CHECK(colours.find("\033[Koutput by the script") != std::string::npos);  // the status line was removed for it
  CHECK(plain.find("\033[1m") == std::string::npos);
  CHECK(dumb.find('\033') == std::string::npos);
}

TEST_CASE("wrong usage ends with code 2 and a message on stderr, help with 0") {
  if (program_is_missing()) return;
  const std::filesystem::path& here = folder().path;
  for (const char* wrong : {"daw span.h5", "draw", "draw span.h5 --unit si", "draw span.h5 --units mm",
                            "draw span.h5 --columns 0", "repair span.h5", "plot span.h5 -r"}) {
    const Output output = run_program(here, wrong);
    CHECK_MESSAGE(output.code == 2, wrong);
    CHECK_FALSE(output.err.empty());
  }
  CHECK(run_program(here, "--version").prints("trilith "));
  const Output help = run_program(here, "--help");
  CHECK(help.code == 0);
  for (const char* verb : {"draw", "plot", "motion", "info", "repair"}) CHECK(help.prints(verb));
}
