// Mesh sides in flat contact: slivers next to their inner nodes are face pairs like the others.
#include "broad_phase/face_line.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/evaluate.hpp"
#include "energy_watch.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

constexpr double joint_size = 0.4, mesh_height = 0.2;

/// Two stacked meshes: the lower one with `low` elements along the joint, the upper one with `top`.
Model<2> two_meshes(int low, int top, const ContactLaw& law = Frictional{1e10, 4e9, 0.6, 0}) {
  Scene scene(law);
  scene.set_gravity(Vec2::Zero());
  scene.builder.add_material(elastic("soft", 2000, 1e10, 0));
  scene.add(grid_body("low", rectangle({0, 0}, {joint_size, mesh_height}), "soft", low, 2));
  scene.add(grid_body("top", rectangle({0, mesh_height}, {joint_size, 2 * mesh_height}), "soft", top, 2));
  return scene.builder.build();
}

/// Resultant on the skin of one body: force, and moment about the middle of the joint.
struct SkinTotal {
  Vec2 force = Vec2::Zero();
  double moment = 0;
};

struct JointAnswer {
  SkinTotal on_top;
  int general = 0, faces = 0;
};

/// `alone`: faces do not know their neighbours, so that slivers are contacts of general shape.
JointAnswer joint_answer(Model<2> model, const State<2>& state, bool alone) {
  if (alone) model.skin_before.clear(), model.skin_after.clear();
  Work<2> work;
  evaluate(model, state, work, 0);
  JointAnswer out;
  out.general = static_cast<int>(work.general_touching.size());
  for (const ContactMemory& m : work.contacts.memory)
    out.faces += (m.state & contact_touching) != 0 && (m.state & contact_general) == 0 ? 1 : 0;
  const Body& top = model.bodies[1];
  for (int s = top.first_skin; s < top.first_skin + top.skins; ++s) {
    out.on_top.force += work.skin_force[s];
    out.on_top.moment +=
        cross(Vec2(work.skin[s].x - 0.5 * joint_size, work.skin[s].y - mesh_height), work.skin_force[s]);
  }
  return out;
}

/// State of the upper body pressed by `depth` into the lower one, slid by `slid` and rotated by `tilt`. In addition,
/// all nodes of the joint are displaced along it by up to `apart` in a pattern.
State<2> pressed_meshes(const Model<2>& model, double depth, double slid, double tilt, double apart) {
  State<2> state = initial_state(model);
  const Body& top = model.bodies[1];
  for (int n = 0; n < model.nodes(); ++n) {
    Vec2& x = state.position[n];
    const bool is_top = n >= top.first_node;
    if (is_top) {
      const Vec2 from = x - Vec2(0.5 * joint_size, mesh_height);
      x += Vec2(slid - tilt * from.y(), tilt * from.x() - depth);
    }
    if (std::abs(model.start_position[n].y() - mesh_height) < 1e-9)
      x.x() += apart * std::sin(3.0 * n + (is_top ? 1 : 0));
  }
  return state;
}

TEST_CASE("faces of a mesh in line: a flat joint has the forces of its overlap, with no contact of general shape") {
  double worst = 0;
  for (const std::pair<int, int>& elements : {std::pair{2, 2}, std::pair{4, 2}, std::pair{3, 4}, std::pair{5, 5}}) {
    const int low = elements.first, top = elements.second;
    const Model<2> model = two_meshes(low, top);
    REQUIRE(!model.skin_after.empty());
    for (const double slid : {0.0, 1e-9, -1e-7, 1e-5, -1e-4, 1e-3})
      for (const double apart : {0.0, 1e-8, 1e-6, 2e-5})
        for (const double tilt : {0.0, 1e-5, -2e-5}) {
          const double depth = 1e-5;
          const State<2> state = pressed_meshes(model, depth, slid, tilt, apart);
          const JointAnswer line = joint_answer(model, state, false), alone = joint_answer(model, state, true);
          INFO("elements ", low, " and ", top, ", slid ", slid, ", nodes apart ", apart, ", tilt ", tilt);
          CHECK(line.general == 0);
          const double carried = alone.on_top.force.y();
          const double off = (line.on_top.force - alone.on_top.force).norm() / carried,
                       turned = std::abs(line.on_top.moment - alone.on_top.moment) / (joint_size * carried);
          // The only difference are bevels of slivers, of second order in the penetration.
          CHECK(off < 1e-8);
          CHECK(turned < 1e-8);
          worst = std::max({worst, off, turned});
        }
  }
  MESSAGE("forces and moments differ by ", worst, " of what the joint carries");
}

TEST_CASE("faces of a mesh in line: the pressure of a joint is kn times depth over the length that both lines share") {
  const Model<2> model = two_meshes(3, 4);
  for (const double slid : {0.0, 1e-6, 1e-3, 0.05}) {
    const double depth = 2e-5;
    const JointAnswer line = joint_answer(model, pressed_meshes(model, depth, slid, 0, 1e-7), false);
    CHECK(line.general == 0);
    CHECK(near(line.on_top.force.y(), 1e10 * depth * (joint_size - slid), 1e-5));
  }
}

TEST_CASE("faces of a mesh in line: both sides of the limits of tilt and depth") {
  const Model<2> model = two_meshes(2, 2);
  const auto general = [&](double depth, double tilt) {
    return joint_answer(model, pressed_meshes(model, depth, 1e-7, tilt, 0), false).general;
  };
  // Two faces of 0.2 m with a neighbour each: a line of 0.4 m, with a penetration of up to 0.005 of it.
  CHECK(general(0.9 * face_pair_max_depth * joint_size, 0) == 0);
  CHECK(general(1.1 * face_pair_max_depth * joint_size, 0) > 0);
  CHECK(general(0.5e-3, 0.9 * face_pair_max_tilt) == 0);
  CHECK(general(0.5e-3, 1.1 * face_pair_max_tilt) > 0);
}

TEST_CASE("faces of a mesh in line: a side that is bent by more than the limit is not a line") {
  const Model<2> model = two_meshes(2, 2);
  const auto bent = [&](double by) {
    State<2> state = pressed_meshes(model, 2e-5, 1e-7, 0, 0);
    // The middle of the lower side is displaced downwards, and the upper one by less: faces tilt against their
    // neighbours.
    state.position[node_at(model, {0.5 * joint_size, mesh_height})].y() -= by;
    return joint_answer(model, state, false).general;
  };
  CHECK(bent(0) == 0);
  CHECK(bent(0.2 * face_pair_max_tilt * 0.5 * joint_size) == 0);
}

TEST_CASE("faces of a mesh in line: rigid bodies, quads and corners of meshes have no neighbours") {
  Scene scene(Frictional{1e10, 4e9, 0.6, 0});
  scene.builder.add_material(elastic("soft", 2000, 1e10, 0));
  scene.fixed("rigid", rectangle({0, 0}, {1, 1}));
  BodySpec quad = grid_body("quad", rectangle({2, 0}, {3, 1}), "soft", 1, 1);
  scene.add(quad);
  CHECK(scene.builder.build().skin_after.empty());
  scene.add(grid_body("mesh", rectangle({4, 0}, {5, 1}), "soft", 2, 1));
  scene.fixed("later", rectangle({6, 0}, {7, 1}));
  const Model<2> model = scene.builder.build();
  REQUIRE(model.skin_after.size() == model.skin_place.size());
  int linked = 0;
  for (int s = 0; s < static_cast<int>(model.skin_after.size()); ++s) linked += model.skin_after[s] != s ? 1 : 0;
  CHECK(linked == 2);  // the middles of its two long sides
}

TEST_CASE("faces of a mesh in line: meshes that slide and hop on each other keep their energy and their momentum") {
  for (const double beta : {0.0, 2e-5}) {
    Model<2> model = two_meshes(3, 4, Frictional{1e9, 4e8, 0.4, beta});
    for (int n = model.bodies[1].first_node; n < model.nodes(); ++n) model.start_velocity[n] = {0.3, -0.05};
    Simulation<2> sim(model);
    StageOptions options;
    options.duration = 0.05, options.energy_interval = 1e-4, options.safety = 0.2;
    EnergyWatch watch;
    RunListener<2> listener;
    watch.listen(listener);
    const auto momenta = [&](const State<2>& s) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int n = 0; n < model.nodes(); ++n) {
        const Vec2 p = model.mass[n] * s.velocity[n];
        sum += Eigen::Vector3d(p.x(), p.y(), cross(s.position[n], p));
      }
      return sum;
    };
    const Eigen::Vector3d before = momenta(sim.state());
    sim.run(options, listener);
    const Eigen::Vector3d after = momenta(sim.state());
    MESSAGE("residual ", watch.check.share(), ", momenta ", (after - before).norm() / before.norm());
    CHECK(watch.check.share() < 2e-3);
    CHECK(std::abs(after[0] - before[0]) < 1e-9 * before.norm());
    CHECK(std::abs(after[1] - before[1]) < 1e-9 * before.norm());
    CHECK(std::abs(after[2] - before[2]) < 1e-5 * before.norm());
  }
}

}  // namespace
}  // namespace trilith::testing
