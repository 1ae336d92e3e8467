// Shear key, dowel or weld: elastic up to its strength, then it breaks and slides with a share of the strength, or not
// at all.
//
// f = k d (and a dashpot) while |k d| has never exceeded the strength. After that a slider: f = k (d - p) with |f| <=
// residual * strength. At the break the slider position p jumps to where the force is the slider's; the excess stored
// energy is dissipated. Memory: `inner` is p, `travelled` the path of the slider: above 0 once it is broken.
#pragma once

#include <array>
#include <cmath>

#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct ShearKey {
  double stiffness = 0;  ///< [N/m]
  double strength = 0;   ///< [N]
  double residual = 0;   ///< [1]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "shear_key";
  static constexpr std::string_view sentence = "brittle key: elastic up to its strength, then nothing or friction";
  static constexpr auto parameters() {
    using P = Parameter<ShearKey>;
    return std::array{
        P{&ShearKey::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "force per displacement"},
        P{&ShearKey::strength, "strength", "N", no_default, 0, unbounded, false,
          "force at which it breaks permanently"},
        P{&ShearKey::residual, "residual", "1", 0, 0, 1, true, "friction of the broken key over its strength"},
        P{&ShearKey::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity until it breaks"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }
  [[nodiscard]] static bool broken(const DirectionMemory& memory) { return memory.travelled > 0; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory = before;
    const double rubs = residual * strength, trial = stiffness * (m.displacement - before.inner);
    out.memory.force = trial;
    if (std::abs(trial) > (broken(before) ? rubs : strength)) {
      out.memory.force = std::copysign(rubs, trial);
      out.memory.inner = m.displacement - out.memory.force / stiffness;
    }
    const double slid = out.memory.inner - before.inner;
    out.memory.travelled += std::abs(slid);
    out.yielding = broken(out.memory);
    out.stored = 0.5 * out.memory.force * out.memory.force / stiffness;
    out.lost_inner = 0.5 * (out.memory.force + before.force) * slid;
    add_dashpot(out.yielding ? 0 : damping, m, before, out);
    return out;
  }
};

}  // namespace trilith
