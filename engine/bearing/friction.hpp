// Coulomb slider on the bearing's own compression, with an elastic stiffness before sliding: |f| <= mu N.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/schema.hpp"
#include "bearing/direction.hpp"

namespace trilith {

struct Friction {
  double mu = 0;         ///< [1]
  double stiffness = 0;  ///< before sliding [N/m]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "friction";
  static constexpr std::string_view sentence = "Coulomb friction under the bearing's compression";
  static constexpr auto parameters() {
    using P = Parameter<Friction>;
    return std::array{
        P{&Friction::mu, "mu", "1", no_default, 0, 100, true, "friction coefficient"},
        P{&Friction::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "stiffness before sliding"},
        P{&Friction::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }
  /// A slider that goes live late does so unstressed, where it stands.
  [[nodiscard]] static DirectionMemory begin_at(double displacement) {
    DirectionMemory memory;
    memory.inner = displacement;
    return memory;
  }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory = before;
    const double limit = mu * m.compression;
    const double trial = stiffness * (m.displacement - before.inner);
    out.memory.force = std::clamp(trial, -limit, limit);
    if (std::abs(trial) > limit) {
      out.memory.inner = m.displacement - out.memory.force / stiffness;
      out.yielding = true;
    }
    const double slid = out.memory.inner - before.inner;
    out.memory.travelled += std::abs(slid);
    out.lost_inner = 0.5 * (out.memory.force + before.force) * slid;
    out.stored = 0.5 * out.memory.force * out.memory.force / stiffness;
    add_dashpot(damping, m, before, out);
    return out;
  }
};

}  // namespace trilith
