// VALIDATION C7, C8 in space: a bonded joint in tension and shear, with the whole model rotated about random axes.
#include <algorithm>
#include <bit>
#include <vector>

#include "contact/held_joint.hpp"
#include "model/pushes.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "physics/scene.hpp"
#include "physics/space/space_implicit.hpp"
#include "physics/space/turned_worlds.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Force of a joint against the prescribed displacement of its block, and this displacement, at one instant.
struct LedReading {
  double moved, force;  // [m], [N]
};

/// The reading of the largest force.
LedReading strongest(const std::vector<LedReading>& readings) {
  return *std::max_element(readings.begin(), readings.end(),
                           [](const LedReading& a, const LedReading& b) { return a.force < b.force; });
}

/// A joint of 1 m2 between a fixed base and a pressed block with a prescribed displacement along one direction and no
/// rotation.
class LedJoint {
 public:
  /// The mortar sets without stress, then the block comes to rest under `pressure` [Pa].
  LedJoint(const ContactLaw& law, double pressure, const UnitQuaternion& world)
      : scene_(world), sim_(make(scene_, law)) {
    if (pressure > 0) press(pressure);
  }
  void press(double pressure) {
    sim_.edit_model().load[1] = scene_.to_world(Vec3(0, 0, -pressure));
    StageOptions stage = explicit_steps(0.5, 5e-5);
    stage.rest_share = 0.8;
    sim_.run(stage);
  }

  /// Moves the block along the scene direction `way` by u(t) = size sin(2 pi t / period) for `cycles`; across it the
  /// block is free.
  std::vector<LedReading> lead(const Vec3& way, double size, double period, double cycles) {
    const double w = 2 * M_PI / period, end = cycles * period, begun = sim_.state().time;
    const auto motion = motion_of(
        end, period / 4000, [&](double t) { return -size * w * w * std::sin(w * t); }, size * w);
    const Vec3 along = scene_.to_world(way);
    Model<3>& model = sim_.edit_model();
    add_push(model, sim_.state(), "lead",
             push_rows(model, {1}, scene_.to_world(Vec3(0.5, 0.5, 0)), PushPattern::uniform, along), along, motion);
    const double origin = model.pushes[0].origin;
    std::vector<LedReading> readings;
    RunListener<3> listener = after_each_step([&](const Instant<3>& now) {
      readings.push_back({push_place(now.state, now.model.pushes[0]) - origin, -now.work.solids.force[1].dot(along)});
    });
    listener.on_event = [&](const Event& e, const Instant<3>&) {
      if (e.type == EventType::bond_broken) broken.push_back(e), broken.back().time -= begun;
    };
    sim_.run(explicit_steps(end - 1e-6 * period, period / 20000), listener);
    sim_.edit_model().pushes.clear();
    return readings;
  }
  [[nodiscard]] int bonds() const {
    int sum = 0;
    for (const JointMemory& j : sim_.state().contacts.joint) sum += std::popcount(j.bonds);
    return sum;
  }

  std::vector<Event> broken;  ///< bonds broken during the prescribed motion; times count from its start

 private:
  static Model<3> make(SolidScene& scene, const ContactLaw& law) {
    scene.add(fixed_stone("base", box_solid(Vec3(-1, -1, -0.5), Vec3(4, 2, 0))));
    scene.add(stone("block", box_solid(Vec3(0, 0, 0), Vec3(1, 1, 0.5)), 200));
    scene.contact(law);
    Model<3> model = scene.build();
    for (const int about : {3, 4, 5}) set_support(model, 1, about, Support::fixed);
    return model;
  }

  SolidScene scene_;
  Simulation<3> sim_;
};

const Vec3 upwards(0, 0, 1), sidewards(std::cos(0.4), std::sin(0.4), 0);

/// The published joint: [Pa/m], [Pa].
constexpr double joint_kn = 1e8, joint_ks = 5e7, joint_tension = 19150, joint_cohesion = 9768;

}  // namespace

TEST_CASE("C7 in space: a cohesive joint carries its tensile strength and then nothing until it closes again") {
  // The work of the softening law is fully dissipated at an opening of 2.5e-4 m.
  const double work = 0.5 * joint_tension * 2.5e-4;
  struct Pulled {
    ContactLaw law;
    double gone;  // opening at which the traction is zero [m]
  };
  const double reached = joint_tension / joint_kn;
  for (const Pulled& p : {Pulled{brittle_mortar(joint_kn, joint_ks, 0.7, 1e5, joint_tension), 1.005 * reached},
                          Pulled{brittle_mortar(joint_kn, joint_ks, 0.7, 1e5, joint_tension, 1), 1.005 * reached},
                          Pulled{soft_mortar(joint_kn, joint_ks, 0.7, 1e5, joint_tension, work, 100), 2.51e-4}})
    check_in_turned_worlds([&](const UnitQuaternion& world) {
      LedJoint joint(p.law, 0, world);
      CHECK(joint.bonds() == most_patches);
      const std::vector<LedReading> all = joint.lead(upwards, 3e-4, 1, 1.5);
      CHECK(joint.bonds() == 0);
      const LedReading most = strongest(all);
      const auto lost = std::find_if(all.begin(), all.end(), [&](const LedReading& r) { return r.moved > p.gone; });
      double after = 0, deepest = 0;
      for (auto it = lost; it != all.end(); ++it)
        after = std::max(after, it->force), deepest = std::min(deepest, it->force);
      return std::vector<Published>{
          {most.force, 19150, 5e-3}, {most.moved, 1.915e-4, 5e-3}, {after, 0, 0}, {deepest, -joint_kn * 3e-4, 5e-3}};
    });
}

TEST_CASE("C7 in space: closed again after its loss the joint holds by friction alone") {
  const double mu = 0.7, pressure = 5e4;
  Bonded law = brittle_mortar(joint_kn, joint_ks, mu, 1e5, joint_tension);
  law.beta = 1e-4;
  check_in_turned_worlds([&](const UnitQuaternion& world) {
    LedJoint joint(law, 0, world);
    joint.lead(upwards, 3e-4, 1, 1);
    CHECK(joint.bonds() == 0);
    joint.press(pressure);
    return std::vector<Published>{{strongest(joint.lead(sidewards, 3e-3, 4, 0.5)).force, mu * pressure, 5e-3}};
  });
}

TEST_CASE("C8 in space: direct shear reaches c + s tan(phi) and then s tan(phi) and unloads along ks") {
  const double mu = std::tan(radians(35)), pressure = 5e4, slides = 35010, breaks = 44778;
  for (const double by_point : {0.0, 1.0}) {
    Bonded law = brittle_mortar(joint_kn, joint_ks, mu, joint_cohesion, 1e5, by_point);
    law.beta = 1e-5;
    check_in_turned_worlds([&](const UnitQuaternion& world) {
      LedJoint joint(law, pressure, world);
      const std::vector<LedReading> all = joint.lead(sidewards, 4 * breaks / joint_ks, 4, 0.5);
      CHECK(joint.bonds() == 0);
      const auto turning = std::max_element(all.begin(), all.end(),
                                            [](const LedReading& a, const LedReading& b) { return a.moved < b.moved; });
      // Reversed by half of the elastic displacement.
      const auto half = std::find_if(
          turning, all.end(), [&](const LedReading& r) { return r.moved < turning->moved - 0.5 * slides / joint_ks; });
      const LedReading most = strongest(all);
      return std::vector<Published>{{most.force, breaks, 5e-3},
                                    {most.moved, 8.956e-4, 5e-3},
                                    {turning->force, slides, 5e-3},
                                    {(turning->force - half->force) / (turning->moved - half->moved), joint_ks, 5e-3},
                                    {all.back().force, -slides, 5e-3}};
    });
  }
}

TEST_CASE("C7 and C8 in space: a broken bond is reported with mode, force, place and time") {
  const double breaks = 44778;
  Bonded slid = brittle_mortar(joint_kn, joint_ks, std::tan(radians(35)), joint_cohesion, 1e5);
  slid.beta = 1e-5;
  check_in_turned_worlds([&](const UnitQuaternion& world) {
    LedJoint pulled(brittle_mortar(joint_kn, joint_ks, 0.7, 1e5, joint_tension), 0, world), sheared(slid, 5e4, world);
    pulled.lead(upwards, 3e-4, 1, 0.25);
    sheared.lead(sidewards, 4 * breaks / joint_ks, 4, 0.25);
    REQUIRE(pulled.broken.size() == 1);
    REQUIRE(sheared.broken.size() == 1);
    const Event &torn = pulled.broken[0], &slipped = sheared.broken[0];
    CHECK(torn.mode == JointMode::tension);
    CHECK(slipped.mode == JointMode::shear);
    std::vector<Published> all{{torn.value, joint_tension, 5e-3},
                               {torn.time, std::asin(joint_tension / joint_kn / 3e-4) / (2 * M_PI), 5e-3},
                               {slipped.value, std::hypot(breaks, 5e4), 5e-3},
                               {slipped.time, 4 * std::asin(0.25) / (2 * M_PI), 5e-3}};
    for (const Event* e : {&torn, &slipped}) {
      const Vec3 at = SolidScene(world).to_scene(Vec3(e->x, e->y, e->z));
      all.push_back({(at - Vec3(0.5, 0.5, 0)).norm(), 0, 1e-3});  // the block has reached this displacement
    }
    return all;
  });
}
