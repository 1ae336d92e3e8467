#include "model/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace trilith {
namespace {

std::string words_of(const FaultCount& fault, Fault type) {
  if (type != Fault::passed || fault.count == 1) return fault.first;
  return fmt::format("{} times one body passed into another, first: {}", fault.count, fault.first);
}

}  // namespace

void Verdict::add(EventType type, double time, double value, const std::string& text) {
  if (type == EventType::body_left) ++left_;
  if (!has_trait(type, spoils_run) || type == EventType::body_left) return;
  const Fault which = type == EventType::stage_diverged    ? Fault::diverged
                      : type == EventType::stage_unsettled ? Fault::not_at_rest
                                                           : Fault::passed;
  FaultCount& fault = fault_[static_cast<std::size_t>(which)];
  if (fault.count++ > 0) return;
  fault.time = which == Fault::diverged ? value : time;
  fault.first = text;
}

bool Verdict::sound() const {
  return std::none_of(fault_.begin(), fault_.end(), [](const FaultCount& f) { return f.count > 0; });
}

double Verdict::sound_until() const {
  double until = sound() ? 0 : 1e300;
  for (const FaultCount& f : fault_)
    if (f.count > 0) until = std::min(until, f.time);
  return until;
}

std::string Verdict::text(double zero) const {
  if (sound()) return "";
  std::vector<std::string> parts;
  for (const Fault type : {Fault::diverged, Fault::passed, Fault::not_at_rest})
    if (has(type)) parts.push_back(words_of(fault(type), type));
  return fmt::format("not to be trusted after {:.4g} s: {}", sound_until() - zero, fmt::join(parts, "; "));
}

}  // namespace trilith
