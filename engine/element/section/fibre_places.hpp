// Where the stations of a beam of fibres stand, which its integral does not need but a reader does.
#pragma once

#include "element/beam/fibre_beam.hpp"

namespace trilith {

/// From -1 at the beam's start to 1 at its end: of the rule that has its weights.
double place_of_station(const FibreBeam& beam, int station);

}  // namespace trilith
