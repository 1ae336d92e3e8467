// Rate of spin of a node in space against Euler's equations.
#include "assembly/implicit_turn.hpp"

#include <doctest/doctest.h>

#include "near.hpp"

using namespace trilith;
using testing::near_zero;

TEST_CASE("the spin of a free body in space changes by Euler's equations, in any orientation") {
  const Vec3 inertia(2, 3, 5), spin(0.7, -1.1, 0.4), moment(0.3, 0.2, -0.6);
  Model<3> model;
  model.support.resize(1), model.support[0].fill(Support::free);
  model.inertia.push_back(inertia);
  // In the principal axes of the body.
  const Vec3 rate((moment.x() + (inertia.y() - inertia.z()) * spin.y() * spin.z()) / inertia.x(),
                  (moment.y() + (inertia.z() - inertia.x()) * spin.z() * spin.x()) / inertia.y(),
                  (moment.z() + (inertia.x() - inertia.y()) * spin.x() * spin.y()) / inertia.z());
  for (const Vec3& angle : {Vec3(0, 0, 0), Vec3(0.3, -0.8, 1.2)}) {
    const UnitQuaternion rotation = rotation_by(angle);
    const Turn3 turn(rotation);
    State<3> state;
    state.rotation.push_back(rotation), state.spin.push_back(turn.apply(spin));
    const Vec3 found = spin_rate_under(model, state, 0, turn.apply(moment));
    CHECK(near_zero((found - turn.apply(rate)).norm(), 1e-13));
  }
}
