// Runs commands or functions as separate processes, a limited number at a time, until all have ended or the caller
// stops.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace trilith {

struct ProcessOrder {
  std::vector<std::string> command;   ///< program and arguments
  std::filesystem::path out, errors;  ///< files for its output, overwritten
  /// Instead of a command: function that runs in a forked process and returns its exit code.
  std::function<int()> here = nullptr;
};

struct ProcessEnd {
  int exit = 0;        ///< exit code; -1 if a signal ended it or it could not start
  int signal = 0;      ///< the signal that ended it, or 0
  double seconds = 0;  ///< wall clock
  /// "" if it ended with 0, otherwise "ended with code 3", "ended by signal 9 (Killed)"
  [[nodiscard]] std::string trouble() const;
};

/// Decision on a waiting order, after others have ended: start now, later, or never.
enum class OrderTurn { now, later, never };

struct ProcessWatch {
  std::function<void(std::size_t)> begun;                    ///< order number
  std::function<void(std::size_t, const ProcessEnd&)> ended; /**< order number; not called for stopped ones */
  std::function<bool()> goes_on;                             ///< called several hundred times a second; false: stop all
  /// Called for waiting orders, in order, whenever one has ended; empty: always now. An order that returns `later`
  /// while nothing runs is skipped.
  std::function<OrderTurn(std::size_t)> turn = nullptr;
};

/// Runs all `orders` in their order, at most `at_once` (at least 1) at a time. Each has its own process group, so that
/// an interrupt of the terminal reaches this program alone; if this program dies, they are ended too. To stop them,
/// they are interrupted, and killed after 10 s. Returns false if they were stopped.
bool run_processes(std::span<const ProcessOrder> orders, int at_once, const ProcessWatch& watch);

/// Number of processors that this program may use, at least 1.
int processors();

}  // namespace trilith
