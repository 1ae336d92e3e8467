// Models of solids in worlds that are turned as a whole: what comes out must not depend on it.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith::testing {

/// A model of solids in the making. Everything is given in the axes of the scene, which `world` turns to those of the
/// world: shapes, velocities, gravity.
class SolidScene {
 public:
  explicit SolidScene(const UnitQuaternion& world) : world_(world), turn_(world) {}
  [[nodiscard]] Vec3 to_world(const Vec3& v) const { return turn_.apply(v); }
  [[nodiscard]] Vec3 to_scene(const Vec3& v) const { return turn_.undo(v); }
  void gravity(const Vec3& field) { builder_.gravity(to_world(field)); }
  void contact(const ContactLaw& law) { builder_.contact(0, 0, law, "joint"); }
  int add(SolidBody body) {
    for (Polyhedron& piece : body.pieces) piece = placed(piece, world_, Vec3::Zero());
    body.velocity = to_world(body.velocity), body.spin = to_world(body.spin);
    return builder_.add(body);
  }
  [[nodiscard]] Model<3> build() const { return builder_.build(); }

  /// Where a point of a rigid body is that stood at `at` at the start [m].
  [[nodiscard]] Vec3 now_at(const Model<3>& model, const State<3>& state, int body, const Vec3& at) const {
    const auto b = static_cast<std::size_t>(body);
    const Turn3 turned(state.rotation[b] * inverse(model.start_rotation[b]));
    return to_scene(state.position[b] + turned.apply(to_world(at) - model.start_position[b]));
  }
  [[nodiscard]] Vec3 now_at(const SolidRun& run, int body, const Vec3& at) const {
    return now_at(run.model(), run.state(), body, at);
  }

 private:
  UnitQuaternion world_;
  Turn3 turn_;
  SpaceBuilder builder_;
};

/// A figure that a run came to, and what is published for it: within a share of that, of 0 within that much.
struct Published {
  double figure, expected, within;
};

/// What rounding may make of a figure where a world is turned. Places are rounded to some 1e-16 m, which is up to 1e-12
/// of overlaps of .1 mm; over 1e4 to 1e5 steps figures came to differ by up to 7e-11 in 40 worlds.
inline constexpr double rounding_of_figures = 2e-10;

/// Runs a case in the world as it is and in worlds turned about axes by chance, the same every time: its figures are
/// the published ones in each, and those of turned worlds the first's within `alike` of their size.
inline void check_in_turned_worlds(const std::function<std::vector<Published>(const UnitQuaternion&)>& figures,
                                   double alike = rounding_of_figures) {
  std::mt19937_64 bits(1906);
  const std::vector<Published> upright = figures(UnitQuaternion{});
  double off = 0, apart = 0, drift = 0;
  for (int world = 0; world < 5; ++world) {
    CAPTURE(world);
    const std::vector<Published> now = world == 0 ? upright : figures(random_rotation(bits));
    REQUIRE(now.size() == upright.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Published& p = now[i];
      CAPTURE(i);
      if (p.expected == 0) {
        CHECK(near_zero(p.figure, p.within));
        drift = std::max(drift, std::abs(p.figure));
        continue;
      }
      CHECK(near(p.figure, p.expected, p.within));
      CHECK(near(p.figure, upright[i].figure, alike));
      off = std::max(off, std::abs(p.figure / p.expected - 1));
      apart = std::max(apart, std::abs(p.figure / upright[i].figure - 1));
    }
  }
  MESSAGE("at most ", off, " off what is published, turned worlds apart by ", apart, "; what should be 0 at most ",
          drift);
}

}  // namespace trilith::testing
