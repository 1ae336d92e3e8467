// Members of frames along their axes, for the watch.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The beam that its member's material is made for least, as its ends lie.
struct BeamStretch {
  int member = -1, beam = -1;  ///< rows of the model; -1: there is none
  double strain = 0;           ///< change of its length, as a share of that at the start [1]
  double spare = unbounded;    ///< how much more it is made for; not above 0 where it is too much [1]
  double room = unbounded;     ///< path that every point may go, at least, before any beam comes to its limit [m]
};

/// Of all beams but those that were removed, or whose body is out.
template <int D>
BeamStretch worst_beam(const Model<D>& model, const State<D>& state);

/// Where the middle of a beam is [m].
template <int D>
Vec<D> middle_of_beam(const Model<D>& model, const State<D>& state, int beam);

}  // namespace trilith
