// Ground motions in a results file.
#include <doctest/doctest.h>

#include <cmath>

#include "draw/chart/stored_motion.hpp"
#include "near.hpp"
#include "results/file/extended.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

MotionRow sample_motion(int body, const std::string& direction, double size) {
  MotionRow row;
  row.body = row.node = body;
  row.direction = direction;
  row.begin = 0.02, row.origin = 0.5, row.step = 0.01, row.start_time = 0.005;
  row.start_velocity = 0.1, row.start_displacement = -0.25;
  row.record = "somewhere.at2", row.title = "Somewhere, 1 January", row.text = "somewhere.at2, x 2";
  for (int i = 0; i < 400; ++i) row.acceleration.push_back(size * std::sin(0.1 * i) / 3);
  return row;
}

void check_same(const MotionRow& got, const MotionRow& want) {
  CHECK(got.body == want.body);
  CHECK(got.node == want.node);
  CHECK(got.direction == want.direction);
  CHECK(got.begin == want.begin);
  CHECK(got.origin == want.origin);
  CHECK(got.step == want.step);
  CHECK(got.start_time == want.start_time);
  CHECK(got.start_velocity == want.start_velocity);
  CHECK(got.start_displacement == want.start_displacement);
  CHECK(got.record == want.record);
  CHECK(got.title == want.title);
  CHECK(got.text == want.text);
  CHECK(got.acceleration == want.acceleration);
}

}  // namespace

TEST_CASE("motions are read back to the bit while the file is written and finished and samples are stored once") {
  for (const int dim : {2, 3}) {
    const Folder folder;
    const Header header = sample_header(3, dim);
    ResultsWriter writer(folder / "run.h5", header);
    const MotionRow first = sample_motion(0, "x", 1), other = sample_motion(1, "y", 2);
    MotionRow delayed = sample_motion(2, "x", 1);
    delayed.start_time = 0.3;
    writer.append_motion(first);
    SampleRow(header, 0).append_to(writer);
    writer.append_motion(other);
    writer.append_motion(delayed);
    const auto check_all = [&] {
      const std::vector<MotionRow> read = ResultsReader(folder / "run.h5").motions();
      REQUIRE(read.size() == 3);
      check_same(read[0], first);
      check_same(read[1], other);
      check_same(read[2], delayed);
      CHECK(read[2].first_sample == read[0].first_sample);
      CHECK(read[1].first_sample == 400);
    };
    check_all();
    writer.finish();
    check_all();
  }
}

TEST_CASE("a motion of an unknown body or with too few samples is rejected and leaves the file usable") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  for (const int wrong : {0, 1, 2, 3, 4}) {
    MotionRow motion = sample_motion(0, "x", 1);
    if (wrong == 0) motion.body = 3;
    if (wrong == 1) motion.node = -1;
    if (wrong == 2) motion.acceleration.resize(1);
    if (wrong == 3) motion.step = 0;
    if (wrong == 4) motion.acceleration[7] = std::nan("");
    CHECK_THROWS_AS(writer.append_motion(motion), ResultsError);
  }
  writer.finish();
  CHECK(ResultsReader(folder / "run.h5").motions().empty());
}

TEST_CASE("motions keep their rows when bodies are added to the file") {
  const Folder folder;
  const Header header = sample_header(), more = sample_header(5);
  ResultsWriter writer(folder / "run.h5", header);
  writer.append_motion(sample_motion(0, "x", 1));
  ResultsWriter longer = extended(std::move(writer), more, {});
  longer.append_motion(sample_motion(4, "x", 3));
  longer.finish();
  const std::vector<MotionRow> read = ResultsReader(folder / "run.h5").motions();
  REQUIRE(read.size() == 2);
  check_same(read[0], sample_motion(0, "x", 1));
  check_same(read[1], sample_motion(4, "x", 3));
}

TEST_CASE("a stored motion equals its source, and the deviation of a body from it is reported") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  const MotionRow row = sample_motion(0, "x", 1);
  writer.append_motion(row);
  const GroundMotion motion = draw::stored_motion(row);
  const GroundMotion made =
      GroundMotion(row.acceleration, row.step, {row.start_velocity, row.start_displacement}).delayed(row.start_time);
  for (const double t : {0.0, 0.004, 0.1, 3.9, 9.0}) CHECK(motion.displacement(t) == made.displacement(t));
  writer.begin_stage("shake", "dynamic", 0);
  for (int i = 0; i < 20; ++i) {
    SampleRow sample(header, i);
    sample.position[0] = row.origin + made.displacement(sample.time - row.begin) + (i == 11 ? 1e-3 : 0);
    if (sample.time < row.begin) sample.position[0] = 99;  // before its start the body has another position
    sample.frame.position = sample.position;
    sample.append_to(writer);
  }
  writer.finish();
  const ResultsReader reader(folder / "run.h5");
  const std::vector<double> miss = draw::motion_misses(reader, reader.motions());
  REQUIRE(miss.size() == 1);
  CHECK(near(miss[0], 1e-3, 1e-9));
}

TEST_CASE("pictures are titled by the model's name or where it has none by the file's") {
  const Folder folder;
  Header header = sample_header();
  ResultsWriter(folder / "plain.h5", header).finish();
  CHECK(ResultsReader(folder / "plain.h5").title() == "plain");
  header.provenance.model = "seven spans";
  ResultsWriter(folder / "named.h5", header).finish();
  CHECK(ResultsReader(folder / "named.h5").title() == "seven spans");
}
