// Shows a run on the terminal: events as they happen, and below them one line of status.
#pragma once

#include <chrono>
#include <string>

#include "host.hpp"

namespace trilith::program {

class Progress : public script::RunObserver {
 public:
  /// `quiet`: events and status are left out, notes too.
  explicit Progress(bool quiet);
  ~Progress() override;
  void note(const std::string& text) override;
  void event(const Event& event, const Instant& now) override;
  void step(const Instant& now) override;
  void stage_ended(const StageReport& report) override;
  /// Takes the status line away, before something else is written.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void show(const Instant& now);

  bool quiet_, terminal_;
  bool shown_ = false;
  int steps_since_ = 0;
  Clock::time_point stage_begun_ = Clock::now(), last_ = Clock::now();
};

}  // namespace trilith::program
