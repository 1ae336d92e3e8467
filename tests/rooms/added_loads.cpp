// The kind of load that docs/architecture.md adds, run in the plane and in space. tests/rooms/add_a_law compiles this
// file in a copy of the tree that has it. Its row changes the layout of Model, so the file needs no compiled part of
// the engine: loads act on a point mass by leapfrog.
#include <doctest/doctest.h>

#include "load/list.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

/// A point mass as target.
template <int D>
struct PointMass {
  double now = 0, mass = 1;
  Vec<D> force = Vec<D>::Zero(), velocity = Vec<D>::Zero(), position = Vec<D>::Zero();

  [[nodiscard]] double time() const { return now; }
  [[nodiscard]] auto turn_of(const Attachment<D>& /*at*/) const { return Turn(0); }
  void push(const Attachment<D>& /*at*/, const Vec<D>& f, const Moment<D>& /*moment*/) { force += f; }
  [[nodiscard]] Vec2 skin(int /*point*/) const { return Vec2::Zero(); }
  void push_skin(int /*point*/, const Vec2& /*force*/) {}

  void step(const Unbalance<D>& load, double dt) {
    force.setZero();
    load.apply(*this, 0);
    velocity += (now == 0 ? 0.5 : 1.0) * dt / mass * force;
    position += dt * velocity, now += dt;
  }
};

/// A free mass under a rotating force from rest: x = F / (m w^2) (1 - cos wt), and y (z in space) = F / (m w^2) (wt -
/// sin wt).
template <int D>
void circles() {
  Loads<D> loads;
  CHECK(loads.empty());
  Unbalance<D> load;
  load.name = "rotor", load.force = 50, load.rate = 20;
  loads.add(std::vector{load});
  int count = 0;
  loads.for_each([&](const auto& one) {
    CHECK(one.name == "rotor");
    CHECK(one.parts() == 1);
    ++count;
  });
  CHECK(count == 1);
  loads.for_each([](auto& one) { one.scale(2); });
  PointMass<D> body;
  body.mass = 3;
  const double size = 100 / (3 * 20.0 * 20.0);
  for (int i = 0; i < 20000; ++i) body.step(loads.template of<Unbalance<D>>()[0], 5e-5);
  CHECK(near(body.position[0], size * (1 - std::cos(20.0)), 1e-4));
  CHECK(near(body.position[D - 1], size * (20 - std::sin(20.0)), 1e-4));
  CHECK(loads.erase_if([](const auto& one) { return one.name == "rotor"; }) == 1);
  CHECK(loads.empty());
}

}  // namespace

TEST_CASE("an unbalance moves a free mass along a cycloid in the plane and in space") {
  circles<2>();
  circles<3>();
}

}  // namespace trilith::testing
