// The laws that docs/architecture.md adds, tested in the plane and in space. tests/rooms/add_a_law compiles this file
// in a copy of the tree that has them.
#include <doctest/doctest.h>

#include "contact/law_trial.hpp"
#include "law/material/space_point.hpp"
#include "model/contact/contact_rules.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

/// 50 kN of pressure on 1 m2.
constexpr Lie resting{5e-5, 0, 0.2, 1e-3};

/// A model of two bodies in contact, with the members that rules of contact need.
template <int D>
Model<D> two_bodies() {
  Model<D> model;
  model.bodies.resize(2);
  model.bodies[0].name = "pier", model.bodies[1].name = "deck";
  return model;
}

template <int D>
std::string refusal_of(const ContactLaw& law) {
  ContactRules rules;
  std::vector<std::string> notes;
  rules.add_law("glue", law, notes);
  rules.set_contact("*", "*", "glue");
  Model<D> model = two_bodies<D>();
  try {
    rules.fill(model);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("rate_friction has the friction of its sliding speed in every geometry") {
  RateFriction law;
  law.kn = 1e9, law.ks = 1e9, law.mu = 0.1, law.mu_fast = 0.3, law.rate = 10;
  const double due = 0.3 - 0.2 * std::exp(-10 * resting.speed);
  const ContactLaw in_list = law;
  using K = RateFriction::Kernel;
  for (const Carried& c : {as_plane_faces<K>(in_list, resting), as_polygons<K>(in_list, resting),
                           as_solids(in_list, resting, true), as_solids(in_list, resting, false)}) {
    CHECK(near(c.normal, 50e3, 1e-3));
    CHECK(near(-c.shear, due * 50e3, 1e-3));
  }
  const Carried ball = as_ball(in_list, resting);
  CHECK(near(-ball.shear, due * ball.normal, 1e-9));
  CHECK(refusal_of<2>(in_list).empty());
  CHECK(refusal_of<3>(in_list).empty());
}

TEST_CASE("sticky has tension as faces in the plane, friction otherwise, and is rejected in space by name") {
  Sticky law;
  law.kn = 1e8, law.ks = 1e8, law.mu = 0.3, law.tension = 2e5;
  const ContactLaw in_list = law;
  const Lie open{-5e-4, 0, 0, 1e-3};
  CHECK(near(as_plane_faces<Sticky::Kernel>(in_list, open).normal, -50e3, 1e-9));
  CHECK(as_polygons<Sticky::Kernel>(in_list, open).normal == 0);
  CHECK(refusal_of<2>(in_list).empty());
  const std::string message = refusal_of<3>(in_list);
  INFO(message);
  for (const char* word : {"'glue'", "sticky", "'pier'", "'deck'", "flat faces in space", "press", "frictional"})
    CHECK(message.find(word) != std::string::npos);
}

TEST_CASE("mean_limit under three equal strains has three equal stresses at its limit, in plane strain the same mean") {
  const MeanLimit law{30e9, 0.2, 100e3, 0};
  SpaceVector strain;
  strain << 1e-4, 1e-4, 1e-4, 0, 0, 0;
  const SpaceResponse all = respond_in_space(law, strain, {});
  for (const int k : {0, 1, 2}) CHECK(near(all.stress[k], 100e3, 1e-12));
  const PlaneVector in_plane(1e-4, 1e-4, 0);
  strain << 1e-4, 1e-4, 0, 0, 0, 0;
  const PointResponse plane = respond_in_plane(law, Plane::strain, in_plane, {});
  const SpaceResponse space = respond_in_space(law, strain, {});
  CHECK(near(plane.stress.xx + plane.stress.yy + plane.stress.zz, 300e3, 1e-12));
  CHECK(near(plane.stress.xx, space.stress[0], 1e-12));
  CHECK(near(plane.stress.zz, space.stress[2], 1e-12));
  const PointResponse thin = respond_in_plane(law, Plane::stress, in_plane, {});
  CHECK(near(thin.stress.xx, 150e3, 1e-9));
  CHECK(near(thin.stress.yy, 150e3, 1e-9));
}

}  // namespace trilith::testing
