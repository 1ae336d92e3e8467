#include "run/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quantity_text.hpp"
#include "element/rigid/rigid_turn.hpp"
#include "model/event/event_text.hpp"

namespace trilith {
namespace {

constexpr double pace_window = 5, pace_spacing = 0.2;  // wall clock [s]
constexpr double crowd_window = 1;                     // simulated [s]

std::string grouped(std::int64_t number) {
  const std::string digits = std::to_string(number);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

std::string step_text(double shortest, double longest) {
  const std::string low = quantity_text(shortest, "s"), high = quantity_text(longest, "s");
  return low == high ? low : fmt::format("{} to {}", low, high);
}

/// Number of events of a type that are reported one by one within a window. Bonds break by the dozen at one moment, so
/// only the first is reported.
int crowd_size(EventType type) {
  return has_trait(type, of_joint) ? 1 : 12;
}

bool comes_in_crowds(EventType type) {
  return type == EventType::impact || has_trait(type, of_joint);
}

}  // namespace

void Pace::add(double time, double wall) {
  if (!samples_.empty() && wall - samples_.back().wall < pace_spacing) return;
  samples_.push_back({time, wall});
  while (samples_.size() > 2 && wall - samples_[1].wall > pace_window) samples_.pop_front();
}

double Pace::speed() const {
  if (samples_.size() < 2) return 0;
  const double wall = samples_.back().wall - samples_.front().wall;
  return wall > 0 ? (samples_.back().time - samples_.front().time) / wall : 0;
}

std::optional<double> Pace::left(double end) const {
  const double rate = speed();
  if (!(rate > 0)) return std::nullopt;
  return std::max(0.0, (end - samples_.back().time) / rate);
}

namespace {

/// Twice the rotational kinetic energy of a node [J].
double turning_energy(const Model<2>& model, const State<2>& state, int n) {
  return model.inertia[n] * state.spin[n] * state.spin[n];
}
double turning_energy(const Model<3>& model, const State<3>& state, int n) {
  return state.spin[n].dot(momentum_of(model.inertia[n], state.rotation[n], state.spin[n]));
}

}  // namespace

template <int D>
double kinetic_energy(const Model<D>& model, const State<D>& state) {
  double sum = 0;
  for (int n = 0; n < model.nodes(); ++n)
    if (model.moves(n))
      sum += 0.5 * (model.mass[n] * state.velocity[n].squaredNorm() + turning_energy(model, state, n));
  return sum;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::clamp(std::ceil(seconds), 0.0, 1e9));
  const std::int64_t h = whole / 3600, m = whole / 60 % 60, s = whole % 60;
  return h > 0 ? fmt::format("{}:{:02}:{:02}", h, m, s) : fmt::format("{}:{:02}", m, s);
}

template <int D>
std::string status_text(const Instant<D>& now, const Pace& pace, double zero) {
  std::string out = fmt::format("{}  t {:.3f} s  step {}  dt {}", now.stage.name, now.state.time - zero,
                                grouped(now.state.step), quantity_text(now.dt, "s"));
  if (pace.speed() > 0) out += fmt::format("  {:.3g} x real time", pace.speed());
  out += fmt::format("  kinetic {}  unbalanced {:.1e}", quantity_text(kinetic_energy(now.model, now.state), "J"),
                     now.ratio);
  if (const auto left = pace.left(now.begun + now.stage.duration))
    out += fmt::format("  {}{} left", now.stage.until_rest ? "at most about " : "about ", duration_text(*left));
  return out;
}

std::string stage_text(const StageReport& report, double wall) {
  const double span = report.ended - report.begun;
  std::string out = fmt::format("{} ended ({}) after {:.4g} s in {} steps of {}", report.name, name_of(report.end),
                                span, grouped(report.steps), step_text(report.shortest_dt, report.longest_dt));
  out += fmt::format(", {:.3g} s of wall clock", wall);
  if (wall > 0 && span > 0) out += fmt::format(" ({:.3g} x real time)", span / wall);
  if (report.threads > 1) out += fmt::format(", {} threads", report.threads);
  if (report.threads > 1 && report.thread_gain > 0) out += fmt::format(": {:.2g} times one", report.thread_gain);
  return out;
}

bool EventLines::leaves_out(const Event& event) const {
  if (show_ != EventShow::important) return show_ == EventShow::none;
  return severity_of(event.type) == Severity::routine ||
         (event.type == EventType::impact && event.value < least_impact_);
}

std::string EventLines::crowd_line(const Crowd& crowd, EventType type) const {
  return fmt::format("{:10.3f} s  ... and {} more: {}", crowd.last - zero_, crowd.hidden, info_of(type).heading);
}

bool EventLines::thins_out(const Event& event, std::vector<std::string>& lines) {
  if (show_ == EventShow::all || !comes_in_crowds(event.type)) return false;
  Crowd& crowd = crowd_[static_cast<std::size_t>(event.type)];
  if (event.time >= crowd.since + crowd_window) {
    if (crowd.hidden > 0) lines.push_back(crowd_line(crowd, event.type));
    crowd = {event.time, event.time, 0, 0};
  }
  if (crowd.shown < crowd_size(event.type)) {
    ++crowd.shown;
    return false;
  }
  ++crowd.hidden;
  crowd.last = event.time;
  return true;
}

std::vector<std::string> EventLines::rest() {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < crowd_.size(); ++i)
    if (crowd_[i].hidden > 0) lines.push_back(crowd_line(crowd_[i], static_cast<EventType>(i)));
  crowd_ = {};
  return lines;
}

void EventLines::count_from(const Event& event, std::vector<std::string>& lines) {
  const bool is_stage = event.type == EventType::stage_begun && event.text == since_;
  if (since_.empty() || !(is_stage || info_of(event.type).name == since_)) return;
  lines.push_back(fmt::format("{:10.3f} s  times count from here on", event.time));
  zero_ = event.time;
  since_.clear();
}

template <int D>
std::vector<std::string> EventLines::tell(const Event& event, const Model<D>& model) {
  std::vector<std::string> lines;
  if (show_ == EventShow::none) return lines;
  const std::string text = event_text(event, model);
  const bool is_stage = event.type == EventType::stage_begun || event.type == EventType::stage_ended;
  // Events of a model are numbered in their order. Stored events with this or a later number belong to a run that was
  // restored to an earlier instant, or to a model that no longer exists.
  std::map<std::int64_t, Cause>& causes = causes_[&model];
  causes.erase(causes.lower_bound(event.id), causes.end());
  if (severity_of(event.type) != Severity::routine && !is_stage) causes[event.id] = {event.time, text};
  count_from(event, lines);
  if (leaves_out(event) || thins_out(event, lines)) return lines;
  std::string line = fmt::format("{:10.3f} s  {:<15}  {}", event.time - zero_, info_of(event.type).heading, text);
  // A bearing changes at its failure, which is the line above.
  const auto cause = causes.find(event.cause);
  if (cause != causes.end() && event.type != EventType::bearing_changed)
    line += fmt::format("  (because at {:.3f} s: {})", cause->second.time - zero_, cause->second.text);
  lines.push_back(std::move(line));
  return lines;
}

template double kinetic_energy(const Model<2>&, const State<2>&);
template std::string status_text(const Instant<2>&, const Pace&, double);
template std::vector<std::string> EventLines::tell(const Event&, const Model<2>&);
template double kinetic_energy(const Model<3>&, const State<3>&);
template std::string status_text(const Instant<3>&, const Pace&, double);
template std::vector<std::string> EventLines::tell(const Event&, const Model<3>&);

}  // namespace trilith
