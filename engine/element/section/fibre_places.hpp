// Positions of the stations of a fibre beam, for output; the beam's integral does not use them.
#pragma once

#include "element/beam/fibre_beam.hpp"

namespace trilith {

/// From -1 at the beam's start to 1 at its end, by the quadrature rule with the beam's weights.
double place_of_station(const FibreBeam& beam, int station);

}  // namespace trilith
