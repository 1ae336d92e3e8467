// Meshes in space that crack along faces of their elements: the stress at the faces, and quantities that a split
// conserves.
#include <algorithm>
#include <cmath>
#include <functional>

#include "assembly/contact/solid_resultants.hpp"
#include "edit/mesh_section.hpp"
#include "edit/motion_sums.hpp"
#include "edit/split.hpp"
#include "edit/split_mesh.hpp"
#include "model/builder/crack_mesh.hpp"
#include "model/loads.hpp"
#include "near.hpp"
#include "run/simulation.hpp"
#include "statics/equilibrium.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double bar_length = 0.8, bar_width = 0.1, bar_height = 0.2, bar_strength = 3e6;
constexpr std::array shapes{ElementShape::brick, ElementShape::tetrahedron, ElementShape::quadratic_tetrahedron,
                            ElementShape::wedge};

/// Without gravity, with the material of the bars and the law of their planes.
SolidModelBuilder concrete_in_space() {
  SolidModelBuilder builder;
  builder.gravity.setZero();
  builder.add_material({"concrete", 2400, Solid{LinearElastic{30e9, 0.2}}});
  Cohesive law;
  law.kn = 1e13, law.ks = 5e12, law.mu = 0.6, law.tension = bar_strength, law.cohesion = 2 * bar_strength;
  law.energy_tension = 100, law.energy_shear = 400;
  builder.add_law("plane", law);
  builder.set_contact("*", "*", "plane");
  return builder;
}

/// A bar of elements along x, turned about the origin. Held along x at its left end, and at two of its nodes across.
SolidModelBuilder space_bar(ElementShape shape, bool held_left, const UnitQuaternion& axes = {}) {
  SolidModelBuilder builder = concrete_in_space();
  const Vec3 far(bar_length, bar_width, bar_height);
  std::array<Vec3, 8> corners;
  const Turn3 turn(axes);
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = Vec3(i % 4 == 1 || i % 4 == 2 ? far.x() : 0, i % 4 >= 2 ? far.y() : 0, i >= 4 ? far.z() : 0);
  const ElementShape straight = shape == ElementShape::quadratic_tetrahedron ? ElementShape::tetrahedron : shape;
  SpaceMesh mesh = divided_into(straight, brick_grid(corners, {8, 2, 3}));
  if (shape == ElementShape::quadratic_tetrahedron) mesh = quadratic_of(mesh);
  for (Vec3& x : mesh.node) x = turn.apply(x);
  SolidSpec spec;
  spec.name = "bar", spec.mesh = mesh, spec.material = "concrete", spec.floating = true;
  if (held_left) {
    constexpr Support held = Support::fixed, open = Support::free;
    spec.supports = {{Vec3(0, 0, 0), Vec3(0, bar_width, bar_height), {held, open, open}},
                     {Vec3(0, 0, 0), Vec3(0, 0, 0), {held, held, held}},
                     {Vec3(0, bar_width, 0), Vec3(0, bar_width, 0), {held, open, held}}};
  }
  spec.cracks.planes = {{turn.apply(Vec3(0.5 * bar_length, 0, 0)), turn.apply(Vec3(1, 0, 0))}};
  spec.cracks.law = "plane";
  builder.add_body(spec);
  return builder;
}

/// The faces of a mesh whose nodes all lie on the plane x = `at` of the initial position.
template <class See>
void faces_on_plane(const Model<3>& model, double at, See&& see) {
  for (const SpaceElement& e : model.space_elements) {
    std::vector<Vec3> nodes;
    for (int i = 0; i < nodes_of(e); ++i)
      nodes.push_back(model.start_position[static_cast<std::size_t>(e.node[static_cast<std::size_t>(i)])]);
    for (int f = 0; f < info_of(e.shape).faces; ++f) {
      const auto on = info_of(e.shape).nodes_of_face(f);
      if (std::all_of(on.begin(), on.end(),
                      [&](int i) { return std::abs(nodes[static_cast<std::size_t>(i)].x() - at) < 1e-9; }))
        see(e, f, fit_face(e.shape, nodes, f), face_products(e.shape, nodes, f));
    }
  }
}

/// A normal stress that is linear over the right end, by the consistent forces of its faces [N].
void load_end(Model<3>& model, double mean, const Vec3& slope) {
  faces_on_plane(model, bar_length, [&](const SpaceElement& e, int f, const FaceFit& fit, const FaceProducts& of) {
    const auto on = info_of(e.shape).nodes_of_face(f);
    const double at = mean + slope.dot(fit.middle - Vec3(bar_length, 0.5 * bar_width, 0.5 * bar_height));
    const Vec2 along(slope.dot(fit.x), slope.dot(fit.y));
    for (std::size_t i = 0; i < on.size(); ++i)
      model.load[static_cast<std::size_t>(e.node[static_cast<std::size_t>(on[i])])].x() +=
          fit.area * fit.mean[i] * at + along.dot(Vec2(of.second * fit.gradient[i]));
  });
}

const SpaceCut& cut_of(const Simulation<3>& sim) {
  return space_cut(*sim.cracking().bodies.front().sections.front().cut);
}

std::vector<Crack<3>> crack_space_mesh_now(Simulation<3>& sim) {
  sim.refresh();
  CrackScratch<3> scratch;
  Crack<3> crack;
  crack.body = 0, crack.section = 0, crack.stress = bar_strength;
  for (const SpaceForces& f : plate_forces(sim.model(), sim.state(), 0, cut_of(sim), scratch, 4))
    for (const Vec3& part : packed_forces(f)) crack.traction.push_back(part);
  return {crack};
}

/// Force of the contacts on the part behind that have no joint [N].
Vec3 force_without_joints(const Simulation<3>& sim) {
  const Work<3>& work = sim.work();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < work.general_touching.size(); ++i) {
    const auto row = static_cast<std::size_t>(work.general_touching[i].row);
    const JointMemory* const joint = work.contacts.joint_at(row);
    if (joint != nullptr && !joint->empty()) continue;
    const Vec3 on_b = solid_force(work, i);
    sum += sim.model().piece_body[static_cast<std::size_t>(work.pairs[row].piece_b)] == 1 ? on_b : Vec3(-on_b);
  }
  return sum;
}

/// Force and moment on the nodes of both parts, as they are and as the accelerations before the split ask for.
struct PartForces {
  Vec3 force[2] = {Vec3::Zero(), Vec3::Zero()}, moment[2] = {Vec3::Zero(), Vec3::Zero()};
  double jump = 0, largest = 0;  ///< of accelerations of nodes
};
PartForces jump_of_forces(const Simulation<3>& sim, const Model<3>& whole, const std::vector<Vec3>& force) {
  const MeshParts<3> parts(sim.model(), {0, 1, 2}, cut_of(sim));
  PartForces sums;
  for (int n = 0; n < whole.bodies[0].nodes; ++n)
    for (const int side : {0, 1}) {
      const int copy = parts.copy(side, n);
      if (copy < 0) continue;
      const auto at = static_cast<std::size_t>(n), own = static_cast<std::size_t>(copy);
      const Vec3 before = force[at] / whole.mass[at], now = sim.work().force[own] / sim.model().mass[own];
      const Vec3 change = sim.model().mass[own] * (now - before);
      sums.force[side] += change, sums.moment[side] += cross(sim.state().position[own], change);
      sums.jump = std::max(sums.jump, (now - before).norm()), sums.largest = std::max(sums.largest, before.norm());
    }
  return sums;
}

}  // namespace

TEST_CASE("the stress at the faces of a mesh in space is the exact one of a pulled and of a bent bar") {
  for (const ElementShape shape : shapes)
    for (const bool bent : {false, true}) {
      // Constant strain does not bend exactly, and a wedge not in the plane of its triangles.
      if (bent && shape != ElementShape::brick && shape != ElementShape::quadratic_tetrahedron) continue;
      CAPTURE(std::string(info_of(shape).name));
      CAPTURE(bent);
      SolidModelBuilder builder = space_bar(shape, true);
      Model<3> model = builder.build();
      const double mean = 1e5;  // small, because the bar is loaded in its initial shape
      const Vec3 slope = bent ? Vec3(0, 4e5, 8e5) : Vec3(0, 0, 0);
      load_end(model, mean, slope);
      State<3> state = initial_state(model);
      CHECK(find_equilibrium(model, state).converged);
      const std::vector<CrackingBody<3>> rows = builder.cracking(model);
      const SpaceCut& cut = space_cut(*rows.front().sections.front().cut);
      CHECK(cut.plates.size() == (shape == ElementShape::brick || shape == ElementShape::wedge ? 6 : 12));
      CHECK(near(rows.front().sections.front().area, bar_width * bar_height, 1e-12));
      CrackScratch<3> scratch;
      for (const int rounds : {0, 4}) {
        const std::vector<SpaceForces> forces = plate_forces(model, state, 0, cut, scratch, rounds);
        for (std::size_t f = 0; f < forces.size(); ++f) {
          const CrackSection<3>& s = cut.plates[f].section;
          const SectionStress stress = section_stress(s, forces[f]);
          for (const Vec2& p : s.corners) {
            const Vec3 arm = s.at(p) - Vec3(0.5 * bar_length, 0.5 * bar_width, 0.5 * bar_height);
            CHECK(near_zero(stress(p) - mean - slope.dot(arm), 2e-3 * mean));
          }
          CHECK(near_zero(forces[f].shear.norm() / s.area, 2e-3 * mean));
        }
      }
    }
}

TEST_CASE("a mesh in space cracks above the strength of its law and not below it") {
  for (const double share : {0.99, 1.01}) {
    CAPTURE(share);
    SolidModelBuilder builder = space_bar(ElementShape::brick, true);
    Model<3> model = builder.build();
    load_end(model, share * bar_strength, Vec3::Zero());
    State<3> state = initial_state(model);
    CHECK(find_equilibrium(model, state).converged);
    CrackScratch<3> scratch;
    const CrackSearch<3> found = mesh_cracks(model, state, Cracking<3>{builder.cracking(model), {}}, scratch);
    const std::vector<Crack<3>>& cracks = found.cracks;
    CHECK(near(found.share, share, 1e-4));
    CHECK(cracks.size() == (share > 1 ? 1 : 0));
    if (share < 1) continue;
    CHECK(cracks.front().mode == JointMode::tension);
    CHECK(near(cracks.front().stress, share * bar_strength, 1e-4));
    CHECK(near(cracks.front().place.x(), 0.5 * bar_length, 1e-3));
    CHECK(cracks.front().traction.size() == 12);
  }
}

TEST_CASE("no force jumps where the stress of a mesh in space is linear over its faces") {
  for (const ElementShape shape : shapes)
    for (const bool bent : {false, true}) {
      if (bent && shape != ElementShape::brick && shape != ElementShape::quadratic_tetrahedron) continue;
      CAPTURE(std::string(info_of(shape).name));
      CAPTURE(bent);
      SolidModelBuilder builder = space_bar(shape, true);
      Model<3> model = builder.build();
      load_end(model, 0.5 * bar_strength, bent ? Vec3(0, 4e6, 8e6) : Vec3(0, 0, 0));
      State<3> state = initial_state(model);
      CHECK(find_equilibrium(model, state).converged);
      Simulation<3> sim(model, state);
      sim.set_cracking(builder.cracking(sim.model()));
      const std::vector<Crack<3>> cracks = crack_space_mesh_now(sim);
      double largest = 0;
      for (const Vec3& f : sim.work().element_force) largest = std::max(largest, f.norm());
      const std::vector<Vec3> force = sim.work().force;
      const Model<3> whole = sim.model();
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      sim.refresh();
      const MeshParts<3> parts(sim.model(), {0, 1, 2}, cut_of(sim));
      double jump = 0;
      for (int n = 0; n < whole.bodies[0].nodes; ++n)
        for (const int side : {0, 1}) {
          if (parts.copy(side, n) < 0) continue;
          const auto own = static_cast<std::size_t>(parts.copy(side, n));
          const Vec3 before =
              sim.model().mass[own] / whole.mass[static_cast<std::size_t>(n)] * force[static_cast<std::size_t>(n)];
          jump = std::max(jump, (sim.work().force[own] - before).norm());
        }
      CHECK(largest > 0);
      CHECK(jump < 5e-3 * 0.5 * bar_strength * bar_width * bar_height / 12);
    }
}

TEST_CASE("a mesh in space that splits in motion keeps mass, momentum, angular momentum and energy") {
  for (const ElementShape shape : shapes)
    for (const double angle : {0.0, 0.5}) {
      CAPTURE(std::string(info_of(shape).name));
      CAPTURE(angle);
      const UnitQuaternion axes = rotation_by(Vec3(0.3 * angle, angle, -0.7 * angle));
      SolidModelBuilder builder = space_bar(shape, false, axes);
      Simulation<3> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      // It spins, and waves run through it.
      sim.edit([&](Model<3>& model) {
        const Turn3 turn(axes);
        const Vec3 end = turn.apply(Vec3(bar_length, bar_width, bar_height));
        for (std::size_t n = 0; n < model.mass.size(); ++n)
          if ((model.start_position[n] - end).norm() < 0.3)
            model.load[n] = 6e2 * model.mass[n] * turn.apply(Vec3(1, 0.2, 0.7));
      });
      StageOptions on;
      on.duration = 1e-3;
      sim.run(on);
      sim.grow(Model<3>(sim.model()));  // a change without a change: ends the last step, as each change does
      const std::vector<Crack<3>> cracks = crack_space_mesh_now(sim);
      for (std::size_t f = 0; f < cut_of(sim).plates.size(); ++f)  // below the strength, so that all bonds are whole
        CHECK(
            section_use(sim.model().laws[0], cut_of(sim).plates[f].section, unpacked_forces(cracks.front(), f)).share <
            1);
      const PresentMotion<3> before = motion_of_present(sim);
      const double balance = sim.energy().balance(), elastic = sim.energy()[EnergyTerm::strain];
      const std::vector<Vec3> force = sim.work().force;
      const Model<3> whole = sim.model();
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      sim.refresh();
      const PresentMotion<3> after = motion_of_present(sim);
      CHECK(near(after.mass, before.mass, 1e-14));
      CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum.norm());
      CHECK((after.first - before.first).norm() < 1e-13 * before.first.norm());
      CHECK((after.angular - before.angular).norm() < 1e-12 * before.angular.norm());
      CHECK(near(after.kinetic, before.kinetic, 1e-12));
      CHECK(near_zero(sim.energy().balance() - balance, 1e-9 * elastic));
      CHECK(near(sim.energy()[EnergyTerm::strain], elastic, 1e-12));  // no node moves
      CHECK(sim.energy()[EnergyTerm::contact_elastic] > 0);
      // Each part keeps its acceleration and its angular acceleration. The plates of faces that warp overlap their
      // other neighbours by slivers, whose pressure is the rest. With faces of six nodes it is 6e-5 of the size, which
      // is less than 1e-6 of the force in the section. Nodes keep theirs up to the modes in which a face warps or
      // stretches, which plates in contact do not carry.
      const PartForces sums = jump_of_forces(sim, whole, force);
      const double size = whole.mass[0] * sums.largest;
      const Vec3 slivers = force_without_joints(sim);
      CHECK(slivers.norm() < 1e-4 * size);
      for (const int side : {0, 1}) {
        CHECK((sums.force[side] - (side == 0 ? slivers : Vec3(-slivers))).norm() < 3e-7 * size);
        CHECK(sums.moment[side].norm() < 2e-5 * size * bar_length);
      }
      // A face of six nodes has more of these modes, and single nodes of little mass: there it is 0.41.
      if (shape != ElementShape::quadratic_tetrahedron) CHECK(sums.jump < 0.3 * sums.largest);
    }
}

namespace {

/// A mesh of bricks that flies and spins, with a plane behind its first column.
SolidModelBuilder spinning_space_bar(const std::array<int, 3>& divisions) {
  SolidModelBuilder builder = concrete_in_space();
  const UnitQuaternion axes = rotation_by(Vec3(0.2, 0.5, -0.3));
  const Turn3 turn(axes);
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = turn.apply(
        Vec3(i % 4 == 1 || i % 4 == 2 ? bar_length : 0, i % 4 >= 2 ? bar_width : 0, i >= 4 ? bar_height : 0));
  SolidSpec spec;
  spec.name = "bar", spec.mesh = brick_grid(corners, divisions), spec.material = "concrete", spec.floating = true;
  spec.velocity = Vec3(3, -2, 1), spec.spin = Vec3(10, 40, -20);
  spec.cracks.planes = {{turn.apply(Vec3(bar_length / divisions[0], 0, 0)), turn.apply(Vec3(1, 0, 0))}};
  spec.cracks.law = "plane";
  builder.add_body(spec);
  return builder;
}

}  // namespace

TEST_CASE("a part of one, two or more bricks keeps the motion that it had in its mesh") {
  for (const std::array<int, 3>& divisions : {std::array{2, 1, 1}, std::array{3, 1, 1}, std::array{4, 2, 1}}) {
    CAPTURE(divisions[0]);
    SolidModelBuilder builder = spinning_space_bar(divisions);
    Simulation<3> sim(builder.build());
    sim.set_cracking(builder.cracking(sim.model()));
    StageOptions on;
    on.duration = 2e-4;
    sim.run(on);
    sim.grow(Model<3>(sim.model()));  // ends the last step, as each change does
    const std::vector<Crack<3>> cracks = crack_space_mesh_now(sim);
    const WholeMotion<3> before = whole_motion(sim);
    const double balance = sim.energy().balance();
    sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
    sim.refresh();
    CHECK(sim.model().bodies[1].nodes == 4 * (divisions[1] + 1));
    CHECK(sim.model().bodies[1].kind == BodyKind::mesh);
    const WholeMotion<3> after = whole_motion(sim);
    CHECK((after.momentum - before.momentum).norm() < 1e-13 * before.momentum.norm());
    CHECK((after.angular - before.angular).norm() < 1e-12 * before.angular.norm());
    CHECK(near(after.kinetic, before.kinetic, 1e-12));
    CHECK(near(sim.energy()[EnergyTerm::kinetic], before.kinetic, 1e-12));
    CHECK(near_zero(sim.energy().balance() - balance, 1e-11 * before.kinetic));
    on.duration = 1e-3;  // the bonded parts spin on as the mesh did
    sim.run(on);
    sim.grow(Model<3>(sim.model()));
    const WholeMotion<3> later = whole_motion(sim);
    CHECK((later.momentum - before.momentum).norm() < 1e-12 * before.momentum.norm());
    CHECK((later.angular - before.angular).norm() < 1e-10 * before.angular.norm());
  }
}

TEST_CASE("a plane may not leave one tetrahedron on a side, whose inertia as a body differs") {
  const SpaceMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)},
                       {{ElementShape::tetrahedron, {0, 1, 2, 3}}, {ElementShape::tetrahedron, {1, 4, 2, 3}}}};
  const CrackPlane<3> between{Vec3(1, 1, 1) / 3, Vec3(1, 1, 1)};
  CHECK(mesh_plane_fault(mesh, between, 1).find("leaves one tetrahedron behind it") != std::string::npos);
}

TEST_CASE("forces at points of a mesh in space go to the parts that have these points") {
  SolidModelBuilder builder = space_bar(ElementShape::brick, false);
  Simulation<3> sim(builder.build());
  sim.set_cracking(builder.cracking(sim.model()));
  const std::array points{Vec3(0, 0.03, bar_height), Vec3(0.5 * bar_length, 0.04, bar_height),
                          Vec3(bar_length, 0.5 * bar_width, 0.1)};
  const std::array forces{Vec3(10, 20, -30), Vec3(-5, 8, 40), Vec3(7, -9, 11)};
  sim.edit([&](Model<3>& model) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      SolidLoadSpec spec;
      spec.name = "load", spec.at = points[i], spec.force = forces[i];
      model.loads.add(make_solid_loads(model, 0, spec));
    }
  });
  const std::vector<Crack<3>> cracks = crack_space_mesh_now(sim);
  sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
  sim.refresh();
  for (const int part : {1, 2}) {
    const Body& body = sim.model().bodies[static_cast<std::size_t>(part)];
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (auto n = static_cast<std::size_t>(body.first_node); n < static_cast<std::size_t>(body.first_node + body.nodes);
         ++n)
      force += sim.work().load[n], moment += cross(sim.state().position[n], sim.work().load[n]);
    // The elements on both sides of the cut are alike, so both parts have half of the force on it.
    const std::size_t own = part == 1 ? 0 : 2;
    const Vec3 moment_wanted = cross(points[own], forces[own]) + 0.5 * cross(points[1], forces[1]);
    CHECK((force - forces[own] - 0.5 * forces[1]).norm() < 1e-12 * forces[1].norm());
    CHECK((moment - moment_wanted).norm() < 1e-12 * moment_wanted.norm());
  }
}
