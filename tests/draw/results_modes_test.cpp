// Pictures of natural modes: readable displacements about the current position.
#include "draw/results/results_modes.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"
#include "near.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::draw;
using results::Header;
using results::ModeRow;

namespace {

/// Three blocks of 1 m x 2 m side by side, 2 m apart; the first is fixed.
ModeRow mode_of_blocks(const Header& header, double sway, double turn) {
  ModeRow mode;
  mode.frequency = 2.5, mode.damping = 0.031, mode.number = 2, mode.time = 0.75;
  mode.position = header.node_position, mode.rotation = header.node_rotation;
  mode.displacement = {0, 0, sway, 0, 0.5 * sway, 0};
  mode.turn = {0, turn, 0};
  return mode;
}

double largest_way(const Scene& scene) {
  double most = 0;
  std::size_t ghost = 0;
  for (const SceneBody& body : scene.bodies) {
    if (body.role != BodyRole::free) continue;
    for (std::size_t i = 0; i < body.outline.size(); ++i)
      most = std::max(most, (body.outline[i] - scene.ghosts[ghost][i]).norm());
    ++ghost;
  }
  return most;
}

}  // namespace

TEST_CASE("a mode is drawn with its largest displacement at 6 % of the structure's size, whatever its own scale") {
  const Header header = testing::sample_header();
  const double size = std::hypot(3.0, 2.0);  // of the two free blocks
  for (const double sway : {1e-3, 40.0}) {
    const Scene scene = mode_scene(header, mode_of_blocks(header, sway, 0));
    CHECK(testing::near(largest_way(scene), 0.06 * size, 1e-12));
    CHECK(scene.ghosts.size() == 2);
    CHECK(scene.title == "mode 2");
    CHECK(scene.stage == "2.5 Hz, damping 3.1 %");
    CHECK(*scene.time == 0.75);
    CHECK(testing::near(largest_way(mode_scene(header, mode_of_blocks(header, sway, 0), 3)), 0.18 * size, 1e-12));
  }
}

TEST_CASE("a mode that is mostly a rotation is drawn with half a radian") {
  const Header header = testing::sample_header();
  const ModeRow mode = mode_of_blocks(header, 1e-6, 20);
  // The corner of a block moves by more than 6 % of the size only by rotations above 0.19 rad: the displacement
  // governs.
  CHECK(testing::near(mode_scale(header, mode) * 20, 0.06 * std::hypot(3.0, 2.0) / std::hypot(0.5, 1), 1e-6));
  Header far = testing::sample_header(60);
  ModeRow small = mode_of_blocks(header, 1e-6, 20);
  small.position = far.node_position, small.rotation = far.node_rotation;
  small.displacement.resize(120), small.turn.resize(60);
  CHECK(testing::near(mode_scale(far, small) * 20, 0.5, 1e-12));
}

TEST_CASE("of several sets of modes the last before the given time is drawn, and without one it is an error") {
  const testing::Folder folder;
  const Header header = testing::sample_header();
  results::ResultsWriter writer(folder / "run.h5", header);
  CHECK_THROWS_AS(modes_found(results::ResultsReader(folder / "run.h5")), InputError);
  for (const int analysis : {0, 1})
    for (const int number : {1, 2}) {
      ModeRow mode = mode_of_blocks(header, 1, 0);
      mode.analysis = analysis, mode.time = 1 + analysis, mode.number = number;
      writer.append_mode(mode);
    }
  writer.finish();
  const results::ResultsReader reader(folder / "run.h5");
  CHECK(modes_found(reader).front().analysis == 1);
  CHECK(modes_found(reader).size() == 2);
  CHECK(modes_found(reader, 1.5).front().analysis == 0);
  CHECK_THROWS_WITH_AS(modes_found(reader, 0.5), doctest::Contains("the first were computed at 1 s"), InputError);
}
