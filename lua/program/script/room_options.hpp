// The options of every verb that runs a script: whether its room is closed, and its limits.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "bindings/core/host.hpp"

namespace trilith::program {

struct RoomOptions {
  bool trust = false;
  double memory = -1, seconds = -1;  ///< -1: not given
  std::vector<std::string> folders;  ///< of a study's case: instead of the paths in its command line

  /// These options as words of a command line.
  [[nodiscard]] std::vector<std::string> words() const;
};

template <class File>
void each_field(File& file, RoomOptions& o) {
  file.item(o.trust), file.item(o.memory), file.item(o.seconds), file.item(o.folders);
}

void add_room_options(CLI::App& verb, RoomOptions& options);

/// Closes the room of `host`, unless it is trusted, and sets its limits. Script, parameters, results file and folder of
/// the case must be set before, because their paths are accessible.
void set_room(script::Host& host, const RoomOptions& options);

}  // namespace trilith::program
