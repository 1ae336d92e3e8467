#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "world/event_text.hpp"

namespace trilith::program {
namespace {

/// The clock is looked at every so many steps.
constexpr int steps_between_looks = 64;
constexpr double seconds_between_lines = 0.1;

double seconds_since(std::chrono::steady_clock::time_point t) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDOUT_FILENO) != 0) {}
Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (shown_) fmt::print("\r\033[K");
  shown_ = false;
  std::fflush(stdout);
}

void Progress::note(const std::string& text) {
  if (quiet_) return;
  clear();
  fmt::print("note: {}\n", text);
}

void Progress::event(const Event& event, const Instant& now) {
  if (event.type == EventType::stage_begun) {
    stage_begun_ = last_ = Clock::now();
    steps_since_ = 0;
  }
  if (quiet_ || !is_important(event.type) || event.type == EventType::stage_ended) return;
  clear();
  fmt::print("{:10.4f} s  {}\n", event.time, event_text(event, now.model));
}

void Progress::step(const Instant& now) {
  if (quiet_ || !terminal_ || ++steps_since_ < steps_between_looks) return;
  steps_since_ = 0;
  if (seconds_since(last_) < seconds_between_lines) return;
  last_ = Clock::now();
  show(now);
}

void Progress::show(const Instant& now) {
  double kinetic = 0;
  for (std::size_t i = 0; i < now.state.velocity.size(); ++i)
    kinetic += 0.5 * (now.model.mass[i] * now.state.velocity[i].squaredNorm() +
                      now.model.inertia[i] * now.state.spin[i] * now.state.spin[i]);
  const double done = now.state.time - now.begun, wall = seconds_since(stage_begun_), rate = wall > 0 ? done / wall : 0;
  const double left = rate > 0 ? (now.stage.duration - done) / rate : 0;
  clear();
  fmt::print(
      "{}  t = {:.3f} s  dt = {:.3g} s  {:.3g} x real time  kinetic {:.3g} J  unbalanced {:.2g}  at most {:.0f} s left",
      now.stage.name, now.state.time, now.dt, rate, kinetic, now.ratio, left);
  std::fflush(stdout);
  shown_ = true;
}

void Progress::stage_ended(const StageReport& report) {
  if (quiet_) return;
  clear();
  fmt::print(
      "{:10.4f} s  {}: ended ({}) after {:.4g} s in {} steps of {:.3g} to {:.3g} s, {:.2f} s of wall clock; fastest "
      "{:.3g} m/s, unbalanced {:.2g}\n",
      report.ended, report.name, name_of(report.end), report.ended - report.begun, report.steps, report.shortest_dt,
      report.longest_dt, seconds_since(stage_begun_), report.speed, report.ratio);
  if (!report.reason.empty()) fmt::print("              {}\n", report.reason);
  std::fflush(stdout);
}

}  // namespace trilith::program
