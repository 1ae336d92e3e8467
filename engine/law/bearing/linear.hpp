// Linear spring and dashpot: f = k d + c dd/dt.
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/bearing/direction.hpp"
#include "law/bearing/horizontal.hpp"

namespace trilith {

struct Linear {
  double stiffness = 0;  ///< [N/m]
  double damping = 0;    ///< [N s/m]

  static constexpr std::string_view name = "linear";
  static constexpr std::string_view sentence = "linear spring with a dashpot";
  static constexpr auto parameters() {
    using P = Parameter<Linear>;
    return std::array{
        P{&Linear::stiffness, "stiffness", "N/m", no_default, 0, unbounded, true, "force per displacement"},
        P{&Linear::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  [[nodiscard]] double tangent() const { return stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory.force = stiffness * m.displacement;
    out.stored = 0.5 * stiffness * m.displacement * m.displacement;
    add_dashpot(damping, m, before, out);
    return out;
  }

  /// The same spring in every azimuth. It has no memory, but a memory must have at least one number.
  struct Horizontal {
    double none = 0;
  };
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    return {before, stiffness * m.displacement, 0.5 * stiffness * m.displacement.squaredNorm()};
  }
};

}  // namespace trilith
