// Isotropic linear elasticity (Hooke).
#pragma once

#include <array>

#include "base/schema.hpp"
#include "law/material/point.hpp"

namespace trilith {

struct LinearElastic {
  double young = 0;    ///< [Pa]
  double poisson = 0;  ///< [1]
  double damping = 0;  ///< [s]

  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::string_view sentence = "isotropic, linear elastic";
  static constexpr bool is_elastic = true;
  static constexpr auto parameters() {
    using P = Parameter<LinearElastic>;
    return std::array{
        P{&LinearElastic::young, "E", "Pa", no_default, 0, unbounded, false, "Young's modulus"},
        P{&LinearElastic::poisson, "nu", "1", 0, 0, 0.499, true, "Poisson's ratio"},
        P{&LinearElastic::damping, "beta", "s", 0, 0, 1, true, "damping stress over elastic stress of strain rate"}};
  }
};

}  // namespace trilith
