// Models of solids in rotated worlds: results must not depend on the world's orientation.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "near.hpp"
#include "physics/space/solid_bodies.hpp"

namespace trilith::testing {

/// Builder of a model of solids. All input is given in scene axes, which `world` rotates to world axes: shapes,
/// velocities, gravity.
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

  /// Current position of a point of a rigid body whose start position is `at` [m].
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

/// A computed figure and its published value: tolerance as a share of the value, or absolute if the value is 0.
struct Published {
  double figure, expected, within;
};

/// Allowed influence of rounding on a figure in a rotated world. Positions are rounded to about 1e-16 m, which is up to
/// 1e-12 of penetrations of 0.1 mm. Over 1e4 to 1e5 steps figures differed by up to 7e-11 in 40 worlds.
inline constexpr double rounding_of_figures = 2e-10;

/// Runs a case in the given world and in worlds rotated about random axes, the same in every run. In each world the
/// figures must equal the published values, and in rotated worlds also the figures of the first world within `alike` of
/// their size.
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
