#include "live.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/terminal_text.hpp"
#include "model/caution.hpp"
#include "model/event/event_list.hpp"

namespace trilith::program {
namespace {

// Wall clock [s]: between redrawn lines on a terminal, between lines elsewhere, between reads of the clock.
constexpr double redraw_interval = 0.15, line_interval = 5, status_interval = 30, look_interval = 0.02;

}  // namespace

Live::Live(std::FILE* out, const EventLines& lines, bool quiet) : screen_(out), lines_(lines), quiet_(quiet) {}

void Live::note(const std::string& text) {
  if (is_caution(text))
    caution(text);
  else if (!quiet_)
    screen_.line("note: " + text);
}

/// A note that limits a result reaches the reader of a quiet run too, on stderr and apart from the script's own output.
void Live::caution(const std::string& text) {
  if (!quiet_) return screen_.line(text, true);
  screen_.clear();
  fmt::print(stderr, "{}\n", terminal_text(units_.message(text)));
}

template <int D>
void Live::tell_event(const Event& event, const Instant<D>& now) {
  if (event.type == EventType::stage_begun) {
    pace_.reset();
    stage_began_ = shown_ = looked_ = wall();
    pace_.add(now.state.time, stage_began_);
  }
  // The report of a stage contains more than its last event.
  if (quiet_ || event.type == EventType::stage_ended) return;
  if (event.type == EventType::stage_begun) unsettled_ = false;
  if (event.type == EventType::stage_unsettled) {
    unsettled_ = true;
    return;
  }
  const bool strong = severity_of(event.type) >= Severity::loss;
  for (const std::string& line : lines_.tell(event, now.model)) screen_.line(line, strong);
}

template <int D>
void Live::tell_step(const Instant<D>& now) {
  if (quiet_ || ++steps_ < stride_) return;
  steps_ = 0;
  const double at = wall();
  // Number of steps for which the clock is read about 50 times per second.
  if (at - looked_ < 0.5 * look_interval) stride_ = std::min(2 * stride_, 1 << 16);
  if (at - looked_ > 2 * look_interval) stride_ = std::max(stride_ / 2, 1);
  looked_ = at;
  if (at - shown_ >= (screen_.is_terminal() ? redraw_interval : line_interval)) show(now, at);
}

template <int D>
void Live::show(const Instant<D>& now, double at) {
  shown_ = at;
  pace_.add(now.state.time, at);
  const std::string text = status_text(now, pace_, lines_.zero());
  if (screen_.is_terminal())
    screen_.status(text);
  else
    screen_.line(text);
}

void Live::event(const Event& event, const Instant<2>& now) {
  tell_event(event, now);
}
void Live::event(const Event& event, const Instant<3>& now) {
  tell_event(event, now);
}
void Live::step(const Instant<2>& now) {
  tell_step(now);
}
void Live::step(const Instant<3>& now) {
  tell_step(now);
}

void Live::stage_ended(const StageReport& report) {
  if (quiet_) return;
  for (const std::string& line : lines_.rest()) screen_.line(line);
  screen_.line(fmt::format("{:10.3f} s  {:<15}  {}", report.ended - lines_.zero(), "stage ended",
                           stage_text(report, wall() - stage_began_)));
  if (!report.reason.empty() && !unsettled_) screen_.line(fmt::format("{:14}{}", "", report.reason));
}

void Live::line(const std::string& text, bool strong) {
  if (!quiet_) screen_.line(text, strong);
}

void Live::status(const std::string& text) {
  if (quiet_ || wall() - shown_ < (screen_.is_terminal() ? redraw_interval : status_interval)) return;
  shown_ = wall();
  if (screen_.is_terminal())
    screen_.status(text);
  else
    screen_.line(text);
}

}  // namespace trilith::program
