// Rigid bodies in space that crack: section forces from either side, and quantities that a split conserves.
#include <numeric>

#include "edit/split.hpp"
#include "geometry/space/cut_solid.hpp"
#include "near.hpp"
#include "readings/section_forces_space.hpp"
#include "run/record/body_forces.hpp"
#include "run/simulation.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double strong = 1e6;

Bonded brittle_in_space() {
  return {1e11, 5e10, 0.6, 0, strong, strong, 0};
}
Cohesive softening_in_space(double kn = 1e11) {
  Cohesive law;
  law.kn = kn, law.ks = 0.4 * kn, law.mu = 0.6, law.cohesion = strong, law.tension = strong;
  law.energy_tension = 1e3, law.energy_shear = 1e3;
  return law;
}

SolidSpec solid(const char* name, const Polyhedron& shape, double mass) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {shape}, spec.mass = mass;
  return spec;
}

/// Gravity at an angle, so that the joints are bent about two axes, twisted and sheared.
SolidModelBuilder bedded_block(const ContactLaw& law, const CrackPlane<3>& plane, const ContactLaw& crack) {
  SolidModelBuilder builder;
  builder.add_law("joint", law), builder.add_law("plane", crack);
  builder.set_contact("*", "*", "joint");
  SolidSpec floor = solid("floor", box_solid({-3, -3, -1}, {3, 3, 0}), 1e4);
  floor.support.fill(Support::fixed);
  builder.add_body(floor);
  SolidSpec block = solid("block", box_solid({-0.5, -0.2, 0}, {0.7, 0.3, 0.3}), 700);
  block.cracks.planes = {plane}, block.cracks.law = "plane";
  builder.add_body(block);
  builder.add_body(solid("stone", box_solid({-0.4, -0.1, 0.3}, {0.5, 0.35, 0.6}), 900));
  return builder;
}

/// Settles, then pushes block and stone aside, and stops in motion.
void shake_in_space(Simulation<3>& sim) {
  StageOptions rest;
  rest.duration = 0.5, rest.rest_share = 0.8;
  sim.run(rest);
  sim.edit([](Model<3>& model) {
    const auto n = [&](const char* name) {
      return static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(model.find_body(name))].first_node);
    };
    model.load[n("stone")] = Vec3(900, 700, 0), model.load[n("block")] = Vec3(400, -600, -500);
  });
  StageOptions on;
  on.duration = 0.002;
  sim.run(on);
}

SpaceForces forces_in(Simulation<3>& sim, const CrackSection<3>& section, const char* body) {
  sim.refresh();
  SurfaceForces3 forces(sim.model(), sim.state(), sim.work());
  const std::vector<int> bodies{sim.model().find_body(body)};
  forces.collect(bodies);
  return forces.in_section(0, section);
}

/// The same section seen from its other side: half a turn about x.
CrackSection<3> seen_from_ahead(const Model<3>& model, const CrackSection<3>& s, int body) {
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
  CrackSection<3> other = s;
  other.normal = -s.normal, other.y = -s.y, other.xy = -s.xy;
  other.corners.clear();
  for (auto p = s.corners.rbegin(); p != s.corners.rend(); ++p) other.corners.emplace_back(p->x(), -p->y());
  other.mass = model.mass[n] - s.mass;
  other.centroid = -s.mass / other.mass * s.centroid;
  const auto about = [](double mass, const Vec3& r) {
    return Eigen::Matrix3d(mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose()));
  };
  other.inertia = Eigen::Matrix3d(model.inertia[n].asDiagonal()) - s.inertia - about(s.mass, s.centroid) -
                  about(other.mass, other.centroid);
  return other;
}

std::vector<Crack<3>> crack_of_first(Simulation<3>& sim, const char* body) {
  const CrackingBody<3>& row = sim.cracking().bodies.front();
  Crack<3> crack;
  crack.body = row.body, crack.section = 0, crack.stress = strong;
  crack.forces = forces_in(sim, row.sections.front(), body);
  return {crack};
}

Vec3 on_body(Simulation<3>& sim, const char* body) {
  sim.refresh();
  const std::vector<int> bodies{sim.model().find_body(body)};
  return force_on(sim.model(), sim.work(), bodies);
}

/// Sums over present bodies.
struct Motion {
  double mass = 0, energy = 0;
  Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();

  explicit Motion(const Simulation<3>& sim) {
    const Model<3>& model = sim.model();
    const State<3>& state = sim.state();
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (state.left[b] != 0) continue;
      const auto n = static_cast<std::size_t>(model.bodies[b].first_node);
      const Turn3 turn(state.rotation[n]);
      const Vec3 own = turn.apply(Vec3(model.inertia[n].cwiseProduct(turn.undo(state.spin[n]))));
      mass += model.mass[n], momentum += model.mass[n] * state.velocity[n];
      angular += own + cross(state.position[n], Vec3(model.mass[n] * state.velocity[n]));
      energy += 0.5 * model.mass[n] * state.velocity[n].squaredNorm() + 0.5 * own.dot(state.spin[n]);
    }
  }
};

const std::array oblique{CrackPlane<3>{{0.1, 0.05, 0.1}, {1, 0, 0}}, CrackPlane<3>{{-0.1, 0.05, 0.15}, {1, 0.4, 0.3}},
                         CrackPlane<3>{{0.3, 0.05, 0.12}, {-1, 0.5, -0.2}}};

std::vector<ContactLaw> joints_in_space() {
  return {Frictional{5e9, 2e9, 0.6, 0}, Bonded{5e9, 2e9, 0.6, 0, 1e7, 1e7, 0}, [] {
            Cohesive law = softening_in_space(5e9);
            law.tension = law.cohesion = 1e7, law.energy_tension = law.energy_shear = 1e5;
            return law;
          }()};
}

}  // namespace

TEST_CASE("a body that spins about an oblique axis keeps its momenta and its energy when it splits") {
  const Polyhedron box = box_solid({-0.5, -0.2, -0.1}, {0.7, 0.2, 0.3});
  const auto wedge = cut_solid(box, {Vec3(1, 2, 1).normalized(), 0.25}, 1e-9);
  REQUIRE(wedge.has_value());
  for (const Polyhedron& shape : {box, *wedge})
    for (const CrackPlane<3>& plane : oblique) {
      SolidModelBuilder builder;
      builder.gravity = Vec3::Zero();
      builder.add_law("plane", brittle_in_space());
      builder.set_contact("*", "*", "plane");
      SolidSpec spec = solid("stone", placed(shape, rotation_by(Vec3(0.3, -0.2, 0.5)), {4, 5, 6}), 300);
      const Turn3 turn(rotation_by(Vec3(0.3, -0.2, 0.5)));
      spec.floating = true, spec.velocity = {1, -2, 0.5}, spec.spin = {3, -4, 7};
      spec.cracks.planes = {{Vec3(turn.apply(plane.point) + Vec3(4, 5, 6)), turn.apply(plane.normal)}};
      spec.cracks.law = "plane";
      builder.add_body(spec);
      Simulation<3> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      StageOptions on;
      on.duration = 0.05, on.dt = 5e-5;
      sim.run(on);
      sim.grow(Model<3>(sim.model()));  // ends the last step, as each change does
      const Motion before(sim);
      const std::vector<Crack<3>> cracks = crack_of_first(sim, "stone");
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      const Motion after(sim);
      REQUIRE(sim.model().bodies.size() == 3);
      CHECK(near(after.mass, before.mass, 1e-14));
      CHECK((after.momentum - before.momentum).norm() < 1e-12 * before.momentum.norm());
      CHECK((after.angular - before.angular).norm() < 1e-11 * before.angular.norm());
      CHECK(near(after.energy, before.energy, 1e-12));
      // Free parts keep these quantities from then on as well.
      on.duration = 0.01, on.dt = 5e-6;
      sim.run(on);
      CHECK((Motion(sim).angular - before.angular).norm() < 1e-4 * before.angular.norm());
    }
}

TEST_CASE("the forces in a section in space are the same from the part on either side of it") {
  for (const ContactLaw& law : joints_in_space())
    for (const CrackPlane<3>& plane : oblique) {
      SolidModelBuilder builder = bedded_block(law, plane, brittle_in_space());
      Simulation<3> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      shake_in_space(sim);
      const CrackingBody<3> row = sim.cracking().bodies.front();
      const CrackSection<3>& section = row.sections.front();
      const SpaceForces f = forces_in(sim, section, "block");
      const SpaceForces other = forces_in(sim, seen_from_ahead(sim.model(), section, row.body), "block");
      // The opposite force and moment, along axes of which y and the normal are reversed.
      const double size = std::abs(f.normal) + f.shear.norm(), turning = f.bending.norm() + std::abs(f.torsion);
      CHECK(size > 1);
      CHECK(turning > 1);
      CHECK(std::abs(f.normal - other.normal) < 1e-6 * size);
      CHECK(std::abs(f.shear.x() + other.shear.x()) < 1e-6 * size);
      CHECK(std::abs(f.shear.y() - other.shear.y()) < 1e-6 * size);
      CHECK(std::abs(f.bending.x() + other.bending.x()) < 1e-6 * turning);
      CHECK(std::abs(f.bending.y() - other.bending.y()) < 1e-6 * turning);
      CHECK(std::abs(f.torsion - other.torsion) < 1e-6 * turning);
    }
}

TEST_CASE("a block in space that splits with fracture energy leaves all forces of its neighbours as they were") {
  for (const ContactLaw& law : joints_in_space())
    for (const CrackPlane<3>& plane : oblique) {
      SolidModelBuilder builder = bedded_block(law, plane, softening_in_space());
      Simulation<3> sim(builder.build());
      sim.set_cracking(builder.cracking(sim.model()));
      shake_in_space(sim);
      sim.grow(Model<3>(sim.model()));
      const std::vector<Crack<3>> cracks = crack_of_first(sim, "block");
      const Vec3 floor = on_body(sim, "floor"), stone = on_body(sim, "stone"), block = on_body(sim, "block");
      const double balance = sim.energy().balance();
      const Motion before(sim);
      sim.split(with_cracks(builder, sim.model(), sim.cracking().bodies, cracks), cracks);
      const double size = floor.norm();
      CHECK((on_body(sim, "floor") - floor).norm() < 1e-6 * size);
      CHECK((on_body(sim, "stone") - stone).norm() < 1e-6 * size);
      CHECK((on_body(sim, "block.a") + on_body(sim, "block.b") - block).norm() < 1e-6 * size);
      CHECK(near(Motion(sim).energy, before.energy, 1e-12));
      CHECK(near_zero(sim.energy().balance() - balance, 1e-9 * sim.energy()[EnergyTerm::contact_elastic]));
    }
}
