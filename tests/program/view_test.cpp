// `trilith view` and its page in headless Chromium. Pictures stay in tests/view_pictures/ of the build tree.
#include <doctest/doctest.h>

#include "program/verb.hpp"
#include "results/tumbling_boxes.hpp"
#include "run/falling_span.hpp"
#include "source_dir.hpp"

using namespace trilith;
using testing::Output;
using testing::program_is_missing;
using testing::run_program;

namespace {

std::filesystem::path picture_folder() {
  const auto folder = testing::program_path().parent_path().parent_path() / "tests" / "view_pictures";
  std::filesystem::create_directories(folder);
  return folder;
}

/// Runs view_page.py, which controls `page` in a browser.
void browse(const std::filesystem::path& page, const std::string& steps) {
  const std::string script = testing::source_dir() + "/tests/program/view_page.py";
  const std::string command =
      "/usr/bin/python3 '" + script + "' '" + picture_folder().string() + "' '" + page.string() + "' " + steps;
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == 77)
    MESSAGE("skipped: there is no Chromium with its driver and python3-selenium");
  else
    CHECK(code == 0);
}

constexpr const char* wall_script = R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "small wall", thickness = 0.2 }
local brick = m:material { name = "brick", density = 1900 }
m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 5e9, ks = 2e9, mu = 0.7, beta = 5e-5, cohesion = 20e3, tension = 12e3 } }
m:wall { name = "wall", length = 2.4, unit_length = 0.4, unit_height = 0.2, bond = "running", storeys = 1, storey_height = 1.6,
  slab_height = 0.2, base_height = 0.4, base_margin = 3, openings = { { storey = 1, x = 0.8, width = 0.8, height = 1.0 } },
  lintel_bearing = 0.2, material = brick, fixed = "base" }
m:results { file = "wall.h5", frames = 0.04, histories = 0.02, energy = 0.04 }
m:history { name = "slab", body = "wall.s1.slab", what = "ux" }
m:consolidate { duration = 4, rest = { ratio = 1e-3, speed = 1e-4 } }
m:shake { body = "wall.base", x = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = 9 }, duration = 4 }
)lua";

}  // namespace

TEST_CASE("the page of the bridge plays to the end, goes to the first failure and shows the failed bearing's history") {
  if (program_is_missing()) return;
  const testing::Folder here;
  const std::string script = "'" + testing::source_dir() + "/scripts/bridge.lua'";
  const Output run = run_program(here.path, "run " + script + " --quiet out=bridge.h5");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  const Output output = run_program(here.path, "view bridge.h5");
  CHECK(output.out == "bridge.html\n");
  CHECK(std::filesystem::file_size(here / "bridge.html") < 1'000'000);
  browse(here / "bridge.html", "plays_to_the_end shows_a_failed_bearing shows_a_body");
}

TEST_CASE("the page of a wall in running bond shows cracks and damage") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "wall.lua") << wall_script;
  const Output run = run_program(here.path, "run wall.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view wall.h5 -o page.html").out == "page.html\n");
  std::filesystem::rename(here / "page.html", here / "wall.html");
  browse(here / "wall.html", "plays_to_the_end shows_cracks shows_a_body");
}

TEST_CASE("the page shows temperatures in the plane and in space at the time that is played") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "heat.lua") << R"lua(
local trilith = require "trilith"
local p = trilith.params { dim = { 2, "2 or 3" } }
local m = trilith.model { name = "heat", dim = p.dim }
m:material { name = "stone", density = 2400, E = 2e10, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
local function block(name, x, width, height, keys)
  keys.name, keys.material = name, "stone"
  if p.dim == 3 then
    keys.at, keys.size = { x, 0, height < 0 and height or 0 }, { width, 2, math.abs(height) }
  else
    keys.at, keys.width, keys.height = { x, height < 0 and height or 0 }, width, math.abs(height)
  end
  m:block(keys)
end
block("ground", -1, 9, -1, { support = "fixed" })
block("kiln", 0, 2, 2, { body = { mesh = p.dim == 3 and { 4, 2, 4 } or { 4, 4 } } })
block("store", 3, 1, 2, {})
block("bare", 5, 1, 1, {})
m:heat { body = "kiln", conductivity = 2, heat_capacity = 900, temperature = 30 }
m:heat { body = "store", conductivity = 2, heat_capacity = 900, temperature = 3 }
m:heat { body = "ground", conductivity = 2, heat_capacity = 900, temperature = 8 }
m:heat_exchange { body = "kiln", side = "top", temperature = 5, exchange = 50 }
m:heat_contact { conductance = 100 }
m:results { file = p.dim == 3 and "heat3.h5" or "heat.h5", frames = 0.01, histories = 0.01 }
m:consolidate { integrator = "static" }
m:process { duration = 864000, step = 43200 }
)lua";
  for (const std::string dim : {"2", "3"}) {
    const Output run = run_program(here.path, "run heat.lua --quiet dim=" + dim);
    REQUIRE_MESSAGE(run.code == 0, run.err);
    const std::string name = dim == "3" ? "heat3" : "heat";
    CHECK(run_program(here.path, "view " + name + ".h5").out == name + ".html\n");
    browse(here.path / (name + ".html"), "shows_temperature");
  }
}

TEST_CASE("the page of a wall of finite elements shows their stress") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::string script = wall_script;
  const auto put = [&](const std::string& mark, const std::string& by) {
    const std::size_t at = script.find(mark);
    REQUIRE(at != std::string::npos);
    script.replace(at, mark.size(), by);
  };
  put("thickness = 0.2", "thickness = 0.2, body = \"quad\"");
  put("density = 1900", "density = 1900, E = 2e9, nu = 0.2");
  put("duration = 4 }\n", "duration = 1 }\n");
  put("wall.h5", "quads.h5");
  std::ofstream(here / "quads.lua") << script;
  const Output run = run_program(here.path, "run quads.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view quads.h5").out == "quads.html\n");
  browse(here / "quads.html", "shows_stress");
}

TEST_CASE("the page plays the natural modes that a run has found, and goes back to the run") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "frame.lua") << R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "bent", thickness = 1 }
m:material { name = "steel", density = 7850, E = 2.1e11 }
m:results { file = "frame.h5", frames = 0.01 }
local section = trilith.rectangle_section { width = 0.2, depth = 0.2 }
m:frame { name = "bent", material = "steel", floating = true,
  joints = { foot = { at = { 0, 0 }, support = "fixed" }, head = { 0, 4 }, tip = { at = { 2.5, 4 }, mass = 300 } },
  members = { { name = "column", from = "foot", to = "head", section = section },
              { name = "arm", from = "head", to = "tip", section = section } } }
m:modes { count = 3 }
m:run { duration = 0.2, integrator = "implicit", dt = 0.005 }
)lua";
  const Output run = run_program(here.path, "run frame.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view frame.h5").out == "frame.html\n");
  browse(here / "frame.html", "plays_a_mode plays_to_the_end");
}

TEST_CASE("the page plays natural modes of models in space, of members and of rigid bodies") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "modes.lua") << R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "bent and stone", dim = 3 }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
m:results { file = "modes3d.h5", frames = 0.01 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
m:block { name = "ground", size = { 5, 3, 0.4 }, at = { -1, -1.5, -0.4 }, material = "steel", support = "fixed" }
m:block { name = "stone", size = { 0.4, 0.4, 1.2 }, at = { 3, 1, 0 }, turn = { axis = { 0, 0, 1 }, angle = 0.5 }, material = "steel" }
local section = trilith.rectangle_section { width = 0.2, depth = 0.2 }
m:frame { name = "bent", material = "steel", floating = true,
  joints = { foot = { at = { 0, 0, 0 }, support = "fixed" }, head = { 0, 0, 4 }, tip = { at = { 2.5, 0, 4 }, mass = 300 } },
  members = { { name = "column", from = "foot", to = "head", section = section },
              { name = "arm", from = "head", to = "tip", section = section } } }
m:consolidate { integrator = "static" }
m:modes { count = 3 }
m:run { duration = 0.2, integrator = "implicit", dt = 0.005 }
)lua";
  const Output run = run_program(here.path, "run modes.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view modes3d.h5").out == "modes3d.html\n");
  browse(here / "modes3d.html", "plays_a_mode_in_space plays_to_the_end");
}

TEST_CASE("the page draws loops, enlarges plots and counts times from the chosen origin") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "loop.lua") << R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "deck", thickness = 1 }
m:material { name = "concrete", density = 2400 }
m:contact { between = { "*", "*" }, law = "none" }
local pier = m:block { name = "pier", width = 2, height = 4, at = { 0, 0 }, material = "concrete", support = "fixed" }
local deck = m:block { name = "deck", width = 4, height = 1, at = { -1, 4.1 }, material = "concrete", floating = true }
m:bearing { name = "rubber", between = { pier, deck }, at = { 1, 4.05 }, limit = { along = 1 },
  along = trilith.lead_rubber { strength = 2e4, post_stiffness = 2e5 }, axial = trilith.linear { stiffness = 1e8, damping = 1e5 },
  turning = trilith.linear { stiffness = 1e8, damping = 1e6 } }
m:results { file = "loop.h5", frames = 0.04, histories = 0.005 }
m:history { name = "force", bearing = "rubber", what = "force_along" }
m:history { name = "displacement", bearing = "rubber", what = "displacement_along" }
m:run { name = "rest", duration = 0.5, local_damping = 0.8 }
m:shake { body = pier, x = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = 3 }, duration = 4 }
)lua";
  const Output run = run_program(here.path, "run loop.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view loop.h5").out == "loop.html\n");
  browse(here / "loop.html", "shows_loops counts_from_a_stage");
  CHECK(run_program(here.path, "view loop.h5 --since shake -o since.html").code == 0);
  browse(here / "since.html", "counts_from_the_start_it_was_given");
}

TEST_CASE("the page of a model in space shows, turns and cuts solids and describes the clicked one") {
  if (program_is_missing()) return;
  const testing::Folder here;
  testing::record_boxes(here / "solids.h5", testing::tumbling_boxes(), 11, 0.1);
  CHECK(run_program(here.path, "view solids.h5").out == "solids.html\n");
  browse(here / "solids.html", "plays_to_the_end shows_solids shades_depth cuts_solids");
}

TEST_CASE("the page of a wall in space shows its cracks after they open") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::ofstream(here / "stones.lua") << R"lua(
local trilith = require "trilith"
local m = trilith.model { name = "stones", dim = 3 }
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 5e8, ks = 2e8, mu = 0.6, beta = 1e-4, tension = 1e4, cohesion = 1.5e4 } }
m:wall { name = "wall", length = 1.2, unit_length = 0.4, unit_height = 0.2, thickness = 0.2, courses = 6, slab_height = 0,
  base_height = 0.3, base_margin = 1, material = "stone", fixed = "base" }
m:results { file = "stones.h5", frames = 0.05 }
m:consolidate { duration = 5, fresh = true }
m:shake { body = "wall.base", y = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = 12 }, duration = 2 }
)lua";
  const Output run = run_program(here.path, "run stones.lua --quiet");
  REQUIRE_MESSAGE(run.code == 0, run.err);
  CHECK(run_program(here.path, "view stones.h5").out == "stones.html\n");
  browse(here / "stones.html", "shows_cracks_of_solids");
}

TEST_CASE("the page of a long flow in space shows its start and its end") {
  if (program_is_missing()) return;
  const testing::Folder here;
  std::vector<testing::FlyingBox> boxes;
  for (int i = 0; i < 20; ++i) boxes.push_back({{0.1, 0.1, 0.1}, {0.3 * i, 0, 0}, {10, 0, -4}});
  testing::record_boxes(here / "flow.h5", boxes, 21, 0.1);
  CHECK(run_program(here.path, "view flow.h5").out == "flow.html\n");
  browse(here / "flow.html", "shows_where_it_goes");
}

TEST_CASE("a running or stopped run is viewed up to its last row, with a notice") {
  if (program_is_missing()) return;
  const testing::Folder here;
  {
    Simulation<2> simulation(testing::falling_span());
    Recording<2> recording(here / "early.h5", simulation.model(), simulation.state());
    StageOptions o;
    o.duration = 0.1;
    o.frame_interval = 0.02;
    simulation.run(o, recording.listener());
    const Output output = run_program(here.path, "view early.h5");
    CHECK(output.prints("the run is in progress"));
    browse(here / "early.html", "shows_a_run_in_progress shows_a_body");
    recording.abandon("the power went");
  }
  CHECK(run_program(here.path, "view early.h5").prints("the run was stopped"));
  browse(here / "early.html", "shows_a_stopped_run plays_to_the_end");
}

TEST_CASE("trilith view rejects wrong output names and foreign files") {
  if (program_is_missing()) return;
  const testing::Folder here;
  testing::check_refused(run_program(here.path, "view nothing.h5"), "there is no such file");
  { results::ResultsWriter(here / "empty.h5", testing::sample_header()).finish(); }
  testing::check_refused(run_program(here.path, "view empty.h5 -o page.pdf"), "end with .html");
  testing::check_refused(run_program(here.path, "view empty.h5 -o empty.h5/where/page.html"), "cannot write");
  CHECK(run_program(here.path, "view empty.h5 -o new/folder/page.html").out == "new/folder/page.html\n");
  CHECK(run_program(here.path, "view").code == 2);
  CHECK(run_program(here.path, "view empty.h5").out == "empty.html\n");
  browse(here / "empty.html", "shows_that_there_is_no_frame");
  { results::ResultsWriter(here / "faceless.h5", testing::sample_header(2, 3)).finish(); }
  testing::check_refused(run_program(here.path, "view faceless.h5"), "contains no faces of solids");
}
