// Axial strain of members, for the watch.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The beam with the least strain reserve, from the present positions of its ends.
struct BeamStretch {
  int member = -1, beam = -1;  ///< rows of the model; -1: none
  double strain = 0;           ///< change of length over the initial length [1]
  double spare = unbounded;    ///< remaining strain up to the limit of its material; 0 or negative beyond it [1]
  double room = unbounded;     ///< least travel of all points before any beam may reach its limit [m]
};

/// Considers all beams except removed ones and beams of deactivated bodies.
template <int D>
BeamStretch worst_beam(const Model<D>& model, const State<D>& state);

/// Where the middle of a beam is [m].
template <int D>
Vec<D> middle_of_beam(const Model<D>& model, const State<D>& state, int beam);

}  // namespace trilith
