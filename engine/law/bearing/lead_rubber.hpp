// Lead rubber bearing in shear: layered rubber with a yielding lead core, as a bilinear loop.
//
// f = K1 d to first yield at d_y = Q / (K1 - K2), then f = Q + K2 d; unloading along K1 over twice the yield force Q +
// K2 d_y. Robinson, "Lead-rubber hysteretic bearings suitable for protecting structures during earthquakes", Earthquake
// Eng. Struct. Dyn. 10, 1982, with K1 of 6.5 to 10 times K2; Naeim and Kelly, "Design of Seismic Isolated Structures",
// 1999.
//
// Not modelled: heating lead loses strength over many large loops; rubber stiffens beyond a shear strain of about 1.5
// (set the `limit` of the bearing); the load has no influence (no buckling).
#pragma once

#include <array>

#include "law/bearing/elastic_plastic.hpp"

namespace trilith {

struct LeadRubber {
  double strength = 0;        ///< Q [N]
  double post_stiffness = 0;  ///< K2 [N/m]
  double stiffness = 0;       ///< K1 [N/m], or 0
  double ratio = 0;           ///< K1 / K2 where K1 is not given [1]
  double damping = 0;         ///< [N s/m]

  static constexpr std::string_view name = "lead_rubber";
  static constexpr std::string_view sentence =
      "lead rubber bearing: bilinear loop given by its characteristic strength";
  static constexpr auto parameters() {
    using P = Parameter<LeadRubber>;
    return std::array{
        P{&LeadRubber::strength, "strength", "N", no_default, 0, unbounded, false,
          "characteristic strength Q: force where the loop crosses zero displacement"},
        P{&LeadRubber::post_stiffness, "post_stiffness", "N/m", no_default, 0, unbounded, false,
          "K2, stiffness after yield (rubber)"},
        P{&LeadRubber::stiffness, "stiffness", "N/m", 0, 0, unbounded, true, "K1, before yield; 0: `ratio` times K2"},
        P{&LeadRubber::ratio, "ratio", "1", 10, least_ratio, 1000, true, "K1 / K2 where K1 is not given"},
        P{&LeadRubber::damping, "damping", "N s/m", 0, 0, unbounded, true, "force per velocity"}};
  }
  /// A bearing for tests, with K1 above K2 as required.
  static LeadRubber sample() { return {3e3, 1e5, 0, 10, 0}; }
  /// Throws InputError where K1 is given and is not above K2.
  void check() const {
    if (stiffness > 0 && stiffness < least_ratio * post_stiffness)
      throw InputError(fmt::format(
          "lead_rubber: stiffness is {:g} N/m, must be at least {:g} times post_stiffness ({:g} N/m); is K1 meant?",
          stiffness, least_ratio, post_stiffness));
  }
  [[nodiscard]] double tangent() const { return stiffness > 0 ? stiffness : ratio * post_stiffness; }
  [[nodiscard]] double dashpot() const { return damping; }

  [[nodiscard]] DirectionResponse respond(const DirectionMotion& m, const DirectionMemory& before) const {
    return loop().respond(m, before);
  }

  /// A round bearing yields at the same resultant in every azimuth.
  using Horizontal = ElasticPlastic::Horizontal;
  [[nodiscard]] HorizontalResponse<Horizontal> respond_horizontal(const HorizontalMotion& m,
                                                                  const Horizontal& before) const {
    return loop().respond_horizontal(m, before);
  }

 private:
  [[nodiscard]] ElasticPlastic loop() const {
    const double first = tangent(), hardening = post_stiffness / first;
    return {first, strength / (1 - hardening), hardening, damping};
  }
  static constexpr double least_ratio = 1.01;  // below it the loop has no distinct corner
};

}  // namespace trilith
