#include "model/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "model/event/event_list.hpp"

namespace trilith {

bool Verdict::counts(EventType type) {
  return severity_of(type) == Severity::invalid || type == EventType::body_left;
}

void Verdict::add(EventType type, double time, double value, const std::string& text) {
  if (type == EventType::body_left) ++left_;
  if (severity_of(type) != Severity::invalid) return;
  FaultCount& fault = fault_[static_cast<std::size_t>(type)];
  if (fault.count++ > 0) return;
  fault.time = has_trait(type, valid_until) ? value : time;
  fault.first = text;
}

bool Verdict::sound() const {
  return failed_.empty() && std::none_of(fault_.begin(), fault_.end(), [](const FaultCount& f) { return f.count > 0; });
}

double Verdict::sound_until() const {
  double until = sound() ? 0 : 1e300;
  for (const FaultCount& f : fault_)
    if (f.count > 0) until = std::min(until, f.time);
  for (const FailedCheck& f : failed_) until = std::min(until, f.time);
  return until;
}

std::string Verdict::text(double zero) const {
  if (sound()) return "";
  std::vector<std::string> parts;
  for (const EventTypeInfo& row : event_type_info) {
    const FaultCount& found = fault(row.type);
    if (found.count == 1) parts.push_back(found.first);
    if (found.count > 1) parts.push_back(fmt::format("{} times {}, first: {}", found.count, row.heading, found.first));
  }
  for (const FailedCheck& f : failed_) parts.push_back(f.text);
  return fmt::format("not reliable after {:.4g} s: {}", sound_until() - zero, fmt::join(parts, "; "));
}

}  // namespace trilith
