// A search that has no solution: neither a mistake of the user nor an error of the program, but a result of the model.
#pragma once

#include <stdexcept>
#include <string>

namespace trilith {

/// No equilibrium, path or step was found, mostly as the model is unstable. Scripts catch it as they catch any error;
/// the program ends with the exit code of unreliable runs where no script does.
class NoSolution : public std::runtime_error {
 public:
  /// `message`: one line, no trailing full stop: which stage, which body is worst, what to try.
  explicit NoSolution(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace trilith
