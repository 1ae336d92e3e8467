// Run times of the parts of a run, as lines.
#pragma once

#include <string>

#include "bindings/core/host.hpp"

namespace trilith::program {

/// Parts of the step, contact laws and Lua callbacks with their shares of the wall clock; the largest first among the
/// laws and callbacks.
std::string profile_text(const script::Profile& profile);

}  // namespace trilith::program
