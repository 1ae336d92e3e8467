#include <doctest/doctest.h>

#include "base/error.hpp"
#include "near.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

void write_sample(const std::filesystem::path& path, const Header& header, int rows, int flush_every) {
  ResultsWriter writer(path, header);
  writer.append_note(0, "the polygon of 'span 1' ran clockwise and was turned");
  const std::int32_t stage = writer.begin_stage("shake", "dynamic", 0);
  CHECK(stage == 0);
  for (int i = 0; i < rows; ++i) {
    SampleRow(header, i).append_to(writer);
    if (i % flush_every == 0) writer.flush();
  }
  writer.end_stage(0.01 * (rows - 1), "at rest");
  writer.finish();
}

}  // namespace

TEST_CASE("everything written to a results file is read back to the bit, in two and three dimensions") {
  for (const int dim : {2, 3}) {
    const Folder folder;
    const Header header = sample_header(3, dim);
    const int rows = 137;
    write_sample(folder / "run.h5", header, rows, 10);
    CHECK(!std::filesystem::exists(folder / "run.h5.part"));
    const ResultsReader reader(folder / "run.h5");
    CHECK(reader.finished());
    CHECK(!reader.running());
    const Header& read = reader.header();
    CHECK(read.dim == dim);
    CHECK(read.provenance.script == header.provenance.script);
    CHECK(read.provenance.command_line == header.provenance.command_line);
    CHECK(read.provenance.motions == header.provenance.motions);
    REQUIRE(read.provenance.parameters.size() == 1);
    CHECK(read.provenance.parameters[0].fallback == "0.35");
    REQUIRE(read.bodies.size() == 3);
    CHECK(read.bodies[2].name == "span 3");
    CHECK(read.bodies[2].groups == "spans deck");
    CHECK(read.bodies[2].first_vertex == 8);
    CHECK(read.vertices == header.vertices);
    CHECK(read.vertex_node == header.vertex_node);
    CHECK(read.node_position == header.node_position);
    CHECK(read.node_rotation == header.node_rotation);
    CHECK(read.node_mass == header.node_mass);
    CHECK(read.node_inertia == header.node_inertia);
    REQUIRE(read.laws.size() == 2);
    CHECK(read.laws[1].second == "ground");
    REQUIRE(read.bearings.size() == 2);
    CHECK(read.bearings[1].body_b == 2);
    CHECK(read.bearings[1].point_b[0] == -0.5);
    REQUIRE(read.histories.size() == 2);
    CHECK(read.histories[0].name == "top.x");
    CHECK(read.histories[1].unit == "N");
    REQUIRE(read.energy_terms.size() == 2);
    CHECK(read.energy_terms[1].name == "input");
    CHECK(read.with_velocity);

    REQUIRE(reader.frame_count() == rows);
    for (int i = 0; i < rows; ++i) CHECK(has_row(reader, i));
    const std::vector<double> history = reader.history("base shear"), times = reader.history_times();
    REQUIRE(history.size() == rows);
    CHECK(history[100] == -300);
    CHECK(times[100] == 0.01 * 100);
    const EnergyTable energy = reader.energy();
    REQUIRE(energy.terms.size() == 2);
    CHECK(energy.terms[1].at(50) == 100);
    CHECK(energy.residual.at(50) == 1e-9);
    const std::vector<EventRow> events = reader.events();
    REQUIRE(events.size() == rows);
    CHECK(events[7].type == "bearing.failed");
    CHECK(events[7].body_b_name == "span 2");
    CHECK(events[7].bearing_name == "bearing 1");
    CHECK(events[7].first.name == "displacement");
    CHECK(events[7].first.unit == "m");
    CHECK(events[7].first.value == 7.05);
    CHECK(events[7].second.name.empty());
    CHECK(events[7].has_place);
    CHECK(events[7].place[0] == 7.5);
    CHECK(events[7].cause == 6);
    CHECK(events[7].text == "the bearing reached its limit");
    const std::vector<StageRow> stages = reader.stages();
    REQUIRE(stages.size() == 1);
    CHECK(stages[0].name == "shake");
    CHECK(stages[0].ended);
    CHECK(stages[0].why == "at rest");
    CHECK(stages[0].end == 0.01 * (rows - 1));
    REQUIRE(reader.notes().size() == 1);
    CHECK(reader.notes()[0].text.find("clockwise") != std::string::npos);
  }
}

TEST_CASE("the bytes of a finished file depend on its rows alone, not on when they were flushed") {
  const Folder folder;
  const Header header = sample_header();
  write_sample(folder / "a.h5", header, 300, 10);
  write_sample(folder / "b.h5", header, 300, 10);
  write_sample(folder / "c.h5", header, 300, 7);
  const std::string a = bytes_of(folder / "a.h5");
  CHECK(a.size() > 10000);
  CHECK(a == bytes_of(folder / "b.h5"));
  CHECK(a == bytes_of(folder / "c.h5"));
}

TEST_CASE("a run without frames, bearings, histories or events finishes as a readable file") {
  const Folder folder;
  Header header = sample_header(1);
  header.bearings.clear();
  header.histories.clear();
  header.energy_terms.clear();
  header.laws.clear();
  header.provenance = {};
  header.with_velocity = false;
  ResultsWriter(folder / "run.h5", header).finish();
  const ResultsReader reader(folder / "run.h5");
  CHECK(reader.finished());
  CHECK(reader.frame_count() == 0);
  CHECK(reader.events().empty());
  CHECK(reader.energy().residual.empty());
  CHECK_THROWS_AS(reader.frame(0), ResultsError);
  CHECK_THROWS_AS(reader.nearest_frame(1), ResultsError);
  CHECK_THROWS_WITH_AS(reader.history("x"), doctest::Contains("has no histories"), ResultsError);
}

TEST_CASE("a frame between two frames is interpolated, and the nearest one is found at both ends") {
  const Folder folder;
  const Header header = sample_header();
  write_sample(folder / "run.h5", header, 5, 2);
  const ResultsReader reader(folder / "run.h5");
  CHECK(reader.nearest_frame(-1) == 0);
  CHECK(reader.nearest_frame(9) == 4);
  CHECK(reader.nearest_frame(0.014) == 1);
  CHECK(reader.nearest_frame(0.016) == 2);
  const Frame between = reader.frame_at(0.0125), first = reader.frame(1), second = reader.frame(2);
  CHECK(between.time == 0.0125);
  CHECK(near(between.position[1], 0.75 * first.position[1] + 0.25 * second.position[1], 1e-12));
  CHECK(near(between.rotation[2], 0.75 * first.rotation[2] + 0.25 * second.rotation[2], 1e-12));
  CHECK(between.contacts.size() == first.contacts.size());
  CHECK(reader.frame_at(99).position == reader.frame(4).position);
  CHECK(reader.frame_at(0.02).position == second.position);
}

TEST_CASE("quaternions are interpolated along the shorter arc and keep unit length") {
  const Folder folder;
  Header header = sample_header(1, 3);
  header.with_velocity = false;
  const double c = std::sqrt(0.5);
  const std::vector<double> place = {0, 0, 0}, none = {1, 0, 0, 0}, quarter_turn = {-c, 0, 0, -c};
  {
    ResultsWriter writer(folder / "run.h5", header);
    FrameRow frame;
    frame.position = place;
    frame.rotation = none;
    writer.append_frame(frame);
    frame.time = 1;
    frame.rotation = quarter_turn;
    writer.append_frame(frame);
    writer.finish();
  }
  const Frame half = ResultsReader(folder / "run.h5").frame_at(0.5);
  CHECK(near(half.rotation[0], std::cos(std::acos(-1.0) / 8), 1e-12));
  CHECK(near(half.rotation[3], std::sin(std::acos(-1.0) / 8), 1e-12));
}

TEST_CASE("text is kept as valid UTF-8: bad bytes become question marks, long text is cut at a character") {
  const Folder folder;
  Header header = sample_header();
  header.provenance.script = std::string("a\xff\0b", 4);
  {
    ResultsWriter writer(folder / "run.h5", header);
    EventRow event;
    for (int i = 0; i < 100; ++i) event.text += "ü";
    event.type = "impact";
    writer.append_event(event);
    writer.finish();
  }
  const ResultsReader reader(folder / "run.h5");
  CHECK(reader.header().provenance.script == "a??b");
  std::string kept;
  for (int i = 0; i < 78; ++i) kept += "ü";
  CHECK(reader.events().at(0).text == kept + "…");
}

TEST_CASE("an unknown history is rejected with the nearest name") {
  const Folder folder;
  write_sample(folder / "run.h5", sample_header(), 3, 1);
  const ResultsReader reader(folder / "run.h5");
  CHECK_THROWS_WITH_AS(reader.history("base shaer"), doctest::Contains("did you mean 'base shear'?"), ResultsError);
}

TEST_CASE("names of histories that a file cannot hold are rejected before anything is written") {
  const Folder folder;
  for (const char* name : {"", "a/b", ".", "time", "top.x"}) {
    Header header = sample_header();
    header.histories.push_back({name, "m", ""});
    CHECK_THROWS_AS(ResultsWriter(folder / "run.h5", header), InputError);
  }
  Header header = sample_header();
  header.energy_terms.push_back({"residual", "J", ""});
  CHECK_THROWS_AS(ResultsWriter(folder / "run.h5", header), InputError);
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a number that is not finite and an array of the wrong size never reach the file") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  SampleRow row(header, 1);
  row.position[3] = std::nan("");
  CHECK_THROWS_WITH_AS(writer.append_frame(row.frame), doctest::Contains("number 3 of position is nan"), ResultsError);
  const SampleRow other(header, 1);
  FrameRow narrow = other.frame;
  narrow.position = std::span<const double>(row.rotation);
  CHECK_THROWS_WITH_AS(writer.append_frame(narrow), doctest::Contains("position has 3 numbers, needs 6"), ResultsError);
  const double bad[2] = {0, INFINITY};
  CHECK_THROWS_WITH_AS(writer.append_history(0.5, bad), doctest::Contains("history 'base shear'"), ResultsError);
  CHECK_THROWS_WITH_AS(writer.append_energy(0.5, bad, 0), doctest::Contains("energy term 'input'"), ResultsError);
  writer.finish();
  CHECK(ResultsReader(folder / "run.h5").frame_count() == 0);
  CHECK_THROWS_WITH_AS(writer.flush(), doctest::Contains("is finished"), ResultsError);
}
