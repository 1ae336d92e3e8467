// A joint of softening mortar with prescribed openings and slips, for tests of its law.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "contact/face_scene.hpp"

namespace trilith::testing {

/// A joint of 1 m2 with prescribed openings and slips; `work` is the work of the applied forces.
struct MortarJoint {
  static constexpr double kn = 1e9, ks = 4e8, mu = 0.7, cohesion = 2e5, tension = 1e5, gi = 20, gii = 125;

  static Cohesive mortar() { return {kn, ks, mu, 0, cohesion, tension, gi, gii, 0, 0}; }

  Cohesive::Kernel law{mortar(), 1, 1e-4};
  Turn turn{0.0};
  FaceMemory<double> memory = no_memory(true);
  LawMemory<Cohesive::Kernel> own;
  double gap = 0, slip = 0;                                  // [m]
  double normal = 0, shear = 0;                              // opening and shear force on b [N]
  double work = 0, fracture = 0, friction = 0, damping = 0;  // [J]

  void to(double next_gap, double next_slip) {
    const Vec2 speed((next_slip - slip) / law.dt, (next_gap - gap) / law.dt), still = Vec2::Zero();
    // b's face is longer than a's, so that a's face stays covered.
    const Faces f = turned({rigid_face({1, 0}, {0, 0}, still, 0),
                            rigid_face({-1 + next_slip, next_gap}, {2 + next_slip, next_gap}, speed, 0)},
                           turn);
    const auto r = respond_face_pair(f.a, f.b, 1.0, memory, own, law);
    REQUIRE(r.is_face_pair);
    const Vec2 on_b = turn.undo(Vec2(on_b0(r) + on_b1(r)));
    work -= 0.5 * (on_b.y() - normal) * (next_gap - gap) + 0.5 * (on_b.x() - shear) * (next_slip - slip);
    normal = -on_b.y(), shear = -on_b.x();
    fracture += r.lost_fracture, friction += r.lost_friction, damping += r.lost_damping;
    memory = r.touching ? r.memory : no_memory(false);
    own = r.touching ? r.own : law.parted(r.own);
    gap = next_gap, slip = next_slip;
  }
  /// In `steps` equal steps; calls `see` after each.
  void lead(
      double next_gap, double next_slip, int steps, const std::function<void()>& see = [] {}) {
    const double g0 = gap, s0 = slip;
    for (int i = 1; i <= steps; ++i) {
      to(g0 + (next_gap - g0) * i / steps, s0 + (next_slip - s0) * i / steps);
      see();
    }
  }
  [[nodiscard]] double damage() const { return most_damage(own); }
  /// Elastic energy of the joint, uniformly open or closed [J].
  [[nodiscard]] double stored() const {
    double sum = 0;
    for (const int h : {0, 1}) {
      const double left = gap + own.crushed[h];
      const double hold = left <= 0 ? 1 : memory.bonds[h] ? law.held(1 - law.damage(own, h)) : 0;
      sum += 0.5 * kn * hold * left * left * 0.5;
      if (memory.active[h] > 0)
        sum += 0.5 * memory.shear_elastic[h] * memory.shear_elastic[h] / (ks * memory.active[h]);
    }
    return sum;
  }
};

}  // namespace trilith::testing
