// Several listeners to one run: a recording, a display and handlers of one's own.
#pragma once

#include "run/stage.hpp"

namespace trilith {

/// Tells `first`, then `second`, of everything either listens to. What one throws ends the run.
template <int D>
RunListener<D> both(RunListener<D> first, RunListener<D> second);

}  // namespace trilith
