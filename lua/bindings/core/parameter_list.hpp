// The parameters of a script as `--params` lists them.
#pragma once

#include <string>

#include "bindings/core/host.hpp"

namespace trilith::script {

/// A line for each parameter that the script has declared: name, value, unit, sentence. `title` is the name of a script
/// without parameters.
std::string parameter_lines(const Host& host, const std::string& title);

}  // namespace trilith::script
