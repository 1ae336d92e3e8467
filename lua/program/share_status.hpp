// A status line with the completed share of a task.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

#include "screen.hpp"

namespace trilith::program {

/// Prints the completed share on a terminal, after a short time.
class ShareStatus {
 public:
  /// `what`: such as "reading frames".
  explicit ShareStatus(std::string what) : what_(std::move(what)) {}
  void operator()(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = now;
    screen_.status(fmt::format("{}  {:.0f} %", what_, 100 * share));
  }
  void clear() { screen_.clear(); }

 private:
  std::string what_;
  Screen screen_{stderr};
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

}  // namespace trilith::program
