// Runs commands, or functions, as processes of their own, so many at a time, until all have ended or the caller wants
// no more.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace trilith {

struct ProcessOrder {
  std::vector<std::string> command;   ///< program and arguments
  std::filesystem::path out, errors;  ///< files for what it writes, made anew
  /// Instead of a command: what a process that parts from this one does; gives its exit code.
  std::function<int()> here = nullptr;
};

struct ProcessEnd {
  int exit = 0;        ///< exit code; -1 where a signal ended it or it could not begin
  int signal = 0;      ///< the signal that ended it, or 0
  double seconds = 0;  ///< wall clock
  /// "" where it ended with 0, else "ended with code 3", "ended by signal 9 (Killed)"
  [[nodiscard]] std::string trouble() const;
};

/// Whether an order that waits begins now, once others have ended, or not at all.
enum class OrderTurn { now, later, never };

struct ProcessWatch {
  std::function<void(std::size_t)> begun;  ///< order number
  std::function<void(std::size_t, const ProcessEnd&)>
      ended;                      /**< order number; not called for those that were stopped */
  std::function<bool()> goes_on;  ///< some hundred times a second; false: stop all
  /// Asked of what waits, in order, whenever one has ended; empty: always now. One that says later when nothing runs is
  /// left out.
  std::function<OrderTurn(std::size_t)> turn = nullptr;
};

/// Runs all `orders`, at most `at_once` (at least 1) at a time, in their order. Each has a process group of its own, so
/// that an interrupt of the terminal reaches this program alone; where this program dies, they are ended too. To stop,
/// they are interrupted, and ended by force after ten seconds. Gives false where they were stopped.
bool run_processes(std::span<const ProcessOrder> orders, int at_once, const ProcessWatch& watch);

/// Processors this program may use, at least 1.
int processors();

}  // namespace trilith
