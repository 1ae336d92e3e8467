// Combines several listeners of a run, for example a recording, a display and user handlers.
#pragma once

#include "run/stage.hpp"

namespace trilith {

/// Calls `first`, then `second`, for each notification that either handles. An exception of one ends the run.
template <int D>
RunListener<D> both(RunListener<D> first, RunListener<D> second);

}  // namespace trilith
