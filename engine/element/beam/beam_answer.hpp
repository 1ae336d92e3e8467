// The response of a yielding plane beam with its tangents.
#pragma once

#include "element/beam/beam_yield.hpp"

namespace trilith {

struct BeamAnswer {
  BeamTangent tangent;    ///< actions, and their derivatives
  double stored = 0;      ///< [J]
  double dissipated = 0;  ///< by yielding, in this step [J]
};

/// `before` and `after` have memory_size numbers and do not overlap.
BeamAnswer answer_of(const BeamYields& yields, const Beam& beam, const BeamNow& now, std::span<const double> before,
                     std::span<double> after);

}  // namespace trilith
