// Cable or restrainer: carries tension when taut and never compression. It may be slack or prestretched at placement,
// and it may break.
//
// f = max(0, k e + c e') with the stretch e = d - slack + pretension / k, where e > 0. Once k e exceeds `strength` the
// cable is broken permanently, and its stored energy is dissipated. Memory: `travelled` is the stretch at which it
// broke, 0 before.
#pragma once

#include <algorithm>
#include <array>

#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct Cable {
  double stiffness = 0;   ///< [N/m]
  double slack = 0;       ///< [m]
  double pretension = 0;  ///< [N]
  double strength = 0;    ///< [N]; 0: it does not break
  double damping = 0;     ///< [N s/m]
  double side = 0;        ///< >= 0: in tension where d > 0; < 0: where d < 0

  static constexpr std::string_view name = "cable";
  static constexpr std::string_view sentence = "cable or restrainer: tension only, slack or prestressed, may break";
  static constexpr auto parameters() {
    using P = Parameter<Cable>;
    return std::array{P{&Cable::stiffness, "stiffness", "N/m", no_default, 0, unbounded, false, "force per elongation"},
                      P{&Cable::slack, "slack", "m", 0, 0, unbounded, true, "displacement at which the cable is taut"},
                      P{&Cable::pretension, "pretension", "N", 0, 0, unbounded, true,
                        "force at displacement 0 where it has no slack"},
                      P{&Cable::strength, "strength", "N", 0, 0, unbounded, true,
                        "force at which it breaks permanently; 0: it does not break"},
                      P{&Cable::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity while taut"},
                      P{&Cable::side, "side", "1", 1, -1, 1, true,
                        "+1: taut in motion of the second point along the axis; -1: against it"}};
  }
  /// A cable for tests, so soft that the usual strength breaks it after many steps.
  static Cable sample() { return {1e5, 0, 0, 0, 0, 1}; }
  /// Throws InputError where it would break at placement.
  void check() const {
    if (strength > 0 && pretension > strength)
      throw InputError(
          fmt::format("cable: pretension is {:g} N, must not be above strength ({:g} N)", pretension, strength));
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }
  [[nodiscard]] static bool broken(const DirectionMemory& memory) { return memory.travelled > 0; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    const double sign = side < 0 ? -1 : 1, stretch = sign * m.displacement - slack + pretension / stiffness;
    DirectionResponse out;
    out.memory.travelled = before.travelled;
    out.yielding = broken(before);
    if (stretch > 0 && !broken(before)) {
      const double pull = stiffness * stretch;
      if (strength > 0 && pull > strength) return breaking(stretch, m, before);
      out.memory.force = sign * pull;
      out.memory.damping = sign * std::max(-pull, sign * damping * m.rate);
      out.stored = 0.5 * pull * stretch;
    }
    out.lost_damping = 0.5 * (out.memory.damping + before.damping) * m.mean * m.dt;
    return out;
  }

 private:
  /// Dissipates the stored energy and the work done within the step.
  [[nodiscard]] DirectionResponse breaking(double stretch, const DirectionMotion& m,
                                           const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory.travelled = stretch;
    out.yielding = true;
    out.lost_inner = 0.5 * before.force * before.force / stiffness + 0.5 * before.force * m.mean * m.dt;
    out.lost_damping = 0.5 * before.damping * m.mean * m.dt;
    return out;
  }
};

}  // namespace trilith
