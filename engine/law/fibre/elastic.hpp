// Elastic in one direction: stress = E strain.
#pragma once

#include "base/schema.hpp"
#include "law/fibre/point.hpp"

namespace trilith {

struct UniaxialElastic {
  double young = 0;  ///< [Pa]

  static constexpr std::string_view name = "uniaxial_elastic";
  static constexpr std::string_view sentence = "linear elastic fibre";
  static constexpr auto parameters() {
    using P = Parameter<UniaxialElastic>;
    return std::array{P{&UniaxialElastic::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"}};
  }
  static constexpr int memory_size = 2;
  using Memory = std::array<double, memory_size>;
  static constexpr bool loses_at_every_step = true;
  [[nodiscard]] double tangent() const { return young; }
  [[nodiscard]] double stored(const Memory& m) const { return 0.5 * m[last_stress] * m[last_strain]; }

  [[nodiscard]] UniaxialResponse<memory_size> respond(double strain, const Memory&) const {
    UniaxialResponse<memory_size> out;
    out.memory = {strain, young * strain};
    out.tangent = young;
    out.stored = stored(out.memory);
    return out;
  }
};

}  // namespace trilith
