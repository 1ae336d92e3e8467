// A frame in space in the results file: all of its nodes, and its skin with the node of each part.
#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/space/space_frames.hpp"
#include "results/file/placement.hpp"
#include "run/record/recording_header.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("the skin of a frame in space that has moved is where a results file puts it") {
  SolidSpec spec = chain_body("angle", {Vec3(2, 0, 0), Vec3::Zero(), Vec3(0, 2, 0.5)}, plain_section(0.1, 0.2), 4);
  spec.spin = Vec3(3, -2, 1);
  SolidSpec stone;
  stone.name = "stone", stone.material = "steel", stone.floating = true;
  stone.pieces = {box_solid(Vec3(5, 5, 5), Vec3(6, 6, 6))};
  const Model<3> model = of_space_frames(member_material(2000, 1e8, 0.2), {stone, spec});
  SolidRun run(model, 1e-4);
  const results::Header header = recording_header(model, run.state(), RecordingOptions<3>{});
  REQUIRE(header.node_count() == static_cast<std::size_t>(model.nodes()));
  CHECK(header.bodies[1].kind == "frame");
  CHECK(header.bodies[1].node_count == 9);
  run.run(0.1);
  results::Frame frame;
  for (int n = 0; n < model.nodes(); ++n) {
    const Vec3& x = run.state().position[n];
    const UnitQuaternion& q = run.state().rotation[n];
    frame.position.insert(frame.position.end(), {x.x(), x.y(), x.z()});
    frame.rotation.insert(frame.rotation.end(), {q.w, q.x, q.y, q.z});
  }
  const results::Placement at(header, frame);
  int row = header.bodies[1].first_vertex;
  for (int p = model.bodies[1].first_piece; p < model.bodies[1].first_piece + model.bodies[1].pieces; ++p)
    for (const Vec3& corner : run.work().solids.placed[static_cast<std::size_t>(p)].corners)
      CHECK((at.vertex(row++) - corner).norm() < 1e-12);
  CHECK(row == header.bodies[1].first_vertex + header.bodies[1].vertex_count);
  // Inner cuts between the pieces are not faces: 4 sides each, both tips, and both ends at the joint, because obliquely
  // joined members cover each other's ends only in part.
  CHECK(header.bodies[1].face_count == 4 * model.bodies[1].pieces + 4);
}
