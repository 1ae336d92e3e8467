// A single direction law: with prescribed displacements and its energies, or on a mass that moves freely.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include "law/bearing/list.hpp"

namespace trilith::testing {

/// A law with prescribed displacements in equal time steps. `work` is the work of the mean forces of each step.
template <DirectionLawType L>
struct LedLaw {
  L law;
  double dt = 1e-3, compression = 0;
  double at = 0;
  DirectionResponse now = {};
  double work = 0, lost = 0, least_loss = 0, most_force = 0;

  void to(double d) {
    const DirectionResponse next = law.respond({d, (d - at) / dt, dt, compression}, now.memory);
    work += 0.5 * (next.force() + now.force()) * (d - at);
    lost += next.lost_inner + next.lost_damping;
    least_loss = std::min(least_loss, next.lost_inner + next.lost_damping);
    most_force = std::max(most_force, std::abs(next.force()));
    at = d, now = next;
  }
  void along(double d, int steps = 400) {
    for (int i = 1, left = steps; i <= steps; ++i, --left) to(i == steps ? d : at + (d - at) / left);
  }
  /// X sin(2 pi t / T) for some periods, starting at 0; returns the work of the last one.
  double sine(double amplitude, double period, int periods, int steps) {
    dt = period / steps;
    double before = 0;
    for (int i = 1; i <= periods * steps; ++i) {
      if (i == (periods - 1) * steps + 1) before = work, most_force = 0;
      to(amplitude * std::sin(2 * M_PI * i / steps));
    }
    return work - before;
  }
  /// Residual of the energy balance [J].
  [[nodiscard]] double unbooked() const { return work - now.stored - lost; }
};

/// A mass that moves along the direction of its laws, with the engine's time stepping.
template <DirectionLawType... L>
struct MassOn {
  double mass, dt;
  std::tuple<L...> laws;
  double x = 0, v = 0, compression = 0, time = 0;
  std::array<DirectionResponse, sizeof...(L)> now = {};

  /// Under an external force [N].
  void step(double push = 0) {
    double force = push;
    for (const DirectionResponse& r : now) force -= r.force();
    v += dt * force / mass, x += dt * v, time += dt;
    const DirectionMotion motion{x, v, dt, compression};
    std::apply(
        [&](const L&... law) {
          std::size_t i = 0;
          ((now[i] = law.respond(motion, now[i].memory), ++i), ...);
        },
        laws);
  }
};

}  // namespace trilith::testing
