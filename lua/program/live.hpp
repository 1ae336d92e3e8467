// Shows a run while it goes on: events as they happen, below them one line of status.
#pragma once

#include <chrono>
#include <string>

#include "run/progress.hpp"
#include "screen.hpp"

namespace trilith::program {

class Live {
 public:
  /// `quiet`: shows nothing at all but what goes wrong.
  Live(std::FILE* out, EventShow events, bool quiet = false);

  void note(const std::string& text);
  void event(const Event& event, const Instant& now);
  /// Called after every step; looks at the clock only every so many of them.
  void step(const Instant& now);
  void stage_ended(const StageReport& report);
  /// Takes the status line away, before something else is written.
  void clear() { screen_.clear(); }
  /// The same for a run without a script; valid as long as this lives.
  RunListener listener();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  void show(const Instant& now, double at);

  Screen screen_;
  EventLines lines_;
  Pace pace_;
  bool quiet_;
  Clock::time_point started_ = Clock::now();
  double stage_began_ = 0, looked_ = 0, shown_ = 0;  // wall clock [s]
  int steps_ = 0, stride_ = 1;
};

}  // namespace trilith::program
