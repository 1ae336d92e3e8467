// Shows a run while it goes on: events as they happen, below them one line of status.
#pragma once

#include <chrono>
#include <string>

#include "bindings/core/host.hpp"
#include "run/progress.hpp"
#include "screen.hpp"

namespace trilith::program {

class Live : public script::RunObserver {
 public:
  /// `quiet`: shows nothing at all but what goes wrong.
  Live(std::FILE* out, const EventLines& lines, bool quiet = false);

  void note(const std::string& text) override;
  void event(const Event& event, const Instant<2>& now) override;
  void event(const Event& event, const Instant<3>& now) override;
  /// Called after every step; looks at the clock only every so many of them.
  void step(const Instant<2>& now) override;
  void step(const Instant<3>& now) override;
  void stage_ended(const StageReport& report) override;
  void clear() override { screen_.clear(); }
  /// Times were to count from a stage or an event that has not come.
  [[nodiscard]] bool waits() const { return lines_.waits(); }
  void line(const std::string& text, bool strong) override;
  /// Redrawn on a terminal, a line now and then elsewhere.
  void status(const std::string& text) override;

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  template <int D>
  void tell_event(const Event& event, const Instant<D>& now);
  template <int D>
  void tell_step(const Instant<D>& now);
  template <int D>
  void show(const Instant<D>& now, double at);

  Screen screen_;
  EventLines lines_;
  Pace pace_;
  bool quiet_;
  Clock::time_point started_ = Clock::now();
  double stage_began_ = 0, looked_ = 0, shown_ = 0;  // wall clock [s]
  int steps_ = 0, stride_ = 1;
};

}  // namespace trilith::program
