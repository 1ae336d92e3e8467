// Motion of the pieces of frames: their corners rotate with the sections.
#include "broad_phase/moving_piece.hpp"

#include "near.hpp"
#include "physics/members/frames.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("the corners of a beam's pieces have the velocities of their paths, and these bend by its spin squared") {
  Scene scene(Frictional{1e8, 5e7, 0.6, 0});
  scene.builder.add_material(elastic_material("concrete", 2400, 30e9));
  scene.builder.add_body(beam_body("beam", {0, 0}, {4, 0}, rectangle_section(1, 0.4), "concrete", 4));
  const Model<2> model = scene.builder.build();
  State<2> state = initial_state(model);
  for (int n = 0; n < model.nodes(); ++n)
    state.rotation[n] = 0.1 * n, state.velocity[n] = {0.3 * n, 1 - 0.2 * n}, state.spin[n] = 2 - 0.7 * n;
  constexpr double h = 1e-4;
  REQUIRE(model.pieces() >= 4);
  for (int piece = 0; piece < model.pieces(); ++piece) {
    const MovingPiece before = moving_piece(model, state, piece, -h), now = moving_piece(model, state, piece),
                      after = moving_piece(model, state, piece, h);
    double bend = 0;
    for (int c = 0; c < now.corners; ++c) {
      CHECK(near_zero((now.velocity[c] - (after.at[c] - before.at[c]) / (2 * h)).norm(), 1e-7));
      bend = std::max(bend, (after.at[c] - 2 * now.at[c] + before.at[c]).norm() / (h * h));
    }
    CHECK(near(now.bend, bend, 1e-5));
  }
}
