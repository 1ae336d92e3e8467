// Natural modes in a results file.
#include <doctest/doctest.h>

#include "results/file/extended.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

ModeRow sample_mode(const Header& header, int analysis, int number) {
  const std::size_t nodes = header.node_count(), dim = static_cast<std::size_t>(header.dim);
  ModeRow mode;
  mode.analysis = analysis, mode.number = number, mode.time = 0.5 * analysis;
  mode.frequency = 2.5 * number, mode.damping = 0.01 * number;
  for (std::size_t k = 0; k < dim; ++k) mode.mass[k] = 7.0 * number + static_cast<double>(k);
  const auto fill = [&](std::vector<double>& to, std::size_t size, double base) {
    for (std::size_t i = 0; i < size; ++i) to.push_back(base + number + static_cast<double>(i) / 7);
  };
  fill(mode.position, nodes * dim, 1);
  fill(mode.rotation, nodes * static_cast<std::size_t>(rotation_width(header.dim)), 2);
  fill(mode.displacement, nodes * dim, 3);
  fill(mode.turn, nodes * static_cast<std::size_t>(spin_width(header.dim)), 4);
  return mode;
}

void check_modes(const ResultsReader& reader) {
  const std::vector<ModeRow> read = reader.modes();
  REQUIRE(read.size() == 5);
  for (int i = 0; i < 5; ++i) {
    const ModeRow want = sample_mode(reader.header(), i / 3, 1 + i % 3), &got = read[static_cast<std::size_t>(i)];
    CHECK(got.analysis == want.analysis);
    CHECK(got.number == want.number);
    CHECK(got.time == want.time);
    CHECK(got.frequency == want.frequency);
    CHECK(got.damping == want.damping);
    CHECK(std::equal(got.mass, got.mass + 3, want.mass));
    CHECK(got.position == want.position);
    CHECK(got.rotation == want.rotation);
    CHECK(got.displacement == want.displacement);
    CHECK(got.turn == want.turn);
  }
}

}  // namespace

TEST_CASE("modes written to a results file are read back to the bit, while it is written and finished") {
  for (const int dim : {2, 3}) {
    const Folder folder;
    const Header header = sample_header(3, dim);
    ResultsWriter writer(folder / "run.h5", header);
    for (int i = 0; i < 5; ++i) {
      writer.append_mode(sample_mode(header, i / 3, 1 + i % 3));
      if (i == 2) SampleRow(header, 0).append_to(writer);
    }
    check_modes(ResultsReader(folder / "run.h5"));
    writer.finish();
    check_modes(ResultsReader(folder / "run.h5"));
  }
}

TEST_CASE("a mode with too few or non-finite numbers is rejected and leaves the file usable") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter writer(folder / "run.h5", header);
  ModeRow mode = sample_mode(header, 0, 1);
  mode.displacement.pop_back();
  CHECK_THROWS_AS(writer.append_mode(mode), ResultsError);
  mode = sample_mode(header, 0, 1);
  mode.turn[0] = std::nan("");
  CHECK_THROWS_AS(writer.append_mode(mode), ResultsError);
  writer.finish();
  CHECK(ResultsReader(folder / "run.h5").modes().empty());
}

TEST_CASE("modes keep their rows when bodies are added to the file, and later bodies stand still in them") {
  const Folder folder;
  const Header header = sample_header(), more = sample_header(5);
  ResultsWriter writer(folder / "run.h5", header);
  writer.append_mode(sample_mode(header, 0, 1));
  ResultsWriter longer = extended(std::move(writer), more, {});
  longer.append_mode(sample_mode(more, 1, 1));
  longer.finish();
  const std::vector<ModeRow> read = ResultsReader(folder / "run.h5").modes();
  REQUIRE(read.size() == 2);
  const ModeRow was = sample_mode(header, 0, 1);
  CHECK(std::equal(was.displacement.begin(), was.displacement.end(), read[0].displacement.begin()));
  CHECK(read[0].displacement.size() == 10);
  CHECK(read[0].displacement[8] == 0);
  CHECK(read[0].turn[4] == 0);
  CHECK(read[0].position[8] == more.node_position[8]);
  CHECK(read[1].displacement == sample_mode(more, 1, 1).displacement);
}
