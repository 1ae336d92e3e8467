// Displays a run: events as they occur, below them one status line.
#pragma once

#include <chrono>
#include <string>

#include "bindings/core/host.hpp"
#include "run/progress.hpp"
#include "screen.hpp"

namespace trilith::program {

class Live : public script::RunObserver {
 public:
  /// `quiet`: shows only errors and, on stderr, notes that limit a result (model/caution.hpp).
  Live(std::FILE* out, const EventLines& lines, bool quiet = false);

  void note(const std::string& text) override;
  void event(const Event& event, const Instant<2>& now) override;
  void event(const Event& event, const Instant<3>& now) override;
  /// Called after every step; reads the clock only at intervals of steps.
  void step(const Instant<2>& now) override;
  void step(const Instant<3>& now) override;
  void stage_ended(const StageReport& report) override;
  void clear() override { screen_.clear(); }
  void show_in(const UnitSystem& units) override { screen_.show_in(units), units_ = units; }
  /// The stage or event at which times should start has not occurred yet.
  [[nodiscard]] bool waits() const { return lines_.waits(); }
  void line(const std::string& text, bool strong) override;
  /// Redrawn on a terminal, printed from time to time elsewhere.
  void status(const std::string& text) override;

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  template <int D>
  void tell_event(const Event& event, const Instant<D>& now);
  template <int D>
  void tell_step(const Instant<D>& now);
  void caution(const std::string& text);
  template <int D>
  void show(const Instant<D>& now, double at);

  Screen screen_;
  UnitSystem units_;
  EventLines lines_;
  Pace pace_;
  bool quiet_;
  bool unsettled_ = false;  // an error or the verdict gives the reason
  Clock::time_point started_ = Clock::now();
  double stage_began_ = 0, looked_ = 0, shown_ = 0;  // wall clock [s]
  int steps_ = 0, stride_ = 1;
};

}  // namespace trilith::program
