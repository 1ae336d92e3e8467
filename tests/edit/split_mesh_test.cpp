// Meshes that crack along edges of their elements: the stress at the edges, and quantities that a split conserves.
#include "edit/split_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "edit/mesh_section.hpp"
#include "edit/motion_sums.hpp"
#include "edit/split.hpp"
#include "model/builder/crack_mesh.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "statics/equilibrium.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double depth = 0.1, height = 0.2, length = 0.8, weak = 3e6;

Cohesive concrete_joint() {
  Cohesive law;
  law.kn = 1e13, law.ks = 5e12, law.mu = 0.6, law.tension = weak, law.cohesion = 2 * weak;
  law.energy_tension = 100, law.energy_shear = 400;
  return law;
}

/// A mesh of quadrilaterals or triangles, rotated by an angle [rad] in the plane. Held along x at its left end, and at
/// one node along y.
struct MeshBar {
  Scene scene;
  double angle;
  explicit MeshBar(bool held_left, bool triangles = false, double turned = 0)
      : scene(Frictional{1e10, 5e9, 0.6, 0}), angle(turned) {
    ModelBuilder& builder = scene.builder;
    builder.thickness = depth;
    scene.set_gravity(Vec2::Zero());
    builder.add_material({"concrete", 2400, Solid{LinearElastic{30e9, 0.2}}});
    builder.add_law("plane", concrete_joint());
    const Turn turn(angle);
    Mesh mesh = grid_mesh({Vec2(0, 0), Vec2(length, 0), Vec2(length, height), Vec2(0, height)}, 16, 4);
    if (triangles) {
      Mesh halves{mesh.node, {}};
      for (const auto& q : mesh.element) {
        halves.element.push_back({q[0], q[1], q[2], -1});
        halves.element.push_back({q[0], q[2], q[3], -1});
      }
      mesh = halves;
    }
    for (Vec2& p : mesh.node) p = turn.apply(p);
    BodySpec spec;
    spec.name = "bar", spec.kind = BodyKind::mesh, spec.mesh = mesh, spec.material = "concrete";
    spec.floating = true;
    if (held_left)
      spec.supports = {{Vec2(0, 0), Vec2(0, height), {Support::fixed, Support::free}},
                       {Vec2(0, 0), Vec2(0, 0), {Support::fixed, Support::fixed}}};
    spec.cracks.planes = {{turn.apply(Vec2(0.5 * length, 0)), turn.apply(Vec2(1, 0))}};
    spec.cracks.law = "plane";
    builder.add_body(spec);
  }
};

/// Forces on the right end with a linear stress over it [N], by the consistent forces of its edges.
void load_right_end(Model<2>& model, const std::function<double(double)>& stress) {
  std::vector<std::pair<double, std::size_t>> end;
  for (std::size_t n = 0; n < model.mass.size(); ++n)
    if (std::abs(model.start_position[n].x() - length) < 1e-9) end.emplace_back(model.start_position[n].y(), n);
  std::sort(end.begin(), end.end());
  for (std::size_t i = 0; i + 1 < end.size(); ++i) {
    const double size = depth * (end[i + 1].first - end[i].first), a = stress(end[i].first),
                 b = stress(end[i + 1].first);
    model.load[end[i].second].x() += size * (a / 3 + b / 6),
        model.load[end[i + 1].second].x() += size * (a / 6 + b / 3);
  }
}

const CrackSection<2>& section_of(const Simulation<2>& sim) {
  return sim.cracking().bodies.front().sections.front();
}

std::vector<Crack<2>> crack_mesh_now(Simulation<2>& sim) {
  sim.refresh();
  const CrackingBody<2>& row = sim.cracking().bodies.front();
  CrackScratch<2> scratch;
  Crack<2> crack;
  crack.body = row.body, crack.section = 0, crack.stress = weak;
  crack.traction = mesh_tractions(sim.model(), sim.state(), row.body, *section_of(sim).cut, scratch);
  const std::vector<Turn> turns = turns_of_cut(sim.model(), sim.state(), row.body, *section_of(sim).cut);
  for (std::size_t i = 0; i < turns.size(); ++i) crack.traction[i] = turns[i].undo(crack.traction[i]);
  return {crack};
}

}  // namespace

TEST_CASE("the stress at the edges of a mesh is the exact one of a pulled and of a bent bar") {
  for (const bool triangles : {false, true})
    for (const bool bent : {false, true}) {
      if (bent && triangles) continue;  // triangles of constant strain do not bend exactly
      CAPTURE(triangles);
      CAPTURE(bent);
      const MeshBar bar(true, triangles);
      ModelBuilder builder = bar.scene.builder;
      Model<2> model = builder.build();
      const auto stress = [&](double y) { return bent ? 2e6 * (1 - 2 * y / height) : 1e6; };
      load_right_end(model, stress);
      State<2> state = initial_state(model);
      CHECK(find_equilibrium(model, state).converged);
      const std::vector<CrackingBody<2>> rows = builder.cracking(model);
      const MeshCut& cut = *rows.front().sections.front().cut;
      CHECK(cut.faces.size() == 4);
      CrackScratch<2> scratch;
      const std::vector<Vec2> t = mesh_tractions(model, state, 0, cut, scratch);
      for (std::size_t i = 0; i < t.size(); ++i) {
        const double y = model.start_position[static_cast<std::size_t>(cut.nodes[i])].y();
        CHECK(near_zero(t[i].x() - stress(y), 1e-3 * 2e6));
        CHECK(near_zero(t[i].y(), 1e-3 * 2e6));
      }
    }
}

TEST_CASE("a mesh cracks above the strength of its law and not below it") {
  for (const double share : {0.99, 1.01}) {
    CAPTURE(share);
    const MeshBar bar(true);
    ModelBuilder builder = bar.scene.builder;
    Model<2> model = builder.build();
    load_right_end(model, [&](double) { return share * weak; });
    State<2> state = initial_state(model);
    CHECK(find_equilibrium(model, state).converged);
    CrackScratch<2> scratch;
    const CrackSearch<2> found = mesh_cracks(model, state, Cracking<2>{builder.cracking(model), {}}, scratch);
    const std::vector<Crack<2>>& cracks = found.cracks;
    CHECK(near(found.share, share, 1e-4));
    CHECK(cracks.size() == (share > 1 ? 1 : 0));
    if (share < 1) continue;
    CHECK(cracks.front().mode == JointMode::tension);
    CHECK(near(cracks.front().stress, share * weak, 1e-4));
    CHECK(near(cracks.front().place.x(), 0.5 * length, 1e-3));
  }
}

TEST_CASE("a mesh that splits in motion keeps mass, momentum, angular momentum and energy, and no force jumps") {
  for (const bool triangles : {false, true})
    for (const double angle : {0.0, 0.5}) {
      CAPTURE(triangles);
      CAPTURE(angle);
      MeshBar bar(false, triangles, angle);
      ModelBuilder& builder = bar.scene.builder;
      Simulation<2> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      // It spins, and waves run through it.
      sim.edit([&](Model<2>& model) {
        const Vec2 end = Turn(angle).apply(Vec2(length, height));
        for (std::size_t n = 0; n < model.mass.size(); ++n)
          if ((model.start_position[n] - end).norm() < 0.3) model.load[n] = 6e3 * model.mass[n] * Vec2(1, 0.7);
      });
      run_for(sim, 1e-3);
      sim.grow(Model<2>(sim.model()));  // a change without a change: ends the last step, as each change does
      const std::vector<Crack<2>> cracks = crack_mesh_now(sim);
      double size = 0;
      for (const Vec2& t : cracks.front().traction) size = std::max(size, t.norm());
      CHECK(size > 0.1 * weak);
      CHECK(size < weak);
      const PresentMotion<2> before = motion_of_present(sim);
      const double balance = sim.energy().balance(), elastic = sim.energy()[EnergyTerm::strain];
      const std::vector<Vec2> force = sim.work().force;
      const Model<2> whole = sim.model();
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      sim.refresh();
      const PresentMotion<2> after = motion_of_present(sim);
      CHECK(near(after.mass, before.mass, 1e-14));
      CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum.norm());
      CHECK((after.first - before.first).norm() < 1e-13 * before.first.norm());
      CHECK(near(after.angular, before.angular, 1e-12));
      CHECK(near(after.kinetic, before.kinetic, 1e-12));
      CHECK(near_zero(sim.energy().balance() - balance, 1e-9 * elastic));
      // The strain of the elements changes by the ratio of the opening to their size only.
      CHECK(near(sim.energy()[EnergyTerm::strain], elastic, 1e-4));
      CHECK(sim.energy()[EnergyTerm::contact_elastic] > 0);
      // Both copies of a node on the cut keep its acceleration.
      const MeshParts<2> parts(sim.model(), {0, 1, 2}, *section_of(sim).cut);
      double largest = 0, jump = 0;
      for (int n = 0; n < whole.bodies[0].nodes; ++n)
        for (const int side : {0, 1}) {
          const int copy = parts.copy(side, n);
          if (copy < 0) continue;
          const auto at = static_cast<std::size_t>(n), own = static_cast<std::size_t>(copy);
          const Vec2 a = force[at] / whole.mass[at], now = sim.work().force[own] / sim.model().mass[own];
          largest = std::max(largest, a.norm()), jump = std::max(jump, (now - a).norm());
        }
      CHECK(jump < 1e-3 * largest);
    }
}

namespace {

/// A mesh of `columns` x `rows` quadrilaterals that flies and spins, with a plane behind its first column.
ModelBuilder spinning_bar(int columns, int rows, double angle) {
  ModelBuilder builder;
  builder.thickness = depth;
  builder.gravity.setZero();
  builder.add_material({"concrete", 2400, Solid{LinearElastic{30e9, 0.2}}});
  builder.add_law("plane", concrete_joint());
  builder.set_contact("*", "*", "plane");
  const Turn turn(angle);
  Mesh mesh = grid_mesh({Vec2(0, 0), Vec2(length, 0), Vec2(length, height), Vec2(0, height)}, columns, rows);
  for (Vec2& p : mesh.node) p = turn.apply(p);
  BodySpec spec;
  spec.name = "bar", spec.kind = BodyKind::mesh, spec.mesh = mesh, spec.material = "concrete", spec.floating = true;
  spec.velocity = Vec2(3, -2), spec.spin = 40;
  spec.cracks.planes = {{turn.apply(Vec2(length / columns, 0)), turn.apply(Vec2(1, 0))}};
  spec.cracks.law = "plane";
  builder.add_body(spec);
  return builder;
}

}  // namespace

TEST_CASE("a part of one, two or more elements keeps the motion that it had in its mesh") {
  for (const auto& [columns, rows] : {std::array{2, 1}, std::array{3, 1}, std::array{8, 2}})
    for (const double angle : {0.0, 0.5}) {
      const int own_columns = columns, own_rows = rows;
      CAPTURE(own_columns);
      CAPTURE(own_rows);
      CAPTURE(angle);
      ModelBuilder builder = spinning_bar(columns, rows, angle);
      Simulation<2> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      run_for(sim, 2e-4);
      sim.grow(Model<2>(sim.model()));  // ends the last step, as each change does
      const std::vector<Crack<2>> cracks = crack_mesh_now(sim);
      const WholeMotion<2> before = whole_motion(sim);
      const double balance = sim.energy().balance();
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      sim.refresh();
      CHECK(sim.model().bodies[1].nodes == 2 * (rows + 1));
      const WholeMotion<2> after = whole_motion(sim);
      CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum.norm());
      CHECK(near(after.angular, before.angular, 1e-12));
      CHECK(near(after.kinetic, before.kinetic, 1e-12));
      CHECK(near(sim.energy()[EnergyTerm::kinetic], before.kinetic, 1e-12));
      CHECK(near_zero(sim.energy().balance() - balance, 1e-11 * before.kinetic));
      // The bonded parts spin on as the mesh did.
      run_for(sim, 2e-3);
      sim.grow(Model<2>(sim.model()));
      const WholeMotion<2> later = whole_motion(sim);
      CHECK((later.momentum - before.momentum).norm() < 1e-12 * before.momentum.norm());
      CHECK(near(later.angular, before.angular, 1e-10));
    }
}

TEST_CASE("a mesh of one quadrilateral has the inertia of a quad, and such a part the inertia of its nodal masses") {
  ModelBuilder builder = spinning_bar(2, 1, 0);
  BodySpec one;
  one.name = "one", one.kind = BodyKind::mesh, one.outline = {Vec2(0, 1), Vec2(0.4, 1), Vec2(0.4, 1.2), Vec2(0, 1.2)};
  one.material = "concrete", one.floating = true;
  builder.add_body(one);
  one.name = "quad", one.kind = BodyKind::quad;
  for (Vec2& p : one.outline) p += Vec2(0, 1);
  builder.add_body(one);
  Simulation<2> sim(builder.build());
  sim.set_cracking(builder.cracking(sim.model()));
  const double mass = 2400 * 0.4 * 0.2 * depth, solid = mass * (0.4 * 0.4 + 0.2 * 0.2) / 12;
  for (const int body : {1, 2}) {
    CHECK(is_one_element(sim.model(), body));
    CHECK(near(body_inertia(sim.model(), body), solid, 1e-12));
  }
  const std::vector<Crack<2>> cracks = crack_mesh_now(sim);
  sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
  for (const int part : {3, 4}) {
    CHECK(!is_one_element(sim.model(), part));
    CHECK(near(body_inertia(sim.model(), part), 3 * solid, 1e-4));  // the stress of the spin has set the faces apart
  }
}

TEST_CASE("a plane may not leave one triangle on a side, whose inertia as a body differs") {
  Mesh mesh{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}, {{0, 1, 2, -1}, {0, 2, 3, -1}}};
  const CrackPlane<2> diagonal{Vec2(0.5, 0.5), Vec2(1, -1)};
  CHECK(mesh_plane_fault(mesh, diagonal, 1).find("leaves one triangle behind it") != std::string::npos);
  mesh.element = {{0, 1, 2, 3}};
  CHECK(mesh_plane_fault(mesh, diagonal, 1).find("{ mesh = { 2, 1 } }") != std::string::npos);
}
