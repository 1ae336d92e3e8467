// Faces that a law would bond, but for a gap between them: told before a run, as nothing else would.
#pragma once

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Pairs of faces under a law that bonds, which look at each other across a gap of up to a hundredth of the smaller
/// body's size and are not bonded.
struct MissedBonds {
  int count = 0;
  // Of the first of them:
  int body_a = -1, body_b = -1, law = -1;
  double gap = 0;  ///< the widest between its faces [m]
};

/// Those of a model as it stands; gaps wider than contacts are looked for are not seen.
MissedBonds missed_bonds(const Model<2>& model, const State<2>& state);
MissedBonds missed_bonds(const Model<3>& model, const State<3>& state);

}  // namespace trilith
