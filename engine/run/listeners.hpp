// Several listeners to one run: a recording, a display and handlers of one's own.
#pragma once

#include "run/stage.hpp"

namespace trilith {

/// Tells `first`, then `second`, of everything either listens to. What one throws ends the run.
RunListener both(RunListener first, RunListener second);

}  // namespace trilith
