// Force tabulated over displacement: linear between points, constant beyond the ends; elastic (same path back).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/schema.hpp"
#include "law/bearing/direction.hpp"

namespace trilith {

struct Table {
  std::vector<double> displacement;  ///< strictly rising [m]
  std::vector<double> force;         ///< same length [N]
  double damping = 0;                ///< [N s/m]

  static constexpr std::string_view name = "table";
  static constexpr std::string_view sentence = "elastic force given by points (displacement, force)";
  static constexpr auto parameters() {
    using P = Parameter<Table>;
    return std::array{P{&Table::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  /// A table for tests, because its points are not declared parameters.
  static Table sample() { return {{-0.05, -0.01, 0, 0.02, 0.06}, {-4e3, -3e3, 0, 1e3, 2e3}, 0}; }
  /// Throws InputError unless there are at least two finite points in increasing order that enclose 0.
  void check() const;
  [[nodiscard]] double tangent() const;
  [[nodiscard]] double dashpot() const { return damping; }
  /// Force at displacement d, and the integral of the force from 0 to d.
  [[nodiscard]] double force_at(double d) const;
  [[nodiscard]] double energy_at(double d) const;

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    DirectionResponse out;
    out.memory.force = force_at(m.displacement);
    out.stored = energy_at(m.displacement);
    add_dashpot(damping, m, before, out);
    return out;
  }
};

}  // namespace trilith
