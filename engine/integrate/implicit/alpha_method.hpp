// The implicit schemes of assembly/alpha_scheme.hpp as an integrator: HHT-alpha by `alpha`, or generalised alpha by
// `spectral_radius`.
#pragma once

#include <array>

#include "assembly/alpha_scheme.hpp"
#include "base/schema.hpp"
#include "integrate/integrator.hpp"

namespace trilith {

struct AlphaMethod {
  static constexpr double hht_only = -unbounded;
  double alpha = -0.05;               ///< HHT
  double spectral_radius = hht_only;  ///< from 0 on: generalised alpha

  static constexpr std::string_view name = "implicit";
  static constexpr std::string_view sentence = "Newmark, HHT-alpha and generalised alpha, by Newton's method";
  static constexpr VelocityTimes velocities = VelocityTimes::collocated;
  static constexpr StepBound bound = StepBound::accuracy;
  static constexpr auto parameters() {
    using P = Parameter<AlphaMethod>;
    return std::array{
        P{&AlphaMethod::alpha, "alpha", "1", -0.05, -1.0 / 3, 0, true, "HHT; 0 has no numerical damping (Newmark)"},
        P{&AlphaMethod::spectral_radius, "spectral_radius", "1", hht_only, 0, 1, true, "instead: generalised alpha"}};
  }
  /// Parameters of which a script gives one at most, and the reason.
  static constexpr std::array exclusive{"alpha", "spectral_radius", "each sets the numerical damping"};

  static constexpr AlphaMethod hht(double alpha) { return {alpha, hht_only}; }
  static constexpr AlphaMethod from_radius(double radius) { return {-0.05, radius}; }
  [[nodiscard]] AlphaScheme scheme() const {
    return spectral_radius >= 0 ? AlphaScheme::from_radius(spectral_radius) : AlphaScheme::hht(alpha);
  }

  template <int D>
  [[nodiscard]] StepResult step(const StepInput<D>& input) const;
};

}  // namespace trilith
