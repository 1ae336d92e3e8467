// Rigid bodies that crack: section forces from either side, and quantities that a split conserves.
#include "edit/split.hpp"

#include "assembly/contact/contact_resultants.hpp"
#include "model/loads.hpp"
#include "near.hpp"
#include "physics/scene.hpp"
#include "readings/section_forces.hpp"
#include "run/record/body_forces.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double strength = 1e6;

/// A beam on a floor and under a stone, all three bodies under one law, the beam with one plane.
Scene bedded_beam(const ContactLaw& law, const CrackPlane<2>& plane, const ContactLaw& crack) {
  Scene scene(law);
  scene.builder.add_law("plane", crack);
  scene.fixed("floor", box(-3, -1, 3, 0));
  BodySpec beam;
  beam.name = "beam", beam.outline = box(-0.5, 0, 0.7, 0.3), beam.mass = 700;
  beam.cracks.planes = {plane}, beam.cracks.law = "plane";
  scene.add(beam);
  scene.block("stone", box(-0.4, 0.3, 0.5, 0.6), 900);
  return scene;
}

Bonded brittle() {
  return {1e11, 5e10, 0.6, 0, strength, strength, 0};
}
Cohesive softening() {
  Cohesive law;
  law.kn = 1e11, law.ks = 5e10, law.mu = 0.6, law.cohesion = strength, law.tension = strength;
  law.energy_tension = 100, law.energy_shear = 100;
  return law;
}

/// The same section seen from its other side.
CrackSection<2> turned_over(const Model<2>& model, const CrackSection<2>& s, int body) {
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
  CrackSection<2> other = s;
  std::swap(other.from, other.to);
  other.normal = -s.normal;
  other.mass = model.mass[n] - s.mass;
  other.centroid = -s.mass / other.mass * s.centroid;
  other.inertia =
      model.inertia[n] - s.inertia - s.mass * s.centroid.squaredNorm() - other.mass * other.centroid.squaredNorm();
  return other;
}

PlaneForces beam_section(Simulation<2>& sim, const CrackSection<2>& section) {
  sim.refresh();
  SurfaceForces forces(sim.model(), sim.state(), sim.work());
  const std::vector<int> bodies{sim.model().find_body("beam")};
  forces.collect(bodies);
  return forces.in_section(0, section);
}

/// The model with its planes.
void begin(const Scene& scene, Simulation<2>& sim) {
  sim.set_cracking(scene.builder.cracking(sim.model()));
}

/// Pushes the beam and the stone so that their joints carry shear and are pressed unevenly, and stops in motion.
void shake(Simulation<2>& sim) {
  settle(sim, 5, 1e-8);
  sim.edit([](Model<2>& model) {
    model.load[static_cast<std::size_t>(node_of(model, "stone"))] = Vec2(1500, 0);
    model.load[static_cast<std::size_t>(node_of(model, "beam"))] = Vec2(800, -500);
  });
  run_for(sim, 0.004);
}

std::vector<Crack<2>> crack_now(Simulation<2>& sim) {
  const CrackingBody<2>& row = sim.cracking().bodies.front();
  const PlaneForces f = beam_section(sim, row.sections.front());
  Crack<2> crack;
  crack.body = row.body, crack.section = 0, crack.stress = strength;
  crack.normal = f.normal, crack.shear = f.shear, crack.moment = f.moment;
  return {crack};
}

void split_now(Scene& scene, Simulation<2>& sim, const std::vector<Crack<2>>& cracks) {
  sim.split(with_cracks(scene.builder, sim.model(), sim.cracking().bodies, cracks), cracks);
}

Vec2 on(Simulation<2>& sim, const char* body) {
  sim.refresh();
  const std::vector<int> bodies{sim.model().find_body(body)};
  return force_on(sim.model(), sim.work(), bodies);
}

double kinetic(const Simulation<2>& sim) {
  double sum = 0;
  for (std::size_t n = 0; n < sim.model().mass.size(); ++n)
    sum += 0.5 * sim.model().mass[n] * sim.state().velocity[n].squaredNorm() +
           0.5 * sim.model().inertia[n] * sim.state().spin[n] * sim.state().spin[n];
  return sum;
}

const std::array planes{CrackPlane<2>{{0.1, 0.1}, {1, 0}}, CrackPlane<2>{{-0.2, 0.1}, {1, 0.3}},
                        CrackPlane<2>{{0.3, 0.1}, {-1, 0.5}}};
const std::array<ContactLaw, 3> joints{Frictional{5e9, 2e9, 0.6, 0}, Bonded{5e9, 2e9, 0.6, 0, 1e7, 1e7, 0}, [] {
                                         Cohesive law = softening();
                                         law.kn = 5e9, law.ks = 2e9, law.beta = 0;
                                         law.energy_tension = 1e3, law.energy_shear = 1e3;
                                         return law;
                                       }()};

}  // namespace

TEST_CASE("the forces in a section are the same from the part on either side of it") {
  for (const ContactLaw& law : joints)
    for (const CrackPlane<2>& plane : planes) {
      Scene scene = bedded_beam(law, plane, brittle());
      Simulation<2> sim(scene.builder.build());
      begin(scene, sim);
      shake(sim);
      const CrackingBody<2> row = sim.cracking().bodies.front();
      const PlaneForces f = beam_section(sim, row.sections.front());
      const PlaneForces other = beam_section(sim, turned_over(sim.model(), row.sections.front(), row.body));
      CHECK(std::abs(f.moment) > 1);
      CHECK(near_zero(f.normal - other.normal, 1e-6));
      CHECK(near_zero(f.shear - other.shear, 1e-6));
      CHECK(near_zero(f.moment + other.moment, 1e-6));  // it turns the other part the other way
    }
}

TEST_CASE("pressure on a part of a face enters the section of a free beam as in the theory of beams") {
  const double w = 4e3, length = 1.2, from = 0.3, to = 0.9;  // on the top, from its left end
  for (const double cut : {0.2, 0.5, 0.7, 1.0}) {
    Scene scene(brittle());
    scene.set_gravity({0, 0});
    scene.builder.add_law("plane", brittle());
    BodySpec beam;
    beam.name = "beam", beam.outline = box(0, 0, length, 0.3), beam.mass = 700;
    beam.cracks.planes = {CrackPlane<2>{{cut, 0.15}, {1, 0}}}, beam.cracks.law = "plane";
    scene.add(beam);
    Model<2> model = scene.builder.build();
    PressureSpec pressure;
    pressure.name = "p", pressure.value = w;
    const std::vector<FacePart> top = faces_towards(model, 0, {0, 1});
    REQUIRE(top.size() == 1);
    loads_of<FaceLoad<2>>(model) =
        make_pressure(model, 0, {{top[0].skin_a, top[0].skin_b, 1 - to / length, 1 - from / length}}, pressure);
    Simulation<2> sim(model);
    begin(scene, sim);
    // The beam accelerates with a + alpha (x - L/2); the part on the left bears the load on it.
    const double load = w * (to - from), arm = 0.5 * (from + to) - 0.5 * length;
    const double inertia = 700 * (length * length + 0.3 * 0.3) / 12;
    const double alpha = -load * arm / inertia, lift = -load / 700;
    const double line_mass = 700 / length, behind = std::clamp(cut - from, 0.0, to - from);
    const double mass = line_mass * cut, centre = 0.5 * cut - 0.5 * length;
    const double shear = mass * (lift + alpha * centre) + w * behind;
    const double own = mass * (cut * cut + 0.3 * 0.3) / 12;
    const double moment =
        own * alpha - 0.5 * cut * mass * (lift + alpha * centre) - w * behind * (cut - from - 0.5 * behind);
    const CrackingBody<2> row = sim.cracking().bodies.front();
    const PlaneForces f = beam_section(sim, row.sections.front());
    const PlaneForces other = beam_section(sim, turned_over(sim.model(), row.sections.front(), row.body));
    CHECK(near(std::abs(f.shear), std::abs(shear), 1e-9));
    CHECK(near(f.moment, moment, 1e-9));
    CHECK(near_zero(f.shear - other.shear, 1e-9 * load));
    CHECK(near_zero(f.moment + other.moment, 1e-9 * load));
  }
}

TEST_CASE("a body that splits keeps mass, momentum and kinetic energy, and no force of a neighbour jumps") {
  for (const ContactLaw& law : joints)
    for (const CrackPlane<2>& plane : planes) {
      Scene scene = bedded_beam(law, plane, softening());
      Simulation<2> sim(scene.builder.build());
      begin(scene, sim);
      shake(sim);
      const std::vector<Crack<2>> cracks = crack_now(sim);
      sim.grow(Model<2>(sim.model()));  // a change without a change: ends the last step, as each change does
      const Vec2 floor = on(sim, "floor"), stone = on(sim, "stone"), beam = on(sim, "beam");
      const double energy = kinetic(sim), balance = sim.energy().balance();
      split_now(scene, sim, cracks);
      const double size = floor.norm();
      CHECK((on(sim, "floor") - floor).norm() < 1e-6 * size);
      CHECK((on(sim, "stone") - stone).norm() < 1e-6 * size);
      // The bond of the parts carries the section: together they feel the same force as the whole.
      CHECK((on(sim, "beam.a") + on(sim, "beam.b") - beam).norm() < 1e-6 * size);
      CHECK(near(kinetic(sim), energy, 1e-12));
      CHECK(near_zero(sim.energy().balance() - balance, 1e-9 * sim.energy()[EnergyTerm::contact_elastic]));
      const Model<2>& model = sim.model();
      const auto mass = [&](const char* name) { return model.mass[static_cast<std::size_t>(node_of(model, name))]; };
      CHECK(near(mass("beam.a") + mass("beam.b"), mass("beam"), 1e-14));
    }
}

TEST_CASE("the joint of a crack with fracture energy carries the forces of the section at once") {
  for (const CrackPlane<2>& plane : planes) {
    Scene scene = bedded_beam(joints[0], plane, softening());
    Simulation<2> sim(scene.builder.build());
    begin(scene, sim);
    shake(sim);
    const std::vector<Crack<2>> cracks = crack_now(sim);
    split_now(scene, sim, cracks);
    sim.refresh();
    std::vector<TouchingContact> touching;
    contact_resultants(sim.model(), sim.state(), sim.work(), touching);
    const int behind = sim.model().find_body("beam.a"), ahead = sim.model().find_body("beam.b");
    int found = 0;
    for (const TouchingContact& c : touching) {
      if (c.body_a != behind || c.body_b != ahead) continue;
      ++found;
      CHECK(c.hold == ContactHold::bonded);
      CHECK(near(c.resultant.normal, -cracks[0].normal, 1e-6));
      CHECK(near(c.resultant.shear, cracks[0].shear, 1e-6));
    }
    CHECK(found == 1);
  }
}

TEST_CASE("a part of a cracked body is bonded to a neighbour on it and not to one across a corner") {
  // The stone ends over the plane, or less than a micrometre beyond it. Then one part of the beam only touches it.
  for (const bool stone_ahead : {true, false}) {
    CAPTURE(stone_ahead);
    Scene scene(joints[2]);
    scene.builder.add_law("plane", softening());
    scene.fixed("floor", box(-3, -1, 3, 0));
    BodySpec beam;
    beam.name = "beam", beam.outline = box(-0.5, 0, 0.7, 0.3), beam.mass = 700;
    beam.cracks.planes = {planes.front()}, beam.cracks.law = "plane";
    scene.add(beam);
    const double beyond = 5e-7, middle = planes.front().point.x();
    scene.block("stone", stone_ahead ? box(middle - beyond, 0.3, 0.6, 0.6) : box(-0.4, 0.3, middle + beyond, 0.6), 900);
    Simulation<2> sim(scene.builder.build());
    begin(scene, sim);
    shake(sim);
    sim.grow(Model<2>(sim.model()));
    const double balance = sim.energy().balance();
    split_now(scene, sim, crack_now(sim));
    sim.refresh();
    CHECK(near_zero(sim.energy().balance() - balance, 1e-9 * sim.energy()[EnergyTerm::contact_elastic]));
    std::vector<TouchingContact> touching;
    contact_resultants(sim.model(), sim.state(), sim.work(), touching);
    const int stone = sim.model().find_body("stone"), behind = sim.model().find_body("beam.a"),
              ahead = sim.model().find_body("beam.b");
    int bonded = 0;
    for (const TouchingContact& c : touching) {
      if (c.body_a != stone && c.body_b != stone) continue;
      const int part = c.body_a == stone ? c.body_b : c.body_a;
      if (c.hold != ContactHold::bonded) continue;
      CHECK(part == (stone_ahead ? ahead : behind));
      ++bonded;
    }
    CHECK(bonded == 1);
  }
}
